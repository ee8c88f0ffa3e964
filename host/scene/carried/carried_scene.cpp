#include "host/scene/carried/carried_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <system_error>
#include <variant>

#include "host/error.hpp"
#include "host/files/allowed_folders.hpp"
#include "host/files/carried_text.hpp"
#include "host/files/image_format.hpp"
#include "host/files/regular_file.hpp"
#include "host/scene/carried/carried_json.hpp"
#include "host/scene/picture_path.hpp"
#include "host/scene/scene_path.hpp"
#include "host/text/digest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

/// Of any number of bytes.
std::string digest_of_file(const RegularFile& file) {
    constexpr std::size_t block_bytes = std::size_t{1} << 20U;
    Digest digest;
    for (std::uint64_t at = 0; at < file.bytes(); at += block_bytes)
        digest.add(digest_of(file.read(at, block_bytes)));
    return fmt::format("{:016x}-{}", digest.value(), file.bytes());
}

/// The name of the file that a scene folder had, after its number there.
std::string name_in_folder(const std::string& name) {
    return name.starts_with(':') ? name.substr(std::min(name.find('/'), name.size() - 1) + 1)
                                 : name;
}

/// Where a carried name would be, if the picture were the scene: for messages, and for textures.
std::string place_beside(const std::string& path, const std::string& name) {
    const auto slash = path.rfind('/');
    return (slash == std::string::npos ? "" : path.substr(0, slash + 1)) + name_in_folder(name);
}

/// The texture's file, if it has one.
const FileTexture* file_of(const TextureBlock& texture) {
    return texture.source ? std::get_if<FileTexture>(&*texture.source) : nullptr;
}

/// By their names, as they were put there.
Scene parse_by_names(const CarriedScene& carried, Diagnostics& diagnostics,
                     const LetNumber& let_number, double frame) {
    const auto find = [&](const std::string& name) {
        return std::ranges::find(carried.files, name, &SourceFile::name);
    };
    const FileReader reader = [&](const std::string& name) {
        const auto found = find(name);
        if (found == carried.files.end())
            throw Error(ErrorKind::file, "the picture does not carry it");
        return found->text;
    };
    const IncludeFinder finder = [&](const std::string& beside, const std::string& written) {
        if (find(beside) != carried.files.end()) return beside;
        const std::string below = fs::path(written).lexically_normal().string();
        const auto named = std::ranges::find_if(carried.files, [&](const SourceFile& file) {
            return file.name.starts_with(':') && name_in_folder(file.name) == below;
        });
        return named == carried.files.end() ? beside : named->name;
    };
    const SourceFile& scene = carried.files.front();
    return parse_text(scene.name, scene.text, diagnostics, reader, let_number, frame, finder);
}

/// Reads a scene from the disk as parse_scene() does, under names that start at its folder. What is
/// found by its name in a scene folder gets a colon, that folder's number and its place there.
class NamedFiles {
  public:
    NamedFiles(const std::string& path, const std::vector<std::string>& allowed)
        : path_(path), allowed_(path, allowed) {}

    /// The files, the scene first.
    std::vector<SourceFile> read() {
        files_.push_back({fs::path(path_).filename().string(), read_file(path_)});
        const IncludeFinder finder = [&](const std::string& beside, const std::string& written) {
            return name_of(beside, written);
        };
        const FileReader reader = [&](const std::string& name) {
            const std::string place = place_of(name);
            files_.push_back({name, read_file(allowed_.resolved(place), place)});
            return files_.back().text;
        };
        const SourceFile scene = files_.front();  // others come to the list
        Diagnostics diagnostics;
        (void)parse_text(scene.name, scene.text, diagnostics, reader, nullptr, 0, finder);
        return std::move(files_);
    }

  private:
    [[nodiscard]] std::string place_of(const std::string& name) const {
        for (std::size_t i = 0; i < folders_.size(); ++i) {
            const std::string start = fmt::format(":{}/", i);
            if (name.starts_with(start)) return folders_[i] + "/" + name.substr(start.size());
        }
        return (fs::path(path_).parent_path() / name).lexically_normal().string();
    }

    std::string name_of(const std::string& beside, const std::string& written) {
        std::error_code failed;
        if (fs::exists(place_of(beside), failed)) return beside;
        const auto found = find_included(written);
        if (!found) return beside;
        allowed_.allow(found->folder);
        auto known = std::ranges::find(folders_, found->folder);
        if (known == folders_.end()) known = folders_.insert(known, found->folder);
        return fmt::format(":{}/{}", known - folders_.begin(),
                           fs::path(written).lexically_normal().string());
    }

    std::string path_;
    AllowedFolders allowed_;
    std::vector<std::string> folders_;
    std::vector<SourceFile> files_;
};

