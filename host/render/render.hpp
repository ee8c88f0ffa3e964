// A render from text to picture: host/render/render.cpp is the path as code, one call each.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/engine/engine.hpp"
#include "host/engine/frame.hpp"
#include "host/engine/statistics.hpp"
#include "host/scene/check/settings.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
struct NeighbourWalk;

/// What the command line says over the scene's own image, render and object blocks.
struct SceneOverrides {
    std::optional<PixelSize> size;             // of the image
    std::optional<CropWindow> crop;            // the window of it
    std::optional<long> levels;                // of all objects: stop after so many maps
    double zoom = 1;                           // the eye moves to look + (eye - look) / zoom
    std::optional<Shading> shading;            // how normals are weighted
    std::optional<CoversChoice> covers;        // local covers
    std::optional<long> samples;               // eye rays a pixel
    std::optional<IntersectMethod> intersect;  // how the first hit is found
    std::optional<Numeric> numeric;            // what nodes compute with
    std::optional<double> detail;              // a cell is small enough at so many pixels
    std::optional<LipschitzMethod> lipschitz;  // how diameters are estimated
    std::optional<VolumeKind> volume;          // of all objects
    std::optional<long> heap;                  // entries
};

/// The scene as it is rendered: overrides win.
void apply(const SceneOverrides& overrides, Scene& scene);

/// What to render, and how. The scene is `scene` if it is given, else `scene_text`, else the file
/// at `scene_path`; of the first two scene_path is a name for messages, and what a text includes is
/// looked for beside it.
struct RenderRequest {
    std::string scene_path;                      // a file, or a name for messages
    std::optional<std::string> scene_text = {};  // in the scene language
    std::optional<Scene> scene = {};             // as data
    Settings settings;                           // of the scene, under the overrides
    std::vector<std::string> allowed = {};       // folders beside the scene's own (--allow)
    double frame = 0;          // of the scene's animation, from 0; its text is read for this one
    SceneOverrides overrides;  // of what the scene says
    const Model* machine = nullptr;          // null: native
    int threads = 1;                         // of the host
    std::string threads_because;             // why so many: for the statistics
    CostModel costs = default_cost_model();  // of the machine
    NodeCode code = NodeCode::counted;       // of the machine's nodes
    std::optional<long> only_sample;         // of an open shutter: one of the samples of all pixels
    std::optional<std::uint32_t> cell_cap;   // of studies; absent: that of CompiledScene
    std::vector<std::string> outputs;  // to be written: none may be what the scene is read from
    /// For the channel `neighbours`: how the shapes' words are read. Throws Error.
    std::function<std::vector<std::shared_ptr<const NeighbourWalk>>(const Scene&,
                                                                    const CompiledScene&)>
        walks;
};
/// What a render gives.
struct RenderResult {
    Frame frame;              // of the window; empty if a PictureTaker took it
    CropWindow window;        // what was rendered, of the image
    Statistics statistics;    // counted and measured
    std::string warnings;     // for the user, empty if there are none
    bool stopped = false;     // given up by control.stop: the frame is incomplete
    double pixel_at_eye = 0;  // p(t) = pixel_at_eye + pixel_growth t, world units (Eq. 15.2)
    double pixel_growth = 0;  // a world unit of the way
};

/// The scene in the engine that was chosen: the one place that knows all three. Keeps a reference
/// to `scene`. Throws Error: a bank of the machine is too small (5).
[[nodiscard]] std::unique_ptr<LoadedScene> load(const CompiledScene& scene,
                                                const EngineChoice& choice);

/// Takes a picture while it is rendered.
class PictureTaker {
  public:
    virtual ~PictureTaker() = default;
    /// Before the first ray: all is known but the frame and what is counted and measured.
    virtual void begin(const RenderResult& known) = 0;
    /// A part of the window. Any thread, and parts in any order (host/engine/engine.hpp).
    virtual void take(const Frame& part) = 0;
};

/// Renders. Without a taker the result has the whole frame, 64 bytes a pixel. Throws Error: an
/// output is an input (2), the scene is wrong (3), a file cannot be read (4), the machine is too
/// small (5). Nothing outside of the result is touched, so that any number of renders may run at a
/// time in threads of one process.
[[nodiscard]] RenderResult render(const RenderRequest& request, const RunControl& control,
                                  PictureTaker* taker = nullptr);

/// The scene of a request with its overrides, checked and not compiled: what an animation's first
/// frame says of all. Throws as render().
[[nodiscard]] Scene scene_of(const RenderRequest& request);

/// The same path up to the engine. Throws Error: the scene is wrong (3), a file cannot be read (4).
[[nodiscard]] CompiledScene compiled_scene_of(const RenderRequest& request);

/// The same, then one pixel's descent as text (`--pixel x,y`). A pixel
/// outside the image is an Error(ErrorKind::setting).
[[nodiscard]] std::string explain_pixel(const RenderRequest& request, long x, long y);

}  // namespace pxm::host
