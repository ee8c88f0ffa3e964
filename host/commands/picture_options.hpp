// What the command line said over a scene, in the picture that carries it: put there by a render,
// and in force again when the picture is the scene (docs/pictures.md, "Pictures are scenes").
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/commands/render_arguments.hpp"
#include "host/render/render.hpp"
#include "host/scene/carried/carried_scene.hpp"

namespace pxm::host {

/// Where the scene is a picture, its options become the arguments that were not given. Throws
/// Error(ErrorKind::scene) if it carries no scene, or options that pxm does not take.
void hold_options_of_picture(RenderArguments& arguments);

/// Where the scene is a picture, its `--set` come before those given.
void hold_settings_of_picture(const std::string& scene, std::vector<std::string>& set);

/// What the pictures of a run carry. The scene is read when the first of them needs it.
class SceneCarrier {
  public:
    explicit SceneCarrier(const RenderArguments& arguments) : arguments_(arguments) {}

    /// Of the picture of that frame, as text; empty with --no-scene. Says once why a scene is left
    /// out. Throws Error as parse_scene().
    [[nodiscard]] std::string text(double frame);
    /// Of the scene's file; of a picture that carried one, of that one's.
    [[nodiscard]] std::string name() const;

  private:
    const RenderArguments& arguments_;
    std::optional<CarriedScene> scene_;
    bool from_picture_ = false;
    bool told_ = false;
};

}  // namespace pxm::host
