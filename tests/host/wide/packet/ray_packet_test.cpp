// Packets of rays against the rays that they are made of, one by one in double.
#include "host/wide/packet/ray_packet.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace pxm::test {
namespace {

using namespace host;
using namespace host::wide;

/// Where lane `i` of a packet is at depth z.
glm::dvec3 at_depth(const RayPacket& packet, std::size_t i, double z) {
    const double u = static_cast<double>(packet.u0[i]) + static_cast<double>(packet.u1[i]) * z;
    const double v = static_cast<double>(packet.v0[i]) + static_cast<double>(packet.v1[i]) * z;
    return packet.origin + packet.axis[0] * u + packet.axis[1] * v + packet.axis[2] * z;
}

std::vector<LoneRay> random_rays(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] { return glm::dvec3{unit(random), unit(random), unit(random)}; };
    const glm::dvec3 origin = 10.0 * vector(), direction = glm::normalize(vector());
    std::vector<LoneRay> rays;
    for (std::size_t i = 0; i < count; ++i) {
        rays.push_back({origin + 1e-3 * vector(), glm::normalize(direction + 1e-4 * vector()),
                        0.5 + 0.1 * unit(random), 20 + unit(random), 1e-3, 1e-4});
    }
    return rays;
}

TEST(RayPacket, every_lane_is_its_ray) {
    std::mt19937 random(11);
    const auto packet = std::make_unique<RayPacket>();
    for (int trial = 0; trial < 100; ++trial) {
        const std::vector<LoneRay> rays = random_rays(random, 1 + trial % packet_rays);
        gather_rays(*packet, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const LoneRay& ray = rays[i];
            ASSERT_TRUE(packet->inside >> i & 1);
            EXPECT_NEAR(
                glm::dot(ray.origin + ray.end * ray.direction - packet->origin, packet->axis[2]),
                packet->end[i], 1e-9);
            for (const double t : {ray.start, 3.0, ray.end}) {
                const glm::dvec3 point = ray.origin + t * ray.direction;
                const double z = glm::dot(point - packet->origin, packet->axis[2]);
                EXPECT_LT(glm::distance(at_depth(*packet, i, z), point), 1e-7);
                const double pixel = static_cast<double>(packet->pixel0[i]) +
                                     static_cast<double>(packet->pixel1[i]) * z;
                EXPECT_NEAR(pixel, ray.pixel_at_origin + ray.pixel_growth * t, 1e-7);
                EXPECT_LE(packet->pixel_at_origin + packet->pixel_growth * z, pixel * (1 + 1e-6));
                EXPECT_GE(packet->most_at_origin + packet->most_growth * z, pixel * (1 - 1e-6));
            }
            EXPECT_LE(std::abs(packet->u0[i]), packet->reach_u0 * (1 + 1e-6));
            EXPECT_LE(std::abs(packet->u1[i]), packet->reach_u1 * (1 + 1e-6));
            EXPECT_LE(std::abs(packet->v0[i]), packet->reach_v0 * (1 + 1e-6));
            EXPECT_LE(std::abs(packet->v1[i]), packet->reach_v1 * (1 + 1e-6));
        }
        EXPECT_EQ(std::popcount(packet->inside), static_cast<int>(rays.size()));
    }
}

TEST(RayPacket, a_tile_has_the_eye_rays_of_its_pixels_inside_the_window) {
    CompiledCamera camera;
    camera.projection = kernels::Projection::perspective;
    camera.forward = {0, 0, -1};
    camera.corner = {-1, 0.75, -2};
    camera.across = {0.01, 0, 0};
    camera.down = {0, -0.01, 0};
    const CropWindow window{10, 3, 100, 90};
    const auto packet = std::make_unique<RayPacket>();
    const glm::dvec2 place{0.25, 0.75};
    for (const auto& [left, top] : {std::pair<long, long>{8, 0}, {16, 16}, {96, 88}}) {
        aim_at_tile(*packet, camera, window, {left, top}, place);
        for (int ray = 0; ray < packet_rays; ++ray) {
            const long x = left + ray % 8, y = top + ray / 8;
            const bool wanted = x >= 10 && x < 100 && y >= 3 && y < 90;
            EXPECT_EQ(packet->inside >> ray & 1, wanted ? 1U : 0U);
            const glm::dvec3 expected = camera.corner +
                                        camera.across * (static_cast<double>(x) + place.x) +
                                        camera.down * (static_cast<double>(y) + place.y);
            const glm::dvec3 p = packet->fan.first + packet->fan.per_column * double(ray % 8) +
                                 packet->fan.per_row * double(ray / 8);
            const glm::dvec3 found =
                packet->axis[0] * p.x + packet->axis[1] * p.y + packet->axis[2] * p.z;
            EXPECT_LT(glm::distance(found, expected), 1e-12);
            EXPECT_LE(std::abs(p.x / p.z), packet->reach_u1 * (1 + 1e-12));
            EXPECT_LE(std::abs(p.y / p.z), packet->reach_v1 * (1 + 1e-12));
        }
    }
}

TEST(RayPacket, rays_that_part_do_not_go_together) {
    const LoneRay ray{{0, 0, 0}, {0, 0, 1}, 0, 10, 0.01, 0};
    LoneRay beside = ray, turned = ray, parting = ray;
    beside.origin.x = 0.1;
    turned.direction = glm::normalize(glm::dvec3{0.1, 0, 1});
    parting.direction = glm::normalize(glm::dvec3{0.014, 0, 1});
    parting.end = 100;
    EXPECT_TRUE(go_together(ray, beside));
    beside.origin.x = 0.2;
    EXPECT_FALSE(go_together(ray, beside));
    EXPECT_FALSE(go_together(ray, turned));
    EXPECT_FALSE(go_together(ray, parting));
}

}  // namespace
}  // namespace pxm::test
