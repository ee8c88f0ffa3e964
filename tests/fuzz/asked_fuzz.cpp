// Any bytes as what a page asks of the studio: it is understood, or refused.
#include "host/studio/asks_json.hpp"

#include "host/studio/http_message.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    (void)host::query_value({reinterpret_cast<const char*>(data), size}, "view");
    for (const auto& read : {+[](const std::string& text) { (void)host::asked_scene(text); },
                             +[](const std::string& text) { (void)host::asked_picture(text); },
                             +[](const std::string& text) { (void)host::asked_view(text); },
                             +[](const std::string& text) { (void)host::asked_pixel(text); },
                             +[](const std::string& text) { (void)host::asked_file(text); }})
        fuzz::one_input(data, size, read);
    return 0;
}
