// The modules of the node program as measured: their bytes, and the stack of their functions.
// tools/measure_modules writes the table (docs/program-memory.md has the recipe and says what the
// numbers stand for).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pxm::host {

/// What a module's object holds.
struct MeasuredModule {
    std::string_view name;
    std::int64_t program_bytes;
    std::int64_t read_only_bytes;
    std::int64_t data_bytes;

    /// All of it, in whole words of four bytes.
    [[nodiscard]] std::int64_t bytes() const {
        return (program_bytes + read_only_bytes + data_bytes + 3) / 4 * 4;
    }
};

/// One function: its frame with the return address, and what it calls.
struct MeasuredFunction {
    std::string_view module;
    std::string_view name;
    std::int64_t stack_bytes;
    std::vector<std::size_t> calls;  // places in function_table
};

extern const std::string_view module_table_compiler;
extern const std::vector<MeasuredModule> module_table;
extern const std::vector<MeasuredFunction> function_table;

/// Where a node starts.
inline constexpr std::string_view entry_function = "pixel_program";

}  // namespace pxm::host
