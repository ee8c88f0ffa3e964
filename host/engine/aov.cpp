#include "host/engine/aov.hpp"

namespace pxm::host {

const char* aov_name(Aov aov) {
    switch (aov) {
        case Aov::z:
            return "Z";
        case Aov::node:
            return "node";
        case Aov::cycles:
            return "cycles";
        case Aov::volumes:
            return "volumes";
        case Aov::level:
            return "level";
        case Aov::heap:
            return "heap";
        case Aov::alpha:
            return "alpha";
        case Aov::object:
            return "object";
        case Aov::word:
            return "word";
        case Aov::normal:
            return "N";
        case Aov::neighbours:
            return "neighbours";
    }
    return "";
}

const std::vector<Aov>& all_aovs() {
    using enum Aov;
    static const std::vector<Aov> all{z,     node,   cycles, volumes, level,     heap,
                                      alpha, object, word,   normal,  neighbours};
    return all;
}

std::vector<AovChannel> channels_of(Aov aov) {
    const std::string name = aov_name(aov);
    if (aov == Aov::z) return {{name, name}};
    if (aov == Aov::normal) return {{"N.X", "N.x"}, {"N.Y", "N.y"}, {"N.Z", "N.z"}};
    return {{name + ".V", name}};
}

}  // namespace pxm::host
