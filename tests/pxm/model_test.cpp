// Laws of pxm/model.
#include "pxm/model.hpp"

#include <gtest/gtest.h>

namespace pxm {
namespace {

TEST(Model, every_natural_raster_fits_a_bank_of_32_bit_pixels) {
    for (const Model& model : models()) {
        const std::int64_t pixels =
            std::int64_t{model.natural_width} * model.natural_height / model.nodes();
        EXPECT_LE(pixels * 4, bank_bytes) << model.name;
    }
}

TEST(Model, a_name_finds_its_model_and_no_other) {
    for (const Model& model : models()) EXPECT_EQ(find_model(model.name), &model);
    EXPECT_EQ(find_model("965"), nullptr);
    EXPECT_EQ(find_model(""), nullptr);
}

}  // namespace
}  // namespace pxm
