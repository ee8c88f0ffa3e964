// The Pixel Machine models as data: the array of pixel nodes and the memories of one node.
// Every number carries how surely it is known (docs/machine.md): S seen in a source, D derived from
// sources by arithmetic, R recalled, A assumed for the emulation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace pxm {

/// How surely a number is known.
enum class Certainty : char { seen = 'S', derived = 'D', recalled = 'R', assumed = 'A' };

/// One member of the family. Node (i,j) owns the pixels with x mod columns = i and y mod rows = j.
struct Model {
    std::string_view name;       // "964dX"
    int columns;                 // of the pixel node array
    int rows;                    // of the same
    Certainty array_certainty;   // of columns and rows
    int natural_width;           // of the natural raster, pixels
    int natural_height;          // of the same
    Certainty raster_certainty;  // of both

    [[nodiscard]] constexpr int nodes() const { return columns * rows; }  // of the array
    /// D: of the natural raster.
    [[nodiscard]] constexpr int pixels_per_node() const {
        return natural_width * natural_height / nodes();
    }
};

inline constexpr std::int64_t fast_memory_bytes = 36'864;  // S: Ch. 19; program + constants + stack
inline constexpr std::int64_t bank_bytes = 262'144;        // D: 48 MB / 64 nodes / 3 banks
inline constexpr std::int64_t zbuffer_part_bytes = 131'072;  // A: half of the z-buffer/texture bank
inline constexpr std::int64_t texture_part_bytes = bank_bytes - zbuffer_part_bytes;  // A: the rest
inline constexpr double instruction_seconds = 200e-9;  // D: 5 MIPS, Ch. 19

/// A memory of a pixel node, the same in all models.
struct Memory {
    std::string_view name;  // as faults call it
    std::int64_t bytes;     // that there are
    Certainty certainty;    // of the bytes
    std::string_view use;   // what it holds
};

/// All of them.
inline constexpr std::array<Memory, 5> node_memories{{
    {"fast memory", fast_memory_bytes, Certainty::seen,
     "program, constants, stack, order of the heap"},
    {"front buffer", bank_bytes, Certainty::derived, "the picture, 32 bits a pixel"},
    {"back buffer", bank_bytes, Certainty::derived, "the shape database"},
    {"z-buffer", zbuffer_part_bytes, Certainty::assumed, "entries of the heap"},
    {"texture", texture_part_bytes, Certainty::assumed, "2-D textures"},
}};

/// All models, 916 first.
[[nodiscard]] std::span<const Model> models();

/// The model of that name, or null.
[[nodiscard]] const Model* find_model(std::string_view name);

}  // namespace pxm
