#include "python/module/points.hpp"

#include <pybind11/stl.h>

#include <atomic>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/in_threads.hpp"
#include "host/render/point_games.hpp"
#include "python/module/scene.hpp"
#include "python/module/work.hpp"

namespace pxm::python {

namespace py = pybind11;
using namespace host;

namespace {

/// Rows of three doubles that Python has.
class Rows {
  public:
    explicit Rows(const py::buffer& buffer) : info_(buffer.request(true)) {
        const bool fits = info_.format == py::format_descriptor<double>::format() &&
                          info_.ndim == 2 && info_.shape[1] == 3 && info_.strides[1] == 8 &&
                          info_.strides[0] == 24;
        if (!fits)
            throw py::value_error("expected an array of doubles of shape (n, 3), in C order");
    }
    [[nodiscard]] std::uint64_t count() const { return static_cast<std::uint64_t>(info_.shape[0]); }
    [[nodiscard]] double* row(std::uint64_t i) const {
        return static_cast<double*>(info_.ptr) + 3 * i;
    }

  private:
    py::buffer_info info_;
};

void put(const glm::dvec3& vector, double* to) {
    for (int i = 0; i < 3; ++i) to[i] = vector[i];
}

struct Target {
    Rows places;
    std::optional<Rows> colors;
};

/// Draws a chunk, whose first point is the `first`th of all.
void draw(const PointGame& one, const PointChunk& chunk, std::uint64_t first, const Target& to) {
    ChaosGame game = one.game;
    game.seek(chunk.number);
    for (std::uint64_t i = first; i < first + chunk.points; ++i) {
        const CloudPoint point = game.next();
        put(one.instance.point(point.place), to.places.row(i));
        if (to.colors) put(point.blend.of(one.color), to.colors->row(i));
    }
}

void draw_all(const std::vector<PointGame>& games, const Target& to, int threads,
              const RunControl& control) {
    const std::vector<PointChunk> chunks = point_chunks(games.size(), to.places.count());
    std::vector<std::uint64_t> firsts(chunks.size(), 0);
    for (std::size_t i = 1; i < chunks.size(); ++i)
        firsts[i] = firsts[i - 1] + chunks[i - 1].points;
    std::atomic<std::size_t> done = 0;
    (void)in_threads(threads, chunks.size(), *control.stop, [&](std::size_t i) {
        draw(games[chunks[i].game], chunks[i], firsts[i], to);
        control.progress(static_cast<double>(++done) / static_cast<double>(chunks.size()));
    });
}

/// Fills the arrays; the scene's warnings.
std::string points(const ReadScene& read, const py::buffer& places, const py::object& colors,
                   std::uint64_t seed, int threads, const py::object& progress) {
    Target to{Rows(places), {}};
    if (!colors.is_none()) to.colors.emplace(colors.cast<py::buffer>());
    if (to.colors && to.colors->count() != to.places.count())
        throw py::value_error("the colours are not as many as the places");
    std::string warnings;
    watch(progress, [&](const RunControl& control) {
        Diagnostics diagnostics;
        const std::vector<PointGame> games = point_games(read.scene, seed, diagnostics);
        diagnostics.throw_if_errors(read.scene.files);
        warnings = diagnostics.warnings_text(read.scene.files);
        draw_all(games, to, choose_threads(threads).threads, control);
    });
    return warnings;
}

}  // namespace

void add_points(py::module_& module) {
    module.def("points", &points, py::arg("scene"), py::arg("places"), py::arg("colors"),
               py::arg("seed"), py::arg("threads"), py::arg("progress"));
}

}  // namespace pxm::python
