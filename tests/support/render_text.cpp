#include "tests/support/render_text.hpp"

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace pxm::test {

host::RenderResult render_text(const std::string& text, host::RenderRequest request) {
    std::string path = (std::filesystem::temp_directory_path() / "pxm-scene-XXXXXX").string();
    const int file = mkstemp(path.data());
    if (file < 0) throw std::runtime_error("no temporary file");
    close(file);
    std::ofstream(path) << text;
    request.scene_path = path;
    try {
        host::RenderResult result = host::render(request, {});
        std::filesystem::remove(path);
        return result;
    } catch (...) {
        std::filesystem::remove(path);
        throw;
    }
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
        return std::to_string(static_cast<int>(error.code())) + ": " + error.what();
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

}  // namespace pxm::test
