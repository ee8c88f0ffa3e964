// IFStile's language: systems whose maps and dimensions are known come out right, and what has no
// meaning as maps ends in one message at its place.
#include "host/import/aifs/aifs_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "host/compile/build_rifs.hpp"
#include "host/error.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/import/import.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;

Imported imported(const std::string& text, const std::optional<std::string>& entry = {}) {
    return import_aifs({"f.aifs", text}, entry);
}

struct Refusal {
    std::optional<ErrorKind> kind;
    std::string text;
};

Refusal refusal(const std::string& text, const std::optional<std::string>& entry = {}) {
    try {
        (void)imported(text, entry);
        return {};
    } catch (const Error& error) {
        return {error.kind(), error.what()};
    }
}

Affine map_of(const Imported& made, std::size_t i) {
    return compose(made.scene.ifs[0].maps[i].commands);
}

struct Known {
    const char* name;
    const char* text;
    double dimension;
};

class KnownSystems : public testing::TestWithParam<Known> {};

TEST_P(KnownSystems, have_their_similarity_dimension) {
    const Imported made = imported(GetParam().text);
    Diagnostics diagnostics;
    const Rifs rifs = build_rifs(made.scene.ifs[0], diagnostics);
    ASSERT_FALSE(diagnostics.has_errors());
    EXPECT_NEAR(similarity_dimension(rifs)->middle(), GetParam().dimension, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Aifs, KnownSystems,
    testing::Values(
        Known{"gasket", "@\n$dim=2\nf=[1/2,0,0,1/2]\nS=(f|[1,0]*f|[0,1]*f)*S",
              std::log(3) / std::log(2)},
        Known{"cantor", "@\n$dim=1\nS=(1/3)*([0]|[2])*S", std::log(2) / std::log(3)},
        Known{"koch",
              "@\n$dim=2\nr=[cos($pi/3),-sin($pi/3),sin($pi/3),cos($pi/3)]\n"
              "K=1/3*(1|[1,0]*r|[3/2,3^(1/2)/2]*r^-1|[2,0])*K",
              std::log(4) / std::log(3)},
        Known{"menger",
              "@\n$dim=3\n$n=Menger\nS=1/3*([1,1,1]|[1,1,0]|[1,1,-1]|[1,0,1]|[1,0,-1]|[1,-1,1]|"
              "[1,-1,0]|[1,-1,-1]|[0,1,1]|[0,1,-1]|[0,-1,1]|[0,-1,-1]|[-1,1,1]|[-1,1,0]|"
              "[-1,1,-1]|[-1,0,1]|[-1,0,-1]|[-1,-1,1]|[-1,-1,0]|[-1,-1,-1])*S",
              std::log(20) / std::log(3)},
        Known{"tetrahedron", "@\n$dim=3\nT=([1,1,1]|[1,-1,-1]|[-1,1,-1]|[-1,-1,1])*2^-1*T", 2},
        Known{"twin dragon", "@\n$dim=2\ng=[1,-1,1,1]\nD=g^-1*(1|[1,0])*D", 2},
        Known{"vicsek", "@\n$dim=2\nV=(1/3)*(1|[2,0]|[-2,0]|[0,2]|[0,-2])*V",
              std::log(5) / std::log(3)},
        Known{"golden words", "@\n$dim=2\nf=[1/2,0,0,1/2]\nA=f*A|[1,0]*f*B\nB=[0,1]*f*A",
              std::log((1 + std::sqrt(5)) / 2) / std::log(2)},
        Known{"rauzy",
              "@\n$dim=3\ns=$companion([-1,-1,-1])\n"
              "$subspace=[s,1]\nA=(s|s^2*[1,0,0]|s^3*([1,0,0]*[0,1,0]))*A",
              2},
        Known{"a sum of powers",
              "@\n$dim=4\n$subspace=s 0\ns=$companion([1,0,0,0])\ng=1+s-s^3\n"
              "A=g^-1*(1|s|s^2)*A",
              std::log(3) / std::log(1 + std::sqrt(2))}),
    [](const auto& tested) {
        std::string name = tested.param.name;
        for (char& c : name)
            if (c == ' ') c = '_';
        return name;
    });

TEST(Aifs, a_vector_before_a_matrix_is_moved_after_it) {
    const Imported made = imported("@\n$dim=2\nf=[1,2]*[0.1,0.2,0.3,0.4]\nS=(f|1/2)*S");
    const glm::dvec3 p = map_of(made, 0).point({5, 7, 0});
    EXPECT_NEAR(p.x, 0.1 * 5 + 0.2 * 7 + 1, 1e-12);
    EXPECT_NEAR(p.y, 0.3 * 5 + 0.4 * 7 + 2, 1e-12);
}

TEST(Aifs, numbers_and_translations_are_composed) {
    // 1/2*[1,0] is (x + (1,0)) / 2, [1,0]*1/2 is x / 2 + (1,0).
    const Imported made = imported("@\n$dim=2\nS=(1/2*[1,0]|[1,0]*1/2)*S");
    EXPECT_EQ(map_of(made, 0).translation.x, 0.5);
    EXPECT_EQ(map_of(made, 1).translation.x, 1);
}

TEST(Aifs, space_is_turned_so_that_z_is_up_and_nothing_is_mirrored) {
    const Imported made = imported("@\n$dim=3\nS=([1,2,3]*0.5|[0,0,0]*0.5)*S");
    EXPECT_EQ(map_of(made, 0).translation, glm::dvec3(1, 3, 2));
    const Imported turn = imported("@\n$dim=3\nr=[0,-1,0, 1,0,0, 0,0,1]\nS=(1/2*r|[1,0,0]*1/2)*S");
    // x goes to y there: to z here.
    EXPECT_NEAR(map_of(turn, 0).direction({1, 0, 0}).z, 0.5, 1e-15);
}

TEST(Aifs, a_companion_matrix_counts_in_powers_of_its_eigenvalue) {
    const Imported made = imported(
        "@\n$dim=4\n$subspace=[s,0]\ns=$companion([1,-1,1,-1])\nS=(1/2*[0,1,0,0]|1/2*[1,0,0,0]|"
        "1/2*[0,0,0,1]|1/2*s)*S");
    const std::complex<double> root = std::polar(1.0, std::acos(-1.0) / 5);  // of x^4-x^3+x^2-x+1
    const auto place = [&](std::size_t i) {
        const glm::dvec3 t = map_of(made, i).translation;
        return std::complex<double>(t.x, t.y);
    };
    EXPECT_NEAR(std::abs(place(0) - 0.5 * root), 0, 1e-12);
    EXPECT_NEAR(std::abs(place(1) - 0.5), 0, 1e-12);
    EXPECT_NEAR(std::abs(place(2) - 0.5 * root * root * root), 0, 1e-12);
    const glm::dvec3 turned = map_of(made, 3).direction({1, 0, 0});
    EXPECT_NEAR(std::abs(std::complex<double>(turned.x, turned.y) - 0.5 * root), 0, 1e-12);
}

TEST(Aifs, sets_of_a_graph_follow_one_another) {
    const Imported made = imported("@\n$dim=2\nf=1/2\nA=f*A|[1,0]*f*B\nB=[0,1]*f*A\n");
    const IfsBlock& ifs = made.scene.ifs[0];
    ASSERT_EQ(ifs.maps.size(), 3U);
    EXPECT_EQ(ifs.start.size(), 2U);
    ASSERT_EQ(ifs.follow.size(), 3U);
    EXPECT_EQ(ifs.follow[1].followers.size(), 1U) << "inside the map to B only B's";
    EXPECT_EQ(imported("@\n$dim=2\nf=1/2\nA=f*A|[1,0]*f*B\nB=[0,1]*f*A\n", ":B")
                  .scene.ifs[0]
                  .start.size(),
              1U);
    EXPECT_EQ(imported("@\n$dim=2\n$root=B\nf=1/2\nA=f*A|[1,0]*f*B\nB=[0,1]*f*A\n")
                  .scene.ifs[0]
                  .start.size(),
              1U);
}

TEST(Aifs, definitions_may_share_a_line) {
    const Imported made = imported("@\n$dim=1\na=0.25;b=[1]; c=1/2;\nS=a*S|b*c*S\n");
    ASSERT_EQ(made.scene.ifs[0].maps.size(), 2U);
    EXPECT_EQ(map_of(made, 0).linear[0].x, 0.25);
    EXPECT_EQ(map_of(made, 1).linear[0].x, 0.5);
    EXPECT_EQ(map_of(made, 1).translation.x, 1);
}

TEST(Aifs, powers_of_unions_stay_small) {
    const Imported made =
        imported("@\n$dim=2\nm=1|[1,0]\ntrunk=m^11*leaf\nleaf=1/2*(1|[0,1])*leaf\n");
    EXPECT_LE(made.scene.ifs[0].maps.size(), 2U * 11 + 2);
}

TEST(Aifs, blocks_inherit_are_hidden_and_are_called) {
    const std::string text =
        "@turn\n$a=h\nangle=0\nret=[cos(angle),-sin(angle),sin(angle),cos(angle)]\n"
        "@Base\n$a=h\n$dim=2\nk=$number($real(0,1))\nS=(k|[1,0]*k*turn($pi/2))*S\n"
        "@:Base\n$n=One third\nk=1/3\n"
        "@:Base\n$n=A half\nk=1/2\n";
    EXPECT_EQ(refusal(text).text,
              "f.aifs has 2 entries; choose one with --entry NAME:\n  One third\n  A half");
    const Imported third = imported(text, "One third");
    EXPECT_NEAR(map_of(third, 1).direction({1, 0, 0}).y, 1 / 3.0, 1e-12);
    EXPECT_EQ(map_of(imported(text, "#2"), 0).linear[0].x, 0.5);
}

TEST(Aifs, what_has_no_meaning_is_told_with_its_place) {
    const auto says = [](const std::string& text, const std::string& message) {
        const Refusal refused = refusal(text);
        EXPECT_EQ(refused.kind, ErrorKind::scene) << text;
        EXPECT_THAT(refused.text, HasSubstr(message)) << text;
    };
    says("@\n$dim=2\nS=(f|1/2)*S\n", "f.aifs:3:4: error: 'f' is not defined");
    says("@\n$dim=2\nS=($number($real(0,1))|1/2)*S\n",
         "f.aifs:3:4: error: $number leaves the value to a search");
    says("@\n$dim=2\nS=([1,2,3]|1/2)*S\n",
         "a vector of 3 is neither a translation (2) nor a matrix (4) of 2 dimensions");
    says("@\n$dim=2\nS=2*S\n", "it could not be shown to contract");
    says("@\n$dim=2\nS=S*S\n", "a set cannot stand on the left of a product");
    says("@\n$dim=2\nS=S+1\n", "expected one map, found a union or a set");
    says("@\n$dim=2\nf=1/2\nS=f*S|f\n", "a part of 'S' is a map without a set to map");
    says("@\n$dim=2\nS=(1/0)*S\n", "a division by zero");
    says("@\n$dim=2\nS=[1,0,0,0]^-1*S\n", "the inverse of a map that squashes flat");
    says("@\nS=1/2*S\n", "the block has no $dim");
    says("@\n$dim=4\nS=1/2*S\n", "$subspace has to name 1 to 3 to be shown");
    says("@\n$dim=2\nS=1/2*S|julia(1)*S\n",
         "there is no function or block 'julia' that can be taken");
    says("function f() {}\n@\n", "programs in JavaScript");
    says("@@import x.aifs\n@\n$dim=2\nS=1/2*S\n", "only the file itself is read");
    says("@:Nobody\n$dim=2\nS=1/2*S\n", "there is no block 'Nobody' to inherit from");
    says("@A:A\n$dim=2\nS=1/2*S\n", "a block that is its own parent");
    says("@\n$dim=2\nS=(1/2*S\n", "expected ')', found the end of the file");
    says("@\n$dim=3\n$subspace=[1,0]\nS=1/2*S\n", "an eigenvalue that comes twice");
    says(
        "@\n$dim=4\n$subspace=[s,0]\ns=$companion([1,-1,1,-1])\n"
        "S=[1/2,0,0,0, 0,1/3,0,0, 0,0,1/2,0, 0,0,0,1/2]*S\n",
        "a map does not keep the subspace that is shown");
}

TEST(Aifs, a_file_cut_anywhere_is_a_scene_or_one_message) {
    const std::string whole =
        "@turn\nangle=0\nret=[cos(angle),-sin(angle),sin(angle),cos(angle)]\n@B\n$n=B # b\n"
        "$dim=2\n$subspace=s 0\ns=$companion([1,1/2])\n&Q=1/3^2\n"
        "A=(Q|turn(1)*[1,-2e-1]*Q|if(1,1/2,2))*B\nB=1/2^(1/1)*A\n";
    for (std::size_t end = 0; end <= whole.size(); ++end) {
        const Refusal refused = refusal(whole.substr(0, end));
        EXPECT_TRUE(!refused.kind || refused.kind != ErrorKind::failed) << end << refused.text;
    }
}

TEST(Aifs, hostile_files_end_in_a_message) {
    const std::string head = "@\n$dim=2\nS=";
    EXPECT_EQ(refusal(head + std::string(100'000, '(') + "1").kind, ErrorKind::scene);
    EXPECT_EQ(refusal(head + std::string(100'000, '[') + "1").kind, ErrorKind::scene);
    EXPECT_EQ(refusal(head + std::string(100'000, '-') + "1").kind, ErrorKind::scene);
    std::string chain = head + "x0*S\n";
    for (int i = 0; i < 20'000; ++i)
        chain += "x" + std::to_string(i) + "=x" + std::to_string(i + 1) + "/2\n";
    EXPECT_EQ(refusal(chain).kind, ErrorKind::scene);
    EXPECT_EQ(refusal("@f\na=1\nret=f(a)\n" + head + "f(1)*S\n").kind, ErrorKind::scene);
    EXPECT_EQ(refusal(head + "(1|2)^1000000*S\n").kind, ErrorKind::scene);
    EXPECT_EQ(refusal(head + "((1|2)^1000)^1000*S\n").kind, ErrorKind::scene);
    EXPECT_EQ(refusal(head + "1e300^9*S\n").kind, ErrorKind::scene);
    EXPECT_EQ(refusal("@\n$dim=2\nf=1e300*[1,1]\nS=f^9*S\n").kind, ErrorKind::scene);
    std::string wide = head + "(1/2";
    for (int i = 0; i < 100'000; ++i) wide += "|1/2";
    EXPECT_THAT(refusal(wide + ")*S\n").text, HasSubstr("a union of more than 65536 maps"));
}

TEST(Aifs, any_bytes_end_in_a_scene_or_a_message) {
    const std::string alphabet = "@$&=()[]|*/+-^%,.:#0123456789efSAB \n\t\x80\x01";
    const std::string whole =
        "@B\n$dim=2\nf=[1/2,0,0,1/2]\n&g=f*[1,0]\nS=(f|g|f^2*[0,1])*A\nA=f*S|g*A\n";
    for (unsigned seed = 0; seed < 1000; ++seed) {
        std::mt19937 random(seed);
        std::string text = whole;
        for (int i = 0; i < 4; ++i)
            text[random() % text.size()] = alphabet[random() % alphabet.size()];
        const Refusal refused = refusal(text);
        EXPECT_TRUE(!refused.kind || refused.kind == ErrorKind::scene ||
                    refused.kind == ErrorKind::setting)
            << text << refused.text;
    }
}

}  // namespace
}  // namespace pxm::host
