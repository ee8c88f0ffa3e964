// The errors of pxm: what kind of thing is wrong, where, and what to tell the user. Thrown anywhere
// in host/; the program ends with an exit code that is made of the kind in one place
// (host/process/exit_code.hpp), a program that uses the library asks for kind and places.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pxm::host {

enum class ErrorKind {  // what kind of thing is wrong: the program's exit code is made of it
    failed,             // of the run: nobody is to blame for it
    setting,            // an option, or another value that the caller gave
    scene,              // the text of a scene, or of a file to import
    file,               // a file that cannot be read or written
    machine_limit,      // a memory of the simulated machine is too small
};

/// One thing that is wrong in a text, and where it stands.
struct Mistake {
    std::string file;     // its name as it was given
    int line = 1;         // from 1
    int column = 1;       // in bytes, from 1
    std::string message;  // what is wrong, without the place
};

/// what() is the whole message, of several lines if there is more to say.
class Error : public std::runtime_error {
  public:  /// `mistakes` are those of a scene.
    Error(ErrorKind kind, const std::string& message, std::vector<Mistake> mistakes = {})
        : std::runtime_error(message), kind_(kind), mistakes_(std::move(mistakes)) {}
    /// What kind of thing is wrong.
    [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
    /// Of a scene: everything that was found wrong, in the order of the text. Else empty.
    [[nodiscard]] const std::vector<Mistake>& mistakes() const noexcept { return mistakes_; }

  private:
    ErrorKind kind_;
    std::vector<Mistake> mistakes_;
};

}  // namespace pxm::host
