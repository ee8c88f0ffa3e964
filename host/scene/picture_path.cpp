#include "host/scene/picture_path.hpp"

namespace pxm::host {

std::string picture_path(const Scene& scene, const TextureBlock& texture,
                         const FileTexture& source) {
    const auto file = static_cast<std::size_t>(texture.source_position.file);
    if (source.file.starts_with('/') || file >= scene.files.size()) return source.file;
    const std::string& name = scene.files[file].name;
    const auto slash = name.rfind('/');
    return slash == std::string::npos ? source.file : name.substr(0, slash + 1) + source.file;
}

}  // namespace pxm::host
