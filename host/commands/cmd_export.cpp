// `pxm export SCENE -o FILE --levels N`: the cells of a scene for programs that know no fractals.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/shared_options.hpp"
#include "host/error.hpp"
#include "host/export/cell_file.hpp"
#include "host/export/exported_scene.hpp"
#include "host/export/obj_reader.hpp"
#include "host/files/regular_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/cloud_extent.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/render/render_options.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/check/settings.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr std::uint64_t most_cells = 1'000'000'000;

struct ExportArguments {
    std::string scene;
    std::string out;
    std::string format;
    std::string shape;
    std::string volume;
    std::vector<std::string> set;
    std::vector<std::string> allowed;
    CellLimit limit;
    double scale = 1;
    bool geometry = false;
    bool quiet = false;
};

struct FormatName {
    const char* word;
    CellFormat format;
};
constexpr FormatName formats[] = {
    {"ply", CellFormat::ply},  {"obj", CellFormat::obj},   {"stl", CellFormat::stl},
    {"glb", CellFormat::glb},  {"gltf", CellFormat::gltf}, {"usda", CellFormat::usda},
    {"usd", CellFormat::usda}, {"pov", CellFormat::pov},   {"inc", CellFormat::pov}};

/// By the option, or else by the file's ending.
CellFormat format_of(const ExportArguments& arguments) {
    std::string word = arguments.format;
    if (word.empty()) {
        word = std::filesystem::path(arguments.out).extension().string();
        if (!word.empty()) word.erase(0, 1);
    }
    for (const FormatName& name : formats)
        if (word == name.word) return name.format;
    throw Error(ErrorKind::setting,
                fmt::format("{}: expected a name that ends in .ply, .obj, .stl, .glb, .gltf, .usda "
                            "or .pov, or --format with one of these",
                            printable_path(arguments.out)));
}

void require_limit(const ExportArguments& arguments, const std::vector<ExportedObject>& objects) {
    if (arguments.limit.levels || arguments.limit.length) return;
    for (const ExportedObject& object : objects) {
        if (object.rifs.maps.empty() || object.levels) continue;
        throw Error(ErrorKind::setting,
                    fmt::format("object \"{}\" has cells of any size: say --levels N or --detail "
                                "LENGTH",
                                object.name));
    }
}

/// Throws Error(ErrorKind::setting) if there are too many cells. False if a signal came.
bool count_all(const CellLimit& limit, std::vector<ExportedObject>& objects) {
    for (ExportedObject& object : objects) {
        const auto refuse = [&](const std::string& found) {
            throw Error(ErrorKind::setting,
                        fmt::format("object \"{}\": expected at most {} cells, found {}: fewer "
                                    "--levels or a larger --detail",
                                    object.name, most_cells, found));
        };
        const bool by_levels = limit.levels && !limit.length && !object.levels;
        if (by_levels && !object.rifs.maps.empty()) {
            const double count = cells_at(object.rifs, *limit.levels);
            if (count > static_cast<double>(most_cells)) refuse(fmt::format("{:.3g}", count));
        }
        if (count_cells(object, limit, most_cells)) continue;
        if (stop_requested()) return false;
        refuse("more");
    }
    return true;
}

/// The middle of the scene if floats would not keep its shape where it is, else zero.
glm::dvec3 offset_for(const std::vector<ExportedObject>& objects) {
    std::vector<CloudExtent> extents;
    glm::dvec3 sum{0.0};
    double count = 0;
    for (const ExportedObject& object : objects) {
        CloudExtent& extent = extents.emplace_back();
        const Mesh& whole = object.meshes[static_cast<std::size_t>(object.rifs.start)];
        for (const glm::dvec3& vertex : whole.vertices) {
            const glm::dvec3 place = object.instance.point(vertex);
            extent.add(place);
            sum += place;
            ++count;
        }
    }
    return number_for(extents) == CoordinateNumber::double_ ? sum / count : glm::dvec3{0.0};
}

void tell_of(const CellFile& cells, CellFormat format) {
    if (cells.offset != glm::dvec3{0.0} && format != CellFormat::pov) {
        tell(
            fmt::format("warning: the scene is far from the origin; the file's origin is ({}, {}, "
                        "{}) of it\n",
                        cells.offset.x, cells.offset.y, cells.offset.z));
    }
    const bool could =
        format == CellFormat::glb || format == CellFormat::gltf || format == CellFormat::usda;
    if (could && !cells.geometry && !has_instances(cells, format))
        tell(
            "warning: the cells are turned or sheared as instances of this format cannot be: they "
            "are "
            "written as triangles\n");
}

