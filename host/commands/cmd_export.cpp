// `pxm export SCENE -o OUT`: cells as instances or geometry for other programs, or the systems.
#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/shared_options.hpp"
#include "host/error.hpp"
#include "host/export/export_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/check/settings.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr std::uint64_t most_levels = 1'000;
constexpr std::uint64_t most_voxels = 4'096;  // a side

struct ExportArguments {
    std::string scene;
    std::string out;
    std::string format;
    std::string shape = "auto";
    std::optional<long> levels;
    std::optional<double> detail;
    std::optional<double> scale;
    std::optional<long> voxels;
    std::vector<std::string> set;
    std::vector<std::string> allowed;
    bool geometry = false;
    bool quiet = false;
};

bool is_mesh_path(const std::string& text) {
    return text.ends_with(".obj") || text.ends_with(".ply") || text.ends_with(".OBJ") ||
           text.ends_with(".PLY");
}

VolumeKind kind_of(const std::string& shape) {
    if (shape == "auto") return VolumeKind::automatic;
    if (shape == "ball") return VolumeKind::sphere;
    if (shape == "box") return VolumeKind::box;
    if (shape == "oriented") return VolumeKind::oriented;
    if (shape == "hull") return VolumeKind::hull;
    throw Error(ErrorKind::setting,
                fmt::format("--shape {}: expected auto, ball, box, oriented, hull, or a mesh, "
                            "FILE.obj or FILE.ply",
                            printable(shape)));
}

/// A file of systems holds no cells.
void require_cells(const ExportArguments& arguments, const ExportFormatName& format) {
    if (format.format != ExportFormat::aifs && format.format != ExportFormat::flame) return;
    const char* option = arguments.levels            ? "--levels"
                         : arguments.detail          ? "--detail"
                         : arguments.scale           ? "--scale"
                         : arguments.shape != "auto" ? "--shape"
                                                     : nullptr;
    if (option != nullptr)
        throw Error(ErrorKind::setting,
                    fmt::format("{} says nothing to {}, which holds systems and "
                                "no cells",
                                option, format.text));
}

/// Only glTF has both, and only a level set has voxels.
void require_choice(const ExportArguments& arguments, const ExportFormatName& format) {
    const bool vdb = format.format == ExportFormat::vdb;
    if (arguments.voxels && !vdb)
        throw Error(ErrorKind::setting,
                    fmt::format("--voxels is for vdb, not for {}", format.text));
    if (vdb && is_mesh_path(arguments.shape))
        throw Error(
            ErrorKind::setting,
            "--shape: a level set is one of volumes: expected auto, ball, box, oriented or hull");
    if (!arguments.geometry || format.format == ExportFormat::gltf ||
        format.format == ExportFormat::glb)
        return;
    throw Error(ErrorKind::setting,
                fmt::format("--geometry is for glb and gltf, not for {}", format.text));
}

/// Throws Error unless all that will be written can be, and is none of what is read.
void require_places(const ExportArguments& arguments, const ExportFormatName& format,
                    const Scene& scene) {
    std::vector<std::string> outputs{arguments.out};
    if (const std::string data = data_path(format, arguments.out); !data.empty()) {
        outputs.push_back(data);
        require_writable(data);
    }
    std::vector<InputFile> inputs = inputs_of(scene);
    if (is_mesh_path(arguments.shape)) inputs.push_back({arguments.shape, "the mesh of --shape"});
    require_spared(outputs, inputs);
}

ExitCode run_export(const ExportArguments& arguments) {
    const ExportFormatName& format = choose_export_format(arguments.format, arguments.out);
    require_cells(arguments, format);
    require_choice(arguments, format);
    const Settings settings = parse_settings(arguments.set);
    ExportRequest request;
    request.levels = arguments.levels;
    request.detail = arguments.detail;
    request.voxels = arguments.voxels;
    request.scale = arguments.scale.value_or(1);
    request.geometry = arguments.geometry;
    if (!is_mesh_path(arguments.shape)) request.shape.kind = kind_of(arguments.shape);
    require_writable(arguments.out);
    Diagnostics diagnostics;
    const Scene scene = parse_scene(arguments.scene, settings, diagnostics, arguments.allowed);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    require_places(arguments, format, scene);
    const std::string warnings = diagnostics.warnings_text(scene.files);
    if (!warnings.empty()) tell(warnings + "\n");
    if (is_mesh_path(arguments.shape)) request.shape.mesh = read_mesh(arguments.shape);
    ExportOutcome outcome;
    {
        Progress progress(arguments.quiet);
        outcome = export_file(
            scene, request, format, arguments.out,
            "pxm " PXM_VERSION " export of " + arguments.scene,
            [&](double share) { progress.update(share); }, stop_requested());
    }
    tell(outcome.messages);
    return outcome.stopped ? exit_code_of_signal(received_signal()) : ExitCode::done;
}

}  // namespace

AddedCommand add_export_command(CommandLine& line) {
    const auto a = std::make_shared<ExportArguments>();
    CommandOptions command =
        line.add_command("export", "Write a scene's cells, or its systems, for other programs");
    command.add_option("scene", a->scene, "The scene file (.pxm)").required();
    command
        .add_option("-o,--out", a->out,
                    "The file; its extension says the format. Beside a .gltf comes a .bin")
        .required();
    command.add_option("--format", a->format, "The format, whatever the extension says")
        .check(some_text());
    command
        .add_option("--levels", a->levels,
                    "Cells are images under so many maps; default: what the objects say")
        .transform(whole_number(0, most_levels));
    command
        .add_option("--detail", a->detail,
                    "Cells are as small as this length of the scene, or smaller")
        .transform(positive_number());
    command
        .add_option("--voxels", a->voxels,
                    "Voxels of a vdb along its longest side; default 256, or of half the --detail")
        .transform(whole_number(2, most_voxels));
    command
        .add_option("--shape", a->shape,
                    "What stands for a cell: a bounding volume or a mesh; default auto, the volume "
                    "that a render takes")
        .check(some_text());
    command
        .add_option("--scale", a->scale,
                    "Lengths of the file for a length of the scene: millimetres, for printers; "
                    "default 1")
        .transform(positive_number());
    command.add_flag("--geometry", a->geometry,
                     "Cells of a glTF as triangles, for programs that do not know instances");
    add_set_option(command, a->set);
    add_allow_option(command, a->allowed);
    command.add_flag("--quiet", a->quiet, "No progress bar");
    return {command, [a] {
                find_scene_by_name(a->scene, a->allowed);
                return run_export(*a);
            }};
}

}  // namespace pxm::host
