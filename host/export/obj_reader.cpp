#include "host/export/obj_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

class Reader {
  public:
    Reader(const std::string& path, std::string_view text) : path_(path), text_(text) {}

    Mesh read() {
        while (!text_.empty()) {
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            whole_ = rest_ = text_.substr(0, end);
            text_.remove_prefix(std::min(end + 1, text_.size()));
            read_line();
            ++line_;
        }
        line_ = at_ = 1;
        if (mesh_.triangles.empty()) refuse("expected a face (f), found none");
        return std::move(mesh_);
    }

  private:
    /// The next word of the line; empty at its end.
    std::string_view word() {
        const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
        while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
        std::size_t length = 0;
        while (length < rest_.size() && !is_space(rest_[length])) ++length;
        at_ = static_cast<int>(whole_.size() - rest_.size()) + 1;
        const std::string_view taken = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return taken;
    }

    [[noreturn]] void refuse(const std::string& what) const {
        const std::string shown = printable_path(path_);
        throw Error(ErrorKind::scene, fmt::format("{}:{}:{}: error: {}", shown, line_, at_, what),
                    {{path_, line_, at_, what}});
    }

    void read_line() {
        at_ = 1;
        const std::string_view kind = word();
        if (kind == "v") read_vertex();
        if (kind == "f") read_face();
        if (mesh_.vertices.size() > obj_vertices || mesh_.triangles.size() > obj_vertices)
            refuse(fmt::format("expected at most {} vertices and faces", obj_vertices));
    }

    void read_vertex() {
        glm::dvec3 vertex{0.0};
        for (int i = 0; i < 3; ++i) {
            const std::string_view text = word();
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), vertex[i]);
            const bool whole = error == std::errc{} && end == text.data() + text.size();
            if (!whole || !(std::abs(vertex[i]) < 1e100))
                refuse(fmt::format("expected a coordinate, found \"{}\"", printable(text)));
        }
        mesh_.vertices.push_back(vertex);
    }

    /// "7", "7/1/2" or "-1": counted from 1, or back from the last vertex so far.
    std::uint32_t corner(std::string_view text) const {
        long number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool whole =
            error == std::errc{} && (end == text.data() + text.size() || *end == '/');
        const auto count = static_cast<long>(mesh_.vertices.size());
        const long index = number < 0 ? count + number : number - 1;
        if (!whole || index < 0 || index >= count) {
            refuse(fmt::format("expected a vertex from 1 to {}, found \"{}\"", count,
                               printable(text)));
        }
        return static_cast<std::uint32_t>(index);
    }

    void read_face() {
        std::vector<std::uint32_t> corners;
        for (std::string_view text = word(); !text.empty(); text = word())
            corners.push_back(corner(text));
        if (corners.size() < 3) refuse("expected three corners or more of a face");
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }

    const std::string& path_;
    std::string_view text_;
    std::string_view whole_;  // the line
    std::string_view rest_;   // of it
    Mesh mesh_;
    int line_ = 1;
    int at_ = 1;
};

}  // namespace

Mesh mesh_of_obj(const std::string& path, std::string_view text) {
    return Reader(path, text).read();
}

}  // namespace pxm::host
