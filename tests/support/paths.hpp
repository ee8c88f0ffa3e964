// Where the tests find the sources and the program.
#pragma once

#include <string>

namespace pxm::test {

// The two places as CMake names them. They are known to paths.cpp alone, so that no other object
// depends on where the tree lies.
const char* configured_source_dir();
const char* configured_binary();

inline const std::string source_dir = configured_source_dir();  // the top of the tree
inline const std::string binary = configured_binary();          // bin/pxm

}  // namespace pxm::test
