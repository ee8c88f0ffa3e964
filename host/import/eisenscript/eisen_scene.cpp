// Boxes are the attractor of eight maps to their corners, which follow the maps of the rules: so a
// script of any depth is a system, and no cell of it is listed. Spheres are objects.
#include "host/import/eisenscript/eisen_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "host/error.hpp"
#include "host/import/eisenscript/eisen_color.hpp"
#include "host/import/eisenscript/eisen_graph.hpp"
#include "host/import/entries.hpp"
#include "host/import/imported_scene.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t corners = 8;
constexpr std::size_t most_edges = maps_an_ifs - corners;
constexpr std::size_t most_spheres = 2'000;  // each is an object of its own

/// The script's space is right-handed, z toward the viewer.
Affine shown(const Affine& map) {
    const Affine turn = scaling({1, 1, -1});
    return then(then(turn, map), turn);
}

class EisenWriter {
  public:
    EisenWriter(const EisenGraph& graph, const SourceFile& source)
        : graph_(graph), source_(source) {}

    Scene scene(const std::string& name) {
        find_shapes();
        Scene scene;
        if (boxes_[0]) scene = imported_scene(block(), name, Space::solid, source_);
        scene.files = {source_};
        if (!spheres_[0]) return scene;
        if (boxes_[0]) {
            ObjectBlock whole;
            whole.name = scene.ifs[0].name;
            whole.ifs = scene.ifs[0].name;
            scene.objects.push_back(std::move(whole));
        }
        place_spheres(scene_name(name), scene);
        return scene;
    }

  private:
    /// Which nodes lead to boxes, and which to spheres.
    void find_shapes() {
        boxes_.assign(graph_.nodes.size(), 0);
        spheres_.assign(graph_.nodes.size(), 0);
        for (std::size_t i = graph_.nodes.size(); i-- > 0;) {
            for (const EisenEdge& edge : graph_.nodes[i].edges) {
                const bool inner = edge.shape == EisenShape::none;
                if (edge.shape == EisenShape::box || (inner && boxes_[edge.node])) boxes_[i] = 1;
                if (edge.shape == EisenShape::sphere || (inner && spheres_[edge.node]))
                    spheres_[i] = 1;
            }
        }
    }

    [[nodiscard]] bool leads_to_box(const EisenEdge& edge) const {
        return edge.shape == EisenShape::box ||
               (edge.shape == EisenShape::none && boxes_[edge.node] != 0);
    }

