// Laws of pictures for compositing programs: Cryptomatte, channels of 16 bits, windows of a larger
// image. They are read by OpenImageIO, and decoded here from their specification.
#define FMT_EXCEPTIONS 1  // OpenImageIO's headers would switch them off
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/output/cryptomatte.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

struct Exr {
    OIIO::ImageSpec spec;
    std::vector<float> values;

    [[nodiscard]] float at(std::size_t pixel, const std::string& channel) const {
        const int c = spec.channelindex(channel);
        EXPECT_GE(c, 0) << channel;
        return values[pixel * static_cast<std::size_t>(spec.nchannels) +
                      static_cast<std::size_t>(c)];
    }
    [[nodiscard]] std::size_t pixels() const { return spec.image_pixels(); }
};

Exr read_exr(const std::string& path) {
    const auto file = OIIO::ImageInput::open(path);
    EXPECT_TRUE(file) << OIIO::geterror();
    Exr exr;
    if (!file) return exr;
    exr.spec = file->spec();
    exr.values.resize(exr.spec.image_pixels() * static_cast<std::size_t>(exr.spec.nchannels));
    EXPECT_TRUE(
        file->read_image(0, 0, 0, exr.spec.nchannels, OIIO::TypeDesc::FLOAT, exr.values.data()));
    return exr;
}

/// The manifest of a layer: names by their hashes, in hexadecimal digits.
std::map<std::uint32_t, std::string> manifest_of(const Exr& exr, const std::string& layer) {
    std::map<std::uint32_t, std::string> names;
    for (const auto& attribute : exr.spec.extra_attribs) {
        const std::string key = attribute.name().string();
        if (!key.starts_with("cryptomatte/") || !key.ends_with("/name") ||
            attribute.get_string() != layer)
            continue;
        const std::string start = key.substr(0, key.size() - 4);
        EXPECT_EQ(start.size(), std::string("cryptomatte/1234567/").size());
        EXPECT_EQ(exr.spec.get_string_attribute(start + "hash"), "MurmurHash3_32");
        EXPECT_EQ(exr.spec.get_string_attribute(start + "conversion"), "uint32_to_float32");
        const auto json =
            nlohmann::json::parse(exr.spec.get_string_attribute(start + "manifest").c_str());
        for (const auto& [name, hash] : json.items())
            names[static_cast<std::uint32_t>(std::stoul(hash.get<std::string>(), nullptr, 16))] =
                name;
    }
    return names;
}

/// The shares of the names in a pixel.
std::map<std::string, float> shares_of(const Exr& exr, const std::string& layer,
                                       std::size_t pixel) {
    const auto names = manifest_of(exr, layer);
    std::map<std::string, float> shares;
    float before = 2;
    for (int i = 0; i < 3; ++i) {
        for (const std::string pair : {"RG", "BA"}) {
            const std::string start = layer + "0" + std::to_string(i) + ".";
            const float id = exr.at(pixel, start + pair[0]);
            const float share = exr.at(pixel, start + pair[1]);
            EXPECT_LE(share, before) << "the largest first";
            before = share;
            if (share == 0) continue;
            const auto name = names.find(std::bit_cast<std::uint32_t>(id));
            EXPECT_NE(name, names.end()) << "an id that the manifest does not have";
            if (name != names.end()) shares[name->second] += share;
        }
    }
    return shares;
}

class Compositing : public testing::Test {
  protected:
    Compositing() {
        folder.write("two.pxm",
                     "ifs t { newmap low scale: .5 newmap high scale: .5 translate: 1,1,0 "
                     "newmap scale: .5 translate: 1,0,1 }\n"
                     "object left { ifs: t }\n"
                     "object right { ifs: t translate: 1.5,0,0 }\n"
                     "plane { point: 0,-.5,0 normal: 0,1,0 }\n");
    }
    [[nodiscard]] Exr render(const Arguments& options, const std::string& scene = "two.pxm") const {
        Arguments command{"render", scene, "-o", "a.exr", "--quiet", "--size", "32x24"};
        command.insert(command.end(), options.begin(), options.end());
        expect_done(folder, command);
        return read_exr(folder.path("a.exr"));
    }
    Folder folder;
};

