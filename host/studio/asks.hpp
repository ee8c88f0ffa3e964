// What a page may ask of the engines, and how much of it: pictures of a text that is being written,
// from a camera that is being moved.
#pragma once

#include <cstdint>
#include <string>

#include "host/render/render.hpp"
#include "host/scene/check/settings.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

inline constexpr std::size_t asked_text_bytes = 1U << 20U;
inline constexpr long asked_side_pixels = 4096;
inline constexpr long asked_pixels = 4L << 20U;  // 16 MB as the page has them
inline constexpr long asked_samples = 64;
inline constexpr std::size_t asked_maps = 2000;  // of a scene that is inspected while it is shaped
inline constexpr double asked_seconds = 600;     // that the answer may take

/// Which page asks, and with what number: of its questions of one kind the newest counts.
struct Asking {
    std::string view;
    std::uint64_t serial = 0;
};

/// A scene as the page has it.
struct AskedScene {
    Asking asking;
    std::string name;  // of its file, which need not be there: what it includes lies beside it
    std::string text;
    double frame = 0;
};

struct AskedPicture {
    AskedScene scene;
    Settings settings;  // of the camera and of the render block
    PixelSize size;
    long samples = 0;  // 0: as the scene says
    const Model* machine = nullptr;
};

/// What to render, so that `pxm render` with the same settings gives the same picture.
[[nodiscard]] RenderRequest request_of(const AskedPicture& asked, int threads);
[[nodiscard]] RenderRequest request_of(const AskedScene& asked);

}  // namespace pxm::host
