#include "tests/support/campaign/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "host/compile/compile.hpp"
#include "host/engine/engine.hpp"
#include "host/error.hpp"
#include "host/node_program/link.hpp"
#include "host/render/alarms.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/print.hpp"
#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/campaign/draw.hpp"
#include "tests/support/campaign/pixel_judge.hpp"

namespace pxm::test {

using namespace host;

namespace {

bool same_bits(const PixelRecord& p, const PixelRecord& q) {
    return std::memcmp(p.color, q.color, sizeof p.color) == 0 &&
           std::memcmp(p.normal, q.normal, sizeof p.normal) == 0 &&
           std::memcmp(&p.z, &q.z, sizeof p.z) == 0 &&
           std::memcmp(&p.alpha, &q.alpha, sizeof p.alpha) == 0 && p.object == q.object &&
           p.level == q.level && p.word == q.word;
}

/// Whether two engines agree on a pixel as far as decision 4 asks.
bool agree(const PixelRecord& p, const PixelRecord& q) {
    if (p.object != q.object || p.level != q.level || p.word != q.word) return false;
    if (std::isfinite(p.z) && std::abs(p.z - q.z) > 1e-5F * p.z) return false;
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(p.color[i] - q.color[i]) <= 1.0F / 255)) return false;
    return true;
}

class SceneTrial {
  public:
    SceneTrial(const Scene& scene, const TrialSettings& settings)
        : scene_(scene), settings_(settings), draw_(settings.seed) {}

    Trial run() {
        trial_.score.add("scenes");
        try_print();
        if (!compile_scene()) return std::move(trial_);
        if (wants("double")) render("double", Numeric::double_);
        if (wants("float")) render("float", Numeric::single);
        if (wants("dsp32")) render("dsp32", Numeric::dsp32);
        if (wants("wide") && wide::why_not_wide(compiled_, Numeric::single).empty()) render_wide();
        if (stopped()) return std::move(trial_);
        judge_pictures();
        if (wants("heap")) try_heap();
        if (wants("machine")) try_machine();
        return std::move(trial_);
    }

  private:
    [[nodiscard]] bool wants(const std::string& method) const {
        return settings_.only.empty() ||
               std::ranges::find(settings_.only, method) != settings_.only.end();
    }
    [[nodiscard]] bool stopped() const { return settings_.stop && *settings_.stop; }

    void note(const std::string& method, long x, long y, const std::string& what) {
        trial_.score.add("finds");
        const bool first = std::ranges::none_of(
            trial_.finds, [&](const Find& find) { return find.method == method; });
        if (first) trial_.finds.push_back({method, x, y, what});
    }

    /// Law: what is printed is read back as the same scene.
    void try_print() {
        if (!wants("print")) return;
        const std::string text = print_scene(scene_);
        Diagnostics diagnostics;
        const Scene again = parse_text("print.pxm", text, diagnostics);
        if (diagnostics.has_errors()) {
            note("print", -1, -1, diagnostics.text(again.files));
        } else if (!(again == scene_)) {
            note("print", -1, -1, "the print is read back as another scene");
        } else if (print_scene(again) != text) {
            note("print", -1, -1, "the print of the print is another text");
        }
    }

    bool compile_scene() {
        Diagnostics diagnostics;
        check_scene(scene_, diagnostics);
        if (!diagnostics.has_errors()) compiled_ = compile(scene_, 1, diagnostics);
        if (diagnostics.has_errors()) {
            trial_.score.add("scenes refused");
            trial_.refused = diagnostics.text(scene_.files);
            return false;
        }
        compiled_.cell_cap = std::min(compiled_.cell_cap, settings_.cell_cap);
        rendered_ = compiled_;
        if (settings_.spoil_scene) settings_.spoil_scene(rendered_);
        return true;
    }

    [[nodiscard]] EngineResult run_engine(const CompiledScene& scene, Numeric numeric) const {
        return run_reference(scene, {nullptr, numeric, 1}, {settings_.stop, nullptr});
    }

