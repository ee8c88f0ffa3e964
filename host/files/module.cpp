#include "host/files/module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "host/error.hpp"
#include "host/files/installed_places.hpp"

namespace pxm::host {

void* module_function(const char* name, const char* function, const char* library) {
    std::string why;
    for (const std::filesystem::path& folder : module_folders()) {
        const std::filesystem::path place = folder / name;
        // Lazy: of the many thousand functions that a module brings, a run calls few.
        void* module = dlopen(place.c_str(), RTLD_LAZY | RTLD_LOCAL);
        void* found = module != nullptr ? dlsym(module, function) : nullptr;
        if (found != nullptr) return found;
        if (why.empty()) why = dlerror();
    }
    throw Error(ErrorKind::failed, fmt::format("{} cannot be loaded: {}", library, why));
}

}  // namespace pxm::host