    IfsBlock block() const {
        std::vector<std::vector<MapReference>> maps(graph_.nodes.size());  // of each node
        std::vector<const EisenEdge*> edges;
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
            for (const EisenEdge& edge : graph_.nodes[i].edges) {
                if (!leads_to_box(edge)) continue;
                edges.push_back(&edge);
                maps[i].push_back(reference(edges.size()));
            }
        }
        std::vector<MapReference> corner_maps;
        for (std::size_t k = 1; k <= corners; ++k)
            corner_maps.push_back(reference(edges.size() + k));
        IfsBlock block;
        std::size_t rules = 0;
        for (const EisenEdge* edge : edges) {
            const bool box = edge->shape == EisenShape::box;
            add_map(edge_map(*edge), box ? corner_maps : maps[edge->node], block);
            rules += block.follow.back().followers.size();
            if (rules > maps_a_scene)
                throw Error(ErrorKind::scene,
                            fmt::format("{}: a graph of more than {} edges",
                                        printable_path(source_.name), maps_a_scene));
        }
        for (std::size_t k = 0; k < corners; ++k) add_map(corner_map(k), corner_maps, block);
        block.start = maps[0];
        return block;
    }

    static MapReference reference(std::size_t number) {
        MapReference reference;
        reference.map = static_cast<long>(number);
        return reference;
    }

    static void add_map(MapBlock map, const std::vector<MapReference>& inside, IfsBlock& block) {
        block.maps.push_back(std::move(map));
        FollowRule rule;
        rule.map = reference(block.maps.size());
        rule.followers = inside;
        block.follow.push_back(std::move(rule));
    }

    [[nodiscard]] MapBlock edge_map(const EisenEdge& edge) const {
        MapBlock map;
        map.commands = {{MatrixCommand{shown(edge.map)}, {}}};
        if (edge.shape == EisenShape::box && graph_.colored) {
            const glm::dvec3 rgb = scene_color(edge.color);
            map.color = {rgb.x, rgb.y, rgb.z, 1};
        }
        return map;
    }

    /// To a corner of the unit cube.
    static MapBlock corner_map(std::size_t corner) {
        const auto half = [](std::size_t bit) { return bit % 2 == 0 ? 0 : 0.5; };
        MapBlock map;
        map.commands = {
            {ScaleCommand{glm::dvec3(0.5)}, {}},
            {TranslateCommand{{half(corner), half(corner / 2), 0 - half(corner / 4)}}, {}}};
        return map;
    }

    void place_spheres(const std::string& name, Scene& scene) const {
        std::vector<std::pair<std::size_t, Affine>> waiting{{0, Affine{}}};
        while (!waiting.empty()) {
            const auto [node, place] = waiting.back();
            waiting.pop_back();
            for (const EisenEdge& edge : graph_.nodes[node].edges) {
                const Affine here = then(edge.map, place);
                if (edge.shape == EisenShape::none && spheres_[edge.node])
                    waiting.emplace_back(edge.node, here);
                if (edge.shape == EisenShape::sphere) add_sphere(name, here, edge.color, scene);
            }
        }
    }

    void add_sphere(const std::string& name, const Affine& place, const EisenColor& color,
                    Scene& scene) const {
        if (scene.objects.size() > most_spheres)
            throw Error(ErrorKind::scene, fmt::format("{}: more than {} spheres; boxes may be more",
                                                      printable_path(source_.name), most_spheres));
        ObjectBlock sphere;
        sphere.name = fmt::format("{}_sphere_{}", name, scene.objects.size());
        sphere.volume = SphereVolume{{0.5, 0.5, -0.5}, 0.5};
        sphere.commands = {{MatrixCommand{shown(place)}, {}}};
        if (graph_.colored) {
            const glm::dvec3 rgb = scene_color(color);
            sphere.color = {rgb.x, rgb.y, rgb.z, 1};
        }
        scene.objects.push_back(std::move(sphere));
    }

    const EisenGraph& graph_;
    const SourceFile& source_;
    std::vector<char> boxes_;
    std::vector<char> spheres_;
};

/// With its colours if it has few enough maps so, else without.
EisenGraph graph_of(const EisenScript& script, std::uint64_t seed, const SourceFile& source,
                    std::string& messages) {
    Diagnostics diagnostics;
    try {
        return eisen_graph(script, EisenColors::kept, seed, most_edges);
    } catch (const EisenUnknown& unknown) {
        diagnostics.error(unknown.position, unknown.message);
        diagnostics.throw_if_errors({source});
    } catch (const EisenTooMany&) {  // once more, below
    }
    try {
        EisenGraph graph = eisen_graph(script, EisenColors::dropped, seed, most_edges);
        messages += "colours are left out: with them there are too many kinds of parts\n";
        return graph;
    } catch (const EisenTooMany& many) {
        throw Error(ErrorKind::scene,
                    fmt::format("{}: rule or shape '{}': more than {} maps; rules that are drawn "
                                "by lot are told apart at every place",
                                printable_path(source.name), printable(many.rule), most_edges));
    }
}

}  // namespace

Imported import_eisenscript(const SourceFile& source, std::uint64_t seed) {
    Diagnostics diagnostics;
    const EisenScript script = parse_eisenscript(source.text, diagnostics);
    diagnostics.throw_if_errors({source});
    std::string messages = script.messages;
    const EisenGraph graph = graph_of(script, seed, source, messages);
    if (graph.nodes[0].edges.empty())
        throw Error(ErrorKind::scene, fmt::format("{}: the script places no box and no sphere",
                                                  printable_path(source.name)));
    if (graph.grids) messages += "grids are left out: their edges have no thickness\n";
    if (graph.drawn) messages += fmt::format("rules of one name were drawn by seed {}\n", seed);
    if (graph.shapes > static_cast<double>(script.max_objects))
        messages += fmt::format("all {:.6g} shapes are there; Structure Synth stops after {}\n",
                                graph.shapes, script.max_objects);
    const std::string name = bare_name(source.name);
    Imported imported =
        finished(EisenWriter(graph, source).scene(name),
                 fmt::format("{}: {} (EisenScript), {:.6g} shapes\n{}", scene_name(name),
                             file_name(source.name), graph.shapes, messages));
    imported.messages = messages;
    return imported;
}

}  // namespace pxm::host
