// Laws of comparing two renders.
#include "host/output/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/error.hpp"

namespace pxm::host {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int channels = 6;  // of row_of_four(): R, G, B, Z, word, object

/// Four grey pixels in a row; the last one is a miss. p(t) = 0.1 + 0.01 t.
LoadedImage row_of_four() {
    LoadedImage image;
    image.width = 4;
    image.height = 1;
    image.channels = {"R", "G", "B", "Z", "word", "object"};
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<float>(i);
        image.values.insert(image.values.end(), {0.5F, 0.5F, 0.5F, 10, n + 7, 0});
    }
    image.values.insert(image.values.end(), {0, 0, 0, infinity, 0, -1});
    image.metadata = {{"pixel_at_eye", "0.1"}, {"pixel_growth", "0.01"}};
    return image;
}

Comparison compare_images(const LoadedImage& a, const LoadedImage& b) {
    ImageComparison comparison(a, b);
    for (int y = 0; y < a.height; ++y) {
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width);
        comparison.add_row(a.values.data() + pixel * a.channels.size(),
                           b.values.data() + pixel * b.channels.size());
    }
    return comparison.result();
}

float& at(LoadedImage& image, std::size_t pixel, const char* channel) {
    return image.values[pixel * channels + static_cast<std::size_t>(image.channel(channel))];
}

TEST(Comparison, an_image_does_not_differ_from_itself) {
    const Comparison c = compare_images(row_of_four(), row_of_four());
    EXPECT_EQ(c.hits, 0);
    EXPECT_EQ(c.words, 0);
    EXPECT_EQ(c.depths, 0);
    EXPECT_EQ(c.worst_depth, 0);
    EXPECT_EQ(c.colors, 0);
    EXPECT_EQ(c.rmse, 0);
    EXPECT_EQ(c.different, 0);
}

TEST(Comparison, a_hit_against_a_miss_is_a_different_hit_and_nothing_else) {
    LoadedImage b = row_of_four();
    for (const char* channel : {"R", "G", "B"}) at(b, 1, channel) = 0;
    at(b, 1, "Z") = infinity;
    at(b, 1, "word") = 0;
    at(b, 1, "object") = -1;
    for (const Comparison& c :
         {compare_images(row_of_four(), b), compare_images(b, row_of_four())}) {
        EXPECT_EQ(c.hits, 0.25);
        EXPECT_EQ(c.words, 0);
        EXPECT_EQ(c.depths, 0);
        EXPECT_EQ(c.colors, 0);
        EXPECT_EQ(c.different, 0.25);
    }
}

TEST(Comparison, depths_are_measured_in_pixels_at_that_depth) {
    LoadedImage b = row_of_four();
    at(b, 0, "Z") = 10.1F;  // p(10) = 0.2: half a pixel
    Comparison c = compare_images(row_of_four(), b);
    EXPECT_EQ(c.depths, 0);
    EXPECT_NEAR(c.worst_depth, 0.5, 1e-5);
    EXPECT_EQ(c.different, 0);
    at(b, 1, "Z") = 9.5F;
    c = compare_images(row_of_four(), b);
    EXPECT_EQ(c.depths, 0.25);
    EXPECT_NEAR(c.worst_depth, 2.5, 1e-5);
    EXPECT_EQ(c.different, 0.25);
}

TEST(Comparison, another_colour_differs_in_whatever_cell) {
    LoadedImage b = row_of_four();
    at(b, 0, "word") = 99;
    Comparison c = compare_images(row_of_four(), b);
    EXPECT_EQ(c.words, 0.25);
    EXPECT_EQ(c.different, 0) << "another cell of the same look and place";
    at(b, 0, "R") = 1;
    at(b, 1, "R") = 1;
    c = compare_images(row_of_four(), b);
    EXPECT_EQ(c.words, 0.25);
    EXPECT_EQ(c.colors, 0.5);
    EXPECT_EQ(c.other_cell_colors, 0.25);
    EXPECT_EQ(c.different, 0.5);
    b = row_of_four();
    at(b, 0, "object") = 1;
    EXPECT_EQ(compare_images(row_of_four(), b).words, 0.25);
}

