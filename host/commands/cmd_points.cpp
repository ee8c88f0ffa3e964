// `pxm points SCENE -n N -o OUT.ply`: the attractors drawn the explicit way (Alg. 7.1).
#include <algorithm>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/shared_options.hpp"
#include "host/compile/proven_rifs.hpp"
#include "host/files/safe_file.hpp"
#include "host/fractal/dimension/default_weights.hpp"
#include "host/fractal/measure/chaos_game.hpp"
#include "host/output/ply.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/check/settings.hpp"
#include "host/scene/default_objects.hpp"

namespace pxm::host {

namespace {

constexpr std::uint64_t points_between_looks = 1 << 16;  // at the stop flag and the progress bar

struct PointsArguments {
    std::string scene;
    std::string out;
    std::vector<std::string> set;
    std::vector<std::string> allowed;
    std::uint64_t count = 0;
    std::uint64_t seed = 1;
    bool quiet = false;
};

/// An object with the game that draws it.
struct Player {
    ChaosGame game;
    Affine instance;
    glm::dvec3 color;
};

std::vector<double> weights_of(const IfsBlock& block, const Rifs& rifs) {
    std::vector<double> weights = default_weights(rifs);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (block.maps[i].weight) weights[i] = *block.maps[i].weight;
    }
    return weights;
}

/// One player per object that is a fractal.
std::vector<Player> make_players(const Scene& scene, std::uint64_t seed, Diagnostics& diagnostics) {
    constexpr glm::dvec3 base_color{0.9, 0.9, 0.9};
    std::vector<Player> players;
    for (const ObjectBlock& object : objects_of(scene)) {
        if (!object.ifs) {
            diagnostics.warning(object.position, "an object without ifs has no points: left out");
            continue;
        }
        const auto block = std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name);
        const auto proven = prove_rifs(*block, diagnostics);
        if (!proven) continue;
        std::vector<glm::dvec4> colors;
        for (const MapBlock& map : block->maps)
            colors.push_back(map.color.value_or(glm::dvec4{0.0}));
        const glm::dvec4 paint = object.color.value_or(glm::dvec4{0.0});
        players.push_back({ChaosGame(proven->rifs, weights_of(*block, proven->rifs), colors, seed,
                                     static_cast<std::uint32_t>(players.size())),
                           compose(object.commands),
                           base_color * (1 - paint.a) + glm::dvec3{paint} * paint.a});
    }
    if (players.empty() && !diagnostics.has_errors()) {
        diagnostics.error({}, "the scene has no linear fractal to draw points of");
    }
    return players;
}

/// What the first points of each object say of all; a copy of its game draws them.
CoordinateNumber number_for_players(const std::vector<Player>& players) {
    constexpr int looked_at = 4096;
    std::vector<CloudExtent> extents;
    for (Player player : players) {
        CloudExtent& extent = extents.emplace_back();
        for (int i = 0; i < looked_at; ++i)
            extent.add(player.instance.point(player.game.next().place));
    }
    return number_for(extents);
}

/// False if a signal came.
bool draw_points(std::vector<Player>& players, std::uint64_t count, PlyWriter& file,
                 Progress& progress) {
    std::uint64_t drawn = 0;
    for (std::size_t i = 0; i < players.size(); ++i) {
        Player& player = players[i];
        const std::uint64_t last = count / players.size() * (i + 1) +
                                   std::min<std::uint64_t>(count % players.size(), i + 1);
        for (; drawn < last; ++drawn) {
            const CloudPoint point = player.game.next();
            file.add(player.instance.point(point.place), point.blend.of(player.color));
            if (drawn % points_between_looks == 0) {
                if (stop_requested()) return false;
                progress.update(static_cast<double>(drawn) / static_cast<double>(count));
            }
        }
    }
    return true;
}

ExitCode run_points(const PointsArguments& arguments) {
    const Settings settings = parse_settings(arguments.set);
    require_writable(arguments.out);
    Diagnostics diagnostics;
    const Scene scene = parse_scene(arguments.scene, settings, diagnostics, arguments.allowed);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    std::vector<Player> players;
    if (!diagnostics.has_errors()) players = make_players(scene, arguments.seed, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    require_spared({arguments.out}, inputs_of(scene));
    const std::string warnings = diagnostics.warnings_text(scene.files);
    if (!warnings.empty()) tell(warnings + "\n");

    struct Stopped {};
    try {
        write_safely(arguments.out, [&](CheckedFile& output) {
            Progress progress(arguments.quiet);
            PlyWriter file(output, arguments.count,
                           "pxm " PXM_VERSION " points of " + arguments.scene,
                           number_for_players(players));
            if (!draw_points(players, arguments.count, file, progress)) throw Stopped{};
            file.finish();
        });
    } catch (const Stopped&) {
        return exit_code_of_signal(received_signal());
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
    add_set_option(command, a->set);
    add_allow_option(command, a->allowed);
    command.add_flag("--quiet", a->quiet, "No progress bar");
    return {command, [a] { return run_points(*a); }};
}

}  // namespace pxm::host
