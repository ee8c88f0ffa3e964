#include "host/commands/join_film.hpp"

#include <fmt/format.h>

#include <optional>

#include "host/commands/render_parts.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/film.hpp"
#include "host/output/frame_list.hpp"
#include "host/output/image.hpp"
#include "host/output/statistics_json.hpp"
#include "host/parts/film_parts.hpp"
#include "host/parts/join.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/phase_clock.hpp"
#include "host/process/terminal.hpp"
#include "host/text/number_runs.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// Takes frames one after another, from their parts.
class FrameJoin {
  public:
    FrameJoin(const FilmJoin& join, const FilmSet& film)
        : join_(join), film_(film), stream_(open_film_stream(join.out, film.shape)) {}

    /// False if it was stopped.
    [[nodiscard]] bool take(long frame, const RunControl& control) {
        const auto found = film_.there.find(frame);
        if (found == film_.there.end()) return take_missing(frame), true;
        PartSet parts = read_parts(found->second);
        const auto picture = stream_
                                 ? to_stream(parts, control)
                                 : host::join(parts, path_of_frame(join_.out.out, frame), control);
        if (!picture) return false;
        if (!picture->missing.empty()) missing_.insert(frame);
        if (warnings_.empty() && !picture->warnings.empty())
            warnings_ = fmt::format("frame {}: {}", frame, picture->warnings);
        if (!join_.stats.empty()) write_statistics(frame, picture->statistics);
        return true;
    }

    void finish() {
        if (stream_) stream_->finish();
    }
    [[nodiscard]] const std::set<long>& missing() const { return missing_; }
    [[nodiscard]] const std::string& warnings() const { return warnings_; }

  private:
    void take_missing(long frame) {
        missing_.insert(frame);
        if (!stream_) return;
        bytes_.begin({0, 0, film_.shape.columns, film_.shape.rows});
        stream_->frame(bytes_.bytes());
    }

    std::optional<JoinedPicture> to_stream(PartSet& parts, const RunControl& control) {
        bytes_.begin(parts.heading().grid.window);
        auto picture = host::join(parts, control, [&](const Frame& block) { bytes_.take(block); });
        if (picture) stream_->frame(bytes_.bytes());
        return picture;
    }

    void write_statistics(long frame, Statistics statistics) const {
        statistics.threads = 1;
        statistics.threads_because = "parts were joined";
        write_text_safely(path_of_frame(join_.stats, frame), statistics_json(statistics));
    }

    const FilmJoin& join_;
    const FilmSet& film_;
    std::unique_ptr<FrameStream> stream_;
    ByteFrame bytes_;
    std::set<long> missing_;
    std::string warnings_;
};

std::string told_out(const FilmJoin& join) {
    return join.out.out == "-" ? "the standard output" : printable_path(join.out.out);
}

}  // namespace

void require_film_output(const FilmJoin& join, const std::vector<long>& frames,
                         const FilmShape& shape, const std::vector<Aov>& channels) {
    if (!join.stats.empty() && frames.size() > 1 && !has_frame_number(join.stats))
        throw Error(ErrorKind::setting, "--stats: put the frame's number into the name, as %04d");
    const bool film = join.out.out == "-" || is_film(join.out.out);
    require_image_format(film ? "film.png" : join.out.out, channels);
    if (film && join.out.out != "-") {
        require_ffmpeg(join.out.out);
        require_writable(join.out.out);
    }
    if (film) return;
    (void)open_film_stream(join.out, shape);  // what --format says
    require_frame_number(join.out.out, frames.size());
    for (const long frame : {frames.front(), frames.back()})
        require_writable(path_of_frame(join.out.out, frame));
}

ExitCode join_film(const FilmJoin& join) {
    PhaseClock clock;
    FilmSet film = read_film(join.folder);
    if (!join.frames.empty()) film.frames = join.frames;
    require_film_output(join, film.frames, film.shape, film.channels);
    FrameJoin frames(join, film);
    const bool done = with_progress(join.quiet, [&](const RunControl& control) {
        for (std::size_t i = 0; i < film.frames.size(); ++i) {
            if (*control.stop ||
                !frames.take(film.frames[i], share_of(control, i, film.frames.size())))
                return false;
        }
        return true;
    });
    if (!done) return exit_code_of_signal(received_signal());
    frames.finish();
    tell(frames.warnings());
    if (!frames.missing().empty()) {
        tell(fmt::format("{}: frames that are missing or lack parts: {} ({} of {})\n",
                         printable_path(join.folder), number_runs(frames.missing()),
                         frames.missing().size(), film.frames.size()));
        return ExitCode::parts_missing;
    }
    if (!join.quiet)
        tell(fmt::format("{}: {} frames in {:.2f} s\n", told_out(join), film.frames.size(),
                         clock.lap()));
    return ExitCode::done;
}

}  // namespace pxm::host
