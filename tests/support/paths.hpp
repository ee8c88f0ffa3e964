// Where the tests find the sources and the program.
#pragma once

#include <string>

namespace pxm::test {

inline const std::string source_dir = PXM_SOURCE_DIR;  // the top of the tree
inline const std::string binary = PXM_BINARY;          // bin/pxm

}  // namespace pxm::test
