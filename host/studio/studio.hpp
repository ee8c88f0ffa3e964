// The studio: one page on the loopback address, behind which the real engines stand
// (docs/studio.md). It computes, opens and saves what its page asks for; what it says to the user
// it leaves to the command.
#pragma once

#include <memory>
#include <string>

#include "host/studio/asks.hpp"

namespace pxm::host {

struct StudioSettings {
    std::string folder = ".";  // scenes are opened and saved below it; what they name is looked for
                               // below the folder that the process is in
    std::string scene;         // below the folder; empty: the gallery
    int port = 0;              // 0: one that is free
    int threads = 1;           // of each render
    double seconds = asked_seconds;  // that whatever a page asks for may take
};

class Studio {
  public:
    static constexpr double grace_seconds = 15;  // that it stays when the last page is closed

    /// Throws Error: no folder, a scene that cannot be opened, a port that is taken.
    explicit Studio(const StudioSettings& settings);
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;
    /// Stops what is being computed.
    ~Studio();

    /// Where its page is, for the user. It has the token: who knows it is let in.
    [[nodiscard]] std::string address() const;
    /// The same for a browser's command line: good for one visit.
    [[nodiscard]] std::string address_for_once() const;
    /// Whether there was a page and none has been there for the grace time.
    [[nodiscard]] bool is_deserted() const;

  private:
    class Desk;
    std::unique_ptr<Desk> desk_;
};

}  // namespace pxm::host