TEST(Murmur3, has_the_values_of_its_author) {
    // Published test vectors of MurmurHash3_x86_32 with the seed 0.
    EXPECT_EQ(host::murmur3(""), 0U);
    EXPECT_EQ(host::murmur3("test"), 0xba6bd213U);
    EXPECT_EQ(host::murmur3("Hello, world!"), 0xc0363e43U);
    EXPECT_EQ(host::murmur3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723U);
    EXPECT_EQ(host::murmur3(std::string("\0\0\0\0", 4)), 0x2362f9deU);
    EXPECT_EQ(host::murmur3("\x21\x43\x65"), 0x7e4a8634U);
    EXPECT_EQ(host::murmur3("\xff\xff\xff\xff"), 0x76293b50U);
}

TEST(Murmur3, ids_are_floats_that_nothing_changes) {
    for (int i = 0; i < 20'000; ++i) {
        const std::uint32_t hash = host::matte_hash(std::to_string(i));
        EXPECT_TRUE(std::isnormal(std::bit_cast<float>(hash))) << i;
        EXPECT_EQ((hash ^ host::murmur3(std::to_string(i))) & ~(1U << 23U), 0U);
    }
}

TEST_F(Compositing, a_matte_of_one_sample_is_the_object_that_is_seen) {
    const Exr exr = render({"--cryptomatte", "object", "--aov", "object,alpha"});
    const std::vector<std::string> names{"left", "right", "plane"};
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < exr.pixels(); ++i) {
        const auto object = static_cast<int>(exr.at(i, "object.V"));
        const auto shares = shares_of(exr, "CryptoObject", i);
        if (object < 0) {
            EXPECT_TRUE(shares.empty());
            continue;
        }
        ASSERT_EQ(shares.size(), 1U);
        EXPECT_EQ(shares.begin()->first, names.at(static_cast<std::size_t>(object)));
        EXPECT_EQ(shares.begin()->second, exr.at(i, "alpha.V"));
        ++seen[shares.begin()->first];
    }
    EXPECT_EQ(seen.size(), 3U);
}

TEST_F(Compositing, shares_are_those_of_the_samples) {
    const Exr exr = render({"--cryptomatte", "object", "--samples", "16", "--aov", "alpha"});
    int mixed = 0;
    for (std::size_t i = 0; i < exr.pixels(); ++i) {
        float sum = 0;
        const auto shares = shares_of(exr, "CryptoObject", i);
        for (const auto& [name, share] : shares) {
            sum += share;
            EXPECT_EQ(share * 16, std::round(share * 16)) << "sixteenths";
        }
        EXPECT_NEAR(sum, exr.at(i, "alpha.V"), 1e-6);
        if (shares.size() > 1) ++mixed;
    }
    EXPECT_GT(mixed, 20);
}

TEST_F(Compositing, maps_divide_the_objects) {
    const Exr exr = render({"--cryptomatte", "object,map", "--samples", "4"});
    std::map<std::string, float> maps;
    float moved = 0, all = 0;
    for (std::size_t i = 0; i < exr.pixels(); ++i) {
        std::map<std::string, float> by_object;
        for (const auto& [name, share] : shares_of(exr, "CryptoMap", i)) {
            by_object[name.substr(0, name.find('/'))] += share;
            maps[name] += share;
        }
        for (const auto& [name, share] : shares_of(exr, "CryptoObject", i)) {
            moved += std::abs(share - by_object[name]);
            all += share;
        }
    }
    EXPECT_EQ(maps.size(), 7U);
    for (const char* name : {"left/low", "left/high", "left/3", "right/low", "plane"})
        EXPECT_GT(maps[name], 1) << name;
    // The cells of a part end a little elsewhere than those of the whole.
    EXPECT_LT(moved, 0.02F * all);
}

TEST_F(Compositing, mattes_change_no_colour) {
    const Exr plain = render({});
    const Exr with = render({"--cryptomatte", "object,map"});
    for (std::size_t i = 0; i < plain.pixels(); ++i)
        for (const char* channel : {"R", "G", "B", "A"})
            EXPECT_EQ(plain.at(i, channel), with.at(i, channel));
}

TEST_F(Compositing, channels_of_16_bits_are_those_of_32_rounded) {
    const Exr floats = render({"--aov", "Z,N,alpha,object"});
    const Exr halves = render({"--aov", "Z,N,alpha,object", "--half", "color,Z,N"});
    for (int c = 0; c < halves.spec.nchannels; ++c) {
        const std::string& name = halves.spec.channelnames[static_cast<std::size_t>(c)];
        const bool is_half = name != "alpha.V" && name != "object.V";
        EXPECT_EQ(halves.spec.channelformat(c),
                  is_half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT)
            << name;
        for (std::size_t i = 0; i < halves.pixels(); ++i) {
            const float exact = floats.at(i, name), stored = halves.at(i, name);
            if (exact == stored) continue;
            EXPECT_TRUE(is_half) << name;
            EXPECT_LE(std::abs(exact - stored), std::max(0x1p-11F * std::abs(exact), 0x1p-25F))
                << name;
        }
    }
}

