// Systems around the border between contracting and not, and a referee of what is called a proof:
// 77 decimal digits, characteristic polynomials and pivots, nothing of what the proofs are made
// with. The quick, slow and full tests take ever larger shares.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/bounds/invariant_ball.hpp"
#include "host/fractal/system/components.hpp"
#include "host/fractal/system/cycle_mean.hpp"
#include "host/fractal/system/quadratic_norm.hpp"
#include "host/fractal/system/words.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host::proof_campaign {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<77>,
                                           boost::multiprecision::et_off>;
using RealVector = std::array<Real, 3>;
using RealMatrix = std::array<RealVector, 3>;  // [column][row], as glm has it

inline RealMatrix real(const glm::dmat3& matrix) {
    RealMatrix result;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) result[c][r] = matrix[c][r];
    }
    return result;
}

inline RealVector operator*(const RealMatrix& a, const RealVector& x) {
    RealVector result;
    for (int r = 0; r < 3; ++r) result[r] = a[0][r] * x[0] + a[1][r] * x[1] + a[2][r] * x[2];
    return result;
}

inline RealMatrix operator*(const RealMatrix& a, const RealMatrix& b) {
    return {a * b[0], a * b[1], a * b[2]};
}

/// det of the rows and columns i, j.
inline Real minor(const RealMatrix& a, int i, int j) {
    return a[i][i] * a[j][j] - a[i][j] * a[j][i];
}

inline Real determinant(const RealMatrix& a) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
           a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/// Whether all eigenvalues are smaller than `radius`: Jury's criterion for z^3 + a z^2 + b z + c,
/// the characteristic polynomial of the matrix over the radius.
inline bool eigenvalues_below(const RealMatrix& matrix, const Real& radius) {
    const Real a = -(matrix[0][0] + matrix[1][1] + matrix[2][2]) / radius;
    const Real b =
        (minor(matrix, 0, 1) + minor(matrix, 0, 2) + minor(matrix, 1, 2)) / (radius * radius);
    const Real c = -determinant(matrix) / (radius * radius * radius);
    return abs(c) < 1 && abs(a + c) < 1 + b && abs(b - a * c) < 1 - c * c;
}

/// Whether no vector gets more than `lip` times as long: the pivots of lip^2 I - M^t M.
inline bool norm_at_most(const RealMatrix& matrix, const Real& lip) {
    RealMatrix s;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            s[i][j] = i == j ? lip * lip : Real{0};
            for (int k = 0; k < 3; ++k) s[i][j] -= matrix[i][k] * matrix[j][k];
        }
    }
    // The least that is told apart in 77 digits: equality must not fail.
    const Real nothing = lip * lip * Real{"1e-60"};
    for (int p = 0; p < 3; ++p) {
        if (s[p][p] < -nothing) return false;
        for (int i = p + 1; i < 3; ++i) {
            if (s[p][p] <= nothing) {
                if (abs(s[p][i]) > lip * lip * Real{"1e-30"}) return false;
                continue;
            }
            for (int j = p + 1; j < 3; ++j) s[i][j] -= s[p][i] * s[p][j] / s[p][p];
        }
    }
    return true;
}

/// Where x = M x + a, by Cramer's rule.
inline RealVector fixed_point(const RealMatrix& m, const RealVector& a) {
    RealMatrix left;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) left[c][r] = (c == r ? 1 : 0) - m[c][r];
    }
    const Real det = determinant(left);
    RealVector x;
    for (int c = 0; c < 3; ++c) {
        RealMatrix with = left;
        with[c] = a;
        x[c] = determinant(with) / det;
    }
    return x;
}

// ---- systems ----

/// Numbers that proofs stumble over.
class Numbers {
  public:
    explicit Numbers(unsigned seed) : random_(seed) {}

    std::mt19937_64& generator() { return random_; }
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    /// Around the border: 0.9 to 1.1.
    double border() { return between(0.9, 1.1) * (below(2) == 0 ? 1 : -1); }
    /// 10^-most to 10^most.
    double any_size(double most) {
        return std::pow(10, between(-most, most)) * (below(2) == 0 ? 1 : -1);
    }

  private:
    std::mt19937_64 random_;
};

inline Affine placed(Numbers& numbers, const glm::dmat3& linear) {
    return {linear, {numbers.between(-1, 1), numbers.between(-1, 1), numbers.between(-1, 1)}};
}

/// Triangular once the axes are taken in `order`, with that diagonal.
inline glm::dmat3 triangular(Numbers& numbers, const std::array<int, 3>& order, double diagonal,
                             double most) {
    glm::dmat3 linear{0.0};
    for (int i = 0; i < 3; ++i) {
        linear[order[i]][order[i]] = diagonal * numbers.between(0.5, 1);
        for (int j = 0; j < i; ++j) {
            if (numbers.below(3) != 0) linear[order[i]][order[j]] = numbers.any_size(most);
        }
    }
    return linear;
}

