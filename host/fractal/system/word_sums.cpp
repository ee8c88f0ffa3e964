#include "host/fractal/system/word_sums.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "host/fractal/system/components.hpp"

namespace pxm::host {

namespace {

constexpr double zero_log = -std::numeric_limits<double>::infinity();

/// The largest singular value: from the largest root of the characteristic polynomial of T T^t, by
/// its trigonometric solution.
double norm(const glm::dmat3& t) {
    const double xx = glm::dot(t[0], t[0]);
    const double yy = glm::dot(t[1], t[1]);
    const double zz = glm::dot(t[2], t[2]);
    const double xy = glm::dot(t[0], t[1]);
    const double xz = glm::dot(t[0], t[2]);
    const double yz = glm::dot(t[1], t[2]);
    const double mean = (xx + yy + zz) / 3;
    const double off = xy * xy + xz * xz + yz * yz;
    const double x = xx - mean;
    const double y = yy - mean;
    const double z = zz - mean;
    const double spread = std::sqrt((x * x + y * y + z * z + 2 * off) / 6);
    if (!(spread > 0)) return std::sqrt(std::max(mean, 0.0));
    const double det = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
    const double angle = std::acos(std::clamp(det / (2 * spread * spread * spread), -1.0, 1.0));
    return std::sqrt(std::max(mean + 2 * spread * std::cos(angle / 3), 0.0));
}

constexpr double unit = std::numeric_limits<double>::epsilon();

double largest_entry(const glm::dmat3& t) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(t[i][j]));
    }
    return largest;
}

glm::dmat3 absolute(const glm::dmat3& t) {
    return {glm::abs(t[0]), glm::abs(t[1]), glm::abs(t[2])};
}

/// A matrix times exp(log), so that products of many do not underflow, and how far its entries may
/// be off by rounding. What is exactly 0 stays so.
struct Scaled {
    glm::dmat3 matrix{1.0};
    glm::dmat3 error{0.0};
    double log = 0;

    [[nodiscard]] double log_norm() const { return log + std::log(norm(matrix)); }
    [[nodiscard]] double log_norm_above() const {
        constexpr double norm_error = 64 * unit;
        const double size = norm(matrix) * (1 + norm_error) + 3 * largest_entry(error);
        return size > 0 ? log + std::log(size) + 64 * unit * (1 + std::abs(log)) : zero_log;
    }
};

/// Its largest entry becomes 1.
Scaled normalized(Scaled x) {
    const double size = largest_entry(x.matrix);
    if (!(size > 0) || !std::isfinite(size)) return x;
    x.matrix /= size;
    x.error = x.error * ((1 + 2 * unit) / size) + absolute(x.matrix) * unit;
    x.log += std::log(size);
    return x;
}

Scaled product(const Scaled& inner, const Scaled& outer) {
    const glm::dmat3 in = absolute(inner.matrix);
    const glm::dmat3 out = absolute(outer.matrix);
    const glm::dmat3 error =
        (out * inner.error + outer.error * (in + inner.error)) * (1 + 16 * unit) +
        out * in * (4 * unit);
    return normalized({outer.matrix * inner.matrix, error, outer.log + inner.log});
}

/// What a linear map does to areas: its cofactor matrix. The norm is a1 a2, and the matrix of a
/// product is the product of the matrices.
Scaled areas_of(const Scaled& lengths) {
    const glm::dmat3& t = lengths.matrix;
    const auto products = [&](int a, int b) {  // the sums of what cross() subtracts
        const glm::dvec3 x = glm::abs(t[a]);
        const glm::dvec3 y = glm::abs(t[b]);
        return glm::dvec3{x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x};
    };
    const glm::dmat3 error =
        glm::dmat3{products(1, 2), products(2, 0), products(0, 1)} * (8 * unit);
    return normalized({{glm::cross(t[1], t[2]), glm::cross(t[2], t[0]), glm::cross(t[0], t[1])},
                       error,
                       2 * lengths.log});
}

/// What a word does to lengths, areas and volumes.
struct Composed {
    Scaled lengths;
    Scaled areas;
    double log_volume = 0;
    double log_volume_above = 0;

    [[nodiscard]] LogStretch stretch() const {
        return {lengths.log_norm(), areas.log_norm(), log_volume};
    }
    [[nodiscard]] LogStretch stretch_above() const {
        return {lengths.log_norm_above(), areas.log_norm_above(), log_volume_above};
    }
    [[nodiscard]] Composed after(const Composed& outer) const {
        return {product(lengths, outer.lengths), product(areas, outer.areas),
                log_volume + outer.log_volume, log_volume_above + outer.log_volume_above};
    }
};

Composed single(const Affine& map) {
    const Scaled lengths = normalized({map.linear, glm::dmat3{0.0}, 0});
    const glm::dmat3& t = lengths.matrix;
    const double volume = std::abs(glm::dot(t[0], glm::cross(t[1], t[2])));
    // The six products that it is made of, each rounded a few times.
    const glm::dvec3 x = glm::abs(t[1]);
    const glm::dvec3 y = glm::abs(t[2]);
    const double error =
        32 * unit *
        glm::dot(glm::abs(t[0]),
                 glm::dvec3{x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x});
    const double log = 3 * lengths.log;
    return {lengths, areas_of(lengths), log + std::log(volume),
            log + std::log(volume + error) + 64 * unit * (1 + std::abs(log))};
}

