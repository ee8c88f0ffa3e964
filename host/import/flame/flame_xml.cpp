#include "host/import/flame/flame_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <pugixml.hpp>
#include <string_view>

#include "host/error.hpp"
#include "host/import/entries.hpp"
#include "host/scene/diagnostics.hpp"

namespace pxm::host {
namespace {

constexpr std::ptrdiff_t most_elements = 4'000'000;    // 64 bytes each in memory
constexpr std::ptrdiff_t most_attributes = 8'000'000;  // 40 bytes each in memory
constexpr int deepest_flame = 8;                       // elements around a flame

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Lines and columns of places in a text.
class Places {
  public:
    explicit Places(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') lines_.push_back(i + 1);
    }
    [[nodiscard]] Position operator()(std::ptrdiff_t offset) const {
        const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
        const auto next = std::ranges::upper_bound(lines_, place);
        const std::size_t begin = *std::prev(next);
        return {0, static_cast<int>(next - lines_.begin()), static_cast<int>(place - begin) + 1};
    }

  private:
    std::vector<std::size_t> lines_{0};  // where they begin
};

[[noreturn]] void refuse(const SourceFile& source, const Position& place,
                         const std::string& message) {
    Diagnostics diagnostics;
    diagnostics.error(place, message);
    diagnostics.throw_if_errors({source});
    throw Error(ErrorKind::scene, message);  // not reached
}

void parse(const SourceFile& source, const Places& place, pugi::xml_document& document) {
    std::string_view text = source.text;
    const std::size_t mark = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    text.remove_prefix(mark);
    if (std::ranges::count(text, '<') > most_elements)
        refuse(source, {}, fmt::format("more than {} elements", most_elements));
    if (std::ranges::count(text, '=') > most_attributes)
        refuse(source, {}, fmt::format("more than {} attributes", most_attributes));
    const pugi::xml_parse_result result =
        document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (result.status == pugi::status_no_document_element)
        refuse(source, {}, "no XML is in the file: expected <flame ...>");
    if (!result) {
        std::string reason = result.description();
        reason.front() = static_cast<char>(reason.front() - 'A' + 'a');
        refuse(source, place(result.offset + static_cast<std::ptrdiff_t>(mark)),
               fmt::format("XML that cannot be read: {}", reason));
    }
}

/// Every flame of the document, in the order of the text; not those inside flames.
std::vector<pugi::xml_node> flames_of(const pugi::xml_document& document) {
    std::vector<pugi::xml_node> flames;
    int depth = 0;
    pugi::xml_node node = document.first_child();
    while (node) {
        const bool flame = std::string_view(node.name()) == "flame";
        if (flame) flames.push_back(node);
        if (!flame && depth < deepest_flame && node.first_child()) {
            ++depth;
            node = node.first_child();
            continue;
        }
        while (node && !node.next_sibling() && depth > 0) {
            --depth;
            node = node.parent();
        }
        node = node.next_sibling();
    }
    return flames;
}

std::vector<std::string> names_of(const std::vector<pugi::xml_node>& flames) {
    std::vector<std::string> names;
    for (const pugi::xml_node& flame : flames) {
        const std::string name = flame.attribute("name").value();
        names.push_back(name.empty() ? fmt::format("flame {}", names.size() + 1) : name);
    }
    return names;
}

XmlElement element_of(const pugi::xml_node& node, const Places& place, std::ptrdiff_t mark) {
    XmlElement element;
    element.name = node.name();
    for (const pugi::xml_attribute& a : node.attributes())
        element.attributes.emplace_back(a.name(), a.value());
    element.text = node.text().get();
    element.position = place(node.offset_debug() + mark - 1);  // it points behind the '<'
    return element;
}

}  // namespace

const std::string* XmlElement::attribute(std::string_view wanted) const {
    const auto found =
        std::ranges::find_if(attributes, [&](const auto& a) { return a.first == wanted; });
    return found == attributes.end() ? nullptr : &found->second;
}

std::vector<std::string> flame_names(const SourceFile& source) {
    pugi::xml_document document;
    parse(source, Places(source.text), document);
    return names_of(flames_of(document));
}

XmlElement read_flame(const SourceFile& source, const std::optional<std::string>& entry) {
    const Places place(source.text);
    pugi::xml_document document;
    parse(source, place, document);
    const std::vector<pugi::xml_node> flames = flames_of(document);
    if (flames.empty()) refuse(source, {}, "no <flame> is in the file");
    const std::vector<std::string> names = names_of(flames);
    const std::size_t chosen = choose_entry(names, source.name, entry);
    const std::ptrdiff_t mark =
        source.text.starts_with(byte_order_mark) ? std::ssize(byte_order_mark) : 0;
    XmlElement flame = element_of(flames[chosen], place, mark);
    std::erase_if(flame.attributes, [](const auto& a) { return a.first == "name"; });
    flame.attributes.emplace_back("name", names[chosen]);
    for (const pugi::xml_node& child : flames[chosen].children())
        if (child.type() == pugi::node_element)
            flame.children.push_back(element_of(child, place, mark));
    return flame;
}

}  // namespace pxm::host
