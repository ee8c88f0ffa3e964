#include "host/files/exr_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>

#include "host/error.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t longest_name = 255;        // of an attribute, its type or a channel
constexpr std::size_t largest_list = 1U << 20U;  // bytes of a list of channels
constexpr std::uint32_t several_parts = 0x1000;  // in the word after the magic number
constexpr int most_attributes = 65'536;

/// Goes through a header, attribute by attribute.
class HeaderReader {
  public:
    explicit HeaderReader(const RegularFile& file) : file_(file) {}

    ExrSizes sizes() {
        at_ = 4;
        const std::uint32_t version = number(take(4), 0);
        bool more = true;
        while (more) {
            const bool any = part();
            more = any && (version & several_parts) != 0;  // an empty header ends the parts
        }
        return sizes_;
    }

    ExrText text_of(std::string_view start, std::size_t most) {
        std::map<std::string, std::string> pieces;
        std::size_t bytes_of_all = 0;
        at_ = 8;  // after the magic number and the version
        for (std::string name = text(); !name.empty(); name = text()) {
            if (++attributes_ > most_attributes) refuse();
            const std::string type = text();
            const std::uint32_t bytes = number(take(4), 0);
            if (!name.starts_with(start)) {
                at_ += bytes;
                continue;
            }
            bytes_of_all += bytes;
            if (type != "string" || bytes_of_all > most) return {true, {}};
            pieces[name] = take(bytes);
        }
        if (pieces.empty()) return {};
        std::string whole;
        for (const auto& [name, piece] : pieces) whole += piece;
        return {true, whole};
    }

  private:
    /// False if the part has no attributes.
    bool part() {
        std::string name = text();
        if (name.empty()) return false;
        for (; !name.empty(); name = text()) {
            if (++attributes_ > most_attributes) refuse();
            const std::string type = text();
            const std::uint32_t bytes = number(take(4), 0);
            if (type == "box2i" && name == "dataWindow" && bytes == 16) {
                window(take(16));
            } else if (type == "tiledesc" && name == "tiles" && bytes == 9) {
                tiles(take(9));
            } else if (type == "chlist" && name == "channels" && bytes <= largest_list) {
                channels(take(bytes));
            } else if (name == "dataWindow" || name == "tiles" || name == "channels") {
                refuse();
            } else {
                at_ += bytes;
            }
        }
        return true;
    }

    void window(const std::string& box) {
        const auto side = [&](std::size_t low, std::size_t high) {
            return std::int64_t{static_cast<std::int32_t>(number(box, high))} -
                   static_cast<std::int32_t>(number(box, low)) + 1;
        };
        sizes_.width = std::max(sizes_.width, side(0, 8));
        sizes_.height = std::max(sizes_.height, side(4, 12));
    }

    void tiles(const std::string& sides) {
        sizes_.tile_width = std::max<std::int64_t>(sizes_.tile_width, number(sides, 0));
        sizes_.tile_height = std::max<std::int64_t>(sizes_.tile_height, number(sides, 4));
    }

    /// Each has a name and 16 bytes more; a name without letters is the end.
    void channels(const std::string& list) {
        std::int64_t count = 0;
        for (std::size_t at = 0; at < list.size() && list[at] != '\0'; ++count) {
            const std::size_t end = list.find('\0', at);
            if (end == std::string::npos) refuse();
            at = end + 17;
        }
        sizes_.channels = std::max(sizes_.channels, count);
    }

    std::string take(std::size_t bytes) {
        std::string data = file_.read(at_, bytes);
        if (data.size() < bytes) refuse();
        at_ += bytes;
        return data;
    }

    std::string text() {
        std::string data = file_.read(at_, longest_name + 1);
        const std::size_t end = data.find('\0');
        if (end == std::string::npos) refuse();
        at_ += end + 1;
        data.resize(end);
        return data;
    }

    static std::uint32_t number(const std::string& data, std::size_t at) {
        std::uint32_t value = 0;  // OpenEXR is little endian, as is every machine that pxm runs on
        std::memcpy(&value, data.data() + at, sizeof value);
        return value;
    }

    [[noreturn]] void refuse() const {
        throw Error(ErrorKind::file,
                    fmt::format("{}: its OpenEXR header is broken or cut off", file_.path()));
    }

    const RegularFile& file_;
    std::uint64_t at_ = 0;
    int attributes_ = 0;
    ExrSizes sizes_;
};

}  // namespace

ExrSizes largest_exr_sizes(const RegularFile& file) { return HeaderReader(file).sizes(); }

ExrText exr_text(const RegularFile& file, std::string_view start, std::size_t most) {
    return HeaderReader(file).text_of(start, most);
}

}  // namespace pxm::host