inline std::array<int, 3> any_order(Numbers& numbers) {
    std::array<int, 3> order{0, 1, 2};
    std::swap(order[0], order[numbers.below(3)]);
    std::swap(order[1], order[1 + numbers.below(2)]);
    return order;
}

/// A map of border norm in coordinates whose axes differ in size by up to 10^most.
inline glm::dmat3 in_uneven_axes(const glm::dmat3& linear, const glm::dvec3& sizes) {
    glm::dmat3 result;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) result[c][r] = linear[c][r] * sizes[r] / sizes[c];
    }
    return result;
}

enum class Kind { norms, nilpotent, nearly_nilpotent, shears, uneven, pairs, huge, kinds };

inline std::vector<Affine> border_maps(Numbers& numbers, Kind kind, int count) {
    std::vector<Affine> maps;
    const std::array<int, 3> order = any_order(numbers);
    const glm::dvec3 sizes{numbers.any_size(4), numbers.any_size(4), numbers.any_size(4)};
    const double border = numbers.border();
    const double huge = numbers.any_size(kind == Kind::huge ? 160 : 6);
    for (int i = 0; i < count; ++i) {
        // One order for all maps, or one for each: words of the latter are no longer triangular.
        const std::array<int, 3> own = numbers.below(2) == 0 ? order : any_order(numbers);
        const glm::dmat3 turned = systems::random_map(numbers.generator(), 1).linear;
        glm::dmat3 linear{0.0};
        switch (kind) {
            case Kind::norms:
                linear = turned * numbers.border();
                break;
            case Kind::nilpotent:
                linear = triangular(numbers, own, 0, 6);
                break;
            case Kind::nearly_nilpotent:
                linear = triangular(numbers, own, 0, 3) + turned * numbers.any_size(9) * 1e-9;
                break;
            case Kind::shears:
                linear = triangular(numbers, order, border, 6);
                break;
            case Kind::uneven:
                linear = in_uneven_axes(turned * numbers.border(), sizes);
                break;
            case Kind::pairs:
            case Kind::huge:
                // Each of two maps vanishes if repeated; both in turn multiply by the border.
                linear[order[i % 2]][order[1 - i % 2]] = i % 2 == 0 ? huge : border / huge;
                break;
            case Kind::kinds:
                break;
        }
        maps.push_back(placed(numbers, linear));
    }
    return maps;
}

/// System `seed`: one to four maps of one kind, every third with a graph.
inline Rifs border_system(unsigned seed) {
    Numbers numbers(seed);
    const auto kind = static_cast<Kind>(seed % static_cast<unsigned>(Kind::kinds));
    const int count = 1 + numbers.below(4);
    const std::vector<Affine> maps = border_maps(numbers, kind, count);
    if (numbers.below(3) != 0) return systems::complete(maps);
    std::vector<std::vector<int>> follow(maps.size());
    for (std::vector<int>& of_map : follow) {
        for (int j = 0; j < count; ++j) {
            if (numbers.below(2) == 0) of_map.push_back(j);
        }
        if (of_map.empty()) of_map.push_back(numbers.below(count));
    }
    return systems::with_graph(maps, follow);
}

// ---- the referee ----

/// A word of maps, composed: the first map is the outermost.
struct RealWord {
    std::vector<int> maps;
    RealMatrix linear;
    RealVector translation;
};

inline RealWord longer(const RealWord& word, const Rifs& rifs, int m) {
    RealWord result = word;
    result.maps.push_back(m);
    result.linear = word.linear * real(rifs.maps[m].linear);
    const glm::dvec3& a = rifs.maps[m].translation;
    const RealVector moved = word.linear * RealVector{a.x, a.y, a.z};
    for (int r = 0; r < 3; ++r) result.translation[r] += moved[r];
    return result;
}

/// Calls `each(set, word)` for every word of at most `longest` maps that leads from a follow set
/// back to it.
template <class Each>
void for_each_cycle(const Rifs& rifs, std::size_t longest, const Each& each) {
    for (int s = 0; s < static_cast<int>(rifs.follow_sets.size()); ++s) {
        std::vector<RealWord> open{{{}, real(glm::dmat3{1.0}), {0, 0, 0}}};
        while (!open.empty()) {
            const RealWord word = std::move(open.back());
            open.pop_back();
            const int set = word.maps.empty() ? s : rifs.follow_of[word.maps.back()];
            if (!word.maps.empty() && set == s) each(s, word);
            if (word.maps.size() == longest) continue;
            for (const int m : rifs.follow_sets[set].maps) open.push_back(longer(word, rifs, m));
        }
    }
}

