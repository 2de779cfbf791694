// SPDX-License-Identifier: MIT
// The verdict on a case: whether the frame kept its promises.
#ifndef L3D_TESTS_STABILITY_JUDGE_H
#define L3D_TESTS_STABILITY_JUDGE_H

#include "arithmetics.h"
#include "cases.h"
#include "curved_cases.h"
#include "exact_surface.h"

#include "reference/region.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stability {

enum class outcome {
    within,    ///< drawn, and the reported bound is at most the tolerance
    weaker,    ///< drawn, and the frame reports a larger bound
    unbounded, ///< drawn, and the frame reports that it knows no bound
    refused,   ///< with a reason
    violated,  ///< anything that was promised does not hold
};

const char* name_of(outcome what);

struct verdict {
    outcome what = outcome::within;
    std::string reason;  ///< of a refusal or a violation
    double bound = 0;    ///< of the frame. Units: pixels
    double measured = 0; ///< largest distance of a drawn point from the exact one. Units: pixels
    double ratio = 0;    ///< largest of measured / bound, each grid with its own bound
    double ratio_measured = 0, ratio_bound = 0; ///< where that is
    std::int64_t points = 0;                    ///< drawn points looked at
    std::int64_t exactly = 0;                   ///< of those, compared in 100 digits
    std::int64_t samples = 0;                   ///< vertices that the library evaluated
    std::int64_t pieces = 0;
    std::int64_t missing = 0, extra = 0; ///< pixels that differ from the exact picture
    double off = 0; ///< of such pixels, the farthest from an outline. Units: pixels
    bool picture_judged = false;
    double milliseconds = 0;

    void violate(const std::string& why);
};

/// How thoroughly points are looked at.
struct effort {
    std::size_t most_polygons =
        20000;                    ///< of a patch; if there are more, each n-th, and one a piece
    std::size_t exact_points = 8; ///< a patch, the ones that seem worst, in 100 digits
    double exact_from = 0;        ///< of their bounds: what is off by less is known in 64 bits
};

/// One case, which several arithmetics are judged by.
class judge {
public:
    judge(const test_case& c, const effort& how);

    /// Empty if the library refuses the case, and why.
    const std::optional<library_case>& accepted() const { return accepted_; }
    const std::string& refusal() const { return why_; }

    /// Dices only.
    verdict of_points(arithmetic& in);

    /// Dices and fills; also compares the picture with the exact one if that can be made.
    verdict of_frame(arithmetic& in);

    /// The words of the last of_frame.
    const std::vector<std::uint32_t>& words() const { return words_; }

private:
    class measuring;

    verdict refused() const;
    void finish(verdict& v, const l3d_dice_counts& counts, const measuring& points) const;
    void judge_picture(verdict& v, const frame& drawn);
    void make_exact_picture(double near);

    const test_case& case_;
    effort how_;
    std::string why_;
    std::optional<library_case> accepted_;
    std::vector<exact_surface> surfaces_;
    std::vector<seen_part> parts_; ///< of surfaces, one for each drawn patch
    bool picture_tried_ = false;
    std::unique_ptr<reference::exact_image> least_covered_; ///< what must be covered
    std::unique_ptr<reference::exact_region> most_covered_; ///< what may be
    std::unique_ptr<reference::exact_region> outlines_;
    std::vector<std::uint32_t> words_;
};

} // namespace stability

#endif
