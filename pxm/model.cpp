#include "pxm/model.hpp"

#include <algorithm>

namespace pxm {

namespace {
using enum Certainty;
constexpr std::array<Model, 6> all_models{{
    // name  columns, rows, mark; natural raster, mark
    {"916", 4, 4, recalled, 1024, 1024, recalled},
    {"920", 5, 4, recalled, 1280, 1024, recalled},
    {"932", 8, 4, recalled, 1024, 1024, recalled},
    {"940", 10, 4, recalled, 1280, 1024, recalled},
    {"964", 8, 8, recalled, 1280, 1024, recalled},
    {"964dX", 8, 8, seen, 1280, 1024, recalled},  // the array: Ch. 19
}};
}  // namespace

std::span<const Model> models() { return all_models; }

const Model* find_model(std::string_view name) {
    const auto found = std::ranges::find(all_models, name, &Model::name);
    return found == all_models.end() ? nullptr : &*found;
}

}  // namespace pxm