/// True if going round some cycle of at most `longest` maps does not shrink.
inline bool has_growing_cycle(const Rifs& rifs, std::size_t longest) {
    bool grows = false;
    for_each_cycle(rifs, longest, [&](int, const RealWord& word) {
        grows = grows || !eigenvalues_below(word.linear, 1);
    });
    return grows;
}

/// Law: round every cycle the maps shrink by the rate that was proven, at least.
inline void cycles_shrink(const Rifs& rifs, const Contraction& proof, std::size_t longest) {
    for_each_cycle(rifs, longest, [&](int, const RealWord& word) {
        const Real most = pow(Real{proof.rate}, static_cast<int>(word.maps.size()));
        ASSERT_TRUE(eigenvalues_below(word.linear, most * (1 + Real{"1e-25"})));
    });
}

/// Law: what the proof says of single maps, or of words, is so.
inline void certificate_holds(const Rifs& rifs, const Contraction& proof, std::mt19937_64& random) {
    const std::vector<int> component = set_components(rifs);
    const std::vector<double> weight = weights_of(largest_cycle_mean(rifs));
    std::vector<glm::dmat3> frames;
    if (proof.proof == ContractionProof::spectral_radius) frames = contracting_norm(rifs)->frame;
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            const auto t = static_cast<std::size_t>(rifs.follow_of[m]);
            const RealMatrix map = real(rifs.maps[m].linear);
            if (proof.proof == ContractionProof::cycle_mean && component[t] == component[s]) {
                const Real lip = Real{proof.rate} * weight[s] / weight[t];
                ASSERT_TRUE(norm_at_most(map, lip));
            }
            if (proof.proof == ContractionProof::spectral_radius) {
                // |F^-1 M F'| <= rate, with the columns of F^-1 by Cramer's rule.
                const RealMatrix frame = real(frames[s]);
                RealMatrix framed = map * real(frames[t]);
                for (RealVector& column : framed) {
                    RealMatrix left = frame;
                    for (auto& entry : left)
                        for (Real& x : entry) x = -x;
                    for (int i = 0; i < 3; ++i) left[i][i] += 1;
                    column = fixed_point(left, column);
                }
                ASSERT_TRUE(norm_at_most(framed, proof.rate));
            }
        }
    }
    if (proof.proof != ContractionProof::words || proof.word_length > 2000) return;
    for (int tries = 0; tries < 3; ++tries) {
        RealWord word{{}, real(glm::dmat3{1.0}), {0, 0, 0}};
        int set = static_cast<int>(random() % rifs.follow_sets.size());
        for (int i = 0; i < proof.word_length; ++i) {
            const std::vector<int>& maps = rifs.follow_sets[set].maps;
            const int m = maps[random() % maps.size()];
            word = longer(word, rifs, m);
            set = rifs.follow_of[m];
        }
        ASSERT_TRUE(norm_at_most(word.linear, pow(Real{proof.rate}, proof.word_length)));
    }
}

/// Law: the points where cycles stand still lie in the volumes.
inline void volumes_contain(const Rifs& rifs, const std::vector<Bounds>& volumes,
                            std::size_t longest) {
    for_each_cycle(rifs, longest, [&](int set, const RealWord& word) {
        const RealVector x = fixed_point(word.linear, word.translation);
        const auto& [ball, box, slack] = volumes[static_cast<std::size_t>(set)];
        Real square = 0;
        for (int i = 0; i < 3; ++i) {
            ASSERT_TRUE(x[i] >= box.low[i] && x[i] <= box.high[i]);
            square += (x[i] - ball.center[i]) * (x[i] - ball.center[i]);
        }
        ASSERT_TRUE(square <= Real{ball.radius} * ball.radius);
    });
}

struct Tried {
    std::map<ContractionProof, int> found;
    int growing = 0;  // systems with a cycle that does not shrink, all of them refused
};

/// The laws of all systems of a range of seeds; every `share`-th is bounded as for a render.
inline Tried try_systems(unsigned first, unsigned last, unsigned share) {
    constexpr long words = 2'000;
    constexpr std::size_t longest = 3;
    Tried tried;
    for (unsigned seed = first; seed < last; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Rifs rifs = border_system(seed);
        const Contraction proof = prove_contraction(rifs, words);
        ++tried.found[proof.proof];
        if (proof.proof == ContractionProof::none) {
            tried.growing += has_growing_cycle(rifs, longest) ? 1 : 0;
            continue;
        }
        std::mt19937_64 random(seed);
        cycles_shrink(rifs, proof, longest);
        certificate_holds(rifs, proof, random);
        volumes_contain(rifs, invariant_volumes(rifs, proof, inner_points(rifs)), longest);
        if (seed % share == 0) volumes_contain(rifs, bound(rifs, proof), longest);
        if (testing::Test::HasFatalFailure()) break;
    }
    return tried;
}

}  // namespace pxm::host::proof_campaign
