#include "host/commands/version.hpp"

#include <nlohmann/json.hpp>

#include "host/commands/build_facts.hpp"
#include "host/text/json_text.hpp"
#include "host/wide/packet/registers.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

Json libraries_json(const BuildFacts& facts) {
    Json libraries = Json::array();
    for (const LibraryFact& library : facts.library_facts) {
        const std::string version = library.version;
        libraries.push_back(
            {{"name", library.name}, {"version", version.empty() ? Json() : Json(version)}});
    }
    return libraries;
}

}  // namespace

std::string version_text() {
    const BuildFacts& facts = build_facts();
    std::string text = std::string("pxm " PXM_VERSION "\nrequired: ") + facts.libraries;
    for (const LeftOut& left : facts.left_out)
        text += std::string("\nleft out: ") + left.what + ": " + left.because;
    return text;
}

std::string version_json() {
    const BuildFacts& facts = build_facts();
    const std::vector<std::string> registers = register_sets();
    Json json = {{"pxm", PXM_VERSION},
                 {"compiler", {{"name", facts.compiler}, {"version", facts.compiler_version}}},
                 {"build_type", facts.build_type},
                 {"flags", facts.flags},
                 {"target", facts.target},
                 {"libraries", libraries_json(facts)},
                 {"registers", {{"used", registers.front()}, {"supported", registers}}},
                 {"left_out", Json::array()}};
    for (const LeftOut& left : facts.left_out)
        json["left_out"].push_back({{"what", left.what}, {"because", left.because}});
    return json_text(json, 2) + "\n";
}

}  // namespace pxm::host
