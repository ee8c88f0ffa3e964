// A report: one HTML page that needs nothing else, neither network nor the files beside it.
// Everything is in the page as text and SVG; its few lines of script only show values under the
// pointer. Libraries such as uPlot draw on a canvas, which is a blurred picture on paper.
#pragma once

#include <string>
#include <vector>

namespace pxm::host {

/// A table; the first column is text, the others are numbers as text.
struct PageTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// A picture with values to show under the pointer, on a grid that may be coarser.
struct PageMap {
    std::string title;
    std::string picture;  // the path of a PNG file, taken into the page
    long columns = 0;
    long rows = 0;
    std::vector<double> values;  // empty: nothing to show
    std::string unit;
};

class Page {
  public:
    explicit Page(const std::string& title);

    void heading(const std::string& text);
    void subheading(const std::string& text);
    void paragraph(const std::string& text);
    void table(const PageTable& table);
    void plot(const std::string& svg);
    /// Several beside each other, as far as there is room.
    void row(const std::vector<std::string>& figures);
    [[nodiscard]] static std::string figure(const PageMap& map);

    /// The whole page.
    [[nodiscard]] std::string html() const;

  private:
    std::string title_;
    std::string body_;
};

/// Rows of a CSV file: a heading, then values, quoted where needed (RFC 4180, lines end in \n).
[[nodiscard]] std::string csv_of(const PageTable& table);

}  // namespace pxm::host
