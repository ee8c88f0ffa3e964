// Judges single pixels of any engine's picture by the definition (docs/design.md, "The picture" and
// decision 4), and says why one that the definition does not admit may be as it is: rounding, an
// alarm that pxm raised itself, or nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/engine/frame.hpp"
#include "tests/support/oracle.hpp"

namespace pxm::test {

/// What a pixel is worth.
enum class Standing {
    same,      // shows the cell that the definition says, or misses as it does
    admitted,  // another cell that decision 4 admits
    rounded,   // what a ray shows that is moved by what rounding moves rays by
    excused,   // wrong, and marked by an alarm
    unjudged,  // the ray meets more cells than the oracle waits for
    find,      // wrong
};

struct Opinion {
    Standing standing = Standing::same;
    std::string reason;  // of what is excused the alarm's name, of a find what is wrong
};

/// A picture to be judged.
struct JudgedPicture {
    std::string method;                             // that made it
    host::Frame frame;                              // with its pixels' alarms
    host::Numeric numeric = host::Numeric::single;  // its cells were placed with
    std::vector<host::Alarm> alarms;
};

class PixelJudge {
  public:
    /// Keeps a reference to `scene`, which is judged as one ray a pixel sees it. `patience`: cells
    /// that the oracle looks at for one ray.
    PixelJudge(const host::CompiledScene& scene, long patience);

    [[nodiscard]] Opinion judge(const JudgedPicture& picture, long x, long y);

  private:
    /// What the definition says of the ray through a pixel.
    struct Truth {
        long x = -1, y = -1;
        bool known = false;  // false: the oracle gave up
        std::vector<TerminalCell> cells;
        double plane = 0;      // where it meets the nearest plane
        int plane_number = 0;  // of the scene's
    };
    /// The definition with a detail of its own: what is terminal by a hair is not with another.
    struct Definition {
        host::CompiledScene scene;
        std::optional<Oracle> oracle;
    };

    Truth truth_of(Oracle& oracle, const Sight& ray) const;
    const Truth& truth(host::Numeric numeric, long x, long y);
    Opinion by_truth(const JudgedPicture& picture, Oracle& oracle, const Truth& truth) const;
    bool shown_by_a_near_ray(const JudgedPicture& picture, long x, long y);
    bool is_shown_by(Oracle& oracle, const Sight& ray, const host::PixelRecord& pixel) const;
    [[nodiscard]] double ray_error(const JudgedPicture& picture,
                                   const host::PixelRecord& pixel) const;
    Oracle& oracle_with(host::Numeric numeric, int finer);

    const host::CompiledScene& scene_;
    long patience_;
    bool floors_;  // whether p's smallest share differs between the numbers here
    std::vector<Definition> definitions_;  // by numbers and detail
    Truth truths_[2];                      // of the pixel looked at last, by numbers
};

}  // namespace pxm::test
