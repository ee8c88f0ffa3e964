#include "host/import/flame/flame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "host/import/flame/flame_palette.hpp"
#include "host/import/fractint/fractint_reader.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr int most_symmetry = 64;
constexpr double farthest_zoom = 60;  // as a power of 2

/// The numbers of a text, with blanks between them; nothing if anything else is there.
std::optional<std::vector<double>> numbers_of(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    std::vector<double> numbers;
    for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = text.find_first_not_of(blanks, begin)) {
        const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
        double number = 0;
        if (!read_number(text.substr(begin, end - begin), number)) return std::nullopt;
        numbers.push_back(number);
        begin = end;
    }
    return numbers;
}

/// Reads one element's attributes; what is wrong with one is told at the element.
class Attributes {
  public:
    Attributes(const XmlElement& element, std::string what, Diagnostics& diagnostics)
        : element_(element), what_(std::move(what)), diagnostics_(diagnostics) {}

    void error(const std::string& message) const {
        diagnostics_.error(element_.position, what_ + ": " + message);
    }
    /// Exactly `count` numbers, any number of them for 0; nothing if the attribute is not there.
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view name,
                                                             std::size_t count) const {
        const std::string* text = element_.attribute(name);
        if (text == nullptr) return std::nullopt;
        auto values = numbers_of(*text);
        if (values && (count == 0 || values->size() == count)) return values;
        error(fmt::format("{}=\"{}\": expected {}", name, printable(*text),
                          count == 0   ? "numbers"
                          : count == 1 ? "a number"
                                       : fmt::format("{} numbers", count)));
        return std::nullopt;
    }
    [[nodiscard]] double number(std::string_view name, double otherwise) const {
        const auto values = numbers(name, 1);
        return values ? values->front() : otherwise;
    }
    [[nodiscard]] bool has(std::string_view name) const {
        return element_.attribute(name) != nullptr;
    }
    [[nodiscard]] const XmlElement& element() const { return element_; }
    [[nodiscard]] const std::string& what() const { return what_; }

  private:
    const XmlElement& element_;
    std::string what_;
    Diagnostics& diagnostics_;
};

/// Attributes of a transform that say nothing of where its points go in the plane.
bool is_no_variation(std::string_view name) {
    static const std::set<std::string_view> names{"weight",
                                                  "color",
                                                  "color_speed",
                                                  "symmetry",
                                                  "animate",
                                                  "opacity",
                                                  "coefs",
                                                  "post",
                                                  "chaos",
                                                  "plotmode",
                                                  "motion_frequency",
                                                  "motion_function",
                                                  "name",
                                                  "var",
                                                  "var1",
                                                  "var_color",
                                                  "linear",
                                                  "linear3D",
                                                  "flatten",
                                                  "zscale",
                                                  "ztranslate",
                                                  "enabled",
                                                  "Re_A",
                                                  "Re_B",
                                                  "Re_C",
                                                  "Re_D",
                                                  "Im_A",
                                                  "Im_B",
                                                  "Im_C",
                                                  "Im_D"};
    return names.contains(name);
}

/// `julian_power` beside `julian` is a number of that variation.
bool belongs_to_another(const XmlElement& element, std::string_view name) {
    for (std::size_t end = name.rfind('_'); end != std::string_view::npos && end > 0;
         end = name.rfind('_', end - 1))
        if (element.attribute(name.substr(0, end)) != nullptr) return true;
    return false;
}

/// The variations of a transform that are not linear, by name.
std::vector<std::string> other_variations(const Attributes& attributes) {
    std::vector<std::string> others;
    for (const auto& [name, value] : attributes.element().attributes) {
        if (is_no_variation(name) || belongs_to_another(attributes.element(), name)) continue;
        const auto numbers = numbers_of(value);
        if (numbers && numbers->size() == 1 && numbers->front() != 0)
            others.push_back(printable(name));
    }
    if (const auto var = attributes.numbers("var", 0))  // the oldest way: weights by number
        for (std::size_t i = 1; i < var->size(); ++i)
            if ((*var)[i] != 0) others.push_back(fmt::format("variation {}", i));
    if (const double var1 = attributes.number("var1", 0); var1 != 0)
        others.push_back(fmt::format("variation {}", var1));
    return others;
}

