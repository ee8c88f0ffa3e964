#include "host/output/spared_inputs.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <variant>

#include "host/error.hpp"
#include "host/scene/picture_path.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

std::vector<InputFile> inputs_of(const Scene& scene) {
    std::vector<InputFile> inputs;
    for (const SourceFile& file : scene.files)
        inputs.push_back({file.name, inputs.empty() ? "the scene" : "a file that it includes"});
    for (const TextureBlock& texture : scene.textures) {
        const auto* image = texture.source ? std::get_if<FileTexture>(&*texture.source) : nullptr;
        if (image == nullptr) continue;
        inputs.push_back({picture_path(scene, texture, *image), "a texture of the scene"});
    }
    return inputs;
}

bool is_same_file(const std::string& a, const std::string& b) {
    struct stat of_a {
    }, of_b{};
    const bool a_is_there = stat(a.c_str(), &of_a) == 0;
    const bool b_is_there = stat(b.c_str(), &of_b) == 0;
    if (a_is_there != b_is_there) return false;
    if (a_is_there) {
        return S_ISREG(of_a.st_mode) && of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
    }
    std::error_code error;
    const auto place = [&](const std::string& path) {
        return fs::weakly_canonical(fs::absolute(path), error);
    };
    return place(a) == place(b);
}

void require_spared(const std::vector<std::string>& outputs, const std::vector<InputFile>& inputs) {
    for (const std::string& output : outputs) {
        for (const InputFile& input : inputs) {
            if (!is_same_file(output, input.path)) continue;
            const std::string name =
                output == input.path || input.what == "the scene" || input.what == "the picture"
                    ? ""
                    : fmt::format(" ({})", printable_path(input.path));
            throw Error(ErrorKind::setting, fmt::format("{} would be written over {}{}",
                                                        printable_path(output), input.what, name));
        }
    }
}

}  // namespace pxm::host
