// Renders by the node program in DSP32 code, beside those of the counted kernels.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/render/render.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {

inline std::filesystem::path scene_file(const std::string& name) {
    return std::filesystem::path(test::source_dir) / "scenes" / (name + ".pxm");
}

/// A request for the node program in DSP32 code: with balls, and constants that are products.
inline RenderRequest assembled(const char* model, long columns, long rows) {
    RenderRequest request = test::on_machine(model, columns, rows);
    request.code = NodeCode::assembled;
    request.overrides.volume = VolumeKind::sphere;
    request.overrides.lipschitz = LipschitzMethod::product;
    return request;
}

inline RenderResult render_scene(const std::string& name, RenderRequest request) {
    request.scene_path = scene_file(name).string();
    return render(request, {});
}

/// Expects the picture of the counted kernels, with all that is known of its pixels.
inline void expect_same(const std::string& name, RenderRequest request) {
    const RenderResult own = render_scene(name, request);
    request.code = NodeCode::counted;
    const RenderResult counted = render_scene(name, request);
    EXPECT_TRUE(test::same_picture(own.frame, counted.frame)) << name;
    EXPECT_GT(counted.statistics.rays.hits, 8U) << name;
    for (std::size_t i = 0; i < own.frame.pixels.size(); ++i) {
        const PixelRecord &a = own.frame.pixels[i], &b = counted.frame.pixels[i];
        ASSERT_EQ(a.alpha, b.alpha) << name << " " << i;
        ASSERT_EQ(a.volumes, b.volumes) << name << " " << i;
        ASSERT_EQ(a.node, b.node) << name << " " << i;
        ASSERT_EQ(a.alarms, b.alarms) << name << " " << i;
        ASSERT_GT(a.cycles, 0U) << name << " " << i;
    }
    EXPECT_EQ(own.statistics.rays.volumes_tested, counted.statistics.rays.volumes_tested);
    EXPECT_EQ(own.statistics.rays.hits, counted.statistics.rays.hits);
}

}  // namespace pxm::host
