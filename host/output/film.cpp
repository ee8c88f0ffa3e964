#include "host/output/film.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "host/error.hpp"
#include "host/files/safe_file.hpp"
#include "host/text/printable.hpp"

extern char** environ;

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

std::string film_extension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// How ffmpeg encodes: visually without loss, as far as the format goes, and the same bytes of the
/// same frames.
std::vector<std::string> encoding(const std::string& extension) {
    const std::string even =
        "pad=ceil(iw/2)*2:ceil(ih/2)*2,"
        "scale=out_color_matrix=bt709:out_range=tv";
    std::vector<std::string> words{"-map_metadata", "-1",       "-fflags",
                                   "+bitexact",     "-flags:v", "+bitexact"};
    const auto add = [&](const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    const std::vector<std::string> color{"-colorspace", "bt709",        "-color_primaries", "bt709",
                                         "-color_trc",  "iec61966-2-1", "-color_range",     "tv"};
    if (extension == ".mp4") {
        add({"-vf", even, "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "17", "-movflags",
             "+faststart"});
        add(color);
    } else if (extension == ".webm") {
        add({"-vf", even, "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "24", "-b:v", "0"});
        add(color);
    } else {
        add({"-filter_complex", "[0:v]split[a][b];[a]palettegen[p];[b][p]paletteuse"});
    }
    return words;
}

std::string program_in_path(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::string folders = path ? path : "";
    for (std::size_t at = 0; at <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        const std::string file = folders.substr(at, end - at) + "/" + name;
        struct stat status {};
        if (end > at && stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
            access(file.c_str(), X_OK) == 0)
            return file;
        at = end + 1;
    }
    return {};
}

/// ffmpeg, reading frames from our end of a pipe.
class Ffmpeg {
  public:
    Ffmpeg(const std::string& path, std::vector<std::string> words) : path_(path) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) cannot_write(path_, strerror(errno));
        writing_end_ = ends[1];
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        // SIGPIPE and what a terminal sends are ours to answer.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        const int error = posix_spawn(&child_, words.front().c_str(), &actions, &attributes,
                                      arguments.data(), environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[0]);
        if (error != 0) {
            child_ = -1;
            close_pipe();
            cannot_write(path_, fmt::format("ffmpeg does not start: {}", strerror(error)));
        }
    }
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;
    ~Ffmpeg() {
        close_pipe();
        if (child_ > 0) kill(child_, SIGKILL);
        if (child_ > 0) wait_for_end();
    }

    void write(std::span<const unsigned char> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(writing_end_, bytes.data(), bytes.size());
            if (written >= 0) {
                bytes = bytes.subspan(static_cast<std::size_t>(written));
            } else if (errno == EPIPE) {
                cannot_write(path_, "ffmpeg gave up");  // why it has said itself
            } else if (errno != EINTR) {
                cannot_write(path_, strerror(errno));
            }
        }
    }

    void finish() {
        close_pipe();
        if (!wait_for_end()) cannot_write(path_, "ffmpeg failed");
    }

  private:
    void close_pipe() {
        if (writing_end_ >= 0) close(writing_end_);
        writing_end_ = -1;
    }
    bool wait_for_end() {
        int status = 0;
        while (waitpid(child_, &status, 0) < 0 && errno == EINTR) continue;
        child_ = -1;
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

    std::string path_;
    pid_t child_ = -1;
    int writing_end_ = -1;
};

class Film : public FrameStream {
  public:
    Film(const std::string& path, const FilmShape& shape)
        : part_(path, Places::any), ffmpeg_(path, words(path, part_.beside(), shape)) {}

    void frame(std::span<const unsigned char> rgb) override { ffmpeg_.write(rgb); }
    void finish() override {
        ffmpeg_.finish();
        part_.commit();
    }

  private:
    static std::vector<std::string> words(const std::string& path, const std::string& beside,
                                          const FilmShape& shape) {
        std::vector<std::string> words{program_in_path("ffmpeg"),
                                       "-nostdin",
                                       "-loglevel",
                                       "error",
                                       "-y",
                                       "-f",
                                       "rawvideo",
                                       "-pix_fmt",
                                       "rgb24",
                                       "-s",
                                       fmt::format("{}x{}", shape.columns, shape.rows),
                                       "-framerate",
                                       fmt::format("{}", shape.rate),
                                       "-i",
                                       "pipe:0"};
        const std::vector<std::string> how = encoding(film_extension(path));
        words.insert(words.end(), how.begin(), how.end());
        words.push_back("file:" + beside);
        return words;
    }

    PartFile part_;
    Ffmpeg ffmpeg_;
};

}  // namespace

bool is_film(const std::string& path) {
    const std::string extension = film_extension(path);
    return extension == ".mp4" || extension == ".webm" || extension == ".gif";
}

void require_ffmpeg(const std::string& path) {
    if (!program_in_path("ffmpeg").empty()) return;
    throw Error(ErrorKind::setting,
                fmt::format("{}: films are written by ffmpeg, which is not installed: apt-get "
                            "install ffmpeg, or write frames (-o frames/%04d.png)",
                            printable_path(path)));
}

std::unique_ptr<FrameStream> make_film(const std::string& path, const FilmShape& shape) {
    require_ffmpeg(path);
    return std::make_unique<Film>(path, shape);
}

}  // namespace pxm::host
