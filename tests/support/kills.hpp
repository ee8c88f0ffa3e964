// Runs of the program that are killed at random moments (kill -9), as a power cut of one process.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace pxm::test {

/// What is killed. The folder holds the scene `tetra.pxm` and the film `film.pxm`.
struct KilledWork {
    Arguments command;
    std::vector<std::string> finals;  // the files that it makes, by their paths in the folder
    /// Puts into an empty folder what the command needs beside the scenes.
    std::function<void(const Folder&)> prepare = [](const Folder&) {};
    std::string old = {};      // what the finals hold before; empty: they are not there
    Arguments companion = {};  // runs beside it, of the same kind, and is not killed
};

/// Kills the work so many times at random moments of its run: from time to time twice before a run
/// comes to its end. Expects at any time that a final name is as before or as an undisturbed run
/// leaves it, and that the run which follows ends well, with the undisturbed run's bytes.
void kill_at_random(const KilledWork& work, int kills, std::mt19937& random);

/// All kinds of work that go on after a death.
[[nodiscard]] std::vector<KilledWork> killed_works();

}  // namespace pxm::test
