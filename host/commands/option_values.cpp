#include "host/commands/option_values.hpp"

#include <string_view>

#include "host/engine/aov.hpp"
#include "host/export/export_format.hpp"
#include "host/scene/words.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

namespace {

/// The names of a list with bars between them.
template <class List, class Name>
std::string bars(const List& list, const Name& name) {
    std::string text;
    for (const auto& one : list) {
        if (!text.empty()) text += '|';
        text += name(one);
    }
    return text;
}

template <class Words>
std::string words(const Words& list) {
    return bars(list, [](const auto& word) { return word.text; });
}

std::string model_words() {
    return bars(models(), [](const Model& model) { return model.name; });
}

std::string channel_words() {
    return bars(all_aovs(), [](Aov aov) { return aov_name(aov); }) + ",...";
}

}  // namespace

std::vector<ValueName> value_names() {
    return {
        {"", "scene", "SCENE"},
        {"", "scenes", "SCENE"},
        {"", "--set", "KEY=VALUE"},
        {"", "--allow", "DIR"},
        {"", "--limit-seconds", "SECONDS"},
        {"", "--limit-memory", "BYTES"},
        {"", "--size", "WxH"},
        {"", "--machine", model_words()},
        {"", "--numeric", words(numeric_words)},
        {"", "--stats", "FILE.json"},
        {"render", "--out", "FILE"},
        {"render", "--program", "default|asm"},
        {"render", "--cost-model", "FILE.json"},
        {"render", "--part", "I/N"},
        {"render", "--claim", "DIR"},
        {"", "--keep", "DIR"},
        {"render", "--crop", "X0,Y0,X1,Y1"},
        {"render", "--covers", "on|off|area|TMIN,TMAX"},
        {"render", "--shading", words(shading_words)},
        {"render", "--intersect", words(intersect_words)},
        {"render", "--lipschitz", words(lipschitz_words)},
        {"render", "--volume", words(volume_words)},
        {"render", "--frames", "LIST"},
        {"render", "--format", "y4m|ppm"},
        {"render", "--aov", channel_words()},
        {"render", "--half", "color|Z|N|alpha,..."},
        {"render", "--cryptomatte", "object|map,..."},
        {"render", "--pixel", "X,Y"},
        {"join", "folder", "DIR"},
        {"join", "--out", "FILE"},
        {"join", "--format", "y4m|ppm"},
        {"inspect", "--point", "MAP,..."},
        {"inspect", "--out", "FILE"},
        {"points", "--out", "FILE.ply"},
        {"points", "--precision", "auto|float|double"},
        {"points", "--offset", "X,Y,Z"},
        {"import", "file", "FILE"},
        {"import", "--out", "FILE.pxm"},
        {"import", "--entry", "ENTRY"},
        {"export", "--out", "FILE"},
        {"export", "--format", export_format_words()},
        {"export", "--shape", "auto|ball|box|oriented|hull|FILE"},
        {"export", "--detail", "LENGTH"},
        {"compare", "a", "FILE.exr"},
        {"compare", "b", "FILE.exr"},
        {"study", "kind", "balance|error|stability|shading"},
        {"study", "--out", "DIR"},
        {"models", "--token", model_words()},
        {"asm", "files", "FILE"},
        {"asm", "--out", "FILE.o"},
        {"asm", "--run", "LABEL"},
        {"asm", "--break", "LABEL"},
        {"completion", "shell", "bash|zsh|fish"},
    };
}

}  // namespace pxm::host
