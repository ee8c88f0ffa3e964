// USD as text: a point instancer where cells are moved and scaled, else a mesh.
#include "host/export/cell_stream.hpp"

namespace pxm::host {

namespace {

/// A name of USD: letters, digits and underscores.
std::string usd_name(const std::string& name, std::size_t number) {
    std::string safe;
    for (const char c : name) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        safe += plain ? c : '_';
    }
    return fmt::format("object{}_{}", number + 1, safe);
}

/// Values of an array, a comma between them and lines of some length.
class Values {
  public:
    explicit Values(ByteStream& out) : out_(out) {}
    void point(const glm::dvec3& v) {
        begin();
        out_.print("({}, {}, {})", static_cast<float>(v.x), static_cast<float>(v.y),
                   static_cast<float>(v.z));
    }
    void number(std::uint64_t n) {
        begin();
        out_.print("{}", n);
    }

  private:
    void begin() {
        if (count_ > 0) out_.put(count_ % 8 == 0 ? ",\n" : ", ");
        ++count_;
    }
    ByteStream& out_;
    std::uint64_t count_ = 0;
};

template <class Put>
void array(ByteStream& out, std::string_view declaration, const Put& put) {
    out.print("{} = [", declaration);
    Values values(out);
    put(values);
    out.put("]\n");
}

void put_color(ByteStream& out, const ExportedObject& object) {
    out.print("color3f[] primvars:displayColor = [({}, {}, {})]\n", object.color.r, object.color.g,
              object.color.b);
}

void put_mesh_head(ByteStream& out, std::string_view name) {
    out.print("def Mesh \"{}\" {{\nuniform token subdivisionScheme = \"none\"\n", name);
}

void put_prototype(ByteStream& out, const ExportedObject& object, std::size_t set) {
    const Mesh& mesh = object.meshes[set];
    put_mesh_head(out, fmt::format("set{}", set));
    put_color(out, object);
    array(out, "int[] faceVertexCounts", [&](Values& values) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) values.number(3);
    });
    array(out, "int[] faceVertexIndices", [&](Values& values) {
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle) values.number(corner);
    });
    array(out, "point3f[] points", [&](Values& values) {
        for (const glm::dvec3& vertex : mesh.vertices) values.point(vertex);
    });
    out.put("}\n");
}

/// Calls each with the cells of one object.
template <class Each>
void of_object(CellPasses& passes, const ExportedObject& one, const Each& each) {
    passes.go_through([&](const ExportedObject& object, const Cell& cell, const Affine& place) {
        if (&object == &one) each(cell, place);
    });
}

void put_instancer(ByteStream& out, CellPasses& passes, const ExportedObject& object,
                   const std::string& name) {
    out.print("def PointInstancer \"{}\" {{\nrel prototypes = [", name);
    for (std::size_t set = 0; set < object.meshes.size(); ++set)
        out.print("{}<shapes/set{}>", set > 0 ? ", " : "", set);
    out.put("]\n");
    array(out, "int[] protoIndices", [&](Values& values) {
        of_object(passes, object, [&](const Cell& cell, const Affine&) {
            values.number(static_cast<std::uint64_t>(cell.set));
        });
    });
    array(out, "point3f[] positions", [&](Values& values) {
        of_object(passes, object,
                  [&](const Cell&, const Affine& place) { values.point(place.translation); });
    });
    array(out, "float3[] scales", [&](Values& values) {
        of_object(passes, object, [&](const Cell&, const Affine& place) {
            values.point({place.linear[0].x, place.linear[1].y, place.linear[2].z});
        });
    });
    out.put("def Scope \"shapes\" {\n");
    for (std::size_t set = 0; set < object.meshes.size(); ++set) put_prototype(out, object, set);
    out.put("}\n}\n");
}

void put_triangles(ByteStream& out, CellPasses& passes, const ExportedObject& object,
                   const std::string& name) {
    put_mesh_head(out, name);
    put_color(out, object);
    array(out, "int[] faceVertexCounts", [&](Values& values) {
        of_object(passes, object, [&](const Cell& cell, const Affine&) {
            for (std::size_t i = 0; i < mesh_of(object, cell).triangles.size(); ++i)
                values.number(3);
        });
    });
    array(out, "int[] faceVertexIndices", [&](Values& values) {
        std::uint64_t first = 0;
        of_object(passes, object, [&](const Cell& cell, const Affine& place) {
            const Mesh& mesh = mesh_of(object, cell);
            const bool mirrored = is_mirrored(place);
            for (const auto& triangle : mesh.triangles)
                for (const std::uint32_t corner : outward(triangle, mirrored))
                    values.number(first + corner);
            first += mesh.vertices.size();
        });
    });
    array(out, "point3f[] points", [&](Values& values) {
        of_object(passes, object, [&](const Cell& cell, const Affine& place) {
            for (const glm::dvec3& vertex : mesh_of(object, cell).vertices)
                values.point(place.point(vertex));
        });
    });
    out.put("}\n");
}

}  // namespace

void write_usda(const CellFile& cells, CheckedFile& file) {
    ByteStream out(file);
    const glm::dvec3 origin = file_coordinates(cells).direction(cells.offset);
    out.print(
        "#usda 1.0\n(\ndefaultPrim = \"pxm\"\nupAxis = \"Y\"\n)\n# {}\ndef Xform \"pxm\" {{\n",
        cells.title);
    if (cells.offset != glm::dvec3{0.0}) {
        out.print(
            "double3 xformOp:translate = ({}, {}, {})\n"
            "uniform token[] xformOpOrder = [\"xformOp:translate\"]\n",
            origin.x, origin.y, origin.z);
    }
    CellPasses passes(cells, 3 * static_cast<int>(cells.objects.size()));
    for (std::size_t i = 0; i < cells.objects.size(); ++i) {
        const ExportedObject& object = cells.objects[i];
        const std::string name = usd_name(object.name, i);
        if (has_instances(cells, CellFormat::usda))
            put_instancer(out, passes, object, name);
        else
            put_triangles(out, passes, object, name);
    }
    out.put("}\n");
    out.flush();
}

}  // namespace pxm::host
