// What a cell of homotheties looks like along rays of nearly one direction: the same for all cells
// of a set, of any size and at any place, as no map turns a ray (Ch. 13). The plane across is
// divided into squares, and each square lists the cells some levels down that a ray through it may
// meet, front to back: a ray looks up its square instead of going down those levels.
// Conditions: balls; a direction that many rays share (the eye's rays through a part of the
// picture, the shadow rays to a directional light).
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

#include "host/wide/tables/candidate_lists.hpp"
#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

/// The tables of a scene in one view, each made when it is first asked for.
struct CandidateView {
    ViewFrame view;
    std::uint64_t number = 0;    // another one for every view
    long column = -1, row = -1;  // of the picture's part
    std::vector<std::unique_ptr<CandidateLists>> tables;

    [[nodiscard]] const CandidateLists& table(const WideScene& scene, int object, int set,
                                              const HomothetyTable& cells) {
        const auto turn =
            static_cast<std::size_t>(scene.objects[static_cast<std::size_t>(object)].turn);
        const std::size_t turned = turn * scene.sets.size() + static_cast<std::size_t>(set);
        std::unique_ptr<CandidateLists>& table =
            tables[turned * HomothetyTable::most_steps + static_cast<std::size_t>(cells.steps) - 1];
        if (!table) table = std::make_unique<CandidateLists>();
        if (table->made_for != number) make(*table, scene.turns[turn], cells);
        return *table;
    }

  private:
    void make(CandidateLists& table, const glm::dmat3& turn, const HomothetyTable& cells) const;
};

struct CandidateViewOf;
struct RayPacket;

/// The view of a packet, of those kept in `candidate_views`: its own, where rays of a part of the
/// picture go too far aside, or objects are turned in too many ways.
[[nodiscard]] CandidateView& candidate_view_of(const WideScene& scene, const RayPacket& packet,
                                               std::vector<CandidateView>& candidate_views);

/// The side in pixels of the parts of a picture that share a view, a multiple of tile_side.
[[nodiscard]] long candidate_view_side(const CompiledCamera& camera, const PixelSize& size);

}  // namespace pxm::host::wide
