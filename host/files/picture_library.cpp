#include "host/files/picture_library.hpp"

#include <cstdlib>
#include <future>

#include "host/files/module.hpp"
#include "host/files/picture_module.hpp"

namespace pxm::host {

namespace {

PictureLibrary& load(const char* name, const char* function, const char* library) {
    return *reinterpret_cast<PictureModuleFunction*>(module_function(name, function, library))();
}

/// OpenImageIO adds to the path of its plug-ins whatever is set here.
void forget_plugins() { ::unsetenv("OIIO_LIBRARY_PATH"); }

std::future<void>& loading() {
    static std::future<void> loading;
    return loading;
}

}  // namespace

PictureLibrary& picture_library() {
    static PictureLibrary& library = []() -> PictureLibrary& {
        forget_plugins();
        return load(picture_module, picture_module_function,
                    "OpenImageIO, which reads pictures and writes formats other than PNG and EXR "
                    "(in Debian packages of pxm: install pxm-formats),");
    }();
    return library;
}

PictureLibrary& exr_library() {
    static PictureLibrary& library =
        load(exr_module, exr_module_function, "OpenEXR, for EXR pictures,");
    return library;
}

void begin_loading_picture_library() {
    forget_plugins();
    // What fails here fails again, and is told, where the library is used.
    loading() = std::async(std::launch::async, [] {
        try {
            (void)picture_library();
        } catch (const std::exception&) {
            return;
        }
    });
}

}  // namespace pxm::host
