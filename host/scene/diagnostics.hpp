// A scene's mistakes: collected with their places, at most 20, and thrown once.
//   fern.pxm:12:7: error: map "stem" does not contract (Lipschitz constant 1.04)
//       scale: 1.04,1,1
//       ^
#pragma once

#include <string>
#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {
/// Collects what is wrong with a scene.
class Diagnostics {
  public:
    static constexpr int error_limit = 20;    // more are not kept
    static constexpr int warning_limit = 20;  // the same of warnings

    void error(const Position& position, const std::string& message);    // at a place of the scene
    void warning(const Position& position, const std::string& message);  // the same

    [[nodiscard]] bool has_errors() const { return errors_ > 0; }  // whether any error was added
    /// True once error_limit errors were collected: a parser may give up.
    [[nodiscard]] bool full() const { return errors_ >= error_limit; }

    /// Takes over all entries of another collection.
    void append(const Diagnostics& other);

    /// True once an error had to be left out: nothing that follows would be shown.
    [[nodiscard]] bool overflowed() const { return more_errors_; }

    /// Errors and warnings in the order found, each as file:line:column, message, the line and a
    /// caret. No newline at the end.
    [[nodiscard]] std::string text(const std::vector<SourceFile>& files) const;
    /// The warnings alone.
    [[nodiscard]] std::string warnings_text(const std::vector<SourceFile>& files) const;
    /// Throws Error(ErrorKind::scene) with the text if there is any error.
    void throw_if_errors(const std::vector<SourceFile>& files) const;

  private:
    struct Entry {
        Position position;
        std::string message;
        bool is_error;
    };
    [[nodiscard]] std::string format(const std::vector<SourceFile>& files, bool errors_too) const;

    std::vector<Entry> entries_;
    int errors_ = 0;
    int warnings_ = 0;
    bool more_errors_ = false;
    bool more_warnings_ = false;
};

}  // namespace pxm::host
