#include "host/parts/heading_json.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/text/json_text.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: null stands for it.
Json number_json(double x) {
    return x < std::numeric_limits<double>::infinity() ? Json(x) : Json();
}
double number_of(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

Json grid_json(const UnitGrid& g) {
    return {{"window", {g.window.x0, g.window.y0, g.window.x1, g.window.y1}},
            {"part_side", g.part_side},
            {"side", g.side},
            {"nodes", {g.node_columns, g.node_rows}}};
}

UnitGrid grid_of(const Json& json) {
    const Json& w = json.at("window");
    return {{w.at(0), w.at(1), w.at(2), w.at(3)},
            json.at("part_side"),
            json.at("side"),
            json.at("nodes").at(0),
            json.at("nodes").at(1)};
}

Json alarms_json(const AlarmBasis& a) {
    Json places = Json::array();
    for (const AlarmPlace& place : a.places)
        places.push_back(
            {place.origin, place.distance, place.diameter, place.begin, number_json(place.end)});
    return {{"numeric", static_cast<int>(a.numeric)},
            {"pixel", {a.pixel_at_eye, a.pixel_growth}},
            {"detail", a.detail},
            {"unit", a.unit},
            {"objects", a.objects},
            {"maps", {a.steep_maps, a.flat_maps, a.maps_out_of_range}},
            {"places", places}};
}

AlarmBasis alarms_of(const Json& json) {
    const Json &pixel = json.at("pixel"), &maps = json.at("maps");
    AlarmBasis basis{static_cast<Numeric>(json.at("numeric").get<int>()),
                     pixel.at(0),
                     pixel.at(1),
                     json.at("detail"),
                     json.at("unit"),
                     json.at("objects"),
                     {},
                     maps.at(0),
                     maps.at(1),
                     maps.at(2)};
    for (const Json& p : json.at("places"))
        basis.places.push_back({p.at(0), p.at(1), p.at(2), p.at(3), number_of(p.at(4))});
    return basis;
}

Json modules_json(const std::vector<ProgramModule>& modules) {
    Json list = Json::array();
    for (const ProgramModule& module : modules)
        list.push_back({module.name, module.because, module.bytes});
    return list;
}

std::vector<ProgramModule> modules_of(const Json& json) {
    std::vector<ProgramModule> modules;
    for (const Json& module : json) modules.push_back({module.at(0), module.at(1), module.at(2)});
    return modules;
}

Json machine_json(const MachineStatistics& m) {
    Json memories = Json::array();
    for (const MemoryUse* use :
         {&m.fast_memory, &m.front_buffer, &m.back_buffer, &m.zbuffer, &m.texture})
        memories.push_back({use->limit_bytes, use->used_bytes});
    Json costs = Json::array();
    for (const OperationCost& cost : m.costs.table.operations)
        costs.push_back({cost.tight, cost.plain});
    return {{"costs", m.costs.name},
            {"table", costs},
            {"plain_share", m.costs.table.plain_share},
            {"factor", m.costs.table.compiled_code_factor},
            {"memories", memories}};
}

MachineStatistics machine_of(const Json& json) {
    MachineStatistics m;
    m.costs.name = json.at("costs");
    m.costs.table.plain_share = json.at("plain_share");
    m.costs.table.compiled_code_factor = json.at("factor");
    for (std::size_t i = 0; i < operation_count; ++i)
        m.costs.table.operations[i] = {json.at("table").at(i).at(0), json.at("table").at(i).at(1)};
    std::size_t i = 0;
    for (MemoryUse* use :
         {&m.fast_memory, &m.front_buffer, &m.back_buffer, &m.zbuffer, &m.texture}) {
        const Json& memory = json.at("memories").at(i++);
        *use = {memory.at(0), memory.at(1)};
    }
    return m;
}

Json statistics_base(const Statistics& s) {
    return {{"scene", s.scene},
            {"engine", s.engine},
            {"model", s.model},
            {"numeric", s.numeric},
            {"size", {s.size.columns, s.size.rows}},
            {"intersect", {s.intersect, s.intersect_because}},
            {"rerooted", {s.rerooted.objects, s.rerooted.levels}},
            {"block", {s.scene_block_words, s.scene_block_hash}},
            {"modules", modules_json(s.program.modules)},
            {"left_out", modules_json(s.program.left_out)},
            {"stack_bytes", s.program.stack_bytes},
            {"deepest_calls", s.program.deepest_calls},
            {"heap_order_bytes", s.program.heap_order_bytes},
            {"machine", s.machine ? machine_json(*s.machine) : Json()}};
}

Statistics statistics_of(const Json& json) {
    Statistics s;
    s.scene = json.at("scene");
    s.engine = json.at("engine");
    s.model = json.at("model");
    s.numeric = json.at("numeric");
    s.size = {json.at("size").at(0), json.at("size").at(1)};
    s.intersect = json.at("intersect").at(0);
    s.intersect_because = json.at("intersect").at(1);
    s.rerooted = {json.at("rerooted").at(0), json.at("rerooted").at(1)};
    s.scene_block_words = json.at("block").at(0);
    s.scene_block_hash = json.at("block").at(1);
    s.program = {modules_of(json.at("modules")), modules_of(json.at("left_out")),
                 json.at("stack_bytes"), json.at("deepest_calls"), json.at("heap_order_bytes")};
    if (!json.at("machine").is_null()) s.machine = machine_of(json.at("machine"));
    return s;
}

Json film_json(const FilmPlace& f) {
    return {{"frame", f.frame},
            {"frames", f.frames},
            {"count", f.count},
            {"rate", f.rate},
            {"source", f.source}};
}

FilmPlace film_of(const Json& json) {
    return {json.at("frame"), json.at("frames"), json.at("count"), json.at("rate"),
            json.at("source")};
}

Aov channel_of(const std::string& name) {
    for (const Aov aov : all_aovs())
        if (name == aov_name(aov)) return aov;
    throw std::invalid_argument("no such channel");
}

}  // namespace

