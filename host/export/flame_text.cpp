// Systems of the plane as fractal flames for flam3 and its kin: numbers stand by columns, and y
// points down. What may stand inside a map is what it may come after.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host/error.hpp"
#include "host/export/systems_text.hpp"
#include "host/export/writers.hpp"
#include "host/output/pixel_values.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t palette_size = 256;

std::string coefs_text(const Affine& map) {
    const glm::dmat3& m = map.linear;
    return fmt::format("{} {} {} {} {} {}", m[0].x, -m[0].y + 0.0, -m[1].x + 0.0, m[1].y,
                       map.translation.x, -map.translation.y + 0.0);
}

/// A width of `columns / scale` that comes out as the double it was, if one of the nearest scales
/// gives it.
double scale_for(double columns, double width) {
    const double scale = columns / width;
    for (const double near : {scale, std::nextafter(scale, INFINITY), std::nextafter(scale, 0.0)})
        if (columns / near == width) return near;
    return scale;
}

class FlameText {
  public:
    FlameText(const Scene& scene, const SystemOfObject& system, std::string& messages)
        : scene_(scene), system_(system), messages_(messages) {}

    std::string text() {
        put_head();
        find_colors();
        for (std::size_t i = 0; i < system_.rifs.maps.size(); ++i) put_transform(i);
        if (!(system_.place == Affine{}))
            text_ += fmt::format(
                "   <finalxform color=\"0\" color_speed=\"0\" "
                "linear=\"1\" coefs=\"{}\"/>\n",
                coefs_text(system_.place));
        for (std::size_t i = 0; i < palette_size; ++i) put_palette(i);
        return text_ += "</flame>\n";
    }

  private:
    /// The scene's view, where it looks at the plane from the front and its rays are parallel.
    void put_head() {
        const CameraBlock camera = scene_.camera.value_or(CameraBlock{});
        const PixelSize size = scene_.image.value_or(ImageBlock{}).size.value_or(PixelSize{});
        const auto columns = static_cast<double>(size.columns);
        double x = 0, y = 0, width = 4;
        if (faces_plane(camera)) {
            x = (*camera.look)[0].value;
            y = (*camera.look)[1].value;
            width = *camera.orthographic;
        } else {
            messages_ +=
                "the camera does not look at the plane from the front in parallel rays: "
                "the flame shows x and y from -2 to 2\n";
        }
        fmt::format_to(std::back_inserter(text_),
                       "<flame name=\"{}\" version=\"pxm {}\" size=\"{} {}\" center=\"{} {}\" "
                       "scale=\"{}\" brightness=\"4\" gamma=\"4\" background=\"0 0 0\">\n",
                       system_.object.name, PXM_VERSION, size.columns, size.rows, x, -y + 0.0,
                       scale_for(columns, width));
    }

    /// A place on the palette for every colour.
    void find_colors() {
        const glm::dvec4 paint = system_.object.color.value_or(glm::dvec4{0.0});
        base_ = glm::dvec3{0.9} * (1 - paint.a) + glm::dvec3{paint} * paint.a;
        for (const MapBlock& map : system_.block->maps) {
            const glm::dvec3 color = map.color ? glm::dvec3{*map.color} : base_;
            if (std::ranges::find(colors_, color) == colors_.end()) colors_.push_back(color);
        }
        if (colors_.size() <= palette_size) return;
        colors_.resize(palette_size);
        messages_ += "more than 256 colours of maps: the others got the last one\n";
    }

    [[nodiscard]] std::size_t place_of(const glm::dvec3& color) const {
        const auto found = std::ranges::find(colors_, color);
        return std::min<std::size_t>(static_cast<std::size_t>(found - colors_.begin()),
                                     colors_.size() - 1);
    }

    void put_transform(std::size_t i) {
        const MapBlock& map = system_.block->maps[i];
        const glm::dvec3 color = map.color ? glm::dvec3{*map.color} : base_;
        // In the middle of its share of the palette: no reader's rounding takes a neighbour.
        const double place = (static_cast<double>(place_of(color)) + 0.5) / palette_size;
        fmt::format_to(std::back_inserter(text_),
                       "   <xform weight=\"{}\" color=\"{}\" color_speed=\"{}\" linear=\"1\" "
                       "coefs=\"{}\"{}{}/>\n",
                       system_.weights[i], place, map.color ? map.color->a : 0.0,
                       coefs_text(system_.rifs.maps[i]), chaos_text(i),
                       is_start(i) ? "" : " opacity=\"0\"");
    }

    [[nodiscard]] const std::vector<int>& inside(std::size_t i) const {
        return system_.rifs.follow_sets[static_cast<std::size_t>(system_.rifs.follow_of[i])].maps;
    }

    /// Which maps may come after this one: those that it may stand in.
    [[nodiscard]] std::string chaos_text(std::size_t i) const {
        if (system_.rifs.follow_sets.size() == 1) return "";
        std::string text;
        for (std::size_t after = 0; after < system_.rifs.maps.size(); ++after)
            text += std::ranges::binary_search(inside(after), static_cast<int>(i)) ? " 1" : " 0";
        return fmt::format(" chaos=\"{}\"", text.substr(1));
    }

    [[nodiscard]] bool is_start(std::size_t i) const {
        const auto& start =
            system_.rifs.follow_sets[static_cast<std::size_t>(system_.rifs.start)].maps;
        return std::ranges::binary_search(start, static_cast<int>(i));
    }

    void put_palette(std::size_t i) {
        const glm::dvec3& color = colors_[std::min(i, colors_.size() - 1)];
        const auto byte = [](double v) { return srgb_byte(static_cast<float>(v)); };
        fmt::format_to(std::back_inserter(text_), "   <color index=\"{}\" rgb=\"{} {} {}\"/>\n", i,
                       byte(color.r), byte(color.g), byte(color.b));
    }

    const Scene& scene_;
    const SystemOfObject& system_;
    std::string& messages_;
    glm::dvec3 base_{0.9};
    std::vector<glm::dvec3> colors_;
    std::string text_;
};

}  // namespace

std::string flame_text(const Scene& scene, std::string& messages) {
    std::string text = "<flames>\n";
    for (const SystemOfObject& system : systems_of(scene, messages)) {
        const bool flat = std::ranges::all_of(system.rifs.maps, is_of_plane);
        if (!flat || !is_of_plane(system.place))
            throw Error(ErrorKind::scene,
                        fmt::format("object \"{}\" is not of the plane z = 0: a flame cannot hold "
                                    "it (--format aifs does)",
                                    system.object.name));
        text += FlameText(scene, system, messages).text();
    }
    return text += "</flames>\n";
}

}  // namespace pxm::host
