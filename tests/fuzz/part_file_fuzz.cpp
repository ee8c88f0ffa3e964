// Any bytes as a part file: it is refused, or all its units can be read or are refused.
#include "host/parts/part_file.hpp"

#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::one_input(data, size, [](const std::string& text) {
        const std::string path = fuzz::memory_file(text);
        const host::StoredPart part = host::read_part(path);
        const host::RegularFile file(path);
        for (const host::UnitEntry& entry : part.entries) (void)host::read_payload(file, entry);
    });
}
