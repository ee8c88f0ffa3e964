#include "tests/support/paths.hpp"

namespace pxm::test {

const char* configured_source_dir() { return PXM_SOURCE_DIR; }

const char* configured_binary() { return PXM_BINARY; }

}  // namespace pxm::test
