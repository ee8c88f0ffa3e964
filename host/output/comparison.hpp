// How much two renders of the same picture differ (`pxm compare`).
#pragma once

#include <cstddef>

#include "host/files/image_reader.hpp"

namespace pxm::host {

/// Shares are of all pixels, 0..1. What a file has no channel for is -1. Words are compared as they
/// are: those of another scene differ even where its picture is the same.
struct Comparison {
    double hits = -1;              // one hits, the other does not (Z)
    double words = -1;             // both hit, different cells (object, word)
    double depths = -1;            // both hit, more than one pixel apart (Z)
    double worst_depth = -1;       // largest distance, in pixels
    double colors = 0;             // both hit or neither: a channel differs by more than 1/255
    double other_cell_colors = 0;  // those of them that have different words
    double rmse = 0;               // of colour, over R, G, B
    double different = 0;  // hits, depths or colours differ: what --tolerance is held against
};

/// Compares pictures row by row, so that none need be kept.
class ImageComparison {
  public:
    /// Throws Error(ErrorKind::file) when the sizes or colour channels do not match.
    ImageComparison(const ImageHeader& a, const ImageHeader& b);

    /// The next row of each, interleaved.
    void add_row(const float* a, const float* b);
    /// Precondition: all rows were added.
    [[nodiscard]] Comparison result() const;

  private:
    /// Where the same channel is in each picture; -1: it has none.
    struct ChannelPair {
        int a = -1;
        int b = -1;
        [[nodiscard]] bool present() const { return a >= 0 && b >= 0; }
    };

    void add_pixel(const float* a, const float* b);
    [[nodiscard]] bool other_word(const float* a, const float* b) const;
    [[nodiscard]] bool other_depth(const float* a, const float* b);
    [[nodiscard]] bool other_color(const float* a, const float* b);

    std::size_t width_;
    std::size_t channels_a_;
    std::size_t channels_b_;
    ChannelPair rgb_[3];
    ChannelPair z_;
    ChannelPair word_;
    ChannelPair object_;
    double pixel_at_eye_;  // p(t) = pixel_at_eye + pixel_growth t, of the first file; 0: not given
    double pixel_growth_;
    std::size_t pixels_ = 0;
    std::size_t hits_ = 0, words_ = 0, depths_ = 0, colors_ = 0, other_cell_colors_ = 0;
    std::size_t different_ = 0;
    double squares_ = 0;
    double worst_depth_ = 0;
};

}  // namespace pxm::host
