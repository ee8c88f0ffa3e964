// Cells as USD text: a PointInstancer an object; where cells are sheared a prim a cell, which
// refers to its shape.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "host/export/sink.hpp"
#include "host/export/turn_of.hpp"
#include "host/export/writers.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

/// A list of values by commas, in brackets.
class List {
  public:
    explicit List(std::string& text) : text_(text) { text_ += '['; }
    template <class... Values>
    void add(fmt::format_string<Values...> format, Values&&... values) {
        if (!std::exchange(first_, false)) text_ += ", ";
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    }

  private:
    std::string& text_;
    bool first_ = true;
};

struct Triple {
    float x, y, z;
    explicit Triple(const glm::dvec3& v)
        : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z)) {}
};

std::string triple(const glm::dvec3& v) {
    const Triple t(v);
    return fmt::format("({}, {}, {})", t.x, t.y, t.z);
}

class UsdaWriter {
  public:
    UsdaWriter(const ExportJob& job, CheckedFile& file)
        : job_(job), sink_(file), text_(sink_.text()) {}

    void write() {
        fmt::format_to(std::back_inserter(text_),
                       "#usda 1.0\n(\n    comment = \"{}\"\n    defaultPrim = \"scene\"\n"
                       "    metersPerUnit = 1\n    upAxis = \"Y\"\n)\n\ndef Xform \"scene\"\n{{\n",
                       quoted(job_.title));
        for (std::size_t i = 0; i < job_.scene.systems.size(); ++i) {
            const auto& sets = job_.tally.systems[i];
            if (std::ranges::any_of(sets, &SetTally::sheared))
                put_prims(i);
            else
                put_instancer(i);
        }
        text_ += "}\n";
        sink_.flush();
    }

  private:
    /// A line inside quotes.
    static std::string quoted(const std::string& text) {
        std::string plain;
        for (const char c : printable_path(text)) {
            if (c == '"' || c == '\\') plain += '\\';
            plain += c;
        }
        return plain;
    }

    [[nodiscard]] std::string prim_name(std::size_t i) const {
        return fmt::format("{}_{}", job_.scene.systems[i].name, i + 1);
    }

    void put_shapes(std::size_t i, const char* kind) {
        const ExportSystem& system = job_.scene.systems[i];
        for (std::size_t s = 0; s < system.sets.size(); ++s) {
            if (job_.tally.systems[i][s].cells == 0) continue;
            const Mesh& shape = system.sets[s].shape;
            fmt::format_to(std::back_inserter(text_), "        {} Mesh \"shape_{}\"\n        {{\n",
                           kind, s + 1);
            text_ +=
                "            uniform token subdivisionScheme = \"none\"\n"
                "            int[] faceVertexCounts = ";
            List counts(text_);
            for (const auto& face : shape.faces) counts.add("{}", face.size());
            text_ += "]\n            int[] faceVertexIndices = ";
            List indices(text_);
            for (const auto& face : shape.faces)
                for (const std::uint32_t corner : face) indices.add("{}", corner);
            text_ += "]\n            point3f[] points = ";
            List points(text_);
            for (const glm::dvec3& v : shape.vertices) points.add("{}", triple(v));
            text_ += "]\n";
            if (!system.colored) put_color(system.color, "            ");
            text_ += "        }\n";
            sink_.settle();
        }
    }

    void put_color(const glm::dvec3& color, const char* indent) {
        fmt::format_to(std::back_inserter(text_), "{}color3f[] primvars:displayColor = [{}]\n",
                       indent, triple(color));
    }

    /// One array of numbers a cell.
    template <class Put>
    void put_array(const ExportSystem& system, const char* name, const Put& put) {
        fmt::format_to(std::back_inserter(text_), "        {} = ", name);
        List list(text_);
        (void)for_each_cell(system, [&](const Cell& cell) {
            job_.watch.visit();
            put(list, cell);
            sink_.settle();
        });
        text_ += ']';
    }

