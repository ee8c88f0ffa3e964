#include "host/studio/asks.hpp"

namespace pxm::host {

RenderRequest request_of(const AskedScene& asked) {
    RenderRequest request;
    request.scene_path = asked.name;
    request.scene_text = asked.text;
    request.allowed = {"."};  // all of the studio's folder
    request.frame = asked.frame;
    return request;
}

RenderRequest request_of(const AskedPicture& asked, int threads) {
    RenderRequest request = request_of(asked.scene);
    request.settings = asked.settings;
    request.overrides.size = asked.size;
    if (asked.samples > 0) request.overrides.samples = asked.samples;
    request.machine = asked.machine;
    request.threads = threads;
    request.threads_because = "it is what the studio was granted";
    return request;
}

}  // namespace pxm::host
