// What the build knows of itself: cmake/build_facts.cmake writes the values.
#pragma once

#include <span>

namespace pxm::host {

struct LibraryFact {
    const char* name;
    const char* version;  // empty where the library does not tell
};

struct LeftOut {
    const char* what;
    const char* because;
};

struct BuildFacts {
    const char* libraries;  // their names, with commas between them
    const char* compiler;
    const char* compiler_version;
    const char* flags;
    const char* build_type;
    const char* target;  // the processor
    std::span<const LibraryFact> library_facts;
    std::span<const LeftOut> left_out;
};

[[nodiscard]] const BuildFacts& build_facts();

}  // namespace pxm::host