std::string heading_json(const PartHeading& heading) {
    Json common = Json::array(), metadata = Json::array(), channels = Json::array();
    for (const CommonThing& thing : heading.common) common.push_back({thing.name, thing.value});
    for (const auto& [name, value] : heading.metadata) metadata.push_back({name, value});
    for (const Aov aov : heading.channels) channels.push_back(aov_name(aov));
    return json_text(Json{{"part", {heading.part, heading.parts}},
                          {"film", heading.film ? film_json(*heading.film) : Json()},
                          {"common", common},
                          {"grid", grid_json(heading.grid)},
                          {"channels", channels},
                          {"cell_cap", heading.cell_cap},
                          {"metadata", metadata},
                          {"statistics", statistics_base(heading.statistics)},
                          {"alarms", alarms_json(heading.alarms)}});
}

PartHeading heading_of_json(const std::string& text) {
    const Json json = Json::parse(text);
    PartHeading heading;
    heading.part = json.at("part").at(0);
    heading.parts = json.at("part").at(1);
    if (const Json film = json.value("film", Json()); !film.is_null()) heading.film = film_of(film);
    for (const Json& thing : json.at("common"))
        heading.common.push_back({thing.at(0), thing.at(1)});
    heading.grid = grid_of(json.at("grid"));
    for (const Json& name : json.at("channels")) heading.channels.push_back(channel_of(name));
    heading.cell_cap = json.at("cell_cap");
    for (const Json& pair : json.at("metadata"))
        heading.metadata.emplace_back(pair.at(0), pair.at(1));
    heading.statistics = statistics_of(json.at("statistics"));
    heading.alarms = alarms_of(json.at("alarms"));
    return heading;
}

}  // namespace pxm::host
