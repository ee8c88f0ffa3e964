#include "host/export/export_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "host/error.hpp"
#include "host/export/tally.hpp"
#include "host/export/vdb_library.hpp"
#include "host/export/writers.hpp"
#include "host/files/safe_file.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

/// As an address has it (RFC 3986).
std::string uri_of(const std::string& name) {
    std::string uri;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') ||
                           std::string_view("-._~").find(c) != std::string_view::npos;
        uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri;
}

/// Both files are whole before one of them is put into place, the numbers first.
void write_gltf(const ExportJob& job, const std::string& path, const std::string& data) {
    PartFile numbers(data, Places::any);
    write_gltf_data(job, numbers.file());
    const std::string json =
        gltf_json(job, uri_of(std::filesystem::path(data).filename().string()));
    write_safely(path, [&](CheckedFile& file) {
        file.append(json.data(), json.size());
        numbers.commit();
    });
}

void write_glb_file(const ExportJob& job, const std::string& path) {
    PartFile part(path, Places::any);
    write_glb(job, part.file());
    part.commit();
}

int visits_of(ExportFormat format) {
    switch (format) {
        case ExportFormat::ply:
            return ply_visits;
        case ExportFormat::usda:
            return usda_visits;
        default:
            return 1;
    }
}

void require_room(const ExportScene& scene, const CellTally& tally, ExportFormat format) {
    if (format == ExportFormat::ply) require_ply(tally);
    if (format == ExportFormat::stl) require_stl(tally);
    if (format == ExportFormat::gltf) require_gltf(scene, tally, false);
    if (format == ExportFormat::glb) require_gltf(scene, tally, true);
    if (format == ExportFormat::vdb) require_vdb(scene, tally);
    if (format == ExportFormat::usda && tally.number == CoordinateNumber::double_)
        throw Error(ErrorKind::setting,
                    "the cells are too small, or too far from the origin, for the floats of USD");
}

std::string summary(const CellTally& tally, const std::string& path) {
    const glm::dvec3 size = tally.high - tally.low;
    return fmt::format("{}: {} cells of {} triangles in all, {:.6g} x {:.6g} x {:.6g}\n",
                       printable_path(path), tally.cells, tally.triangles, size.x, size.y, size.z);
}

std::string write_cells(const ExportScene& scene, ExportFormat format, const std::string& path,
                        const std::string& data, const std::string& title,
                        const HearShare& progress, const std::atomic<bool>& stop) {
    const CellTally forecasted = forecast(scene);
    if (format == ExportFormat::ply) require_ply(forecasted);
    if (format == ExportFormat::stl) require_stl(forecasted);
    if (format == ExportFormat::glb) require_instances(forecasted);
    Watch counting(progress, stop);
    counting.expect(forecasted.cells);
    const CellTally tally = tally_of(scene, counting);
    require_room(scene, tally, format);
    Watch watch(progress, stop);
    watch.expect(tally.cells * static_cast<std::uint64_t>(visits_of(format)));
    const ExportJob job{scene, tally, watch, title};
    switch (format) {
        case ExportFormat::gltf:
            write_gltf(job, path, data);
            break;
        case ExportFormat::glb:
            write_glb_file(job, path);
            break;
        case ExportFormat::usda:
            write_safely(path, [&](CheckedFile& file) { write_usda(job, file); });
            break;
        case ExportFormat::obj:
            write_safely(path, [&](CheckedFile& file) { write_obj(job, file); });
            break;
        case ExportFormat::stl:
            write_safely(path, [&](CheckedFile& file) { write_stl(job, file); });
            break;
        case ExportFormat::vdb:
            write_safely(path, [&](CheckedFile& file) { write_vdb(job, file); });
            return summary(tally, path) + told_of_voxels(scene, tally);
        default:
            write_safely(path, [&](CheckedFile& file) { write_ply_mesh(job, file); });
    }
    return summary(tally, path);
}

/// Why geometry or prims stand where instances could.
std::string told_of_shears(const ExportScene& scene, ExportFormat format) {
    const bool gltf = format == ExportFormat::gltf || format == ExportFormat::glb;
    const bool instances = (gltf && !scene.geometry) || format == ExportFormat::usda;
    std::string messages;
    for (const ExportSystem& system : scene.systems)
        if (instances && !system.similar && !system.maps.empty())
            messages += fmt::format(
                "object \"{}\" has maps that are no turns and uniform scales: "
                "cells that are sheared are {}\n",
                printable(system.name),
                format == ExportFormat::usda ? "prims of their own" : "geometry, not instances");
    return messages;
}

}  // namespace

std::string data_path(const ExportFormatName& format, const std::string& path) {
    if (format.format != ExportFormat::gltf) return "";
    if (!find_destination(path).is_file)
        throw Error(ErrorKind::setting,
                    fmt::format("{} is no file that another one can stand beside, as the numbers "
                                "of a .gltf do: --format glb is one file",
                                printable_path(path)));
    return std::filesystem::path(path).replace_extension(".bin").string();
}

ExportOutcome export_file(const Scene& scene, const ExportRequest& request,
                          const ExportFormatName& format, const std::string& path,
                          const std::string& title, const HearShare& progress,
                          const std::atomic<bool>& stop) {
    ExportOutcome outcome;
    if (format.format == ExportFormat::aifs || format.format == ExportFormat::flame) {
        const bool aifs = format.format == ExportFormat::aifs;
        write_text_safely(
            path, aifs ? aifs_text(scene, outcome.messages) : flame_text(scene, outcome.messages));
        return outcome;
    }
    if (format.format == ExportFormat::vdb) (void)vdb_library();  // or say now that there is none
    Diagnostics diagnostics;
    const ExportScene cells = export_scene(scene, request, format.axes, diagnostics);
    outcome.messages = diagnostics.warnings_text(scene.files);
    if (!outcome.messages.empty()) outcome.messages += '\n';
    if (format.format == ExportFormat::pov) {
        if (std::ranges::any_of(cells.systems, &ExportSystem::colored))
            outcome.messages +=
                "colours of maps: a union is one for all words that lead to it; "
                "left out\n";
        // It copies a union each time that it is used (findings/povray_unions.sh).
        double objects = 0;
        for (const ExportSystem& system : cells.systems) objects += cells_by_levels(system);
        outcome.messages +=
            fmt::format("{}: POV-Ray makes {:.6g} objects of it, some 1.5 kB each\n",
                        printable_path(path), objects);
        write_text_safely(path, pov_text(cells, title));
        return outcome;
    }
    outcome.messages += told_of_shears(cells, format.format);
    try {
        outcome.messages +=
            write_cells(cells, format.format, path, data_path(format, path), title, progress, stop);
    } catch (const ExportStopped&) {
        outcome.stopped = true;
    }
    return outcome;
}

}  // namespace pxm::host
