// Preloaded into the program (LD_PRELOAD), leaves it only the registers that FORCE_WIDTH names, as
// Highway counts them: AVX3, AVX2, SSE4, EMU128 or NEON. Where the processor does not have them the
// program ends with 77.
#include <unistd.h>

#include <hwy/targets.h>
#include <cstdlib>
#include <cstring>

namespace {

struct Width {
    const char* name;
    long long target;
};
constexpr Width widths[] = {{"AVX3", HWY_AVX3},
                            {"AVX2", HWY_AVX2},
                            {"SSE4", HWY_SSE4},
                            {"EMU128", HWY_EMU128},
                            {"NEON", HWY_NEON}};

[[gnu::constructor]] void force() {
    const char* wanted = std::getenv("FORCE_WIDTH");
    if (wanted == nullptr) return;
    for (const Width& width : widths) {
        if (std::strcmp(width.name, wanted) != 0) continue;
        const bool is_there =
            width.target == HWY_EMU128 || (hwy::SupportedTargets() & width.target) != 0;
        if (!is_there) _exit(77);
        hwy::SetSupportedTargetsForTest(width.target);
        return;
    }
    _exit(78);
}

}  // namespace