    void keep(const std::string& method, Numeric numeric, Frame frame) {
        std::vector<Alarm> alarms = raise_alarms(compiled_, numeric, frame);
        if (settings_.spoil) settings_.spoil(method, frame);
        trial_.score.add("pictures");
        trial_.score.add("pixels", std::ssize(frame.pixels));
        pictures_.push_back({method, std::move(frame), numeric, std::move(alarms)});
    }
    void render(const std::string& method, Numeric numeric) {
        if (stopped()) return;
        EngineResult result = run_engine(rendered_, numeric);
        if (result.stopped) return;
        if (numeric == Numeric::dsp32) {
            volumes_ = static_cast<double>(result.rays.volumes_tested);
        }
        keep(method, numeric, std::move(result.frame));
    }
    void render_wide() {
        if (stopped()) return;
        EngineResult result = wide::run_wide(rendered_, EngineChoice{}, {settings_.stop, nullptr});
        if (!result.stopped) keep("wide", Numeric::double_, std::move(result.frame));
    }

    /// Whether the definition says which cell a pixel of this scene shows.
    [[nodiscard]] bool is_defined() const {
        return !needs_covers(compiled_) && !compiled_.area && compiled_.samples.size() == 1;
    }

    void judge_pictures() {
        if (pictures_.empty()) return;
        if (!is_defined()) {
            for (const JudgedPicture& picture : pictures_)
                trial_.score.add("rendered only", std::ssize(picture.frame.pixels));
            return;
        }
        PixelJudge judge(compiled_, settings_.patience);
        const CropWindow& crop = compiled_.crop;
        const long columns = crop.x1 - crop.x0, all = columns * (crop.y1 - crop.y0);
        std::set<long> chosen;
        for (long i = 0; i < settings_.by_definition && i < all; ++i)
            chosen.insert(settings_.by_definition < all ? draw_.below(static_cast<int>(all)) : i);
        long disputed = 0;
        for (long i = 0; i < all && !stopped(); ++i) {
            const long x = crop.x0 + i % columns, y = crop.y0 + i / columns;
            const bool dispute = is_disputed(x, y);
            if (dispute) ++disputed;
            if (chosen.contains(i) || (dispute && disputed <= settings_.disputed)) {
                for (const JudgedPicture& picture : pictures_) judge_pixel(judge, picture, x, y);
            } else {
                count_unjudged(dispute);
            }
        }
    }
    [[nodiscard]] bool is_disputed(long x, long y) const {
        const PixelRecord& first = pictures_.front().frame.at(x, y);
        return std::ranges::any_of(pictures_, [&](const JudgedPicture& picture) {
            return !agree(first, picture.frame.at(x, y));
        });
    }
    void count_unjudged(bool dispute) {
        const bool wide = pictures_.back().method == "wide";
        const char* name = dispute ? "disputed and not judged"
                           : wide  ? "agreed by two engines"
                                   : "agreed by the numbers of one engine";
        trial_.score.add(name, std::ssize(pictures_));
    }
    void judge_pixel(PixelJudge& judge, const JudgedPicture& picture, long x, long y) {
        constexpr long enough = 8;  // a picture that is wrong need not be judged to its end
        if (wrong_[picture.method] >= enough) return trial_.score.add("not judged after 8 finds");
        const Opinion opinion = judge.judge(picture, x, y);
        switch (opinion.standing) {
            case Standing::same:
                return trial_.score.add("judged: as defined");
            case Standing::admitted:
                return trial_.score.add("judged: admissible");
            case Standing::rounded:
                return trial_.score.add("judged: rounding, " + picture.method);
            case Standing::excused:
                return trial_.score.add("judged: excused by " + opinion.reason);
            case Standing::unjudged:
                return trial_.score.add("beyond the oracle's patience");
            case Standing::find:
                trial_.score.add("judged: wrong");
                ++wrong_[picture.method];
                return note(picture.method, x, y, opinion.reason);
        }
    }

