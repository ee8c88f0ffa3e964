#include "host/fractal/measure/random_words.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pxm::host {

namespace {

constexpr std::size_t all_words = 1 << 12;  // of more than one map, all sets together: 0.5 MB
constexpr int most_maps = 64;               // of a word
constexpr double vanishing = 0x1p-60;       // a map this small leaves nothing to what comes next

/// Of each set: the probabilities of its maps.
std::vector<std::vector<double>> shares_of(const Rifs& rifs, const std::vector<double>& weights) {
    std::vector<std::vector<double>> shares;
    for (const FollowSet& set : rifs.follow_sets) {
        std::vector<double>& own = shares.emplace_back();
        for (const int m : set.maps) own.push_back(weights[m]);
        const double sum = std::accumulate(own.begin(), own.end(), 0.0);
        for (double& share : own) share = sum > 0 ? share / sum : 1 / double(own.size());
    }
    return shares;
}

double largest_entry(const glm::dmat3& linear) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(linear[i][j]));
    }
    return largest;
}

}  // namespace

RandomWords::RandomWords(const Rifs& rifs, const std::vector<double>& weights,
                         const std::vector<glm::dvec4>& colors) {
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        passages_.push_back({rifs.maps[m],
                             {1 - colors[m].a, glm::dvec3{colors[m]} * colors[m].a},
                             static_cast<std::uint32_t>(rifs.follow_of[m])});
    }
    const auto shares = shares_of(rifs, weights);
    const std::size_t most_words = all_words / rifs.follow_sets.size();
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        sets_.push_back(choice(rifs, shares, s, most_words));
    }
}

bool RandomWords::is_worth_splitting(const Likely& word) const {
    return word.maps < most_maps && largest_entry(passages_[word.passage].map.linear) > vanishing;
}

/// The likeliest word is split into those that go on by one map, as long as there is room.
RandomWords::Choice RandomWords::choice(const Rifs& rifs,
                                        const std::vector<std::vector<double>>& share,
                                        std::size_t set, std::size_t most_words) {
    std::vector<Likely> open;  // a heap: the likeliest first
    std::vector<Likely> done;
    for (std::size_t i = 0; i < share[set].size(); ++i) {
        const int m = rifs.follow_sets[set].maps[i];
        if (share[set][i] > 0) open.push_back({share[set][i], static_cast<std::uint32_t>(m), 1});
    }
    std::make_heap(open.begin(), open.end());
    std::size_t made = 0;
    while (!open.empty()) {
        std::pop_heap(open.begin(), open.end());
        const Likely word = open.back();
        open.pop_back();
        const std::uint32_t inside = passages_[word.passage].inside;
        made += share[inside].size();
        if (made > most_words || !is_worth_splitting(word)) {
            made -= share[inside].size();
            done.push_back(word);
            continue;
        }
        for (std::size_t i = 0; i < share[inside].size(); ++i) {
            if (!(share[inside][i] > 0)) continue;
            const Passage& next = passages_[rifs.follow_sets[inside].maps[i]];
            const Passage& first = passages_[word.passage];
            const Passage longer{then(next.map, first.map), first.blend.then(next.blend),
                                 next.inside};
            open.push_back({word.probability * share[inside][i],
                            static_cast<std::uint32_t>(passages_.size()), word.maps + 1});
            std::push_heap(open.begin(), open.end());
            passages_.push_back(longer);
        }
    }
    std::vector<double> probabilities;
    std::vector<std::uint32_t> passages;
    for (const Likely& word : done) {
        probabilities.push_back(word.probability);
        passages.push_back(word.passage);
    }
    return {AliasTable(probabilities), std::move(passages)};
}

}  // namespace pxm::host
