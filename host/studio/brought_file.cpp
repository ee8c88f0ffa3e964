#include "host/studio/brought_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "host/error.hpp"
#include "host/files/safe_file.hpp"
#include "host/import/import.hpp"
#include "host/import/imported_scene.hpp"
#include "host/studio/private_folder.hpp"
#include "host/text/without.hpp"

namespace pxm::host {

namespace {

constexpr double search_seconds = 8;
constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// A name for the file that says as much of it as importing asks for.
std::string plain_name(const std::string& name) {
    constexpr std::size_t longest = 80;
    std::string plain = name.substr(name.find_last_of("/\\") + 1);
    for (char& c : plain)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-') c = '_';
    if (plain.size() > longest) plain = plain.substr(plain.size() - longest);
    return plain.empty() || plain.front() == '.' ? "brought" + plain : plain;
}

}  // namespace

MadeScene scene_from(const BroughtFile& brought, const std::atomic<bool>& stop) {
    const PrivateFolder folder;
    const std::string name = plain_name(brought.name);
    ImportRequest request;
    request.path = folder.path() + "/" + name;
    request.entry = brought.entry;
    request.maps = brought.maps;
    request.seconds = search_seconds;
    request.stop = [&stop] { return stop.load(); };
    write_text_safely(request.path, brought.bytes);
    try {
        const Imported imported = import_file(request);
        return {scene_name(imported.name) + ".pxm", imported.text, imported.messages};
    } catch (const Error& error) {
        // Where the file lay meanwhile means nothing to whoever brought it.
        throw Error(error.kind(), without(error.what(), folder.path() + "/"));
    }
}

std::optional<std::string> bytes_of_base64(const std::string& text) {
    constexpr unsigned bits = 6;
    std::string bytes;
    unsigned known = 0;
    unsigned value = 0;
    const std::size_t end = std::min(text.find('='), text.size());
    if (text.size() - end > 2) return std::nullopt;
    for (std::size_t i = 0; i < end; ++i) {
        const std::size_t digit = alphabet.find(text[i]);
        if (digit == std::string_view::npos) return std::nullopt;
        value = (value << bits | static_cast<unsigned>(digit)) & 0xFFFFU;
        known += bits;
        if (known < 8) continue;
        known -= 8;
        bytes += static_cast<char>(static_cast<unsigned char>(value >> known));
    }
    return bytes;
}

}  // namespace pxm::host
