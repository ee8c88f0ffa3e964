#include "host/study/partition.hpp"

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

#include "pxm/model.hpp"

namespace pxm::host {

namespace {

/// A well mixed number from a counter (SplitMix64).
std::uint64_t mixed(std::uint64_t counter) {
    std::uint64_t z = (counter + 1) * 0x9E37'79B9'7F4A'7C15;
    z = (z ^ z >> 30) * 0xBF58'476D'1CE4'E5B9;
    z = (z ^ z >> 27) * 0x94D0'49BB'1331'11EB;
    return z ^ z >> 31;
}

std::vector<std::uint32_t> shuffled_places(std::size_t count) {
    std::vector<std::uint32_t> places(count);
    std::iota(places.begin(), places.end(), 0U);
    for (std::size_t i = count; i > 1; --i) std::swap(places[i - 1], places[mixed(i) % i]);
    return places;
}

long holder(long x, long y, const NodeArray& array) {
    return y % array.rows * array.columns + x % array.columns;
}

/// Node of a pixel where that does not depend on what pixels cost.
long computer(const Work& work, const NodeArray& array, Partition partition, long x, long y) {
    const long nodes = array.nodes();
    switch (partition) {
        case Partition::blocks:
            return y * array.rows / work.rows * array.columns + x * array.columns / work.columns;
        case Partition::rows:
            return y * nodes / work.rows;
        case Partition::columns:
            return x * nodes / work.columns;
        case Partition::random:
            return work.shuffled[static_cast<std::size_t>(y * work.columns + x)] % nodes;
        default:
            return holder(x, y, array);
    }
}

Share static_share(const Work& work, const NodeArray& array, Partition partition,
                   const HandOutCosts& costs) {
    Share share;
    share.cycles.resize(static_cast<std::size_t>(array.nodes()));
    for (long y = 0; y < work.rows; ++y) {
        for (long x = 0; x < work.columns; ++x) {
            const long node = computer(work, array, partition, x, y);
            const std::uint64_t sent = node == holder(x, y, array) ? 0 : costs.gather;
            share.cycles[static_cast<std::size_t>(node)] += work.at(x, y) + sent;
            share.useful += work.at(x, y);
            share.overhead += sent;
        }
    }
    return share;
}

/// What a tile costs a node: its pixels, their sending, and being handed out.
struct TileCost {
    std::uint64_t useful = 0;
    std::uint64_t overhead = 0;
};

TileCost tile_cost(const Work& work, const NodeArray& array, const HandOutCosts& costs, long left,
                   long top, long node) {
    TileCost cost{0, costs.hand_out};
    for (long y = top; y < std::min(top + costs.tile, work.rows); ++y) {
        for (long x = left; x < std::min(left + costs.tile, work.columns); ++x) {
            cost.useful += work.at(x, y);
            if (holder(x, y, array) != node) cost.overhead += costs.gather;
        }
    }
    return cost;
}

Share dynamic_share(const Work& work, const NodeArray& array, const HandOutCosts& costs) {
    Share share;
    share.cycles.resize(static_cast<std::size_t>(array.nodes()));
    using Free = std::pair<std::uint64_t, long>;  // when, which node
    std::priority_queue<Free, std::vector<Free>, std::greater<>> nodes;
    for (long node = 0; node < array.nodes(); ++node) nodes.emplace(0, node);
    for (long top = 0; top < work.rows; top += costs.tile) {
        for (long left = 0; left < work.columns; left += costs.tile) {
            const auto [when, node] = nodes.top();
            nodes.pop();
            const TileCost cost = tile_cost(work, array, costs, left, top, node);
            share.useful += cost.useful;
            share.overhead += cost.overhead;
            const std::uint64_t done = when + cost.useful + cost.overhead;
            share.cycles[static_cast<std::size_t>(node)] = done;
            nodes.emplace(done, node);
        }
    }
    return share;
}

}  // namespace

Work::Work(long width, long height, std::vector<std::uint64_t> pixel_cycles)
    : columns(width),
      rows(height),
      cycles(std::move(pixel_cycles)),
      shuffled(shuffled_places(cycles.size())) {}

NodeArray array_of(long count) {
    NodeArray array;
    while (array.nodes() < count) (array.columns > array.rows ? array.rows : array.columns) *= 2;
    return array;
}

std::string_view name_of(Partition partition) {
    switch (partition) {
        case Partition::interleaved:
            return "interleaved";
        case Partition::blocks:
            return "blocks";
        case Partition::rows:
            return "rows";
        case Partition::columns:
            return "columns";
        case Partition::random:
            return "random";
        case Partition::dynamic:
            return "dynamic";
    }
    return "";
}

double Share::efficiency() const {
    if (slowest == 0) return 1;
    return static_cast<double>(useful) /
           (static_cast<double>(slowest) * static_cast<double>(cycles.size()));
}

double Share::speed_up() const { return efficiency() * static_cast<double>(cycles.size()); }

double Share::seconds() const { return static_cast<double>(slowest) * instruction_seconds; }

Share share_out(const Work& work, const NodeArray& array, Partition partition,
                const HandOutCosts& costs) {
    Share share = partition == Partition::dynamic ? dynamic_share(work, array, costs)
                                                  : static_share(work, array, partition, costs);
    share.slowest = *std::ranges::max_element(share.cycles);
    return share;
}

}  // namespace pxm::host
