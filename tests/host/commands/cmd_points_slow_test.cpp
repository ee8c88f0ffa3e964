// Laws of `pxm points`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

class Points : public testing::Test {
  protected:
    Points() { folder.write("tetra.pxm", tetra_scene); }
    Folder folder;
};

/// What follows the header of a PLY file.
std::string body_of(const std::string& ply) {
    const std::string end = "end_header\n";
    const std::size_t at = ply.find(end);
    return at == std::string::npos ? "" : ply.substr(at + end.size());
}

TEST_F(Points, a_cloud_has_the_points_its_header_says) {
    expect_done(folder, {"points", "tetra.pxm", "-n", "1000", "-o", "cloud.ply"});
    const std::string ply = folder.read("cloud.ply");
    EXPECT_EQ(ply.substr(0, ply.find("end_header")),
              "ply\nformat binary_little_endian 1.0\ncomment pxm " PXM_VERSION
              " points of tetra.pxm\nelement vertex 1000\n"
              "property float x\nproperty float y\nproperty float z\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\n");
    const std::string body = body_of(ply);
    ASSERT_EQ(body.size(), 1000U * 15);
    for (std::size_t i = 0; i < 1000; ++i) {
        float xyz[3];
        std::memcpy(xyz, body.data() + 15 * i, sizeof xyz);
        ASSERT_LE(std::hypot(xyz[0], xyz[1], xyz[2]), 1.01F);  // the tetra's ball
    }
}

TEST_F(Points, the_seed_alone_decides_the_points) {
    expect_done(folder, {"points", "tetra.pxm", "-n", "100", "-o", "a.ply"});
    expect_done(folder, {"points", "tetra.pxm", "-n", "100", "-o", "b.ply"});
    expect_done(folder, {"points", "tetra.pxm", "-n", "100", "-o", "c.ply", "--seed", "2"});
    EXPECT_EQ(folder.read("a.ply"), folder.read("b.ply"));
    EXPECT_NE(body_of(folder.read("a.ply")), body_of(folder.read("c.ply")));
}

