#include "host/export/vdb_library.hpp"

#include "host/files/module.hpp"

namespace pxm::host {

const VdbLibrary& vdb_library() {
    static const VdbLibrary& library = *reinterpret_cast<VdbModuleFunction*>(
        module_function(vdb_module, vdb_module_function,
                        "OpenVDB, which writes .vdb (a pxm has it that was built where Debian's "
                        "libopenvdb-dev is; in Debian packages of pxm: install pxm-formats),"))();
    return library;
}

}  // namespace pxm::host
