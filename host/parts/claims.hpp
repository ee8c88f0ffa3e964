// Who of several workers makes which part, where they share nothing but a folder, perhaps over a
// network. A claim is a file that its worker creates; only one can create it (O_EXCL). While the
// worker lives it writes another number into the file every few seconds; who watches a claim that
// does not change for long takes the part over by creating the claim's next generation. No clocks
// of different computers are compared, no lock is needed, and a worker that was wrongly taken for
// dead does no harm: whoever finishes first puts the part into its place, and both made the same.
// What is asked of the file system: O_EXCL creates once and renames are whole (NFS from version 3
// on), and a file that is opened shows what was there when its writer last closed it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "host/process/interrupt.hpp"

namespace pxm::host {

/// A claim of this process on a part: kept alive by a thread, and given back when it ends.
class Claim {
  public:
    /// `path` was created by try_to_create().
    Claim(std::string path, std::chrono::milliseconds expiry);
    ~Claim();
    Claim(const Claim&) = delete;
    Claim& operator=(const Claim&) = delete;

  private:
    void beat();

    std::string path_;
    PartFileGuard guard_;  // a signal gives the claim back
    std::chrono::milliseconds pause_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool done_ = false;
    std::thread thread_;
};

/// The claims in a folder as one worker sees them.
class Claims {
  public:
    /// A claim that has not changed for `expiry` is of the dead.
    Claims(std::string folder, std::chrono::milliseconds expiry)
        : folder_(std::move(folder)), expiry_(expiry) {}

    /// Claims the part that `name` is the file of, if nobody has or the one who had is dead. Throws
    /// Error(ErrorKind::file) if no file can be created.
    [[nodiscard]] std::unique_ptr<Claim> take(const std::string& name);
    /// Removes the claims on a part that is there.
    void forget(const std::string& name);

  private:
    struct Seen {
        int generation = -1;
        std::string text;
        std::chrono::steady_clock::time_point since;
    };
    [[nodiscard]] std::string path_of(const std::string& name, int generation) const;
    [[nodiscard]] bool is_dead(const std::string& name, int generation);

    std::string folder_;
    std::chrono::milliseconds expiry_;
    std::map<std::string, Seen> seen_;
};

}  // namespace pxm::host
