#include "host/inspect/inspect_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/inspect/exact_text.hpp"
#include "host/inspect/inspect_names.hpp"
#include "host/text/printable.hpp"
#include "host/text/six_digits.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_maps = 40;   // listed one by one
constexpr std::size_t most_names = 12;  // in one line

/// Six digits, and 0 for what is 0 up to rounding.
std::string number(double x) {
    constexpr double nothing = 1e-12;
    return fmt::format("{:.6g}", std::abs(x) < nothing ? 0.0 : x);
}

std::string point(const glm::dvec3& p) {
    return fmt::format("({}, {}, {})", number(p.x), number(p.y), number(p.z));
}

std::string names(const Rifs& rifs, const std::vector<int>& maps) {
    std::string text;
    for (std::size_t i = 0; i < std::min(maps.size(), most_names); ++i) {
        text += (i > 0 ? " " : "") + rifs.map_names[maps[i]];
    }
    if (maps.size() > most_names) text += fmt::format(" ... ({} in all)", maps.size());
    return text;
}

void line(std::string& text, const char* what, const std::string& value) {
    text += fmt::format("  {:<20} {}\n", what, value);
}

std::string map_line(const IfsFacts& ifs, std::size_t m) {
    const MapFacts& map = ifs.maps[m];
    const auto& s = map.singular_values;
    const std::string condition =
        map.kind == MapKind::singular ? "-" : fmt::format("{:.4g}", s[0] / s[2]);
    return fmt::format("    {:<12} {:<10} {:>11} {:>9} {:>9} {:>9} {:>9}  {}\n",
                       ifs.rifs.map_names[m], kind_name(map.kind), number(map.determinant),
                       fmt::format("{:.4g}", s[0]), fmt::format("{:.4g}", s[1]),
                       fmt::format("{:.4g}", s[2]), condition,
                       map.fixed_point ? point(*map.fixed_point) : "none");
}

void add_maps(const IfsFacts& ifs, std::string& text) {
    text += fmt::format("    {:<12} {:<10} {:>11} {:>9} {:>9} {:>9} {:>9}  {}\n", "map", "kind",
                        "determinant", "Lip", "", "", "condition", "fixed point");
    for (std::size_t m = 0; m < std::min(ifs.maps.size(), most_maps); ++m) {
        text += map_line(ifs, m);
    }
    if (ifs.maps.size() > most_maps) {
        text += fmt::format("    ... {} more\n", ifs.maps.size() - most_maps);
    }
}

void add_graph(const IfsFacts& ifs, std::string& text) {
    const GraphFacts& graph = ifs.graph;
    line(text, "graph",
         graph.complete ? "complete: any map may follow any other"
         : graph.strongly_connected
             ? "strongly connected"
             : fmt::format("{} components, {} edges between them", graph.components.size(),
                           graph.condensation.size()));
    if (graph.complete) return;
    line(text, "start", names(ifs.rifs, graph.start));
    if (graph.strongly_connected) return;
    for (std::size_t c = 0; c < std::min(graph.components.size(), most_maps); ++c) {
        line(text, graph.recurrent[c] ? "  recurrent" : "  passed once",
             names(ifs.rifs, graph.components[c]));
    }
    if (!graph.unreachable.empty()) line(text, "unreachable", names(ifs.rifs, graph.unreachable));
}

/// `times` too much, or nothing where it is rounding.
std::string excess(const char* what, double times, const char* wrong) {
    constexpr double rounding = 1e-9;
    if (times < 1 + rounding) return fmt::format("{} is right", what);
    return fmt::format("{} is up to {:.4g} times too {}", what, times, wrong);
}

void add_words(const IfsFacts& ifs, std::string& text) {
    const WordLipschitz& longest = ifs.words.back();
    line(text, "Lipschitz bounds",
         fmt::format("words of {}: {}, {}", longest.length,
                     excess("the product", longest.product_over_actual, "large"),
                     excess("the determinant's root", longest.actual_over_determinant, "small")));
}

/// Coordinates that are 0 within the margin of the bounds.
glm::dvec3 without_margin(glm::dvec3 p, double size) {
    constexpr double margin = 1e-8;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(p[i]) < margin * size) p[i] = 0;
    }
    return p;
}

void add_volumes(const IfsFacts& ifs, std::string& text) {
    const Bounds& all = ifs.bounds[ifs.rifs.start];
    const double size = all.ball.radius;
    line(text, "bounding sphere",
         fmt::format("{} radius {}, at most {:.2g} % too large",
                     point(without_margin(all.ball.center, size)), number(size),
                     100 * all.ball_slack));
    line(text, "bounding box",
         point(without_margin(all.box.low, size)) + " to " +
             point(without_margin(all.box.high, size)));
}

