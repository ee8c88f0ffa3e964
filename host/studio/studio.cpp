#include "host/studio/studio.hpp"

#include <atomic>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "host/error.hpp"
#include "host/process/give_up.hpp"
#include "host/studio/answers_json.hpp"
#include "host/studio/asks_json.hpp"
#include "host/studio/assets.hpp"
#include "host/studio/brought_file.hpp"
#include "host/studio/deadline.hpp"
#include "host/studio/gate.hpp"
#include "host/studio/http_server.hpp"
#include "host/studio/jobs.hpp"
#include "host/studio/picture.hpp"
#include "host/studio/picture_parts.hpp"
#include "host/studio/presence.hpp"
#include "host/studio/scene_answers.hpp"
#include "host/studio/scene_export.hpp"
#include "host/studio/scene_folder.hpp"
#include "host/studio/small_study.hpp"
#include "host/studio/turns.hpp"

namespace pxm::host {

namespace {

constexpr const char* json_type = "application/json";
constexpr int most_pages = 16;
constexpr int computing_at_once = 3;

HttpAnswer answer_of(std::string json) { return {200, json_type, std::move(json)}; }

/// The errors of the house as answers. They are no failures of HTTP: a scene that is being written
/// is wrong most of the time.
template <class Work>
HttpAnswer guarded(const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        return answer_of(error_json(error));
    } catch (const std::bad_alloc&) {
        return answer_of(error_json({ErrorKind::failed, "out of memory"}));
    } catch (const std::exception& error) {
        return answer_of(error_json({ErrorKind::failed, error.what()}));
    }
}

}  // namespace

