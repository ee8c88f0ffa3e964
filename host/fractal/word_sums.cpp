#include "host/fractal/word_sums.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "host/fractal/components.hpp"

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

/// What a linear map does to areas: its cofactor matrix. The norm is a1 a2, and the matrix of a
/// product is the product of the matrices.
glm::dmat3 cofactors(const glm::dmat3& t) {
    return {glm::cross(t[1], t[2]), glm::cross(t[2], t[0]), glm::cross(t[0], t[1])};
}

/// A matrix times exp(log), so that products of many do not underflow.
struct Scaled {
    glm::dmat3 matrix{1.0};
    double log = 0;

    [[nodiscard]] double log_norm() const { return log + std::log(norm(matrix)); }
};

Scaled product(const Scaled& inner, const Scaled& outer) {
    Scaled result{outer.matrix * inner.matrix, outer.log + inner.log};
    const double size = norm(result.matrix);
    if (size > 0 && std::isfinite(size)) {
        result.matrix /= size;
        result.log += std::log(size);
    }
    return result;
}

/// What a word does to lengths, areas and volumes.
struct Composed {
    Scaled lengths;
    Scaled areas;
    double log_volume = 0;

    [[nodiscard]] LogStretch stretch() const {
        return {lengths.log_norm(), areas.log_norm(), log_volume};
    }
};

Composed single(const Affine& map) {
    return {product({}, {map.linear, 0}), product({}, {cofactors(map.linear), 0}),
            std::log(std::abs(determinant(map)))};
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
            table_.words.push_back({first_, set, word.stretch()});
            return;
        }
        for (const int m : rifs_.follow_sets[set].maps) {
            if (component_[rifs_.follow_of[m]] != component_[set]) continue;
            extend(m,
                   {product(single_[m].lengths, word.lengths),
                    product(single_[m].areas, word.areas), word.log_volume + single_[m].log_volume},
                   length + 1);
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

double log_singular_value_function(const LogStretch& stretch, double d) {
    if (d <= 0) return 0;
    if (d > 3) return d / 3 * stretch[2];  // Eq. 6.13
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

StepMatrix word_sums(const Rifs& rifs, const WordTable& table, double d) {
    std::vector<double> phi;
    phi.reserve(table.words.size());
    for (const WordStretch& word : table.words) {
        phi.push_back(std::exp(log_singular_value_function(word.stretch, d)));
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