TEST_F(Compositing, a_crop_stands_in_its_image) {
    const Exr whole = render({"--aov", "Z"});
    for (const Arguments& more : {Arguments{}, Arguments{"--half", "color"}}) {
        Arguments options{"--aov", "Z", "--crop", "5,7,29,21", "--data-window"};
        options.insert(options.end(), more.begin(), more.end());
        const Exr crop = render(options);
        EXPECT_EQ(crop.spec.x, 5);
        EXPECT_EQ(crop.spec.y, 7);
        EXPECT_EQ(crop.spec.width, 24);
        EXPECT_EQ(crop.spec.height, 14);
        EXPECT_EQ(crop.spec.full_width, 32);
        EXPECT_EQ(crop.spec.full_height, 24);
        for (std::size_t i = 0; i < crop.pixels(); ++i) {
            const std::size_t at = (i / 24 + 7) * 32 + i % 24 + 5;
            EXPECT_EQ(crop.at(i, "Z"), whole.at(at, "Z"));
            EXPECT_NEAR(crop.at(i, "R"), whole.at(at, "R"), more.empty() ? 0 : 1e-3);
        }
    }
}

TEST_F(Compositing, parts_and_old_pictures_keep_how_they_are_written) {
    const Arguments options{"--size",        "32x24",  "--crop", "5,7,29,21",
                            "--data-window", "--half", "color",  "--quiet"};
    const auto run_with = [&](Arguments command) {
        command.insert(command.end(), options.begin(), options.end());
        expect_done(folder, command);
    };
    run_with({"render", "two.pxm", "-o", "whole.exr"});
    run_with({"render", "two.pxm", "-o", "parts", "--part", "1/1"});
    expect_done(folder, {"join", "parts", "-o", "joined.exr"});
    EXPECT_TRUE(folder.read("whole.exr") == folder.read("joined.exr"));
    expect_done(folder, {"render", "whole.exr", "-o", "again.exr", "--quiet"});
    EXPECT_TRUE(folder.read("whole.exr") == folder.read("again.exr"));
    (void)render({"--cryptomatte", "object", "--samples", "4"});
    expect_done(folder, {"render", "a.exr", "-o", "b.exr", "--quiet"});
    EXPECT_TRUE(folder.read("a.exr") == folder.read("b.exr"));
}

TEST_F(Compositing, what_cannot_be_had_is_refused) {
    const auto refused = [&](Arguments options, const std::string& message) {
        options.insert(options.begin(), {"render", "two.pxm"});
        expect_refusal(folder, options, 2, message);
    };
    refused({"-o", "a.png", "--half", "color"}, "--half needs an .exr output, not a.png");
    refused({"-o", "a.png", "--data-window"}, "--data-window needs an .exr output, not a.png");
    refused({"-o", "a.png", "--cryptomatte", "object"},
            "--cryptomatte needs an .exr output, not a.png");
    refused({"-o", "a.exr", "--half", "object"},
            "--half: found \"object\", expected color, Z, N or alpha; other channels are whole "
            "numbers, which 16 bits do not hold");
    refused({"-o", "a.exr", "--half", "Z"}, "--half Z: there is no such channel without --aov Z");
    refused({"-o", "a.exr", "--half", "color,color"}, "--half: color is named twice");
    refused({"-o", "a.exr", "--cryptomatte", "objekt"},
            "--cryptomatte: found \"objekt\", expected object, map, or both with a comma between "
            "them (did you mean 'object'?)");
    refused({"-o", "a.exr", "--cryptomatte", "map,map"}, "--cryptomatte: map is named twice");
    refused({"-o", "parts", "--part", "1/2", "--cryptomatte", "map"},
            "--cryptomatte: a picture that is made in parts has none (--part, --claim, --keep)");
    refused({"-o", "a.exr", "--size", "8192x8192", "--cryptomatte", "map"},
            "--cryptomatte: more than 16777216 pixels at a time; render several windows (--crop)");
}

}  // namespace
}  // namespace pxm::test
