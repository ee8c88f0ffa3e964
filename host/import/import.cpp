#include "host/import/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "host/error.hpp"
#include "host/files/image_format.hpp"
#include "host/files/image_reader.hpp"
#include "host/files/regular_file.hpp"
#include "host/import/aifs/aifs_scene.hpp"
#include "host/import/eisenscript/eisen_scene.hpp"
#include "host/import/entries.hpp"
#include "host/import/flame/flame.hpp"
#include "host/import/fractint/fractint_ifs.hpp"
#include "host/import/fractint/fractint_l.hpp"
#include "host/import/ifsrenderer/ifsjson.hpp"
#include "host/import/imported_scene.hpp"
#include "host/import/lsystem/space_system.hpp"
#include "host/import/moments/moment_search.hpp"
#include "host/import/moments/picture.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t longest_name = 200;

/// The entry asked for.
template <class Entry>
Entry& chosen(std::vector<Entry>& list, const std::string& file,
              const std::optional<std::string>& wanted) {
    std::vector<std::string> names;
    for (const Entry& e : list) names.push_back(e.entry.name);
    return list[choose_entry(names, file, wanted)];
}

/// FRACTINT knows no quotes: where people write them, they mean nothing by them.
Imported told_of_quotes(const FractintEntry& entry, Imported imported) {
    if (entry.has_quotes)
        imported.messages +=
            fmt::format("entry \"{}\": quotes are skipped\n", printable(entry.name, longest_name));
    return imported;
}

Imported import_ifs(const SourceFile& source, const std::optional<std::string>& wanted) {
    Diagnostics diagnostics;
    auto list = parse_fractint_ifs(source.text, diagnostics);
    diagnostics.throw_if_errors({source});
    for (FractintIfs& bare : list)
        if (bare.entry.name.empty()) bare.entry.name = bare_name(source.name);
    const FractintIfs& ifs = chosen(list, source.name, wanted);
    ifs.entry.diagnostics.throw_if_errors({source});
    Scene scene = imported_scene(fractint_maps(ifs), ifs.entry.name,
                                 ifs.flat ? Space::plane : Space::solid, source);
    return told_of_quotes(
        ifs.entry,
        finished(std::move(scene),
                 fmt::format("{}: entry \"{}\" of {} (FRACTINT, {})", scene_name(ifs.entry.name),
                             printable(ifs.entry.name, longest_name), file_name(source.name),
                             ifs.flat ? "2-D: the plane z = 0" : "3-D")));
}

Imported import_l(const SourceFile& source, const std::optional<std::string>& wanted) {
    Diagnostics diagnostics;
    auto list = parse_fractint_l(source.text, diagnostics);
    diagnostics.throw_if_errors({source});
    for (FractintL& bare : list)
        if (bare.entry.name.empty()) bare.entry.name = bare_name(source.name);
    FractintL& l = chosen(list, source.name, wanted);
    l.entry.diagnostics.throw_if_errors({source});
    const Lsystem lsystem = lsystem_of(l);
    l.entry.diagnostics.throw_if_errors({source});
    double growth = 1;
    IfsBlock maps;
    try {
        if (lsystem.in_space) {
            const SpaceSystem system = space_system(lsystem);
            growth = system.growth;
            maps = space_maps(system);
        } else {
            const EdgeSystem system = edge_system(lsystem);
            growth = std::abs(system.growth);
            maps = lsystem_maps(system);
        }
    } catch (const Error& error) {  // said at its place
        diagnostics.error(l.entry.position, error.what());
        diagnostics.throw_if_errors({source});
    }
    maps.position = l.entry.position;
    const Space space = lsystem.in_space ? Space::solid : Space::plane;
    Scene scene = imported_scene(std::move(maps), l.entry.name, space, source);
    const std::string heading = fmt::format(
        "{}: entry \"{}\" of {} ({}; lengths grow by {:.6g} a level)", scene_name(l.entry.name),
        printable(l.entry.name, longest_name), file_name(source.name),
        lsystem.in_space ? "L-system in space" : "FRACTINT L-system", growth);
    return told_of_quotes(l.entry, finished(std::move(scene), heading));
}

IfsBlock block_of(const MomentResult& result) {
    IfsBlock block;
    for (std::size_t k = 0; k < result.maps.size(); ++k) {
        const PlaneMap& w = result.maps[k];
        MatrixCommand command;
        command.map.linear[0] = {w.a, w.c, 0};
        command.map.linear[1] = {w.b, w.d, 0};
        command.map.linear[2] = {0, 0, std::sqrt(std::abs(w.determinant()))};
        command.map.translation = {w.e, w.f, 0};
        MapBlock map;
        map.commands.push_back({command, {}});
        map.weight = result.weights[k];
        block.maps.push_back(std::move(map));
    }
    return block;
}

