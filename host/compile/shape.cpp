#include "host/compile/shape.hpp"

#include <algorithm>
#include <cmath>

#include "host/compiled/bounding_volume.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

/// For every map the diameter of the largest volume that it may stand in.
std::vector<double> diameters_around(const Rifs& rifs, const std::vector<CompiledVolume>& volumes) {
    std::vector<double> around(rifs.maps.size(), 0);
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        for (const int map : rifs.follow_sets[s].maps) {
            double& largest = around[static_cast<std::size_t>(map)];
            largest = std::max(largest, volumes[s].diameter);
        }
    }
    return around;
}

}  // namespace

ShapeFrame frame_around(const Ball& ball) { return {ball.center, power_of_two_near(ball.radius)}; }

double power_of_two_near(double x) {
    return x > 0 && std::isfinite(x) ? std::exp2(std::round(std::log2(x))) : 1.0;
}

kernels::Lipschitz choose_lipschitz(LipschitzMethod method, const Rifs& rifs) {
    switch (method) {
        case LipschitzMethod::product:
            return kernels::Lipschitz::product;
        case LipschitzMethod::determinant:
            return kernels::Lipschitz::determinant;
        case LipschitzMethod::polar:
            return kernels::Lipschitz::polar;
        case LipschitzMethod::automatic:
            break;
    }
    const bool similar = std::ranges::all_of(rifs.maps, [](const Affine& map) {
        const MapKind kind = classify(map);
        return kind == MapKind::homothety || kind == MapKind::similitude;
    });
    return similar ? kernels::Lipschitz::product : kernels::Lipschitz::polar;
}

double constant_by(kernels::Lipschitz method, const Affine& map) {
    return method == kernels::Lipschitz::determinant ? determinant_constant(map)
                                                     : lipschitz_constant(map);
}

CompiledShape make_shape(const Rifs& rifs, const std::vector<CompiledVolume>& volumes,
                         const ShapeFrame& frame, kernels::Lipschitz method) {
    CompiledShape shape;
    shape.ifs = rifs.name;
    shape.map_names = rifs.map_names;
    shape.start = rifs.start;
    shape.lipschitz = method;
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        shape.sets.push_back(
            {in_frame(volumes[s], frame.center, frame.scale), rifs.follow_sets[s].maps});
    }
    const std::vector<double> around = diameters_around(rifs, volumes);
    for (std::size_t i = 0; i < rifs.maps.size(); ++i) {
        const Affine& map = rifs.maps[i];
        const auto set = static_cast<std::size_t>(rifs.follow_of[i]);
        shape.maps.push_back({{map.linear, (map.point(frame.center) - frame.center) / frame.scale},
                              constant_by(method, map),
                              smallest_singular_value(map) * volumes[set].diameter / around[i],
                              glm::dvec4{0.0},
                              rifs.follow_of[i],
                              {}});
    }
    return shape;
}

}  // namespace pxm::host
