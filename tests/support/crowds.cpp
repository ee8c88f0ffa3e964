#include "tests/support/crowds.hpp"

#include <fmt/format.h>

#include "dsp_kernels/pixel_program.hpp"
#include "host/node_program/crowded.hpp"
#include "host/node_program/write_scene_block.hpp"

namespace pxm::test {

namespace {

std::string image_of(int side) { return fmt::format("image {{ size: {},{} }}\n", side, side); }

constexpr const char* from_the_front =
    "camera c { eye: 0.5,0.5,-5  look: 0.5,0.5,0  orthographic: 1.2 }\n";

}  // namespace

std::string fat_square(int side) {
    return "ifs fat { newmap scale: 0.8  newmap scale: 0.8 translate: 0.2,0,0\n"
           "newmap scale: 0.8 translate: 0,0.2,0  newmap scale: 0.8 translate: 0.2,0.2,0 }\n" +
           std::string(from_the_front) + image_of(side);
}

std::string fat_cube(int side) {
    std::string text = "ifs cube {\n";
    for (int i = 0; i < 8; ++i) {
        text += fmt::format("newmap scale: 0.7 translate: {},{},{}\n", i & 1 ? 0.3 : 0.0,
                            i & 2 ? 0.3 : 0.0, i & 4 ? 0.3 : 0.0);
    }
    return text + "}\ncamera c { eye: 2.5,3,-5  look: 0.5,0.5,0.5  fov: 20 }\n" + image_of(side);
}

std::string square_of_coinciding_cells(int side) {
    std::string text = "ifs grid {\n";
    for (int x = 0; x < 5; ++x) {
        for (int y = 0; y < 5; ++y) {
            text += fmt::format("newmap scale: 1/2 translate: {}/8,{}/8,0\n", x, y);
        }
    }
    return text + "}\n" + from_the_front + image_of(side) +
           "render { volume: sphere  detail: 2 }\n";
}

std::vector<SeenPixel> look_at(const host::CompiledScene& scene, double known_share) {
    using Node = host::NativeNode<double>;
    const std::vector<std::uint32_t> block = host::make_scene_block<double>(scene);
    Node node(block, scene.texture_words, host::crowded_heap, sizeof(kernels::Cell<double>),
              known_share);
    const auto side = [](long pixels) { return static_cast<std::uint32_t>(pixels); };
    std::vector<SeenPixel> pixels;
    kernels::pixel_program<kernels::plain_features>(
        node, {0, 0, side(scene.size.columns), side(scene.size.rows), 1, 1},
        [&](std::uint32_t, std::uint32_t, const kernels::PixelResult<double>& pixel) {
            const kernels::Cell<double>& cell = pixel.found.cell;
            SeenPixel& seen = pixels.emplace_back(SeenPixel{});
            seen.outcome = pixel.found.outcome;
            seen.tested = pixel.counts.volumes_tested;
            if (seen.outcome == kernels::Outcome::miss) return true;
            seen.key = cell.key;
            for (std::uint32_t i = 0; i < cell.level; ++i) {
                seen.word.push_back(cell.word.get(i, cell.bits));
            }
            return true;
        });
    return pixels;
}

}  // namespace pxm::test
