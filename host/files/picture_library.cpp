#include "host/files/picture_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <future>
#include <mutex>
#include <string>

#include "host/error.hpp"
#include "host/files/installed_places.hpp"
#include "host/files/picture_module.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

PictureLibrary* load(const char* name, const char* function, const char* library) {
    std::string why;
    for (const fs::path& folder : module_folders()) {
        const fs::path place = folder / name;
        // Lazy: of the many thousand functions that it brings, a picture calls few.
        void* module = dlopen(place.c_str(), RTLD_LAZY | RTLD_LOCAL);
        void* make = module ? dlsym(module, function) : nullptr;
        if (make != nullptr) return reinterpret_cast<PictureModuleFunction*>(make)();
        if (why.empty()) why = dlerror();
    }
    throw Error(ErrorKind::failed, fmt::format("{} cannot be loaded: {}", library, why));
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
        return *load(picture_module, picture_module_function,
                     "OpenImageIO, which reads pictures and writes formats other than PNG and EXR "
                     "(in Debian packages of pxm: install pxm-formats),");
    }();
    return library;
}

PictureLibrary& exr_library() {
    static PictureLibrary& library =
        *load(exr_module, exr_module_function, "OpenEXR, for EXR pictures,");
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
