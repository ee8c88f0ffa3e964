#include "host/exact/exact_library.hpp"

#include "host/files/module.hpp"

namespace pxm::host {

const ExactLibrary& exact_library() {
    static const ExactLibrary& library = *reinterpret_cast<ExactModuleFunction*>(
        module_function(exact_module, exact_module_function, "FLINT, which has exact numbers,"))();
    return library;
}

}  // namespace pxm::host
