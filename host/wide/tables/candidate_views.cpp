#include "host/wide/tables/candidate_views.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/wide/packet/ray_packet.hpp"

namespace pxm::host::wide {

namespace {

// Of objects with lists: those that are turned otherwise have lists of their own.
constexpr std::size_t most_turns = 8;
// Of lists: what there is of them for one view takes up to 30 MB.
constexpr std::size_t most_listed = std::size_t{1} << 16;
constexpr std::size_t most_lights = 6;  // further ones have no lists
constexpr double least_pace = 0.7;      // of a part's rays along its axis: few pixels, seen wide

}  // namespace

void CandidateView::make(CandidateLists& table, const glm::dmat3& turn,
                         const HomothetyTable& cells) const {
    glm::dmat3 to_frame;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 unit = glm::normalize(turn * view.axis[axis]);
        for (int i = 0; i < 3; ++i) to_frame[i][axis] = unit[i];
    }
    table.make(cells, to_frame, view);
    table.made_for = number;
}

namespace {

/// Axes that look along w.
void look_along(ViewFrame& view, const glm::dvec3& w) {
    const glm::dvec3 other = std::abs(w.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    view.axis[2] = w;
    view.axis[0] = glm::normalize(glm::cross(other, w));
    view.axis[1] = glm::cross(w, view.axis[0]);
}

/// The part of the picture whose first pixel is (left, top).
ViewFrame view_of_part(const WideScene& scene, long left, long top) {
    const CompiledCamera& camera = scene.camera;
    ViewFrame view;
    view.shared = true;
    if (camera.projection != kernels::Projection::perspective) {
        look_along(view, glm::normalize(camera.forward));
        return view;
    }
    const auto ray = [&](long column, long row) {
        return glm::normalize(camera.corner + camera.across * static_cast<double>(column) +
                              camera.down * static_cast<double>(row));
    };
    const long right = std::min(left + scene.candidate_view_side, scene.size.columns);
    const long bottom = std::min(top + scene.candidate_view_side, scene.size.rows);
    glm::dvec3 middle{0.0};
    for (const long row : {top, bottom}) {
        for (const long column : {left, right}) middle += ray(column, row);
    }
    look_along(view, glm::normalize(middle));
    for (const long row : {top, bottom}) {
        for (const long column : {left, right}) {
            const double pace = glm::dot(ray(column, row), view.axis[2]);
            view.shared = view.shared && least_pace <= pace;
            view.reach = std::max(view.reach, std::sqrt(std::max(0.0, 1 / (pace * pace) - 1)));
        }
    }
    return view;
}

}  // namespace

long candidate_view_side(const CompiledCamera& camera, const PixelSize& size) {
    constexpr double widest = 0.1;  // of the tangents that rays of a part may have between them
    constexpr long least = 4 * tile_side;
    const long whole = (std::max(size.columns, size.rows) / tile_side + 1) * tile_side;
    if (camera.projection != kernels::Projection::perspective) return whole;
    const glm::dvec3 middle = camera.corner +
                              camera.across * (static_cast<double>(size.columns) / 2) +
                              camera.down * (static_cast<double>(size.rows) / 2);
    const double pixels = widest * glm::length(middle) / glm::length(camera.across);
    if (!(pixels < static_cast<double>(whole))) return whole;
    return std::max(least, static_cast<long>(pixels) / tile_side * tile_side);
}

namespace {

void begin(CandidateView& candidate_view, const ViewFrame& view) {
    candidate_view.view = view;
    ++candidate_view.number;
}

CandidateView& own_candidate_view(const RayPacket& packet, CandidateView& candidate_view) {
    begin(candidate_view, {{packet.axis[0], packet.axis[1], packet.axis[2]}, 0, false});
    return candidate_view;
}

/// That of the part of the picture in which a tile's first pixel is.
CandidateView& candidate_view_of_part(const WideScene& scene, const CandidateViewOf& of,
                                      CandidateView& candidate_view) {
    const long side = scene.candidate_view_side, column = of.column / side, row = of.row / side;
    if (candidate_view.number > 0 && candidate_view.column == column && candidate_view.row == row)
        return candidate_view;
    candidate_view.column = column;
    candidate_view.row = row;
    begin(candidate_view, view_of_part(scene, column * side, row * side));
    return candidate_view;
}

CandidateView& candidate_view_of_light(const WideScene& scene, std::size_t light,
                                       CandidateView& candidate_view) {
    constexpr double parallel = 1e-6;  // what rounding makes of it
    if (candidate_view.number > 0) return candidate_view;
    ViewFrame view;
    view.reach = parallel;
    view.shared = true;
    look_along(view, scene.lights[light].place);
    begin(candidate_view, view);
    return candidate_view;
}

}  // namespace

CandidateView& candidate_view_of(const WideScene& scene, const RayPacket& packet,
                                 std::vector<CandidateView>& candidate_views) {
    const CandidateViewOf& of = packet.candidate_view;
    const bool has_lists = scene.turns.size() <= most_turns &&
                           scene.turns.size() * scene.composed_cells <= most_listed;
    const std::size_t lights = has_lists ? std::min(scene.lights.size(), most_lights) : 0;
    if (candidate_views.empty()) {
        candidate_views = std::vector<CandidateView>(has_lists ? 2 + lights : 1);
        for (CandidateView& candidate_view : candidate_views) {
            candidate_view.tables.resize(scene.turns.size() * scene.sets.size() *
                                         HomothetyTable::most_steps);
        }
    }
    if (has_lists) {
        if (of.kind == CandidateViewOf::Kind::light && of.column < static_cast<long>(lights)) {
            const auto light = static_cast<std::size_t>(of.column);
            return candidate_view_of_light(scene, light, candidate_views[2 + light]);
        }
        if (of.kind == CandidateViewOf::Kind::eye) {
            CandidateView& part = candidate_view_of_part(scene, of, candidate_views[1]);
            if (part.view.shared) return part;
        }
    }
    return own_candidate_view(packet, candidate_views[0]);
}

}  // namespace pxm::host::wide
