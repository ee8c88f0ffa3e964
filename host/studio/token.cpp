#include "host/studio/token.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>

#include "host/error.hpp"

namespace pxm::host {

std::string random_token() {
    std::array<unsigned char, 16> bytes{};  // 128 bits
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw Error(ErrorKind::failed, "the system has no random numbers");
    std::string text;
    for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
    return text;
}

bool same_token(std::string_view a, std::string_view b) noexcept {
    if (a.size() != b.size()) return false;
    unsigned differences = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        differences |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^
                                             static_cast<unsigned char>(b[i]));
    return differences == 0;
}

}  // namespace pxm::host
