// A PNG while it is rendered: whoever puts the last pixel into a band of rows deflates it.
#include "host/files/carried_text.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/encoder.hpp"
#include "host/output/pixel_values.hpp"
#include "host/output/png.hpp"
#include "host/output/row_bands.hpp"
#include "host/process/in_order.hpp"

namespace pxm::host {

namespace {

class PngEncoder : public ImageWriter::Encoder {
  public:
    PngEncoder(const std::string& path, const CropWindow& window, const Metadata& metadata)
        : part_(path, Places::in_order),
          bands_(window, 3),
          png_(part_.file(), static_cast<std::uint32_t>(window.x1 - window.x0),
               static_cast<std::uint32_t>(window.y1 - window.y0), software, file_time()) {
        for (const auto& [name, value] : metadata)
            if (name == carried_metadata) png_.text(png_carried(value));
    }

    void append(const Frame& part) override {
        bands_.add(part, &put_srgb_bytes, [&](const RowBand& band) {
            segments_.add(band.index, deflate_rows(band.bytes, bands_.row_bytes()),
                          [&](const PngSegment& segment) { png_.append(segment); });
        });
    }

    void finish() override {
        png_.finish();
        part_.commit();
    }

  private:
    PartFile part_;
    RowBands bands_;
    InOrder<PngSegment> segments_;
    PngFile png_;
};

}  // namespace

std::unique_ptr<ImageWriter::Encoder> make_png_encoder(const std::string& path,
                                                       const CropWindow& window,
                                                       const Metadata& metadata) {
    return std::make_unique<PngEncoder>(path, window, metadata);
}

}  // namespace pxm::host
