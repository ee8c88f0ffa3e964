// Golden pictures: every folder of tests/golden holds a scene, the picture it once made on a 964dX
// with dsp32 numbers, and a few numbers. All of it is compared exactly, the scene block first: if
// it differs, then the host's double arithmetic does, and not the node's. tests/golden/rebaseline
// makes the expected files anew.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "host/render/render.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

const std::string golden_dir = test::source_dir + "/tests/golden";

std::vector<std::string> golden_cases() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(golden_dir)) {
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

/// FNV-1a over 32-bit words.
class Hash {
  public:
    void add(std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) {
            hash_ = (hash_ ^ (word >> shift & 0xFF)) * 0x100'0000'01B3;
        }
    }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
    [[nodiscard]] std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xCBF2'9CE4'8422'2325;
};

/// What is compared of a render, as lines of `name value`, and its pixels as linear bytes.
struct Golden {
    std::string block;
    std::string pixels;  // colours, depths, normals, cells in full precision
    std::string cycles;
    std::vector<std::uint8_t> bytes;
};

Golden golden_of(const RenderResult& result) {
    Hash hash;
    std::uint64_t cycles = 0;
    Golden golden;
    for (const PixelRecord& pixel : result.frame.pixels) {
        for (const float channel : pixel.color) {
            hash.add(channel);
            golden.bytes.push_back(
                static_cast<std::uint8_t>(std::clamp(channel, 0.0F, 1.0F) * 255.0F + 0.5F));
        }
        for (const float coordinate : pixel.normal) hash.add(coordinate);
        hash.add(pixel.z);
        hash.add(static_cast<std::uint32_t>(pixel.object));
        hash.add(static_cast<std::uint32_t>(pixel.level));
        hash.add(pixel.word);
        cycles += pixel.cycles;
    }
    golden.block = "scene_block " + std::to_string(result.statistics.scene_block_hash);
    golden.pixels = "pixels " + std::to_string(hash.value());
    golden.cycles = "cycles " + std::to_string(cycles);
    return golden;
}

constexpr int side = 64;  // pixels

void write_golden(const std::string& folder, const Golden& golden) {
    std::ofstream(folder + "/expected.txt") << golden.block << '\n'
                                            << golden.pixels << '\n'
                                            << golden.cycles << '\n';
    const std::string path = folder + "/expected.png";
    const auto file = OIIO::ImageOutput::create(path);
    const OIIO::ImageSpec spec(side, side, 3, OIIO::TypeDesc::UINT8);
    if (!file || !file->open(path, spec) ||
        !file->write_image(OIIO::TypeDesc::UINT8, golden.bytes.data()) || !file->close()) {
        throw std::runtime_error("cannot write " + path);
    }
}

Golden read_golden(const std::string& folder) {
    Golden golden;
    std::ifstream text(folder + "/expected.txt");
    std::getline(text, golden.block);
    std::getline(text, golden.pixels);
    std::getline(text, golden.cycles);
    const auto file = OIIO::ImageInput::open(folder + "/expected.png");
    golden.bytes.resize(std::size_t{3} * side * side);
    if (!file || file->spec().nchannels != 3 || file->spec().width != side ||
        !file->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, golden.bytes.data())) {
        golden.bytes.clear();
    }
    return golden;
}

class GoldenPicture : public testing::TestWithParam<std::string> {};

TEST_P(GoldenPicture, is_the_same_in_every_bit) {
    const std::string folder = golden_dir + "/" + GetParam();
    RenderRequest request;
    request.scene_path = folder + "/scene.pxm";
    request.machine = find_model("964dX");
    request.threads = 2;
    const RenderResult result = render(request, {});
    ASSERT_EQ(result.frame.pixels.size(), std::size_t{side} * side);
    EXPECT_GT(result.statistics.rays.hits, 100U);
    const Golden golden = golden_of(result);
    if (std::getenv("PXM_REBASELINE") != nullptr) {
        write_golden(folder, golden);
        return;
    }
    const Golden expected = read_golden(folder);
    ASSERT_EQ(golden.block, expected.block) << "the host's double arithmetic differs";
    ASSERT_EQ(golden.bytes.size(), expected.bytes.size()) << "no picture " << folder;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < golden.bytes.size(); i += 3) {
        differing += std::equal(&golden.bytes[i], &golden.bytes[i] + 3, &expected.bytes[i]) ? 0 : 1;
    }
    EXPECT_EQ(differing, 0U) << "pixels of " << folder << "/expected.png";
    EXPECT_EQ(golden.pixels, expected.pixels) << "depths, normals or cells";
    EXPECT_EQ(golden.cycles, expected.cycles);
}

INSTANTIATE_TEST_SUITE_P(Case, GoldenPicture, testing::ValuesIn(golden_cases()),
                         [](const auto& test_case) { return test_case.param; });

}  // namespace
}  // namespace pxm::host
