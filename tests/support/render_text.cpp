#include "tests/support/render_text.hpp"

#include <cstring>

#include "host/process/exit_code.hpp"

namespace pxm::test {

host::RenderResult render_text(const std::string& text, host::RenderRequest request) {
    request.scene_path = "scene.pxm";
    request.scene_text = text;
    return host::render(request, {});
}

host::RenderRequest on_machine(const char* model, long columns, long rows) {
    host::RenderRequest request;
    request.machine = find_model(model);
    request.overrides.size = host::PixelSize{columns, rows};
    request.threads = 2;
    return request;
}

std::string error_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const host::Error& error) {
        return std::to_string(static_cast<int>(exit_code_of(error.kind()))) + ": " + error.what();
    }
    return "";
}

bool same_picture(const host::Frame& a, const host::Frame& b) {
    if (a.pixels.size() != b.pixels.size()) return false;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const host::PixelRecord& p = a.pixels[i];
        const host::PixelRecord& q = b.pixels[i];
        if (std::memcmp(p.color, q.color, sizeof p.color) != 0) return false;
        if (std::memcmp(p.normal, q.normal, sizeof p.normal) != 0) return false;
        if (std::memcmp(&p.z, &q.z, sizeof p.z) != 0) return false;
        if (p.object != q.object || p.level != q.level || p.word != q.word) return false;
    }
    return true;
}

bool same_on_machine_and_natively(const std::string& text) {
    host::RenderRequest machine = on_machine("964dX", 24, 24);
    host::RenderRequest native;
    native.overrides = machine.overrides;
    native.overrides.numeric = host::Numeric::dsp32;
    return same_picture(render_text(text, machine).frame, render_text(text, native).frame);
}

}  // namespace pxm::test
