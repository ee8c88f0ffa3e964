// How the program and the modules with OpenImageIO and OpenEXR find each other.
#pragma once

namespace pxm::host {

class PictureLibrary;

inline constexpr char picture_module[] = "pxm_openimageio.so";
inline constexpr char picture_module_function[] = "pxm_picture_library";

inline constexpr char exr_module[] = "pxm_openexr.so";
inline constexpr char exr_module_function[] = "pxm_exr_library";

/// The one function of a module. What it returns lives as long as the process.
using PictureModuleFunction = PictureLibrary*();

}  // namespace pxm::host
