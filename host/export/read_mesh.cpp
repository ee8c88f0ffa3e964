// A user's mesh from a file: Wavefront OBJ, or PLY as programs write it.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/error.hpp"
#include "host/export/mesh.hpp"
#include "host/files/regular_file.hpp"
#include "host/text/number_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t most_vertices = 10'000'000;
constexpr std::size_t most_corners = 1'000'000;  // of one face

class MeshReader {
  public:
    explicit MeshReader(const std::string& path) : path_(path), text_(read_file(path)) {}

    Mesh read() {
        if (text_.starts_with("ply\n") || text_.starts_with("ply\r\n"))
            read_ply();
        else
            read_obj();
        if (mesh_.faces.empty()) refuse("expected faces, found none");
        if (is_closed(mesh_) && volume_of(mesh_) < 0) turn_over(mesh_);
        return std::move(mesh_);
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error(ErrorKind::scene, fmt::format("{}:{}:1: error: {}", printable_path(path_),
                                                  std::max(line_number_, 1), what));
    }

    bool next_line(std::string_view& line) {
        if (at_ >= text_.size()) return false;
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line = std::string_view(text_).substr(at_, end - at_);
        if (line.ends_with('\r')) line.remove_suffix(1);
        at_ = end + 1;
        ++line_number_;
        return true;
    }

