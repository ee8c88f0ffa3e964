// How the program and the module with OpenImageIO find each other.
#pragma once

namespace pxm::host {

class PictureLibrary;

inline constexpr char picture_module[] = "pxm_openimageio.so";
inline constexpr char picture_module_function[] = "pxm_picture_library";

/// The one function of the module. What it returns lives as long as the process.
using PictureModuleFunction = PictureLibrary*();

}  // namespace pxm::host
