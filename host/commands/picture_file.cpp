#include "host/commands/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "host/commands/exr_options.hpp"
#include "host/commands/options.hpp"
#include "host/commands/scene_options.hpp"
#include "host/output/encoder.hpp"
#include "host/output/image.hpp"
#include "host/output/taken_windows.hpp"
#include "host/process/limits.hpp"
#include "host/process/phase_clock.hpp"
#include "host/process/terminal.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

std::vector<Aov> aovs_of(const RenderArguments& arguments) {
    const auto aovs = arguments.aov.empty() ? std::vector<Aov>{} : parse_aovs(arguments.aov);
    if (arguments.machine.empty() && std::ranges::find(aovs, Aov::cycles) != aovs.end()) {
        throw Error(ErrorKind::setting,
                    "--aov cycles: cycles are counted on the machine only (--machine MODEL)");
    }
    if (!arguments.machine.empty() && std::ranges::find(aovs, Aov::neighbours) != aovs.end())
        throw Error(ErrorKind::setting,
                    "--aov neighbours: only native renders read the words of cells (no --machine)");
    return aovs;
}

Metadata metadata_of(const RenderArguments& a, const RenderResult& result, SceneCarrier& carrier,
                     double frame) {
    const Statistics& s = result.statistics;
    std::string options = noted_options(a);
    const std::string settings = text_of(parse_settings(a.set));
    if (!settings.empty()) options += (options.empty() ? "" : " ") + settings;
    std::string carried = carrier.text(frame);
    Metadata metadata{{"version", PXM_VERSION},
                      {"scene", carrier.name()},
                      {"engine", s.engine},
                      {"model", s.model},
                      {"numeric", s.numeric},
                      {"options", options},
                      {"pixel_at_eye", fmt::format("{:.17g}", result.pixel_at_eye)},
                      {"pixel_growth", fmt::format("{:.17g}", result.pixel_growth)}};
    for (const auto& entry : exr_metadata(a, s.size)) metadata.push_back(entry);
    if (!carried.empty()) metadata.emplace_back(carried_metadata, std::move(carried));
    return metadata;
}

namespace {

/// The picture's file, from before the first ray on.
class PictureToFile : public PictureTaker {
  public:
    PictureToFile(const RenderArguments& arguments, const std::string& path,
                  const std::vector<Aov>& aovs, Warnings warnings, SceneCarrier& carrier,
                  double frame, const ExtraChannels* extra)
        : arguments_(arguments),
          path_(path),
          aovs_(aovs),
          warnings_(warnings),
          carrier_(carrier),
          frame_(frame),
          extra_(extra) {}

    void begin(const RenderResult& known) override {
        if (warnings_ == Warnings::before) tell(told_ = known.warnings);
        writer_.emplace(path_, known.window, aovs_,
                        metadata_of(arguments_, known, carrier_, frame_), extra_);
    }
    void take(const Frame& part) override {
        writer_->append(part);
        taken_.add(part.crop);
    }
    void finish() { writer_->finish(); }
    /// Ends a picture that was given up: what was not taken is black. False if nothing was.
    bool finish_partial(const RenderResult& result) {
        if (!writer_ || taken_.pixels() == 0 || result.statistics.rays.pixels == 0) return false;
        taken_.fill(result.statistics.size, result.window,
                    [&](const Frame& black) { writer_->append(black); });
        writer_->finish();
        return true;
    }
    [[nodiscard]] long taken_pixels() const { return taken_.pixels(); }
    /// Leaves what was not told yet.
    void take_told(std::string& warnings) const {
        if (warnings.starts_with(told_)) warnings.erase(0, told_.size());
    }

  private:
    const RenderArguments& arguments_;
    const std::string& path_;
    const std::vector<Aov>& aovs_;
    Warnings warnings_;
    SceneCarrier& carrier_;
    double frame_;
    const ExtraChannels* extra_;  // or null
    std::string told_;
    std::optional<ImageWriter> writer_;
    TakenWindows taken_;
};

std::string partial_text(const std::string& out, const RenderResult& result, long taken) {
    const CropWindow& window = result.window;
    const long all = (window.x1 - window.x0) * (window.y1 - window.y0);
    const long known = std::min(taken, static_cast<long>(result.statistics.rays.pixels));
    return fmt::format("{} of {} pixels of {} are black", all - known, all, printable_path(out));
}

}  // namespace

RenderResult write_picture(const RenderArguments& arguments, const RenderRequest& request,
                           const std::string& out, const RunControl& control, Warnings warnings,
                           SceneCarrier& carrier, std::string* partial) {
    PhaseClock clock;
    const std::vector<Aov> aovs = aovs_of(arguments);
    const std::vector<MatteKind> kinds = parse_mattes(arguments.cryptomatte);
    std::vector<MatteLayer> mattes;
    if (!kinds.empty()) mattes = render_mattes(request, kinds, control);
    const ExtraChannels extra = matte_channels(mattes);
    PictureToFile picture(arguments, out, aovs, warnings, carrier, request.frame,
                          kinds.empty() ? nullptr : &extra);
    RenderResult result = render(request, control, &picture);
    picture.take_told(result.warnings);
    if (result.stopped) {
        if (partial && take_over_from_limit() && picture.finish_partial(result))
            *partial = partial_text(out, result, picture.taken_pixels());
        return result;
    }
    PhaseClock write_clock;
    picture.finish();
    PhaseSeconds& phases = result.statistics.seconds;
    phases.write = write_clock.lap();
    phases.total = clock.lap();
    return result;
}

}  // namespace pxm::host
