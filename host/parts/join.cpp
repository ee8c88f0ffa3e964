#include "host/parts/join.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "host/output/image.hpp"
#include "host/parts/part_run.hpp"
#include "host/text/number_runs.hpp"

namespace pxm::host {

namespace {

void put(const UnitPixels& unit, const std::vector<PixelRecord>& pixels, Frame& frame) {
    std::size_t i = 0;
    for (long y = unit.y0; y < unit.y1; y += unit.step_y)
        for (long x = unit.x0; x < unit.x1; x += unit.step_x) frame.at(x, y) = pixels[i++];
}

/// The counts of one run.
class Counts {
  public:
    explicit Counts(const PartHeading& heading) : statistics_(heading.statistics) {
        if (!statistics_.machine) return;
        for (long row = 0; row < heading.grid.node_rows; ++row)
            for (long column = 0; column < heading.grid.node_columns; ++column)
                add_node(static_cast<int>(column), static_cast<int>(row));
    }

    void add(std::size_t unit, const StoredUnit& stored) {
        statistics_.rays.add(stored.rays);
        alarms_.add(stored.alarms);
        if (!statistics_.machine || !stored.node) return;
        NodeStatistics& node = statistics_.machine->nodes[unit];
        node.rays = stored.node->rays;
        node.tally = stored.node->tally;
        node.instructions = stored.node->instructions;
        node.cycles = stored.node->cycles;
        statistics_.machine->tally.add(node.tally);
    }

    [[nodiscard]] Statistics all(const AlarmBasis& basis) const {
        Statistics statistics = statistics_;
        statistics.alarms = alarms_of(basis, alarms_);
        return statistics;
    }

  private:
    void add_node(int column, int row) {
        NodeStatistics node;
        node.id = static_cast<int>(statistics_.machine->nodes.size());
        node.column = column;
        node.row = row;
        statistics_.machine->nodes.push_back(node);
    }

    Statistics statistics_;
    AlarmSums alarms_;
};

/// The pixels of a node are in all rows: they are put together first. False if it was stopped.
template <class GoOn>
bool take_nodes(PartSet& parts, Counts& counts, const TakeBlock& take, GoOn go_on) {
    Frame frame(parts.heading().statistics.size, parts.heading().grid.window);
    for (std::size_t i = 0; i < parts.units().size(); ++i) {
        if (!go_on()) return false;
        if (!parts.has(i)) continue;
        const StoredUnit stored = parts.read(i);
        put(parts.units()[i], stored.pixels, frame);
        counts.add(i, stored);
    }
    take(frame);
    return true;
}

/// Tiles go into the picture as they are read, in the memory of the one before.
template <class GoOn>
bool take_tiles(PartSet& parts, Counts& counts, const TakeBlock& take, GoOn go_on) {
    const PixelSize& image = parts.heading().statistics.size;
    Frame frame;
    for (std::size_t i = 0; i < parts.units().size(); ++i) {
        if (!go_on()) return false;
        const UnitPixels& unit = parts.units()[i];
        const CropWindow window{unit.x0, unit.y0, unit.x1, unit.y1};
        if (!parts.has(i)) {
            take(Frame(image, window));
            continue;
        }
        StoredUnit stored = parts.read(i, std::move(frame.pixels));
        counts.add(i, stored);
        frame.size = image;
        frame.crop = window;
        frame.pixels = std::move(stored.pixels);
        take(frame);
    }
    return true;
}

}  // namespace

std::optional<JoinedPicture> join(PartSet& parts, const RunControl& control,
                                  const TakeBlock& take) {
    const PartHeading& heading = parts.heading();
    Counts counts(heading);
    const auto progress = [&, done = std::size_t{0}]() mutable {
        if (control.progress)
            control.progress(static_cast<double>(++done) /
                             static_cast<double>(parts.units().size()));
        return control.stop == nullptr || !*control.stop;
    };
    const bool whole = heading.grid.of_nodes() ? take_nodes(parts, counts, take, progress)
                                               : take_tiles(parts, counts, take, progress);
    if (!whole) return std::nullopt;
    JoinedPicture picture{counts.all(heading.alarms), "", parts.missing()};
    picture.warnings =
        cap_text(picture.statistics.rays, heading.cell_cap) + alarm_text(picture.statistics.alarms);
    return picture;
}

std::optional<JoinedPicture> join(PartSet& parts, const std::string& path,
                                  const RunControl& control) {
    const PartHeading& heading = parts.heading();
    require_image_format(path, heading.channels);
    ImageWriter writer(path, heading.grid.window, heading.channels, heading.metadata);
    auto picture = join(parts, control, [&](const Frame& block) { writer.append(block); });
    if (picture) writer.finish();
    return picture;
}

namespace {

/// Those of N parts that have a missing unit.
std::set<long> parts_with(const PartSet& parts, const std::vector<std::size_t>& missing) {
    std::set<long> numbers;
    for (const std::size_t unit : missing)
        numbers.insert(part_of_unit(unit, parts.units().size(), parts.heading().parts));
    return numbers;
}

}  // namespace

std::string missing_text(const PartSet& parts) {
    const std::vector<std::size_t> missing = parts.missing();
    if (missing.empty()) return "";
    std::size_t pixels = 0, all = 0;
    for (const std::size_t unit : missing) pixels += parts.units()[unit].count();
    for (const UnitPixels& unit : parts.units()) all += unit.count();
    const std::string share = fmt::format("{} of {} pixels are black", pixels, all);
    const long count = parts.heading().parts;
    if (count == 0) {
        return fmt::format("{} of {} units are missing, {} first: {}", missing.size(),
                           parts.units().size(), parts.name_of(missing.front()), share);
    }
    const std::set<long> numbers = parts_with(parts, missing);
    return fmt::format("{} of {} parts {} missing: {}; {}", numbers.size(), count,
                       numbers.size() == 1 ? "is" : "are", number_runs(numbers), share);
}

}  // namespace pxm::host