class Studio::Desk {
  public:
    explicit Desk(const StudioSettings& settings)
        : settings_(settings),
          folder_(settings.folder),
          server_(std::make_unique<HttpServer>(settings.port)),
          gate_(server_->port()) {
        if (!settings.scene.empty()) (void)folder_.open(settings.scene);
        answers_ = {{"GET /api/start", [this](const HttpRequest&) { return start(); }},
                    {"GET /api/alive", [this](const HttpRequest& r) { return alive(r); }},
                    {"POST /api/leave", [this](const HttpRequest& r) { return leave(r); }},
                    {"POST /api/open", [this](const HttpRequest& r) { return open(r); }},
                    {"POST /api/save", [this](const HttpRequest& r) { return save(r); }},
                    {"POST /api/check", [this](const HttpRequest& r) { return check(r); }},
                    {"POST /api/inspect", [this](const HttpRequest& r) { return inspect(r); }},
                    {"POST /api/png", [this](const HttpRequest& r) { return png(r); }},
                    {"POST /api/progress", [this](const HttpRequest& r) { return progress(r); }},
                    {"POST /api/import", [this](const HttpRequest& r) { return import(r); }},
                    {"POST /api/study", [this](const HttpRequest& r) { return study(r); }},
                    {"POST /api/export", [this](const HttpRequest& r) { return exported(r); }},
                    {"POST /api/pick", [this](const HttpRequest& r) { return pick(r); }},
                    {"POST /api/pixel", [this](const HttpRequest& r) { return pixel(r); }}};
        server_->start({[this](const HttpRequest& r) { return gate_.refusal(r); },
                        [this](const HttpRequest& r, HttpBody& body) { return answer(r, body); }});
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;
    ~Desk() {
        turns_.close();
        server_.reset();
    }

    [[nodiscard]] const Gate& gate() const { return gate_; }
    [[nodiscard]] const Presence& presence() const { return presence_; }

  private:
    [[nodiscard]] HttpAnswer with_guard(HttpAnswer answer) const {
        for (HttpField& field : gate_.guarding_fields()) answer.fields.push_back(std::move(field));
        return answer;
    }

    HttpAnswer answer(const HttpRequest& request, HttpBody& body) {
        return with_guard(guarded([&] { return route(request, body); }));
    }

    HttpAnswer route(const HttpRequest& request, HttpBody& body) {
        if (request.method == "POST" && request.path == "/api/picture")
            return picture(request, body);
        const auto found = answers_.find(request.method + " " + request.path);
        if (found != answers_.end()) return found->second(request);
        const bool page = request.path == "/";
        const std::string_view name =
            page ? std::string_view("index.html") : std::string_view(request.path).substr(1);
        const Asset* asset = request.method == "GET" ? find_asset(page_assets(), name) : nullptr;
        if (asset == nullptr) return {404, "text/plain; charset=utf-8", "there is no such page\n"};
        HttpAnswer answer{200, std::string(media_type(name)), std::string(asset->bytes)};
        if (page && gate_.enters(request)) answer.fields.push_back(gate_.cookie());
        return answer;
    }

    HttpAnswer start() {
        return answer_of(start_json(
            {folder_.path(), settings_.scene, folder_.scenes(), settings_.threads, grace_seconds}));
    }

    HttpAnswer alive(const HttpRequest& request) {
        const std::string view = query_value(request.query, "view");
        if (view.empty() || presence_.pages() >= most_pages)
            throw Error(ErrorKind::failed, "too many pages are open");
        HttpAnswer answer{200, "text/event-stream"};
        answer.held = presence_.enter([this, view] { turns_.leave(view); });
        return answer;
    }

    HttpAnswer leave(const HttpRequest& request) {
        turns_.leave(asked_view(request.body));
        return answer_of("{}");
    }

    HttpAnswer open(const HttpRequest& request) {
        return answer_of(opened_json(folder_.open(asked_file(request.body).name)));
    }

    HttpAnswer save(const HttpRequest& request) {
        const AskedFile asked = asked_file(request.body);
        const std::lock_guard lock(saving_);
        const Saved saved = folder_.save(asked.name, asked.text, asked.seen);
        const bool done = saved == Saved::done;
        return answer_of(saved_json(saved, done ? folder_.open(asked.name).digest : ""));
    }

    /// Waits for the turn, works, and says so if something newer has come. Throws Error: it takes
    /// too long.
    template <class Work>
    HttpAnswer in_turn(const Asking& asking, const Work& work) {
        auto turn = turns_.take(asking.view, asking.serial);
        if (!turn) return answer_of(superseded_json(0));
        const MayGiveUp leave(turn->stop());
        const Deadline deadline(turn->stop(), settings_.seconds);
        HttpAnswer answer;
        try {
            answer = work(turn->stop());
        } catch (const GivenUp&) {
            // It is told below, with what was stopped at its end.
        }
        if (deadline.has_passed())
            throw Error(ErrorKind::failed,
                        "this takes longer than the studio waits; pxm itself has no limit");
        if (turn->stop()) return answer_of(superseded_json(turn->stopping_milliseconds()));
        return answer;
    }

    HttpAnswer check(const HttpRequest& request) {
        const AskedCheck asked = asked_check(request.body);
        return in_turn(asked.scene.asking,
                       [&](const auto&) { return answer_of(check_answer(asked)); });
    }

    HttpAnswer inspect(const HttpRequest& request) {
        const AskedScene asked = asked_scene(request.body);
        return in_turn(asked.asking, [&](const auto&) { return answer_of(inspect_answer(asked)); });
    }

    /// What `make(asked, stop, progress)` makes of a picture that is asked for.
    template <class Make>
    HttpAnswer rendered(const HttpRequest& request, const Make& make) {
        const AskedPicture asked = asked_picture(request.body);
        return in_turn(asked.scene.asking, [&](std::atomic<bool>& stop) {
            const std::size_t nodes =
                asked.machine ? static_cast<std::size_t>(asked.machine->nodes()) : 0;
            const auto job = jobs_.begin(asked.scene.asking.view, nodes);
            const NodeWatch::Laid watched(nodes > 0 ? &job->watch : nullptr);
            return make(asked, stop, [&](double share) { job->share = share; });
        });
    }

    /// How far the view's picture or study is.
    HttpAnswer progress(const HttpRequest& request) {
        return answer_of(progress_json(jobs_.find(asked_view(request.body)).get()));
    }

    HttpAnswer import(const HttpRequest& request) {
        const AskedImport asked = asked_import(request.body);
        return in_turn(asked.asking, [&](std::atomic<bool>& stop) {
            return answer_of(imported_json(scene_from(asked.file, stop)));
        });
    }

    HttpAnswer study(const HttpRequest& request) {
        const AskedStudy asked = asked_study(request.body);
        return in_turn(asked.scene.asking, [&](std::atomic<bool>& stop) {
            const auto job = jobs_.begin(asked.scene.asking.view);
            return answer_of(study_json(study_asked(asked, settings_.threads, stop,
                                                    [&](double share) { job->share = share; })));
        });
    }

    HttpAnswer exported(const HttpRequest& request) {
        const AskedExport asked = asked_export(request.body);
        return in_turn(asked.scene.asking, [&](std::atomic<bool>& stop) {
            const auto job = jobs_.begin(asked.scene.asking.view);
            return answer_of(exported_json(
                export_asked(asked, folder_, stop, [&](double share) { job->share = share; })));
        });
    }

    /// Sent while it is rendered. What it ends with, or is refused with before its first block, is
    /// what else would be the whole answer.
    HttpAnswer picture(const HttpRequest& request, HttpBody& body) {
        std::unique_ptr<PictureParts> parts;
        HttpAnswer last = guarded([&] {
            return rendered(request, [&](const AskedPicture& asked, auto& stop, const auto& tell) {
                parts = std::make_unique<PictureParts>(
                    [this, &body, begun = false](std::string piece) mutable {
                        if (!std::exchange(begun, true))
                            body.begin(with_guard({200, "application/octet-stream"}));
                        body.send(std::move(piece));
                    },
                    asked.machine != nullptr);
                return answer_of(
                    picture_json(render_asked(asked, settings_.threads, stop, tell, *parts)));
            });
        });
        if (parts && parts->has_begun()) parts->end(last.body);
        return last;
    }

    HttpAnswer png(const HttpRequest& request) {
        return rendered(request, [&](const AskedPicture& asked, auto& stop, const auto& tell) {
            return HttpAnswer{200, "image/png",
                              png_bytes(picture_asked(asked, settings_.threads, stop, tell))};
        });
    }

    HttpAnswer pick(const HttpRequest& request) {
        const AskedPixel asked = asked_pixel(request.body);
        return in_turn(asked.picture.scene.asking, [&](const auto&) {
            return answer_of(pick_answer(asked, settings_.threads));
        });
    }

    HttpAnswer pixel(const HttpRequest& request) {
        const AskedPixel asked = asked_pixel(request.body);
        return in_turn(asked.picture.scene.asking, [&](const auto&) {
            const RenderRequest wanted = request_of(asked.picture, settings_.threads);
            return answer_of(text_json(explain_pixel(wanted, asked.x, asked.y)));
        });
    }

    StudioSettings settings_;
    SceneFolder folder_;
    Turns turns_{computing_at_once};
    Jobs jobs_;
    Presence presence_;
    std::mutex saving_;
    std::map<std::string, std::function<HttpAnswer(const HttpRequest&)>> answers_;
    std::unique_ptr<HttpServer> server_;
    Gate gate_;
};

Studio::Studio(const StudioSettings& settings) : desk_(std::make_unique<Desk>(settings)) {}

Studio::~Studio() = default;

std::string Studio::address() const { return desk_->gate().address(); }

std::string Studio::address_for_once() const { return desk_->gate().address_for_once(); }

bool Studio::is_deserted() const { return desk_->presence().seconds_alone() > grace_seconds; }

}  // namespace pxm::host
