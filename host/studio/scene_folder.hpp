// The scenes that a studio may open and save: files below the folder that it was started in, with
// the ending .pxm, none of them through a link.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pxm::host {

struct SceneFile {
    std::string text;
    std::string digest;  // of the text: what was seen, when it is saved
};

enum class Saved { done, changed };  // changed: the file is not the one that was seen

class SceneFolder {
  public:
    static constexpr std::size_t most_scenes = 500;        // that are listed
    static constexpr std::size_t scene_bytes = 1U << 20U;  // of a file that is opened or saved

    /// Throws Error(ErrorKind::file) if it is no folder.
    explicit SceneFolder(const std::string& path);

    [[nodiscard]] std::string path() const { return root_.string(); }
    /// Names from the folder on, sorted. What cannot be read is left out.
    [[nodiscard]] std::vector<std::string> scenes() const;

    /// Throws Error: a name that is none or leads out (setting), a file that cannot be read (file).
    [[nodiscard]] SceneFile open(const std::string& name) const;
    /// Writes the scene whole or not at all, if the file is still the one whose digest was seen
    /// (empty: there was none); nothing is written else. Throws as open() does.
    [[nodiscard]] Saved save(const std::string& name, const std::string& text,
                             const std::string& seen) const;

    /// Where a file of that name is or would be, of whatever ending: below the folder, and no part
    /// of the way there is a link. Throws as open() does.
    [[nodiscard]] std::filesystem::path place_of(const std::string& name) const;
    /// A message without the place of the folder, which a page need not know.
    [[nodiscard]] std::string told(const std::string& message) const;

    /// Throws Error(ErrorKind::setting) unless this may be a scene's name here.
    static void require_name(const std::string& name);

  private:
    [[nodiscard]] std::filesystem::path scene_place(const std::string& name) const;

    std::filesystem::path root_;
};

}  // namespace pxm::host