/// Depth first over the words, with the component they must stay in.
class WordWalk {
  public:
    WordWalk(const Rifs& rifs, int length)
        : rifs_(rifs), component_(set_components(rifs)), length_(length) {
        for (const Affine& map : rifs.maps) single_.push_back(single(map));
    }

    WordTable run() {
        table_.length = length_;
        for (std::size_t m = 0; m < rifs_.maps.size(); ++m) {
            table_.first_word.push_back(table_.words.size());
            first_ = static_cast<int>(m);
            extend(first_, single_[m], 1);
        }
        table_.first_word.push_back(table_.words.size());
        return std::move(table_);
    }

  private:
    void extend(int last, const Composed& word, int length) {
        const int set = rifs_.follow_of[last];
        if (length == length_) {
            table_.words.push_back({first_, set, word.stretch(), word.stretch_above()});
            return;
        }
        for (const int m : rifs_.follow_sets[set].maps) {
            if (component_[rifs_.follow_of[m]] != component_[set]) continue;
            extend(m, single_[m].after(word), length + 1);
        }
    }

    const Rifs& rifs_;
    std::vector<int> component_;
    std::vector<Composed> single_;
    int length_;
    int first_ = 0;
    WordTable table_;
};

/// Adds up the entries of one row; a slot for each follow set.
class RowSum {
  public:
    explicit RowSum(std::size_t sets) : sum_(sets, 0.0), used_(sets, 0) {}

    void add(int to, double weight) {
        if (!used_[to]) columns_.push_back(to);
        used_[to] = 1;
        sum_[to] += weight;
    }
    void close(StepMatrix& matrix) {
        weights_.clear();
        for (const int column : columns_) {
            weights_.push_back(sum_[column]);
            sum_[column] = 0;
            used_[column] = 0;
        }
        matrix.add_row(columns_, weights_);
        columns_.clear();
    }

  private:
    std::vector<double> sum_;
    std::vector<char> used_;
    std::vector<int> columns_;
    std::vector<double> weights_;
};

/// `each(map, add)` adds the entries of the words that begin with a map.
template <class Each>
StepMatrix sums(const Rifs& rifs, const Each& each) {
    const std::vector<int> component = set_components(rifs);
    StepMatrix matrix;
    RowSum row(rifs.follow_sets.size());
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            if (component[rifs.follow_of[m]] != component[s]) continue;
            each(m, [&](int to, double weight) { row.add(to, weight); });
        }
        row.close(matrix);
    }
    return matrix;
}

}  // namespace

LogStretch log_stretch(const Affine& map) { return single(map).stretch(); }

double log_singular_value_function(const LogStretch& stretch, double d, int n) {
    if (d <= 0) return 0;
    if (d > n) return d / n * stretch[n - 1];  // Eq. 6.13
    const int m = static_cast<int>(std::ceil(d));
    const double above = m > 1 ? stretch[m - 2] : 0;
    const double share = d - (m - 1);
    // Eq. 6.12, Erratum 7: (a1 ... a_{m-1})^{m-d} (a1 ... a_m)^{d-m+1}
    if (stretch[m - 1] == zero_log) return zero_log;
    return (1 - share) * above + share * stretch[m - 1];
}

WordTable word_table(const Rifs& rifs, int length) { return WordWalk(rifs, length).run(); }

int affordable_length(const Rifs& rifs, int longest, double budget) {
    const std::vector<int> component = set_components(rifs);
    const std::size_t sets = rifs.follow_sets.size();
    std::vector<double> words(sets, 1);  // from each follow set
    double steps = 0;                    // entries that word_sums() has to add up
    for (const FollowSet& set : rifs.follow_sets) steps += static_cast<double>(set.maps.size());
    for (int length = 1; length < longest; ++length) {
        std::vector<double> longer(sets, 0);
        for (std::size_t s = 0; s < sets; ++s) {
            for (const int m : rifs.follow_sets[s].maps) {
                const int to = rifs.follow_of[m];
                if (component[to] == component[s]) longer[s] += words[to];
            }
        }
        words = std::move(longer);
        double count = 0;
        double most = 0;
        for (const int set : rifs.follow_of) {
            count += words[set];
            most = std::max(most, words[set]);
        }
        if (count > budget || steps * most > 4 * budget) return length;
    }
    return longest;
}

StepMatrix word_sums(const Rifs& rifs, const WordTable& table, double d, int n, Rounding rounding) {
    std::vector<double> phi;
    phi.reserve(table.words.size());
    for (const WordStretch& word : table.words) {
        const LogStretch& stretch = rounding == Rounding::above ? word.above : word.stretch;
        phi.push_back(std::exp(log_singular_value_function(stretch, d, n)));
    }
    return sums(rifs, [&](int m, const auto& add) {
        for (std::size_t w = table.first_word[m]; w < table.first_word[m + 1]; ++w) {
            add(table.words[w].to, phi[w]);
        }
    });
}

StepMatrix map_sums(const Rifs& rifs, const std::vector<double>& weight) {
    return sums(rifs, [&](int m, const auto& add) { add(rifs.follow_of[m], weight[m]); });
}

}  // namespace pxm::host
