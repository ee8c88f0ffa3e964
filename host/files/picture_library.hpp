// OpenImageIO as pxm sees it. It brings some 260 shared libraries with it, which take half a second
// to load: so it lies in a module of its own (host/openimageio/), which is loaded when the first
// file needs it. Nothing else of pxm is linked to it. EXR pictures are written by OpenEXR itself,
// in another module (host/openexr/), which brings four.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pxm::host {

/// Metadata as text: name, value.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// Bytes at places of a file. Nothing here throws.
class FileBytes {
  public:
    virtual ~FileBytes() = default;
    /// False once any write has failed.
    virtual bool write_at(std::int64_t place, const void* data, std::size_t bytes) noexcept = 0;
    /// Returns how many bytes were read.
    virtual std::size_t read_at(std::int64_t place, void* data, std::size_t bytes) noexcept = 0;
    /// In bytes; 0 if it cannot be told.
    [[nodiscard]] virtual std::int64_t size() noexcept = 0;
};

/// What a picture says of itself. Nothing here was checked.
struct PictureSpec {
    std::int64_t width = 0;             // pixels
    std::int64_t height = 0;            // pixels
    std::int64_t depth = 1;             // slices; 1 of all that pxm reads
    std::int64_t tile_width = 0;        // 0: lines
    std::int64_t tile_height = 0;       // pixels
    std::int64_t tile_depth = 0;        // slices
    std::int64_t channel_count = 0;     // how many values a pixel has
    std::vector<std::string> channels;  // their names
    bool deep = false;                  // several values a pixel
    bool floats = false;                // else whole numbers
    std::vector<std::string> half;      // of the channels of an EXR: floats of 16 bits
    // Where the picture lies in a larger one that an EXR tells of; 0 wide: it is all.
    std::int64_t x = 0;             // of the first column
    std::int64_t y = 0;             // of the first row
    std::int64_t whole_width = 0;   // pixels
    std::int64_t whole_height = 0;  // pixels
    std::string color_space;        // "sRGB" unless the file says another
    Metadata metadata;              // all else that is told as text
};

/// A picture that is being read. Messages are the library's own words.
class PictureInput {
  public:
    virtual ~PictureInput() = default;
    [[nodiscard]] virtual const PictureSpec& spec() const = 0;  // known from the start
    /// Reads the rows from `first` to before `end`, counted from 0, of the first `channels`
    /// channels, interleaved. A picture in tiles is read by whole rows of tiles.
    [[nodiscard]] virtual bool read_floats(int first, int end, int channels, float* values) = 0;
    /// The same as bytes.
    [[nodiscard]] virtual bool read_bytes(int first, int end, int channels,
                                          unsigned char* values) = 0;
    [[nodiscard]] virtual std::string error() = 0;  // why the last call failed
    /// Which reader it is, by the library's name.
    [[nodiscard]] virtual std::string format() const = 0;
};

/// A picture that is being written, row by row.
class PictureOutput {
  public:
    virtual ~PictureOutput() = default;
    /// Whether it will write to `bytes`, which must outlive it, instead of a file of its own.
    [[nodiscard]] virtual bool takes(FileBytes& bytes) = 0;
    /// Begins a file; false: error() says why.
    [[nodiscard]] virtual bool open(const std::string& path, const PictureSpec& spec) = 0;
    /// Appends the rows from `first` to before `end`; false: error() says why.
    [[nodiscard]] virtual bool write_floats(int first, int end, const float* values) = 0;
    /// The same of bytes.
    [[nodiscard]] virtual bool write_bytes(int first, int end, const unsigned char* values) = 0;
    [[nodiscard]] virtual bool close() = 0;         // ends the file; false: error() says why
    [[nodiscard]] virtual std::string error() = 0;  // why the last call failed
    /// Which writer it is, by the library's name.
    [[nodiscard]] virtual std::string format() const = 0;
};

class PictureLibrary {  // what opens pictures
  public:
    virtual ~PictureLibrary() = default;
    /// Opens a picture through a stream, with the reader of that name; null: `error` says why.
    [[nodiscard]] virtual std::unique_ptr<PictureInput> open(const char* reader, std::FILE* stream,
                                                             const std::string& path,
                                                             std::string& error) = 0;
    /// Opens a file that pxm has written; null if it is none.
    [[nodiscard]] virtual std::unique_ptr<PictureInput> open_own(const std::string& path) = 0;
    /// A writer for the path's extension; null: `error` says why.
    [[nodiscard]] virtual std::unique_ptr<PictureOutput> create(const std::string& path,
                                                                std::string& error) = 0;
};

/// The library; the first call loads it. Any thread. Throws Error(ErrorKind::failed) if its module
/// is not where it was built or installed.
[[nodiscard]] PictureLibrary& picture_library();

/// The library that writes EXR pictures; it opens none. Otherwise as picture_library().
[[nodiscard]] PictureLibrary& exr_library();

/// Begins to load the library beside what the caller does next. To be called from the program's
/// first thread, before there are others: what the environment says of plug-ins is taken out of it.
void begin_loading_picture_library();

}  // namespace pxm::host