/// More than one chunk of each of two objects.
TEST_F(Points, do_not_depend_on_threads) {
    folder.write("two.pxm",
                 "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 }\n"
                 "object left { ifs: a }\nobject right { ifs: a translate: 5,0,0 }\n");
    for (const char* threads : {"1", "3"})
        expect_done(folder, {"points", "two.pxm", "-n", "200001", "-o",
                             std::string(threads) + ".ply", "--threads", threads});
    EXPECT_TRUE(folder.read("1.ply") == folder.read("3.ply"));
    const std::string body = body_of(folder.read("1.ply"));
    std::set<std::string> different;
    for (std::size_t i = 0; i < 100'000; ++i) different.insert(body.substr(15 * i, 12));
    EXPECT_GT(different.size(), 99'000U) << "chunks repeat each other";
}

TEST_F(Points, are_kept_by_a_run_that_goes_on) {
    const auto command = [](const std::string& out, const std::string& count) {
        return Arguments{"points", "tetra.pxm", "-n", count, "-o", out, "--quiet"};
    };
    expect_done(folder, command("one.ply", "300000"));
    Arguments keep = command("kept.ply", "300000");
    keep.insert(keep.end(), {"--keep", "kept"});
    for (int run = 0; run < 2; ++run) {
        expect_done(folder, keep);
        EXPECT_TRUE(folder.read("kept.ply") == folder.read("one.ply"));
        std::filesystem::remove(folder.path("kept.ply"));
    }
    std::string damaged;
    for (const auto& [name, bytes] : folder.contents())
        if (name.starts_with("kept/kept-")) damaged = name;
    folder.write(damaged, folder.read(damaged).substr(0, 1000));
    EXPECT_EQ(expect_done(folder, keep),
              "warning: " + damaged + ": was cut short: what it holds is made again\n");
    EXPECT_TRUE(folder.read("kept.ply") == folder.read("one.ply"));
    Arguments other = command("other.ply", "300001");
    other.insert(other.end(), {"--keep", "kept"});
    expect_refusal_naming(
        folder, other, 4,
        {"kept/kept-",
         "is of other points: another scene, count, seed, version, precision or offset"});
}

TEST_F(Points, far_scenes_keep_their_shape_by_doubles_or_an_offset) {
    folder.write("far.pxm",
                 "ifs t { newmap scale: .5 newmap scale: .5 translate: 1,0,0 newmap scale: .5 "
                 "translate: 0,1,0 }\nobject o { ifs: t translate: 1e6,-2e6,3e6 }\n");
    const auto points = [&](const std::string& out, const Arguments& more) {
        Arguments command{"points", "far.pxm", "-n", "1000", "-o", out, "--quiet"};
        command.insert(command.end(), more.begin(), more.end());
        expect_done(folder, command);
        return folder.read(out);
    };
    const std::string near = points("near.ply", {"--offset", "auto"});
    const std::string exact = points("exact.ply", {});
    EXPECT_NE(exact.find("property double x"), std::string::npos);
    EXPECT_NE(points("f.ply", {"--precision", "float"}).find("property float x"),
              std::string::npos);
    EXPECT_EQ(points("d.ply", {"--precision", "double"}), exact);
    std::array<double, 3> offset{};
    const std::size_t comment = near.find("\ncomment offset ");
    ASSERT_NE(comment, std::string::npos);
    ASSERT_EQ(std::sscanf(near.c_str() + comment, "\ncomment offset %lf %lf %lf\n", &offset[0],
                          &offset[1], &offset[2]),
              3);
    EXPECT_NEAR(offset[0], 1e6, 2);
    EXPECT_NEAR(offset[1], -2e6, 2);
    EXPECT_NE(near.find("property float x"), std::string::npos);
    const std::string floats = body_of(near), doubles = body_of(exact);
    ASSERT_EQ(floats.size(), 1000U * 15);
    ASSERT_EQ(doubles.size(), 1000U * 27);
    for (std::size_t i = 0; i < 1000; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float x = 0;
            double far = 0;
            std::memcpy(&x, &floats[15 * i + 4 * axis], sizeof x);
            std::memcpy(&far, &doubles[27 * i + 8 * axis], sizeof far);
            EXPECT_NEAR(x + offset[axis], far, 1e-7);
        }
    }
    expect_refusal(folder, {"points", "far.pxm", "-n", "9", "-o", "x.ply", "--offset", "1,2"}, 2,
                   "--offset: found \"1,2\", expected x,y,z or auto");
    expect_refusal(folder, {"points", "far.pxm", "-n", "9", "-o", "x.ply", "--precision", "dubble"},
                   2,
                   "--precision: found \"dubble\", expected auto, float or double (did you mean "
                   "'double'?)");
}

TEST_F(Points, every_object_has_its_share) {
    folder.write("two.pxm",
                 "ifs spot { newmap scale: 0.5 }\n"
                 "object left { ifs: spot translate: -5,0,0 color: 1,0,0,1 }\n"
                 "object right { ifs: spot translate: 5,0,0 color: 0,0,1,1 }\n");
    expect_done(folder, {"points", "two.pxm", "-n", "7", "-o", "two.ply"});
    const std::string body = body_of(folder.read("two.ply"));
    ASSERT_EQ(body.size(), 7U * 15);
    int left = 0;
    for (std::size_t i = 0; i < 7; ++i) {
        float x = 0;
        std::memcpy(&x, body.data() + 15 * i, sizeof x);
        const bool is_left = x < 0;
        EXPECT_NEAR(std::abs(x), 5, 1e-6);
        EXPECT_EQ(static_cast<unsigned char>(body[15 * i + 12]), is_left ? 255 : 0);
        EXPECT_EQ(static_cast<unsigned char>(body[15 * i + 14]), is_left ? 0 : 255);
        left += is_left;
    }
    EXPECT_TRUE(left == 3 || left == 4) << left;
}

/// The x of `count` points of a cloud of floats.
std::vector<float> places_of(const std::string& ply, std::size_t count) {
    const std::string body = body_of(ply);
    EXPECT_EQ(body.size(), 15 * count);
    std::vector<float> places(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&places[i], body.data() + 15 * i, sizeof(float));
    }
    return places;
}

