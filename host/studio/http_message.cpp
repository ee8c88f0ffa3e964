#include "host/studio/http_message.hpp"

#include <algorithm>
#include <cctype>

namespace pxm::host {

namespace {

bool same_name(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::size_t fields_of(const HttpRequest& request, std::string_view name) {
    return static_cast<std::size_t>(std::ranges::count_if(
        request.fields, [&](const HttpField& field) { return same_name(field.first, name); }));
}

std::string field_of(const HttpRequest& request, std::string_view name) {
    if (fields_of(request, name) != 1) return "";
    return std::ranges::find_if(
               request.fields, [&](const HttpField& field) { return same_name(field.first, name); })
        ->second;
}

std::string query_value(std::string_view query, std::string_view name) {
    while (!query.empty()) {
        const std::string_view pair = query.substr(0, query.find('&'));
        query.remove_prefix(std::min(query.size(), pair.size() + 1));
        const std::size_t equals = pair.find('=');
        if (equals != std::string_view::npos && pair.substr(0, equals) == name)
            return std::string(pair.substr(equals + 1));
    }
    return "";
}

}  // namespace pxm::host