/// How much of the transform is `linear`.
double linear_weight(const Attributes& attributes) {
    double weight = attributes.number("linear", 0) + attributes.number("linear3D", 0);
    if (const auto var = attributes.numbers("var", 0); var && !var->empty()) weight += var->front();
    if (attributes.has("var1") && attributes.number("var1", 0) == 0) weight += 1;
    return weight;
}

/// coefs="a c b d e f": the columns of the matrix, then the translation.
PlaneNumbers columns(const std::vector<double>& n) { return {n[0], n[2], n[1], n[3], n[4], n[5]}; }

PlaneNumbers scaled(const PlaneNumbers& m, double k) {
    return {k * m.a, k * m.b, k * m.c, k * m.d, k * m.e, k * m.f};
}

bool is_identity(const PlaneNumbers& m) {
    return m.a == 1 && m.b == 0 && m.c == 0 && m.d == 1 && m.e == 0 && m.f == 0;
}

PlaneNumbers map_of(const Attributes& attributes) {
    PlaneNumbers map;
    if (const auto coefs = attributes.numbers("coefs", 6)) map = columns(*coefs);
    if (const double weight = linear_weight(attributes); weight != 1) map = scaled(map, weight);
    if (const auto post = attributes.numbers("post", 6))
        if (!is_identity(columns(*post))) map = then(map, columns(*post));
    return map;
}

void read_color(const Attributes& attributes, FlameTransform& transform) {
    if (const auto color = attributes.numbers("color", 0); color && !color->empty())
        transform.color = std::clamp(color->front(), 0.0, 1.0);
    double speed = 0.5;
    if (attributes.has("symmetry")) speed = (1 - attributes.number("symmetry", 0)) / 2;
    speed = attributes.number("color_speed", speed);
    transform.color_speed = std::clamp(speed, 0.0, 1.0);
}