std::string similarity_text(const std::optional<Interval>& similarity) {
    if (!similarity) return "none: not every map is a similitude";
    constexpr double wide = 1e-6;
    if (similarity->error() > wide * std::max(1.0, similarity->high)) {
        return fmt::format("between {} and {}", number(similarity->low),
                           six_digits_above(similarity->high));
    }
    return number(similarity->middle());
}

void add_dimensions(const Dimensions& found, std::string& text) {
    line(text, "similarity", similarity_text(found.similarity));
    const Affinity& affinity = found.affinity;
    line(text, "affinity",
         affinity.exact ? fmt::format("{} ({})", number(affinity.value), affinity.why)
                        : fmt::format("{}, at most {} ({})", number(affinity.value),
                                      six_digits_above(affinity.upper), affinity.why));
    const BoxCounting& boxes = found.box_counting;
    line(text, "box counting",
         boxes.dimension ? fmt::format("{:.3f} +- {:.3f} ({} scales; {})", *boxes.dimension,
                                       boxes.error, boxes.scales.size(), boxes.method)
                         : boxes.method);
    line(text, "", found.meaning);
}

void add_ifs(const IfsFacts& ifs, std::string& text) {
    text += fmt::format("ifs {}: {} maps\n", ifs.rifs.name, ifs.maps.size());
    add_maps(ifs, text);
    add_graph(ifs, text);
    line(text, "contractivity",
         fmt::format("{} a map, by {}", number(ifs.contraction.rate),
                     proof_name(ifs.contraction.proof)));
    add_words(ifs, text);
    add_volumes(ifs, text);
    add_dimensions(ifs.dimensions, text);
    line(text, "open-set condition",
         fmt::format("{}: {}", condition_name(ifs.open_set.condition), ifs.open_set.why));
    const auto& disconnected = ifs.disconnected.totally_disconnected;
    line(text, "totally disconnected",
         fmt::format("{}: {}", disconnected ? (*disconnected ? "yes" : "no") : "unknown",
                     ifs.disconnected.why));
    text += exact_text(ifs);
}

void add_object(const ObjectFacts& object, std::string& text) {
    std::string what = object.ifs ? "ifs " + *object.ifs + ", volume " + object.volume
                                  : "the volume itself, " + object.volume;
    if (object.short_by > 0) {
        what += fmt::format("; the {} declared is short by {}", kind_name(*object.declared),
                            number(object.short_by));
    }
    text += fmt::format("object {}: {}\n", object.name, what);
}

void add_use(const char* what, const MemoryUse& use, std::string& text) {
    line(text, what, fmt::format("{} of {} bytes", use.used_bytes, use.limit_bytes));
}

void add_needs(const NodeNeeds& needs, std::string& text) {
    text += fmt::format("a node of the {}\n", needs.model);
    for (const ProgramModule& module : needs.program.modules) {
        line(text, module.name.c_str(),
             fmt::format("{:5} bytes: {}", module.bytes, module.because));
    }
    std::string left_out;
    for (const ProgramModule& module : needs.program.left_out) {
        left_out += (left_out.empty() ? "" : ", ") + module.name;
    }
    line(text, "left out", left_out);
    line(text, "stack", fmt::format("{:5} bytes", needs.program.stack_bytes));
    line(text, "heap order", fmt::format("{:5} bytes", needs.program.heap_order_bytes));
    add_use("fast memory", {fast_memory_bytes, needs.program.used_bytes()}, text);
    add_use("front buffer", needs.memory.front_buffer, text);
    add_use("back buffer", needs.memory.back_buffer, text);
    add_use("z-buffer", needs.memory.zbuffer, text);
    add_use("texture", needs.memory.texture, text);
    if (needs.rerooted.objects > 0) {
        line(text, "near the eye",
             fmt::format("{} cells became objects, at most {} levels down", needs.rerooted.objects,
                         needs.rerooted.levels));
    }
    if (needs.native.empty()) return;
    text += "\nnatively, in float\n";
    for (const wide::ObjectMethod& object : needs.native) {
        line(text, object.object.c_str(), fmt::format("{}: {}", object.method, object.because));
    }
}

}  // namespace

std::string inspect_text(const Inspection& inspection) {
    std::string text = printable_path(inspection.scene) + "\n\n";
    for (const IfsFacts& ifs : inspection.ifs) {
        add_ifs(ifs, text);
        text += '\n';
    }
    for (const ObjectFacts& object : inspection.objects) add_object(object, text);
    if (!inspection.objects.empty()) text += '\n';
    add_needs(inspection.needs, text);
    return text;
}

}  // namespace pxm::host
