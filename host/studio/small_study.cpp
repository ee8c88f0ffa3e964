#include "host/studio/small_study.hpp"

#include <filesystem>

#include "host/files/regular_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/studio/private_folder.hpp"
#include "host/study/watched_study.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t report_bytes = 8U << 20U;
constexpr const char* table_names[] = {"scenes", "nodes", "curves", "points"};

std::string whole_file(const std::string& path) {
    const RegularFile file(path, path);
    return file.read(0, report_bytes);
}

/// The scene's own name, without its folders: titles have it.
std::string bare_name(const std::string& name) { return name.substr(name.rfind('/') + 1); }

/// The text with names of files in a folder that is gone by then as names alone.
std::string without_folder(std::string text, const std::string& folder) {
    for (std::size_t at = 0; (at = text.find(folder + "/", at)) != std::string::npos;)
        text.erase(at, folder.size() + 1);
    return text;
}

}  // namespace

StudyFindings study_asked(const AskedStudy& asked, int threads, const std::atomic<bool>& stop,
                          const std::function<void(double)>& progress) {
    const PrivateFolder folder;
    StudyRequest request;
    request.kind = asked.kind;
    request.scenes = {folder.path() + "/" + bare_name(asked.scene.name)};
    request.folder = folder.path() + "/study";
    request.size = asked.size;
    request.threads = threads;
    request.repeats = 1;
    request.quiet = true;
    write_text_safely(request.scenes.front(), asked.scene.text);
    StudyFindings findings;
    findings.stopped = !run_watched_study(request, {&stop, progress});
    if (findings.stopped) return findings;
    for (const char* name : table_names) {
        const std::string table = request.folder + "/" + name + ".csv";
        if (std::filesystem::exists(table))
            findings.tables.push_back(
                {std::string(name) + ".csv", without_folder(whole_file(table), folder.path())});
    }
    findings.report = without_folder(whole_file(request.folder + "/report.html"), folder.path());
    return findings;
}

}  // namespace pxm::host
