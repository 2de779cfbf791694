// SPDX-License-Identifier: MIT
// l3d_picture_pace: which pictures count.
#include "pipeline/picture_pace.h"

#include "base/formatted_p.h"

#include <cstddef>

namespace {

constexpr std::chrono::seconds span{1};

} // namespace

/// The last one is kept at least: it tells what drawing takes.
void l3d_picture_pace::begin() {
    begin_ = now_();
    follows_ = !done_.empty() && begin_ - done_.back().end <= span;
    while (done_.size() > 1 && (!follows_ || begin_ - done_.front().begin > span))
        done_.pop_front();
}

void l3d_picture_pace::end() {
    if (!follows_)
        done_.clear();
    done_.push_back({begin_, now_()});
}

double l3d_picture_pace::milliseconds() const {
    std::chrono::duration<double, std::milli> sum{0};
    for (const picture& each : done_)
        sum += each.end - each.begin;
    return done_.empty() ? 0 : sum.count() / static_cast<double>(done_.size());
}

double l3d_picture_pace::per_second() const {
    if (!follows_ || !(begin_ > done_.front().begin))
        return 0;
    const std::chrono::duration<double> passed = begin_ - done_.front().begin;
    const std::size_t began_before = done_.size() - (done_.back().begin == begin_ ? 1 : 0);
    return static_cast<double>(began_before) / passed.count();
}

std::string l3d_picture_pace::text() const {
    using l3d_detail::formatted;
    if (done_.empty())
        return "";
    const double rate = per_second();
    if (rate == 0)
        return formatted("drawn in %.1f ms", milliseconds());
    constexpr double few = 10; // their tenths can be told apart
    return formatted("%.*f pictures a second, each drawn in %.1f ms", rate < few ? 1 : 0, rate,
                     milliseconds());
}
