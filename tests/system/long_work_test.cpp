// SPDX-License-Identifier: MIT
// long_work: what it writes, and that none of it is left.
#include "system/long_work_p.h"

#include <gtest/gtest.h>

#include <semaphore>
#include <sstream>

namespace {

using l3d_detail::long_work;
using std::chrono::milliseconds;

/// A stream that tells when something has been written in full.
class told_stream : private std::stringbuf, public std::ostream {
public:
    told_stream() : std::ostream(this) {}
    std::string text() const { return str(); }
    void await() { flushed_.acquire(); }

private:
    int sync() override {
        flushed_.release();
        return 0;
    }

    std::counting_semaphore<> flushed_{0};
};

TEST(long_work, is_told_with_its_seconds_and_taken_away) {
    told_stream out;
    {
        const long_work work(out, true, "reading a.obj", milliseconds(0), milliseconds(0));
        for (int lines = 0; lines < 3; ++lines)
            out.await();
    }
    constexpr std::string_view lines = "\r\x1b[Kreading a.obj\r\x1b[Kreading a.obj, 1 s"
                                       "\r\x1b[Kreading a.obj, 2 s";
    EXPECT_EQ(out.text().substr(0, lines.size()), lines);
    EXPECT_TRUE(out.text().ends_with(" s\r\x1b[K")) << out.text().size();
}

TEST(long_work, is_told_with_the_share_that_is_done) {
    told_stream out;
    {
        long_work work(out, true, "reading a.step", milliseconds(0), milliseconds(0));
        work.set_share(0.425);
        for (int lines = 0; lines < 3; ++lines)
            out.await();
    }
    EXPECT_NE(out.text().find("reading a.step, 2 s, 42 %"), std::string::npos) << out.text();
}

TEST(long_work, of_a_moment_and_elsewhere_than_in_terminals_is_not_told) {
    std::ostringstream out;
    { const long_work work(out, true, "reading a.obj", std::chrono::hours(1)); }
    { const long_work work(out, false, "reading a.obj", milliseconds(0), milliseconds(0)); }
    EXPECT_EQ(out.str(), "");
}

} // namespace
