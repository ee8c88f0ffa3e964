// `pxm points SCENE -n N -o OUT.ply`: the attractors drawn the explicit way (Alg. 7.1).
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/points_coordinates.hpp"
#include "host/commands/shared_options.hpp"
#include "host/files/safe_file.hpp"
#include "host/fractal/measure/chaos_game.hpp"
#include "host/output/ply.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/parts/kept_batches.hpp"
#include "host/parts/kept_units.hpp"
#include "host/parts/part_run.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/in_order.hpp"
#include "host/process/in_threads.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/render/point_games.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/check/settings.hpp"
#include "host/scene/print/print.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

namespace {

struct PointsArguments {
    std::string scene;
    std::string out;
    std::vector<std::string> set;
    std::vector<std::string> allowed;
    std::uint64_t count = 0;
    std::uint64_t seed = 1;
    std::string keep;
    std::string precision = "auto";
    std::string offset;
    int threads = 0;  // 0: those granted
    bool quiet = false;
    LimitArguments limits;
};

/// The boxes of the objects, of the first points of each; a copy of its game draws them.
std::vector<CloudExtent> extents_of(const std::vector<PointGame>& players) {
    constexpr int looked_at = 4096;
    std::vector<CloudExtent> extents;
    for (PointGame player : players) {
        CloudExtent& extent = extents.emplace_back();
        for (int i = 0; i < looked_at; ++i)
            extent.add(player.instance.point(player.game.next().place));
    }
    return extents;
}

/// The points of a file, as they come in it: objects one after another, with equal shares.
class Cloud {
  public:
    Cloud(const std::vector<PointGame>& players, std::uint64_t count,
          const Coordinates& coordinates)
        : players_(players),
          coordinates_(coordinates),
          chunks_(point_chunks(players.size(), count)) {}

    [[nodiscard]] std::size_t chunks() const { return chunks_.size(); }

    /// The bytes of a chunk. Any thread.
    [[nodiscard]] std::string draw(std::size_t i) const {
        const PointChunk& chunk = chunks_[i];
        const PointGame& player = players_[chunk.game];
        ChaosGame game = player.game;
        game.seek(chunk.number);
        PlyPoints points(coordinates_.number);
        for (std::uint64_t n = 0; n < chunk.points; ++n) {
            const CloudPoint point = game.next();
            points.add(player.instance.point(point.place) - coordinates_.offset,
                       point.blend.of(player.color));
        }
        return points.bytes();
    }

