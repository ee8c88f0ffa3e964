// Falconer's affinity dimension (Sec. 6.4.1 with Erratum 7): the d at which the sum of phi^d over
// all words of k maps neither grows nor falls with k. For almost all translations it is the
// attractor's dimension, if Lip < 1/2 [Falconer88] [Solomyak98]. Only what the maps do within the
// plane or line that the attractor lies in counts. Not clamped at the dimension of that.
#pragma once

#include <optional>
#include <string>

#include "host/fractal/system/growth.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct Affinity {            // what is known of the affinity dimension
    double value = 0;        // the dimension, or the best that is known of it
    double upper = 0;        // the dimension is not larger: proven
    bool exact = false;      // value is the dimension, up to rounding
    std::string why;         // how it was found
    int word_length = 1;     // longest words looked at
    bool conformal = false;  // all maps are similitudes in some coordinates
};

/// Precondition: the system contracts, and every follow set is reached from the start.
[[nodiscard]] Affinity affinity_dimension(const Rifs& rifs);

/// The closed form for maps whose singular values multiply along words, up to bounded factors: all
/// triangular in one order of the axes [FM07], or so except for a plane of two axes that every map
/// turns and scales as a whole. Nothing if the maps are neither.
struct ClosedForm {
    Interval dimension;  // where it lies
    std::string why;     // why the form applies
};
/// `n`: maps have entries in the first n axes only.
[[nodiscard]] std::optional<ClosedForm> affinity_of_triangular(const Rifs& rifs, int n);

}  // namespace pxm::host