Imported import_picture(const ImportRequest& request, const PlaneMeasure& picture) {
    MomentRequest search{request.maps, request.seed, request.seconds, picture.finest, request.stop};
    const MomentResult result = search_moments(picture.points, search);
    if (result.maps.empty())
        throw Error(ErrorKind::scene, request.path + ": no maps were found that contract");
    const std::string found = fmt::format(
        "{} maps by the method of moments (Sec. 10.1): moments up to degree {}, {} restarts, seed "
        "{}{}\n"
        "moment residual (rms) {:.3g}\n"
        "collage distance h(B, w(B)) {:.4g}, so h(A, B) <= {:.4g} (Theorem 8.1); B is {:.4g} wide, "
        "on a grid of {:.3g}",
        result.maps.size(), result.order, result.restarts, request.seed,
        result.out_of_time ? ", stopped by its time" : "", result.residual, result.collage_distance,
        result.bound, result.size, result.cell);
    const std::string name = bare_name(request.path);
    Scene scene = imported_scene(block_of(result), name, Space::plane, {request.path, ""});
    Imported imported = finished(std::move(scene), fmt::format("{}: {}\n{}", scene_name(name),
                                                               file_name(request.path), found));
    imported.messages = found + '\n';
    return imported;
}

/// A file that can be read and is nothing that is imported is wrong by its content. Other dialects
/// of iterated function systems are text, as no picture is.
void require_picture(const std::string& path, const std::string& extension) {
    const std::string name = printable(path, longest_name);
    if (same_word(extension, ".pxm"))
        throw Error(ErrorKind::scene,
                    fmt::format("{} is a scene already: pxm render {}", name, name));
    const RegularFile file(path);
    if (!found_format(file.read(0, image_head_bytes)).name.empty()) return;
    throw Error(ErrorKind::scene,
                fmt::format("{} is no format that pxm imports: FRACTINT's .ifs and .l, flames "
                            "(.flame), IFStile's .aifs, EisenScript (.es), IFSRenderer's "
                            ".ifsjson, points (.xy, .txt), or a "
                            "picture (PNG, JPEG, OpenEXR, TIFF, PNM)",
                            name));
}

bool is_flame(const std::string& extension) {
    return same_word(extension, ".flame") || same_word(extension, ".flam3");
}

template <class Entry>
std::vector<std::string> names_of(const std::vector<Entry>& list) {
    std::vector<std::string> names;
    for (const Entry& e : list)
        if (!e.entry.name.empty()) names.push_back(e.entry.name);
    return names;
}

}  // namespace

std::vector<std::string> entries_of(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    Diagnostics diagnostics;
    if (same_word(extension, ".ifs"))
        return names_of(parse_fractint_ifs(read_file(path), diagnostics));
    if (same_word(extension, ".l")) return names_of(parse_fractint_l(read_file(path), diagnostics));
    if (is_flame(extension)) return flame_names({path, read_file(path)});
    if (same_word(extension, ".aifs")) return aifs_names({path, read_file(path)});
    return {};
}

Imported import_fractint(const SourceFile& source, FractintFormat format,
                         const std::optional<std::string>& entry) {
    return format == FractintFormat::ifs ? import_ifs(source, entry) : import_l(source, entry);
}

Imported import_file(const ImportRequest& request) {
    const std::string& path = request.path;
    const std::string extension = std::filesystem::path(path).extension().string();
    const bool has_entries =
        std::ranges::any_of(std::array{".ifs", ".l", ".flame", ".flam3", ".aifs"},
                            [&](const char* known) { return same_word(extension, known); });
    if (!has_entries && request.entry)
        throw Error(ErrorKind::setting, "--entry: only .ifs, .l, .flame and .aifs have entries");
    const bool flame = is_flame(extension);
    if (!flame && request.affine_part)
        throw Error(ErrorKind::setting, "--affine-part: only a .flame has other variations");
    if (flame)
        return import_flame({path, read_file(path)},
                            {request.entry, request.affine_part ? Variations::affine_part
                                                                : Variations::linear_only});
    if (same_word(extension, ".aifs")) return import_aifs({path, read_file(path)}, request.entry);
    if (same_word(extension, ".es"))
        return import_eisenscript({path, read_file(path)}, request.seed);
    if (same_word(extension, ".ifsjson")) return import_ifsjson({path, read_file(path)});
    if (same_word(extension, ".ifs"))
        return import_fractint({path, read_file(path)}, FractintFormat::ifs, request.entry);
    if (same_word(extension, ".l"))
        return import_fractint({path, read_file(path)}, FractintFormat::l, request.entry);
    if (same_word(extension, ".xy") || same_word(extension, ".txt"))
        return import_picture(request, read_points(path, read_file(path)));
    require_picture(path, extension);
    // The image is let go before the search: its points are all that is kept.
    const PlaneMeasure picture = picture_of(read_image(path, {"R", "G", "B", "A", "Y"}));
    return import_picture(request, picture);
}

}  // namespace pxm::host
