// The command line from its words to its exit code, within the test's own process. What main adds
// to it is tested with program.hpp.
#pragma once

#include <string>
#include <vector>

#include "tests/support/folder.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {

/// Does what the program would do in that folder.
[[nodiscard]] Outcome run(const Folder& folder, const Arguments& arguments,
                          const Environment& environment = {});

/// Expects the program to refuse: that exit code, exactly this one message, nothing on stdout, and
/// every file in the folder as it was.
void expect_refusal(const Folder& folder, const Arguments& arguments, int exit_code,
                    const std::string& message);
/// The same where the message's details are not ours: it must contain each of these, and `pxm: `
/// once, at its beginning.
void expect_refusal_naming(const Folder& folder, const Arguments& arguments, int exit_code,
                           const std::vector<std::string>& parts);

/// Expects success; what it wrote on stderr.
std::string expect_done(const Folder& folder, const Arguments& arguments,
                        const Environment& environment = {});

/// Sierpinski's tetrahedron as four homotheties, and nothing else.
extern const char* const tetra_scene;

/// Five small frames in which a map turns and another moves.
extern const char* const turning_film;

}  // namespace pxm::test
