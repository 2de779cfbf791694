// SPDX-License-Identifier: MIT
// l3d_picture_pace: which pictures count.
#include "pipeline/picture_pace.h"

#include "base/formatted_p.h"

#include <cstddef>

namespace {

constexpr std::chrono::seconds span{1};

/// The number of pictures that began before the last, or 1 for a single one.
template <class Pictures>
std::size_t counted(const Pictures& done, l3d_picture_pace::clock::time_point begin) {
    return done.size() - (done.size() > 1 && done.back().begin == begin ? 1 : 0);
}

} // namespace

/// Notes the beginning of a picture, and drops old ones. The last is kept: it tells the time that
/// drawing takes.
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
    const std::size_t count = counted(done_, begin_);
    for (std::size_t i = 0; i < count; ++i)
        sum += done_[i].end - done_[i].begin;
    return count == 0 ? 0 : sum.count() / static_cast<double>(count);
}

double l3d_picture_pace::per_second() const {
    if (!follows_ || !(begin_ > done_.front().begin))
        return 0;
    const std::chrono::duration<double> passed = begin_ - done_.front().begin;
    return static_cast<double>(counted(done_, begin_)) / passed.count();
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
