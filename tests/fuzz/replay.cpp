// A fuzz target without its fuzzer: takes the files, and all that lies in the folders, that are
// named. Under any compiler; what is a find ends the process.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

int replay(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    std::fprintf(stderr, "%s\n", path.c_str());
    (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    // Cut short anywhere, as by a full disk: a few places, the same every time.
    constexpr std::size_t cuts = 16;
    for (std::size_t i = 1; i < cuts; ++i)
        (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()),
                                     text.size() * i / cuts);
    return 1;
}

}  // namespace

int main(int count, char** arguments) {
    int files = 0;
    for (int i = 1; i < count; ++i) {
        if (fs::is_regular_file(arguments[i])) files += replay(arguments[i]);
        if (!fs::is_directory(arguments[i])) continue;
        for (const auto& entry : fs::recursive_directory_iterator(arguments[i]))
            if (entry.is_regular_file()) files += replay(entry.path());
    }
    std::printf("%d files\n", files);
    return files > 0 ? 0 : 1;
}