CarriedScene left_out(const std::string& why) {
    CarriedScene carried;
    carried.version = PXM_VERSION;
    carried.left_out = why;
    return carried;
}

/// The pictures of the textures; `scene` was read from the disk, `named` from the same texts.
std::vector<CarriedPicture> pictures_of(const Scene& scene, const Scene& named) {
    std::vector<CarriedPicture> pictures;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const FileTexture* source = file_of(scene.textures[i]);
        if (source == nullptr) continue;
        const RegularFile file(picture_path(scene, scene.textures[i], *source));
        const TextureBlock& texture = named.textures[i];
        pictures.push_back({picture_path(named, texture, *file_of(texture)), digest_of_file(file)});
    }
    return pictures;
}

}  // namespace

std::vector<std::string> CarriedScene::values_of(const std::string& option) const {
    std::vector<std::string> values;
    for (const auto& [name, value] : options)
        if (name == option) values.push_back(value);
    return values;
}

CarriedScene carry(const std::string& path, const std::vector<std::string>& allowed) {
    if (auto own = carried_scene_at(path)) return *std::move(own);
    CarriedScene carried;
    carried.version = PXM_VERSION;
    carried.files = NamedFiles(path, allowed).read();
    if (!is_carried_name(carried.files.front().name)) carried.files.front().name = "scene.pxm";
    for (const SourceFile& file : carried.files) {
        if (fs::path(file.name).is_absolute())
            return left_out("it includes a file by its place on a disk");
        if (!is_carried_name(file.name)) return left_out("it includes a file without a sound name");
    }
    Diagnostics diagnostics;
    const Scene scene = parse_scene(path, diagnostics, allowed);
    const Scene named = parse_by_names(carried, diagnostics, nullptr, 0);
    if (!(named == scene) || named.textures.size() != scene.textures.size())
        return left_out("its files do not stay the same under names that start at its folder");
    carried.has_frames = scene.animation.has_value();
    carried.pictures = pictures_of(scene, named);
    for (const CarriedPicture& picture : carried.pictures) {
        if (fs::path(picture.name).is_absolute())
            return left_out("it shows a picture by its place on a disk");
        if (!is_carried_name(picture.name))
            return left_out("it shows a picture without a sound name");
    }
    return carried;
}

std::optional<CarriedScene> carried_scene_at(const std::string& path) {
    std::error_code failed;
    if (!fs::is_regular_file(path, failed)) return std::nullopt;
    const RegularFile picture(path);
    const FoundFormat found = found_format(picture.read(0, image_head_bytes));
    if (!found.format || *found.format == ImageFormat::pnm) return std::nullopt;
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::scene, fmt::format("{}: {}", printable_path(path), why));
    };
    if (*found.format != ImageFormat::png && *found.format != ImageFormat::openexr)
        refuse(fmt::format("a {} picture carries no scene: PNG and OpenEXR pictures of pxm do",
                           found.name));
    const auto text = carried_text(picture);
    if (!text)
        refuse("a picture that carries no scene: pxm has not made it, or did so with --no-scene");
    CarriedScene carried;
    try {
        carried = carried_of_json(*text);
    } catch (const std::exception&) {
        refuse("the scene that it carries is not written as pxm does it");
    }
    if (!carried.left_out.empty())
        refuse("a picture that carries no scene: " + printable(carried.left_out, 200));
    return carried;
}

Scene parse_carried(const CarriedScene& carried, const std::string& path, Diagnostics& diagnostics,
                    const LetNumber& let_number, double frame) {
    Scene scene = parse_by_names(carried, diagnostics, let_number, frame);
    scene.files.front().name = path;
    for (std::size_t i = 1; i < scene.files.size(); ++i)
        scene.files[i].name = place_beside(path, scene.files[i].name);
    return scene;
}

void refuse_other_pictures(const CarriedScene& carried, const std::string& path, const Scene& scene,
                           Diagnostics& diagnostics) {
    for (const TextureBlock& texture : scene.textures) {
        const FileTexture* source = file_of(texture);
        if (source == nullptr) continue;
        const std::string place = picture_path(scene, texture, *source);
        const auto known = std::ranges::find_if(carried.pictures, [&](const CarriedPicture& one) {
            return place_beside(path, one.name) == place;
        });
        std::error_code failed;
        if (known == carried.pictures.end() || !fs::is_regular_file(place, failed)) continue;
        if (digest_of_file(RegularFile(place)) == known->digest) continue;
        diagnostics.error(texture.source_position,
                          fmt::format("texture \"{}\": {} is not the picture that was there when "
                                      "this one was rendered",
                                      printable(texture.name), printable_path(place)));
    }
}

}  // namespace pxm::host
