// What fuzz targets have in common: any bytes go in, and a result or an Error comes out.
#pragma once

#include <cstdint>
#include <string>

#include "host/error.hpp"

namespace pxm::fuzz {

/// Calls `read(text)`; an Error is an answer, every other exception is a find.
template <class Read>
int one_input(const std::uint8_t* data, std::size_t size, const Read& read) {
    try {
        read(std::string(reinterpret_cast<const char*>(data), size));
    } catch (const host::Error&) {  // refused, and said why
    }
    return 0;
}

}  // namespace pxm::fuzz
