// Any bytes as a FRACTINT file: both parsers end, and L-systems end in a system or a reason.
#include <cstdint>
#include <string>

#include "host/error.hpp"
#include "host/import/fractint/fractint_ifs.hpp"
#include "host/import/fractint/fractint_l.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    Diagnostics diagnostics;
    for (const FractintIfs& ifs : parse_fractint_ifs(text, diagnostics)) {
        if (!ifs.entry.diagnostics.has_errors()) (void)fractint_maps(ifs);
        diagnostics.append(ifs.entry.diagnostics);
    }
    for (FractintL& l : parse_fractint_l(text, diagnostics)) {
        if (l.entry.diagnostics.has_errors()) continue;
        const Lsystem lsystem = lsystem_of(l);
        if (l.entry.diagnostics.has_errors()) continue;
        try {
            (void)lsystem_maps(edge_system(lsystem));
        } catch (const Error&) {  // no exact system: said so
        }
    }
    (void)diagnostics.text({{"fuzz", text}});
    return 0;
}