/// Where points are plotted: `plotmode` is the older word.
double opacity_of(const Attributes& attributes) {
    const std::string* plotmode = attributes.element().attribute("plotmode");
    const double old = plotmode != nullptr && *plotmode == "off" ? 0 : 1;
    return attributes.number("opacity", old);
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

FlameTransform transform_of(const Attributes& attributes) {
    FlameTransform transform;
    transform.position = attributes.element().position;
    transform.map = map_of(attributes);
    transform.weight = attributes.number("weight", 0);
    if (transform.weight < 0) attributes.error("its weight is negative");
    read_color(attributes, transform);
    transform.opacity = opacity_of(attributes);
    if (const auto chaos = attributes.numbers("chaos", 0)) transform.chaos = *chaos;
    for (const double factor : transform.chaos)
        if (factor < 0) return attributes.error("a number of chaos is negative"), transform;
    return transform;
}

/// Nothing is linear in it: all its points are one.
bool has_no_linear_part(const Attributes& attributes) { return linear_weight(attributes) == 0; }

class FlameReader {
  public:
    FlameReader(const XmlElement& element, Variations variations, Diagnostics& diagnostics)
        : element_(element), variations_(variations), diagnostics_(diagnostics) {}

    Flame read() {
        flame_.name = *element_.attribute("name");
        flame_.position = element_.position;
        read_view();
        for (const XmlElement& child : element_.children) {
            if (child.name == "xform") read_transform(child);
            if (child.name == "finalxform") read_final(child);
            if (child.name == "symmetry") read_symmetry(child);
        }
        flame_.palette = palette_of(element_, diagnostics_);
        if (flame_.transforms.empty() && !diagnostics_.has_errors())
            diagnostics_.error(element_.position, "the flame has no <xform> of weight above 0");
        return std::move(flame_);
    }

  private:
    void tell(const std::string& message) { flame_.messages += message + '\n'; }

    void read_view() {
        const Attributes attributes(element_, "flame", diagnostics_);
        if (const auto size = attributes.numbers("size", 2)) {
            for (const double side : *size)
                if (!(side >= 1 && side <= static_cast<double>(image_side_pixels)))
                    return attributes.error(
                        fmt::format("size: expected 1 to {} pixels a side", image_side_pixels));
            flame_.size = {static_cast<long>((*size)[0]), static_cast<long>((*size)[1])};
        }
        if (const auto center = attributes.numbers("center", 2))
            flame_.center = {(*center)[0], (*center)[1]};
        flame_.pixels_a_unit = attributes.number("scale", flame_.pixels_a_unit);
        flame_.zoom = attributes.number("zoom", 0);
        flame_.rotate_degrees = attributes.number("rotate", 0);
        if (!(flame_.pixels_a_unit > 0)) attributes.error("scale must be greater than 0");
        if (std::abs(flame_.zoom) > farthest_zoom)
            attributes.error(fmt::format("zoom: expected -{} to {}", farthest_zoom, farthest_zoom));
        for (const char* name : {"cam_pitch", "cam_yaw", "cam_perspective", "cam_dof"})
            if (attributes.number(name, 0) != 0)
                tell(fmt::format("{}: a view in space; the plane is shown from the front", name));
    }

    /// True if the transform can be taken; says what is not linear.
    bool is_taken(const Attributes& attributes) {
        const std::vector<std::string> others = other_variations(attributes);
        if (others.empty()) return true;
        if (variations_ == Variations::linear_only) {
            attributes.error(
                fmt::format("not linear: {} (--affine-part leaves out all but "
                            "'linear')",
                            joined(others)));
            return false;
        }
        const bool none = has_no_linear_part(attributes);
        tell(fmt::format("{}: {} left out{}", attributes.what(), joined(others),
                         none ? ", and with it the transform: nothing of it is linear" : ""));
        return !none;
    }

    void read_transform(const XmlElement& child) {
        const Attributes attributes(child, fmt::format("xform {}", ++number_), diagnostics_);
        if (flame_.transforms.size() == maps_an_ifs) {
            if (!diagnostics_.has_errors())
                attributes.error(fmt::format("more than {} transforms", maps_an_ifs));
            return;
        }
        FlameTransform transform = transform_of(attributes);
        if (transform.weight > 0 && !is_taken(attributes)) transform.weight = 0;
        flame_.transforms.push_back(std::move(transform));
    }

    void read_final(const XmlElement& child) {
        const Attributes attributes(child, "finalxform", diagnostics_);
        if (flame_.final_transform) return attributes.error("a second one");
        FlameTransform transform = transform_of(attributes);
        if (transform.opacity > 0 && is_taken(attributes)) flame_.final_transform = transform;
    }

    void read_symmetry(const XmlElement& child) {
        const Attributes attributes(child, "symmetry", diagnostics_);
        const double kind = attributes.number("kind", 0);
        if (kind != std::round(kind) || kind == 0 || std::abs(kind) > most_symmetry)
            return attributes.error(
                fmt::format("kind: expected a whole number from -{} to {}, not "
                            "0 (flam3 draws lots for 0)",
                            most_symmetry, most_symmetry));
        flame_.symmetry = static_cast<int>(kind);
    }

    const XmlElement& element_;
    Variations variations_;
    Diagnostics& diagnostics_;
    Flame flame_;
    int number_ = 0;
};

}  // namespace

Flame flame_of(const XmlElement& element, Variations variations, Diagnostics& diagnostics) {
    return FlameReader(element, variations, diagnostics).read();
}

}  // namespace pxm::host