    static std::vector<std::string_view> words_of(std::string_view line) {
        std::vector<std::string_view> words;
        constexpr std::string_view blanks = " \t";
        for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
            const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
            words.push_back(line.substr(begin, end - begin));
            begin = line.find_first_not_of(blanks, end);
        }
        return words;
    }

    double number(std::string_view word) const {
        const auto value = number_of_text<double>(word);
        if (!value)
            refuse(fmt::format("expected a number, found '{}'", printable(std::string(word))));
        return *value;
    }

    void add_vertex(const glm::dvec3& vertex) {
        if (mesh_.vertices.size() == most_vertices)
            refuse(fmt::format("more than {} vertices", most_vertices));
        if (!std::isfinite(vertex.x + vertex.y + vertex.z)) refuse("a vertex that is not finite");
        mesh_.vertices.push_back(vertex);
    }

    /// `number` from 0.
    void add_corner(std::vector<std::uint32_t>& face, double number) const {
        if (!(number >= 0 && number < static_cast<double>(mesh_.vertices.size())) ||
            number != std::floor(number))
            refuse("a face names a vertex that is not there");
        face.push_back(static_cast<std::uint32_t>(number));
    }

    void add_face(std::vector<std::uint32_t> face) {
        if (face.size() < 3) refuse("expected at least 3 corners of a face");
        mesh_.faces.push_back(std::move(face));
    }

    void read_obj() {
        for (std::string_view line; next_line(line);) {
            const std::vector<std::string_view> words = words_of(line);
            if (words.empty()) continue;
            if (words[0] == "v") {
                if (words.size() < 4) refuse("expected three numbers behind 'v'");
                add_vertex({number(words[1]), number(words[2]), number(words[3])});
            }
            if (words[0] == "f") {
                std::vector<std::uint32_t> face;
                for (std::size_t i = 1; i < words.size(); ++i) {
                    const double n = number(words[i].substr(0, words[i].find('/')));
                    add_corner(face,
                               n < 0 ? n + static_cast<double>(mesh_.vertices.size()) : n - 1);
                }
                add_face(std::move(face));
            }
        }
    }

    struct Property {
        std::string name;
        std::string type;
        std::string count_type;  // of a list
    };
    struct Element {
        std::string name;
        std::size_t count = 0;
        std::vector<Property> properties;
    };

    static std::size_t bytes_of(std::string_view type) {
        if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
        if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
        if (type == "int" || type == "uint" || type == "int32" || type == "uint32") return 4;
        if (type == "float" || type == "float32") return 4;
        return type == "double" || type == "float64" ? 8 : 0;
    }

    template <class Value>
    double take() {
        Value value{};
        std::memcpy(&value, text_.data() + at_, sizeof value);
        return static_cast<double>(value);
    }

    double binary_value(std::string_view type) {
        const std::size_t bytes = bytes_of(type);
        if (text_.size() - std::min(at_, text_.size()) < bytes) refuse("the file is cut short");
        double value = 0;
        if (type.starts_with("float") || type == "double")
            value = bytes == 4 ? take<float>() : take<double>();
        else if (type.starts_with('u'))
            value = bytes == 1   ? take<std::uint8_t>()
                    : bytes == 2 ? take<std::uint16_t>()
                                 : take<std::uint32_t>();
        else
            value = bytes == 1   ? take<std::int8_t>()
                    : bytes == 2 ? take<std::int16_t>()
                                 : take<std::int32_t>();
        at_ += bytes;
        return value;
    }

    double value(std::string_view type) {
        if (is_binary_) return binary_value(type);
        while (next_word_ >= words_.size()) {
            std::string_view line;
            if (!next_line(line)) refuse("the file is cut short");
            words_ = words_of(line);
            next_word_ = 0;
        }
        return number(words_[next_word_++]);
    }

    std::vector<Element> ply_header() {
        std::vector<Element> elements;
        std::string_view line;
        (void)next_line(line);
        while (next_line(line)) {
            const std::vector<std::string_view> words = words_of(line);
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "end_header") return elements;
            if (words[0] == "format" && words.size() > 1) {
                if (words[1] != "ascii" && words[1] != "binary_little_endian")
                    refuse("expected PLY as text or binary_little_endian");
                is_binary_ = words[1] != "ascii";
            } else if (words[0] == "element" && words.size() == 3) {
                const auto count = number_of_text<std::uint64_t>(words[2]);
                if (!count) refuse("expected how many there are of an element");
                elements.push_back({std::string(words[1]), *count, {}});
            } else if (words[0] == "property" && words.size() >= 3 && !elements.empty()) {
                const bool list = words[1] == "list" && words.size() == 5;
                Property property{std::string(words.back()), std::string(words[words.size() - 2]),
                                  list ? std::string(words[2]) : ""};
                if (bytes_of(property.type) == 0 || (list && bytes_of(property.count_type) == 0))
                    refuse("a property of no known type");
                elements.back().properties.push_back(std::move(property));
            } else {
                refuse("expected a line of a PLY header");
            }
        }
        refuse("expected end_header");
    }

    void read_ply() {
        for (const Element& element : ply_header())
            for (std::size_t i = 0; i < element.count; ++i) read_row(element);
    }

    void read_row(const Element& element) {
        glm::dvec3 vertex{0.0};
        std::vector<std::uint32_t> face;
        if (element.properties.empty()) refuse("an element without properties");
        for (const Property& property : element.properties) {
            const std::string& name = property.name;
            if (property.count_type.empty()) {
                const double v = value(property.type);
                if (name == "x" || name == "y" || name == "z") vertex[name[0] - 'x'] = v;
                continue;
            }
            const double count = value(property.count_type);
            if (!(count >= 0 && count <= most_corners)) refuse("a list that is too long");
            const bool is_face = element.name == "face" && name.starts_with("vertex_ind");
            for (int k = 0; k < static_cast<int>(count); ++k) {
                const double corner = value(property.type);
                if (is_face) add_corner(face, corner);
            }
            if (is_face) add_face(std::move(face));
        }
        if (element.name == "vertex") add_vertex(vertex);
    }

    std::string path_;
    std::string text_;
    std::size_t at_ = 0;
    int line_number_ = 0;
    bool is_binary_ = false;
    std::vector<std::string_view> words_;
    std::size_t next_word_ = 0;
    Mesh mesh_;
};

}  // namespace

Mesh read_mesh(const std::string& path) { return MeshReader(path).read(); }

}  // namespace pxm::host