TEST(Comparison, another_background_is_another_colour) {
    LoadedImage b = row_of_four();
    at(b, 3, "G") = 0.5F;
    EXPECT_EQ(compare_images(row_of_four(), b).colors, 0.25);
    EXPECT_EQ(compare_images(row_of_four(), b).different, 0.25);
}

TEST(Comparison, channels_are_known_by_their_old_names_too) {
    LoadedImage b = row_of_four();
    b.channels = {"R", "G", "B", "Z", "word.V", "object.V"};
    b.values[4] = 99;
    for (const Comparison& c :
         {compare_images(row_of_four(), b), compare_images(b, row_of_four())}) {
        EXPECT_EQ(c.words, 0.25);
    }
    LoadedImage c = b;
    c.values[5] = 7;
    EXPECT_EQ(compare_images(b, c).words, 0.25);
}

TEST(Comparison, rows_add_up_to_the_picture) {
    LoadedImage a = row_of_four();
    LoadedImage b = row_of_four();
    at(b, 0, "Z") = 9.5F;
    at(b, 2, "G") = 0;
    const Comparison row = compare_images(a, b);
    a.width = b.width = 2;
    a.height = b.height = 2;
    const Comparison square = compare_images(a, b);
    EXPECT_EQ(square.depths, row.depths);
    EXPECT_EQ(square.worst_depth, row.worst_depth);
    EXPECT_EQ(square.colors, 0.25);
    EXPECT_EQ(square.rmse, row.rmse);
    EXPECT_EQ(square.different, 0.5);
}

TEST(Comparison, the_same_cell_has_the_same_colour_within_a_255th) {
    LoadedImage b = row_of_four();
    at(b, 0, "G") = 0.5F + 0.9F / 255;
    EXPECT_EQ(compare_images(row_of_four(), b).colors, 0);
    at(b, 0, "G") = 0.5F + 1.1F / 255;
    Comparison c = compare_images(row_of_four(), b);
    EXPECT_EQ(c.colors, 0.25);
    EXPECT_EQ(c.different, 0.25);
    EXPECT_NEAR(c.rmse, 1.1 / 255 / std::sqrt(12.0), 1e-6);
}

TEST(Comparison, a_colour_that_is_no_number_differs) {
    LoadedImage b = row_of_four();
    at(b, 2, "B") = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(compare_images(row_of_four(), b).different, 0.25);
    EXPECT_EQ(compare_images(b, row_of_four()).different, 0.25);
    b = row_of_four();
    at(b, 2, "B") = infinity;
    EXPECT_EQ(compare_images(b, row_of_four()).different, 0.25);
    EXPECT_EQ(compare_images(b, b).different, 0);
}

TEST(Comparison, what_a_file_does_not_tell_is_not_known) {
    LoadedImage plain;
    plain.width = 4;
    plain.height = 1;
    plain.channels = {"R", "G", "B"};
    plain.values = {0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0, 0, 0};
    const Comparison c = compare_images(row_of_four(), plain);
    EXPECT_EQ(c.hits, -1);
    EXPECT_EQ(c.words, -1);
    EXPECT_EQ(c.depths, -1);
    EXPECT_EQ(c.worst_depth, -1);
    EXPECT_EQ(c.different, 0);
    LoadedImage no_measure = row_of_four();
    no_measure.metadata.clear();
    EXPECT_EQ(compare_images(no_measure, row_of_four()).depths, -1);
}

TEST(Comparison, images_that_cannot_be_compared_are_an_error) {
    LoadedImage tall = row_of_four();
    std::swap(tall.width, tall.height);
    EXPECT_THROW((void)compare_images(row_of_four(), tall), Error);
    LoadedImage grey = row_of_four();
    grey.channels = {"R", "Y", "B", "Z", "word", "object"};
    EXPECT_THROW((void)compare_images(row_of_four(), grey), Error);
}

}  // namespace
}  // namespace pxm::host
