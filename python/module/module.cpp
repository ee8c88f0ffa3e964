// pxm._core: the part of the Python module that is compiled. The package around it (python/pxm/)
// is what users see; here is only what Python cannot do itself.
#include <dlfcn.h>
#include <pybind11/pybind11.h>

#include <filesystem>

#include "host/files/installed_places.hpp"
#include "python/module/errors.hpp"
#include "python/module/points.hpp"
#include "python/module/render.hpp"
#include "python/module/scene.hpp"
#include "python/module/work.hpp"

namespace {

namespace fs = std::filesystem;

/// The folder of this file.
fs::path own_folder() {
    Dl_info info = {};
    if (dladdr(reinterpret_cast<void*>(&own_folder), &info) == 0 || info.dli_fname == nullptr)
        return {};
    std::error_code failed;
    const fs::path file = fs::canonical(info.dli_fname, failed);
    return failed ? fs::path() : file.parent_path();
}

/// Scenes and modules lie where they do for the program, seen from here.
void find_the_rest() {
    const fs::path folder = own_folder();
    if (folder.empty()) return;
    const auto from_here = [&](const char* way) { return (folder / way).lexically_normal(); };
    pxm::host::look_for_modules_in(from_here(PXM_PYTHON_TO_MODULES));
    pxm::host::look_for_data_in(from_here(PXM_PYTHON_TO_DATA));
}

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.doc() = "The compiled part of pxm.";
    module.attr("version") = PXM_VERSION;
    find_the_rest();
    pxm::python::mind_forks();
    pxm::python::translate_errors(module);
    pxm::python::add_scene(module);
    pxm::python::add_render(module);
    pxm::python::add_points(module);
}
