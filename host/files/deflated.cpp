#include "host/files/deflated.hpp"

#include <zlib.h>

#include <memory>
#include <new>
#include <vector>

namespace pxm::host {

namespace {

constexpr std::size_t step_bytes = std::size_t{64} << 10U;  // that are unpacked at a time

struct EndInflation {
    void operator()(z_stream* stream) const { inflateEnd(stream); }
};

}  // namespace

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string stream(size, '\0');
    const int result =
        compress2(reinterpret_cast<Bytef*>(stream.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
    if (result != Z_OK) throw std::bad_alloc();  // there is room for any stream
    stream.resize(size);
    return stream;
}

std::optional<std::string> inflated(std::string_view stream, std::size_t most) {
    z_stream state{};
    if (inflateInit(&state) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, EndInflation> end(&state);
    state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stream.data()));
    state.avail_in = static_cast<uInt>(stream.size());
    std::string bytes;
    std::vector<char> step(step_bytes);
    int result = Z_OK;
    while (result == Z_OK) {
        state.next_out = reinterpret_cast<Bytef*>(step.data());
        state.avail_out = static_cast<uInt>(step.size());
        result = inflate(&state, Z_NO_FLUSH);
        bytes.append(step.data(), step.size() - state.avail_out);
        if (bytes.size() > most) return std::nullopt;
    }
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    if (result != Z_STREAM_END || state.avail_in != 0) return std::nullopt;
    return bytes;
}

}  // namespace pxm::host