TEST_F(Points, no_object_of_any_seed_repeats_another) {
    const std::string ifs = "ifs line { newmap scale: 1/2 newmap scale: 1/2 translate: 1/2,0,0 }\n";
    folder.write("one.pxm", ifs + "object a { ifs: line }\n");
    folder.write("three.pxm",
                 ifs + "object a { ifs: line } object b { ifs: line } object c { ifs: line }\n");
    constexpr std::size_t each = 200;
    std::set<float> places;
    std::size_t drawn = 0;
    for (const char* seed : {"0", "1", "2", "3", "4294967296", "18446744073709551615"}) {
        const std::string out = fmt::format("{}.ply", seed);
        expect_done(folder, {"points", "three.pxm", "-n", "600", "-o", out, "--seed", seed});
        const std::vector<float> three = places_of(folder.read(out), 3 * each);
        places.insert(three.begin(), three.end());
        drawn += three.size();
        // What else the scene holds is nothing to its first object.
        expect_done(folder, {"points", "one.pxm", "-n", "200", "-o", out, "--seed", seed});
        EXPECT_EQ(places_of(folder.read(out), each),
                  std::vector<float>(three.begin(), three.begin() + each));
    }
    // Floats near 1 have 2^24 steps: a pair or two may meet.
    EXPECT_GE(places.size() + 8, drawn);
}

/// The gasket with corners at the origin, (1,0,0) and (0,1,0), moved along x.
std::string moved_gasket(double x) {
    return fmt::format(
        "ifs far {{ newmap scale: 1/2 translate: {0}/2,0,0\n"
        "newmap scale: 1/2 translate: {0}/2+1/2,0,0 newmap scale: 1/2 translate: {0}/2,1/2,0 }}",
        x);
}

TEST_F(Points, far_from_the_origin_keep_their_shape) {
    constexpr std::size_t count = 20'000;
    for (const double x : {1e4, 1e6, 1e9, 1e45}) {
        folder.write("far.pxm", moved_gasket(x));
        expect_done(folder, {"points", "far.pxm", "-n", std::to_string(count), "-o", "far.ply"});
        const std::string ply = folder.read("far.ply");
        EXPECT_NE(ply.find("property double x\nproperty double y\nproperty double z\n"),
                  std::string::npos);
        const std::string body = body_of(ply);
        ASSERT_EQ(body.size(), count * 27);
        if (x > 1e15) continue;  // a double has no place for the shape either, but for x itself
        std::set<double> places;
        for (std::size_t i = 0; i < count; ++i) {
            double xyz[3];
            std::memcpy(xyz, body.data() + 27 * i, sizeof xyz);
            places.insert(xyz[0]);
            ASSERT_GE(xyz[0], x - 1e-5);
            ASSERT_LE(xyz[0] - x + xyz[1], 1 + 1e-5);
        }
        EXPECT_GT(places.size(), count / 2) << "floats near " << x << " have but a few steps";
    }
}

TEST_F(Points, near_the_origin_are_floats) {
    for (const double x : {0.0, 1.0, -20.0}) {
        folder.write("near.pxm", moved_gasket(x));
        expect_done(folder, {"points", "near.pxm", "-n", "10", "-o", "near.ply"});
        EXPECT_EQ(body_of(folder.read("near.ply")).size(), 10U * 15) << x;
    }
}

TEST_F(Points, an_object_that_floats_would_spoil_makes_all_of_them_doubles) {
    folder.write("two.pxm", std::string("ifs s { newmap scale: 0.5 newmap scale: 0.5 translate: "
                                        "0.5,0,0 }\nobject near { ifs: s scale: 1000 }\n"
                                        "object far { ifs: s translate: 1000,0,0 }\n"));
    expect_done(folder, {"points", "two.pxm", "-n", "10", "-o", "two.ply"});
    EXPECT_EQ(body_of(folder.read("two.ply")).size(), 10U * 27);
}

TEST_F(Points, mistakes_have_their_codes_and_leave_no_file) {
    folder.write("grows.pxm", "ifs grows { newmap scale: 1.1 }");
    const auto before = folder.contents();
    EXPECT_EQ(run(folder, {"points", "grows.pxm", "-n", "9", "-o", "x.ply"}).exit_code, 3);
    EXPECT_EQ(run(folder, {"points", "none.pxm", "-n", "9", "-o", "x.ply"}).exit_code, 4);
    EXPECT_EQ(run(folder, {"points", "tetra.pxm", "-n", "9", "-o", "no/x.ply"}).exit_code, 4);
    EXPECT_EQ(run(folder, {"points", "tetra.pxm", "-n", "0", "-o", "x.ply"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"points", "tetra.pxm", "-o", "x.ply"}).exit_code, 2);
    EXPECT_EQ(folder.contents(), before);
}

}  // namespace
}  // namespace pxm::test
