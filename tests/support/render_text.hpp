// Scene texts rendered by the library, without a process of their own.
#pragma once

#include <functional>
#include <string>

#include "host/error.hpp"
#include "host/render/render.hpp"

namespace pxm::test {

/// Renders a scene given as text; `request` says all but where it is.
[[nodiscard]] host::RenderResult render_text(const std::string& text, host::RenderRequest request);

/// On a machine of that name, at that size, on two threads, with the machine's own numbers.
[[nodiscard]] host::RenderRequest on_machine(const char* model, long columns, long rows);

/// The Error that `work` throws, as "exit code: text"; empty if it throws none.
[[nodiscard]] std::string error_of(const std::function<void()>& work);

/// Whether two pictures are the same in every bit, but for which node made a pixel and when.
[[nodiscard]] bool same_picture(const host::Frame& a, const host::Frame& b);

/// Whether the machine shows, on 24x24 pixels, what native rendering in dsp32 does.
[[nodiscard]] bool same_on_machine_and_natively(const std::string& text);

/// Sierpinski's tetrahedron with a declared ball.
inline constexpr const char* tetra_text = R"(
ifs tetra {
    newmap scale: 0.5 translate: 0,0.5,0
    newmap scale: 0.5 translate: 0,-0.166,-0.472
    newmap scale: 0.5 translate: 0.409,-0.166,0.236
    newmap scale: 0.5 translate: -0.409,-0.166,0.236
}
)";

}  // namespace pxm::test
