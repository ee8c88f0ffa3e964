// POV-Ray's language: unions of unions, one for each follow set and level. Its space is pxm's, left
// handed with y up. POV-Ray copies a union each time that it is used (findings/povray_unions.sh),
// so a short file may become very many objects: its head says how many.
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/export/cell_stream.hpp"

namespace pxm::host {

namespace {

void put_point(ByteStream& out, const glm::dvec3& v) { out.print("<{},{},{}>", v.x, v.y, v.z); }

void put_matrix(ByteStream& out, const Affine& map) {
    out.put("matrix <");
    for (int i = 0; i < 3; ++i)
        out.print("{},{},{}, ", map.linear[i].x, map.linear[i].y, map.linear[i].z);
    out.print("{},{},{}>", map.translation.x, map.translation.y, map.translation.z);
}

std::string name_of(std::size_t object, std::size_t set, long level) {
    return fmt::format("Object{}_Set{}_Level{}", object + 1, set, level);
}

void put_mesh(ByteStream& out, const Mesh& mesh) {
    out.put("mesh {\n");
    for (const auto& triangle : mesh.triangles) {
        out.put("triangle { ");
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0) out.put(", ");
            put_point(out, mesh.vertices[triangle[i]]);
        }
        out.put(" }\n");
    }
    out.put("inside_vector <0,1,0> }\n");
}

/// What stands in a follow set so many levels below the outermost cell.
void put_level(ByteStream& out, const ExportedObject& object, std::size_t number, long level) {
    for (std::size_t set = 0; set < object.meshes.size(); ++set) {
        out.print("#declare {} = ", name_of(number, set, level));
        if (level == 0) {
            put_mesh(out, object.meshes[set]);
            continue;
        }
        const std::vector<int>& maps = object.rifs.follow_sets[set].maps;
        out.put(maps.size() > 1 ? "union {\n" : "object {\n");
        for (const int map : maps) {
            const auto at = static_cast<std::size_t>(map);
            const auto inside = static_cast<std::size_t>(object.rifs.follow_of[at]);
            if (maps.size() > 1) out.put("object { ");
            out.print("{} ", name_of(number, inside, level - 1));
            put_matrix(out, object.rifs.maps[at]);
            out.put(maps.size() > 1 ? " }\n" : "\n");
        }
        out.put("}\n");
    }
}

long levels_of(const ExportedObject& object, const CellLimit& limit) {
    if (object.rifs.maps.empty()) return 0;
    const long levels = limit.levels.value_or(0);
    return object.levels ? std::min(levels, *object.levels) : levels;
}

/// A view of everything, unless the file is a part of another scene.
void put_view(ByteStream& out, const CellFile& cells) {
    glm::dvec3 low{1e300}, high{-1e300};
    for (const ExportedObject& object : cells.objects) {
        const Mesh& mesh = object.meshes[static_cast<std::size_t>(object.rifs.start)];
        for (const glm::dvec3& vertex : mesh.vertices) {
            low = glm::min(low, object.instance.point(vertex) * cells.scale);
            high = glm::max(high, object.instance.point(vertex) * cells.scale);
        }
    }
    const glm::dvec3 middle = (low + high) / 2.0;
    const double radius = glm::length(high - low) / 2;
    out.put("#ifndef (Pxm_Without_View)\nglobal_settings { assumed_gamma 1 }\ncamera { location ");
    put_point(out, middle + 3 * radius * glm::normalize(glm::dvec3{0.4, 0.5, -1}));
    out.put(" look_at ");
    put_point(out, middle);
    out.put(" angle 40 }\nlight_source { ");
    put_point(out, middle + 100 * radius * glm::normalize(glm::dvec3{0.5, 1, -0.7}));
    out.put(" rgb 1 }\n#end\n");
}

}  // namespace

void write_pov(const CellFile& cells, CheckedFile& file) {
    ByteStream out(file);
    std::uint64_t count = 0;
    for (const ExportedObject& object : cells.objects) count += object.cells();
    out.print("// {}\n// POV-Ray makes {} objects of it.\n#version 3.7;\n", cells.title, count);
    put_view(out, cells);
    for (std::size_t i = 0; i < cells.objects.size(); ++i) {
        const ExportedObject& object = cells.objects[i];
        const long levels = levels_of(object, cells.limit);
        for (long level = 0; level <= levels; ++level) put_level(out, object, i, level);
        out.print("object {{ {} ", name_of(i, static_cast<std::size_t>(object.rifs.start), levels));
        put_matrix(out, object.instance);
        out.print(" scale {} pigment {{ color rgb <{},{},{}> }} }}\n", cells.scale, object.color.r,
                  object.color.g, object.color.b);
    }
    out.flush();
}

}  // namespace pxm::host
