#include "tests/support/tree_texts.hpp"

#include <filesystem>
#include <set>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

/// Scripts have no extension.
bool is_text(const fs::path& path) {
    static const std::set<std::string> kinds{"",     ".md",    ".hpp", ".cpp", ".inl",
                                             ".txt", ".cmake", ".pxm", ".py",  ".sh"};
    return kinds.contains(path.extension().string());
}

bool is_fetched(const std::string& path) {
    return path.find("/node_modules/") != std::string::npos ||
           path.find("/__pycache__/") != std::string::npos;
}

void add(Texts& texts, const fs::path& path) {
    const std::string name = fs::relative(path, source_dir).generic_string();
    if (is_text(path) && !is_fetched(name)) texts[name] = text_of(path);
}

}  // namespace

bool is_document(const std::string& path) { return path.ends_with(".md"); }

Texts texts_of_the_tree() {
    Texts texts;
    for (const auto& entry : fs::directory_iterator(source_dir))
        if (entry.is_regular_file()) add(texts, entry.path());
    for (const char* top : {"pxm", "dsp_kernels", "host", "tests", "bench", "docs", "scenes",
                            "findings", "cmake", "tools", ".ci"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / top))
            if (entry.is_regular_file()) add(texts, entry.path());
    return texts;
}

}  // namespace pxm::test