    /// Numbers of the sets that have cells, in the order of the shapes.
    [[nodiscard]] std::vector<std::size_t> shape_numbers(std::size_t i) const {
        std::vector<std::size_t> numbers;
        std::size_t next = 0;
        for (const SetTally& set : job_.tally.systems[i])
            numbers.push_back(set.cells > 0 ? next++ : 0);
        return numbers;
    }

    void put_instancer(std::size_t i) {
        const ExportSystem& system = job_.scene.systems[i];
        const std::string name = prim_name(i);
        fmt::format_to(std::back_inserter(text_), "    def PointInstancer \"{}\"\n    {{\n", name);
        put_shapes(i, "def");
        text_ += "        rel prototypes = ";
        List shapes(text_);
        for (std::size_t s = 0; s < system.sets.size(); ++s)
            if (job_.tally.systems[i][s].cells > 0) shapes.add("</scene/{}/shape_{}>", name, s + 1);
        text_ += "]\n";
        const std::vector<std::size_t> numbers = shape_numbers(i);
        put_array(system, "int[] protoIndices", [&](List& list, const Cell& cell) {
            list.add("{}", numbers[static_cast<std::size_t>(cell.set)]);
        });
        text_ += '\n';
        put_array(system, "point3f[] positions", [](List& list, const Cell& cell) {
            list.add("{}", triple(cell.place.translation));
        });
        text_ += '\n';
        put_array(system, "quath[] orientations", [](List& list, const Cell& cell) {
            const glm::dvec4 q = turn_and_stretch(cell.place.linear).quaternion;
            list.add("({:.5g}, {:.5g}, {:.5g}, {:.5g})", q.w + 0.0, q.x + 0.0, q.y + 0.0,
                     q.z + 0.0);
        });
        text_ += '\n';
        put_array(system, "float3[] scales", [](List& list, const Cell& cell) {
            list.add("{}", triple(turn_and_stretch(cell.place.linear).stretch));
        });
        text_ += '\n';
        if (system.colored) {
            put_array(system, "color3f[] primvars:displayColor", [](List& list, const Cell& cell) {
                list.add("({:.4g}, {:.4g}, {:.4g})", cell.color.r, cell.color.g, cell.color.b);
            });
            text_ += " (\n            interpolation = \"vertex\"\n        )\n";
        }
        text_ += "    }\n";
    }

    void put_prims(std::size_t i) {
        const ExportSystem& system = job_.scene.systems[i];
        const std::string name = prim_name(i);
        fmt::format_to(std::back_inserter(text_), "    def Xform \"{}\"\n    {{\n", name);
        put_shapes(i, "class");
        std::uint64_t number = 0;
        (void)for_each_cell(system, [&](const Cell& cell) {
            job_.watch.visit();
            const auto out = std::back_inserter(text_);
            fmt::format_to(out,
                           "        def \"cell_{}\" (\n            references = "
                           "</scene/{}/shape_{}>\n        )\n        {{\n"
                           "            matrix4d xformOp:transform = ( ",
                           ++number, name, cell.set + 1);
            for (int row = 0; row < 3; ++row) {
                const glm::dvec3& r = cell.place.linear[row];
                fmt::format_to(out, "({}, {}, {}, 0), ", r.x, r.y, r.z);
            }
            const glm::dvec3& t = cell.place.translation;
            fmt::format_to(out,
                           "({}, {}, {}, 1) )\n            uniform token[] xformOpOrder = "
                           "[\"xformOp:transform\"]\n",
                           t.x, t.y, t.z);
            if (system.colored) put_color(cell.color, "            ");
            text_ += "        }\n";
            sink_.settle();
        });
        text_ += "    }\n";
    }

    const ExportJob& job_;
    Sink sink_;
    std::string& text_;
};

}  // namespace

void write_usda(const ExportJob& job, CheckedFile& file) { UsdaWriter(job, file).write(); }

}  // namespace pxm::host