std::string size_text(const CellFile& cells, CellFormat format) {
    std::uint64_t count = 0;
    for (const ExportedObject& object : cells.objects) count += object.cells();
    return fmt::format("{} cells as {}", count,
                       has_instances(cells, format) ? "instances" : "triangles");
}

ExitCode run_export(const ExportArguments& arguments) {
    const CellFormat format = format_of(arguments);
    const VolumeKind kind =
        arguments.volume.empty() ? VolumeKind::automatic : parse_volume(arguments.volume);
    const Settings settings = parse_settings(arguments.set);
    require_writable(arguments.out);
    std::optional<Mesh> shape;
    if (!arguments.shape.empty()) {
        shape = mesh_of_obj(arguments.shape, read_file(arguments.shape));
        if (format == CellFormat::stl && !is_closed(*shape)) {
            throw Error(ErrorKind::scene, printable_path(arguments.shape) +
                                              ": the mesh is not closed, as an STL file needs it");
        }
    }
    Diagnostics diagnostics;
    const Scene scene = parse_scene(arguments.scene, settings, diagnostics, arguments.allowed);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    CellFile cells;
    if (!diagnostics.has_errors())
        cells.objects = exported_objects(scene, kind, shape, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    std::vector<InputFile> inputs = inputs_of(scene);
    if (shape) inputs.push_back({arguments.shape, "the shape"});
    require_spared({arguments.out}, inputs);
    const std::string warnings = diagnostics.warnings_text(scene.files);
    if (!warnings.empty()) tell(warnings + "\n");

    cells.limit = arguments.limit;
    cells.scale = arguments.scale;
    cells.geometry = arguments.geometry;
    cells.title = printable_path("pxm " PXM_VERSION " cells of " + arguments.scene);
    require_limit(arguments, cells.objects);
    if (!count_all(cells.limit, cells.objects)) return exit_code_of_signal(received_signal());
    cells.offset = offset_for(cells.objects);
    if (const std::string why = why_not(cells, format); !why.empty())
        throw Error(ErrorKind::setting, printable_path(arguments.out) + ": " + why);
    tell_of(cells, format);

    Progress progress(arguments.quiet);
    cells.progress = [&](double share) { progress.update(share); };
    struct Stopped {};
    try {
        write_safely(arguments.out, [&](CheckedFile& file) {
            if (!write_cells(cells, format, file)) throw Stopped{};
        });
    } catch (const Stopped&) {
        return exit_code_of_signal(received_signal());
    }
    if (!arguments.quiet)
        tell(fmt::format("{}: {}\n", printable_path(arguments.out), size_text(cells, format)));
    return ExitCode::done;
}

}  // namespace

AddedCommand add_export_command(CommandLine& line) {
    const auto a = std::make_shared<ExportArguments>();
    CommandOptions command =
        line.add_command("export", "Write the cells of a scene as shapes for other programs");
    command.add_option("scene", a->scene, "The scene file (.pxm)").required();
    command
        .add_option("-o,--out", a->out,
                    "The file; its ending says what it is: .ply, .obj, .stl, .glb, .gltf, .usda, "
                    ".pov")
        .required();
    command.add_option("--levels", a->limit.levels, "Cells so many maps deep; 0: the whole object")
        .transform(whole_number(0, 10'000));
    command
        .add_option("--detail", a->limit.length,
                    "Cells no longer than this, a length of the scene; with --levels what comes "
                    "first")
        .transform(positive_number());
    command.add_option("--format", a->format, "What the file is, whatever its name says");
    command.add_option(
        "--volume", a->volume,
        "Bounding volumes that stand for the cells; auto: those that rays would meet");
    command.add_option("--shape", a->shape,
                       "A mesh in the coordinates of the ifs that stands for each cell instead");
    command.add_option("--scale", a->scale, "Lengths of the file for one of the scene (default 1)")
        .transform(positive_number());
    command.add_flag("--geometry", a->geometry,
                     "Triangles for each cell, also where the format has instances");
    add_set_option(command, a->set);
    add_allow_option(command, a->allowed);
    command.add_flag("--quiet", a->quiet, "No progress bar and no summary");
    return {command, [a] {
                find_scene_by_name(a->scene, a->allowed);
                return run_export(*a);
            }};
}

}  // namespace pxm::host
