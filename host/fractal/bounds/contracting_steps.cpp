#include "host/fractal/bounds/contracting_steps.hpp"

#include <algorithm>
#include <glm/matrix.hpp>
#include <utility>

#include "host/fractal/system/cycle_mean.hpp"
#include "host/fractal/system/quadratic_norm.hpp"
#include "host/fractal/system/words.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double rounding = 1 + 1e-13;  // a factor that covers the rounding of a singular value

std::vector<StepMap> maps_of(const Rifs& rifs) {
    std::vector<StepMap> maps;
    for (const Affine& map : rifs.maps) {
        maps.push_back({map, BracketMatrix{map.linear}, bracket(map.translation)});
    }
    return maps;
}

double lip_at_most(const glm::dmat3& nearly, const BracketMatrix& linear) {
    return std::max(lipschitz_constant({nearly, glm::dvec3{0.0}}) * rounding, norm_at_most(linear));
}

Steps plain_steps(const Rifs& rifs) {
    Steps steps;
    steps.maps = maps_of(rifs);
    steps.weight = weights_of(largest_cycle_mean(rifs));
    std::vector<double> lip;
    for (const StepMap& map : steps.maps) lip.push_back(lip_at_most(map.map.linear, map.linear));
    for (const FollowSet& set : rifs.follow_sets) {
        std::vector<Step>& from = steps.from.emplace_back();
        for (const int m : set.maps) from.push_back({rifs.follow_of[m], m, lip[m]});
    }
    return steps;
}

std::optional<Steps> framed_steps(const Rifs& rifs) {
    const auto norm = contracting_norm(rifs);
    if (!norm) return std::nullopt;
    const std::vector<glm::dmat3>& frame = norm->frame;
    Steps steps;
    steps.maps = maps_of(rifs);
    steps.weight.assign(frame.size(), 1.0);
    Frames frames{frame, {}, {}};
    for (const glm::dmat3& of_set : frame) {
        frames.into.push_back(glm::inverse(of_set));
        frames.proven_into.push_back(inverse_of_lower(of_set));
    }
    for (std::size_t s = 0; s < frame.size(); ++s) {
        std::vector<Step>& from = steps.from.emplace_back();
        for (const int m : rifs.follow_sets[s].maps) {
            const int to = rifs.follow_of[m];
            const glm::dmat3 nearly = frames.into[s] * rifs.maps[m].linear * frame[to];
            const BracketMatrix framed =
                frames.proven_into[s] * (steps.maps[m].linear * BracketMatrix{frame[to]});
            from.push_back({to, m, lip_at_most(nearly, framed)});
        }
    }
    steps.frames = std::move(frames);
    return steps;
}

StepMap middle_of(const ContractingWord& word) {
    StepMap result{{}, word.linear, word.translation};
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
            result.map.linear[c][r] = word.linear[c][static_cast<std::size_t>(r)].middle();
        }
        result.map.translation[c] = word.translation[static_cast<std::size_t>(c)].middle();
    }
    return result;
}

std::optional<Steps> word_steps(const Rifs& rifs) {
    const auto code = contracting_words(rifs, word_budget);
    if (!code) return std::nullopt;
    Steps steps;
    steps.weight.assign(rifs.follow_sets.size(), 1.0);
    steps.from.resize(rifs.follow_sets.size());
    for (const ContractingWord& word : code->words) {
        const int map = static_cast<int>(steps.maps.size());
        steps.from[word.from].push_back({word.to, map, word.lip * rounding});
        steps.maps.push_back(middle_of(word));
    }
    return steps;
}

}  // namespace

std::optional<Steps> contracting_steps(const Rifs& rifs, ContractionProof proof) {
    switch (proof) {
        case ContractionProof::cycle_mean:
            return plain_steps(rifs);
        case ContractionProof::spectral_radius:
            return framed_steps(rifs);
        case ContractionProof::words:
            return word_steps(rifs);
        case ContractionProof::none:
            break;
    }
    return std::nullopt;
}

}  // namespace pxm::host
