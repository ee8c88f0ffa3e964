// The questions of a page: JSON in, checked values out.
#pragma once

#include <optional>
#include <string>

#include "host/studio/asks.hpp"
#include "host/studio/brought_file.hpp"
#include "host/studio/scene_export.hpp"
#include "host/studio/small_study.hpp"

namespace pxm::host {

/// Each throws Error(ErrorKind::setting) for a body that is not what the page sends, or asks for
/// more than there is.
[[nodiscard]] AskedScene asked_scene(const std::string& body);
[[nodiscard]] AskedPicture asked_picture(const std::string& body);

/// The page that asks for nothing but to be forgotten.
[[nodiscard]] std::string asked_view(const std::string& body);

/// A pixel of a picture.
struct AskedPixel {
    AskedPicture picture;
    long x = 0;
    long y = 0;
};
[[nodiscard]] AskedPixel asked_pixel(const std::string& body);

/// A scene's file to be opened, or saved with a text.
struct AskedFile {
    std::string name;
    std::string text;
    std::string seen;  // digest of what is replaced
};
[[nodiscard]] AskedFile asked_file(const std::string& body);

/// A scene to be looked through, and how large the page shows it: the scene's own view depends on
/// that.
struct AskedCheck {
    AskedScene scene;
    std::optional<PixelSize> size;  // absent: as the scene says
};
[[nodiscard]] AskedCheck asked_check(const std::string& body);

/// A file from elsewhere, to be made a scene of; its bytes come in base64.
struct AskedImport {
    Asking asking;
    BroughtFile file;
};
[[nodiscard]] AskedImport asked_import(const std::string& body);

[[nodiscard]] AskedStudy asked_study(const std::string& body);
[[nodiscard]] AskedExport asked_export(const std::string& body);

}  // namespace pxm::host