    [[nodiscard]] const JudgedPicture* picture(const std::string& method) const {
        const auto found = std::ranges::find(pictures_, method, &JudgedPicture::method);
        return found == pictures_.end() ? nullptr : &*found;
    }

    /// Expects every pixel of `frame`, a window of the picture, to be the same in every bit.
    void expect_same(const std::string& method, const JudgedPicture& picture, Frame frame) {
        if (settings_.spoil) settings_.spoil(method, frame);
        for (long y = frame.crop.y0; y < frame.crop.y1; ++y) {
            for (long x = frame.crop.x0; x < frame.crop.x1; ++x) {
                const PixelRecord& p = picture.frame.at(x, y);
                const PixelRecord& q = frame.at(x, y);
                if (same_bits(p, q)) {
                    trial_.score.add("same in every bit");
                } else if (((p.alarms | q.alarms) & alarm_capped) != 0) {
                    trial_.score.add("judged: excused by capped");
                } else {
                    note(method, x, y,
                         fmt::format("object {} level {} word {:06x} z {:.9g} color {:.9g}, but {} "
                                     "has {} {} {:06x} {:.9g} {:.9g}",
                                     q.object, q.level, q.word, q.z, q.color[0], picture.method,
                                     p.object, p.level, p.word, p.z, p.color[0]));
                }
            }
        }
    }

    /// Law: the picture does not depend on the heap (decision 6), covers by area left out.
    void try_heap() {
        const JudgedPicture* roomy = picture("float");
        if (!roomy || compiled_.area || stopped()) return;
        CompiledScene narrow = rendered_;
        narrow.heap = 1 + draw_.below(40);
        EngineResult result = run_engine(narrow, Numeric::single);
        if (!result.stopped) expect_same("heap", *roomy, std::move(result.frame));
    }

    /// Law: a node of the machine shows what native dsp32 shows, on a window of few pixels.
    void try_machine() {
        const JudgedPicture* native = picture("dsp32");
        if (!native || stopped()) return;
        const double pixels = static_cast<double>(native->frame.pixels.size());
        const double affordable = settings_.machine_budget / std::max(1.0, volumes_ / pixels);
        const long side = std::clamp(static_cast<long>(std::sqrt(affordable)), 1L, 8L);
        CompiledScene part = rendered_;
        part.crop = {compiled_.crop.x0, compiled_.crop.y0,
                     std::min(compiled_.crop.x0 + side, compiled_.crop.x1),
                     std::min(compiled_.crop.y0 + side, compiled_.crop.y1)};
        try {
            const NodeProgram program = link(part);
            EngineChoice choice{find_model("964dX"), Numeric::dsp32, 1};
            choice.program_bytes = program.modules_bytes();
            choice.stack_bytes = program.stack_bytes;
            EngineResult result = run_on_machine(part, choice, {settings_.stop, nullptr});
            if (!result.stopped) expect_same("machine", *native, std::move(result.frame));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::machine_limit) throw;
            trial_.score.add("scenes too large for the machine");
        }
    }

    const Scene& scene_;
    const TrialSettings& settings_;
    Draw draw_;
    CompiledScene compiled_;
    CompiledScene rendered_;  // the same, but for what a test spoils
    std::vector<JudgedPicture> pictures_;
    std::map<std::string, long> wrong_;  // pixels of each method
    double volumes_ = 0;                 // that dsp32 tested
    Trial trial_;
};

}  // namespace

const std::vector<std::string>& all_methods() {
    static const std::vector<std::string> methods{"print", "double", "float",  "dsp32",
                                                  "wide",  "heap",   "machine"};
    return methods;
}

Trial try_scene(const Scene& scene, const TrialSettings& settings) {
    return SceneTrial(scene, settings).run();
}

}  // namespace pxm::test