  private:
    const std::vector<PointGame>& players_;
    Coordinates coordinates_;
    std::vector<PointChunk> chunks_;
};

/// Draws chunks from all threads; false if a signal came.
template <class Take>
bool draw(const Cloud& cloud, const std::vector<std::size_t>& chunks, int threads, bool quiet,
          const Take& take) {
    Progress progress(quiet);
    std::atomic<std::size_t> done = 0;
    return in_threads(threads, chunks.size(), stop_requested(), [&](std::size_t i) {
        take(i, cloud.draw(chunks[i]));
        progress.update(static_cast<double>(++done) / static_cast<double>(chunks.size()));
    });
}

void append(CheckedFile& file, const std::string& bytes) {
    file.append(bytes.data(), bytes.size());
}

struct Stopped {};

/// Straight into the file.
void write_points(const Cloud& cloud, const std::string& header, int threads,
                  const PointsArguments& arguments) {
    write_safely(arguments.out, [&](CheckedFile& output) {
        append(output, header);
        std::vector<std::size_t> all(cloud.chunks());
        std::iota(all.begin(), all.end(), std::size_t{0});
        InOrder<std::string> order;
        const bool drawn =
            draw(cloud, all, threads, arguments.quiet, [&](std::size_t i, std::string bytes) {
                order.add(static_cast<long>(i), std::move(bytes),
                          [&](const std::string& next) { append(output, next); });
            });
        if (!drawn) throw Stopped{};
    });
}

/// By way of a folder, from where it goes on.
void keep_points(const Cloud& cloud, const std::string& header, const std::string& heading,
                 int threads, const PointsArguments& arguments) {
    make_part_folder(arguments.keep);
    std::string warnings;
    KeptUnits kept(arguments.keep, heading, cloud.chunks(),
                   "is of other points: another scene, count, seed, version, precision or offset",
                   warnings);
    tell(warnings);
    const std::vector<std::size_t> missing = kept.missing();
    KeptBatches batches(arguments.keep, heading);
    const bool drawn =
        draw(cloud, missing, threads, arguments.quiet,
             [&](std::size_t i, std::string bytes) { batches.add(missing[i], std::move(bytes)); });
    batches.write_rest();
    if (!drawn) throw Stopped{};
    for (const std::string& path : batches.paths()) kept.add(path);
    write_safely(arguments.out, [&](CheckedFile& output) {
        append(output, header);
        for (std::size_t i = 0; i < cloud.chunks(); ++i) {
            if (stop_requested()) throw Stopped{};
            append(output, kept.read(i));
        }
    });
}

ExitCode run_points(const PointsArguments& arguments) {
    const Settings settings = parse_settings(arguments.set);
    require_coordinates(arguments.precision, arguments.offset);
    require_writable(arguments.out);
    Diagnostics diagnostics;
    const Scene scene = parse_scene(arguments.scene, settings, diagnostics, arguments.allowed);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    std::vector<PointGame> players;
    if (!diagnostics.has_errors()) players = point_games(scene, arguments.seed, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    require_spared({arguments.out}, inputs_of(scene));
    const std::string warnings = diagnostics.warnings_text(scene.files);
    if (!warnings.empty()) tell(warnings + "\n");

    const Coordinates coordinates =
        coordinates_of(extents_of(players), arguments.precision, arguments.offset);
    const Cloud cloud(players, arguments.count, coordinates);
    const std::string header =
        ply_header(arguments.count, "pxm " PXM_VERSION " points of " + arguments.scene,
                   coordinates.number, coordinates.offset);
    const int threads = choose_threads(arguments.threads).threads;
    try {
        if (arguments.keep.empty()) {
            write_points(cloud, header, threads, arguments);
        } else {
            const glm::dvec3& offset = coordinates.offset;
            const std::string heading = fmt::format(
                R"({{"points":{{"version":"{}","scene":"{:016x}","count":{},"seed":{},)"
                R"("bits":{},"offset":[{},{},{}]}}}})",
                PXM_VERSION, digest_of(print_scene(scene)), arguments.count, arguments.seed,
                coordinates.number == CoordinateNumber::single ? 32 : 64, offset.x, offset.y,
                offset.z);
            keep_points(cloud, header, heading, threads, arguments);
        }
    } catch (const Stopped&) {
        return exit_code_of_stop(arguments.keep.empty() ? "no points were written"
                                                        : "what is drawn is kept; the same "
                                                          "command goes on from there");
    }
    return ExitCode::done;
}

}  // namespace

AddedCommand add_points_command(CommandLine& line) {
    const auto a = std::make_shared<PointsArguments>();
    CommandOptions command = line.add_command("points", "Draw a point cloud by the chaos game");
    command.add_option("scene", a->scene, "The scene file (.pxm)").required();
    command.add_option("-n,--count", a->count, "How many points")
        .required()
        .transform(whole_number(1, 1'000'000'000'000));
    command
        .add_option("-o,--out", a->out,
                    "The point cloud, binary PLY; its coordinates are doubles where "
                    "floats would not keep the shape, as far from the origin")
        .required();
    command.add_option("--seed", a->seed, "Another seed gives other points (default 1)")
        .transform(any_whole_number());
    command.add_option(
        "--keep", a->keep,
        "Put what is drawn into this folder now and then; run again, go on from there");
    command.add_option("--precision", a->precision, "float, double, or auto (default)")
        .check(some_text());
    command
        .add_option("--offset", a->offset,
                    "x,y,z that are taken off the coordinates, or auto: the cloud's middle")
        .check(some_text());
    add_threads_option(command, a->threads);
    add_limit_options(command, a->limits);
    add_set_option(command, a->set);
    add_allow_option(command, a->allowed);
    command.add_flag("--quiet", a->quiet, "No progress bar");
    return {command, [a] {
                find_scene_by_name(a->scene, a->allowed);
                hold_settings_of_picture(a->scene, a->set);
                const LimitWatch watch(a->limits.limits());
                return run_points(*a);
            }};
}

}  // namespace pxm::host
