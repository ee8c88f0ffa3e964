// Any bytes as a mesh, OBJ or PLY: it is read, and can be turned, measured and cut into triangles,
// or it is refused.
#include "host/export/mesh.hpp"

#include <cstdlib>

#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::one_input(data, size, [](const std::string& text) {
        const host::Mesh mesh = host::read_mesh(fuzz::memory_file(text));
        for (const auto& triangle : host::triangles_of(mesh))
            for (const std::uint32_t corner : triangle)
                if (corner >= mesh.vertices.size()) std::abort();
        (void)host::volume_of(mesh);
    });
}
