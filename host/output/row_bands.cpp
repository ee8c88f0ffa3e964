#include "host/output/row_bands.hpp"

#include <utility>

namespace pxm::host {

std::shared_ptr<RowBands::Open> RowBands::open(long number) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Open>& band = open_[number];
    if (!band) {
        band = std::make_shared<Open>();
        const long top = std::max(window_.y0, number * band_rows);
        band->band.index = number - window_.y0 / band_rows;
        band->band.first_row = top - window_.y0;
        band->band.rows = std::min(window_.y1, (number + 1) * band_rows) - top;
        band->band.bytes.resize(row_bytes() * static_cast<std::size_t>(band->band.rows));
        band->missing = band->band.rows * (window_.x1 - window_.x0);
    }
    return band;
}

/// Its memory goes with it: other threads that have put their pixels hold an empty band at most.
RowBand RowBands::taken(long number) {
    const std::lock_guard lock(mutex_);
    const auto found = open_.find(number);
    RowBand band = std::move(found->second->band);
    open_.erase(found);
    return band;
}

}  // namespace pxm::host
