// SPDX-License-Identifier: MIT
// dots: shows dots in true perspective: a runway, stars, or snow.
#include "dot.h"

#include <l3d/random.h>
#include <l3d/camera_left_handed.h>
#include <l3d/lesson.h>
#include <l3d/pipeline.h>
#include <l3d/program.h>

#include <cmath>
#include <memory>
#include <vector>

namespace {

using point = l3d_point<l3d_real>;

/// A kind of dots: where they start, and how they move. Units: per update of the book.
class dot_kind {
public:
    dot_kind() = default;
    dot_kind(const dot_kind&) = delete;
    dot_kind& operator=(const dot_kind&) = delete;
    virtual ~dot_kind() = default;

    virtual int count() const { return 150; }
    virtual point place(int number, l3d_random& random) const = 0;
    virtual void move(point& dot, l3d_random& random) const = 0;
};

point random_place(l3d_random& random, int x0, int x1, int y0, int y1, int z0, int z1) {
    const int x = random.between(x0, x1), y = random.between(y0, y1), z = random.between(z0, z1);
    return point::of(x, y, z);
}

class runway final : public dot_kind {
    int count() const override { return 100; }
    point place(int number, l3d_random&) const override {
        return point::of(-200 + 40 * (number % 10), -70, 100 + 40 * (number / 10));
    }
    void move(point& dot, l3d_random&) const override {
        dot += point::of(-5, 0, 0).from_origin;
        // Begins again ten columns of 40 further right, where there is room.
        if (l3d_to_double(dot[0]) <= -200)
            dot += point::of(400, 0, 0).from_origin;
    }
};

class stars final : public dot_kind {
    point place(int, l3d_random& random) const override {
        return random_place(random, -1000, 1000, -1000, 1000, 200, 1199);
    }
    void move(point& dot, l3d_random& random) const override {
        dot += point::of(0, 0, -10).from_origin;
        if (l3d_to_double(dot[2]) < 20)
            dot = place(0, random);
    }
};

class snow final : public dot_kind {
    point place(int, l3d_random& random) const override {
        return random_place(random, -319, 0, 100, 199, 64, 303);
    }
    void move(point& dot, l3d_random& random) const override {
        dot += point::of(random.between(0, 1), -1, 0).from_origin;
        if (l3d_to_double(dot[1]) < -70)
            dot = place(0, random);
    }
};

// Step 2 of 5: the application is a pipeline.
class dots_pipeline final : public l3d_lesson {
public:
    dots_pipeline(l3d_canvas canvas, const dot_kind& kind, std::uint64_t seed)
        : l3d_lesson(std::move(canvas)), kind_(kind), seed_(seed), random_(seed) {
        begin();
    }

private:
    void begin() {
        random_ = l3d_random(seed_);
        eye_ = point::of(0, 0, 0).from_origin;
        dots_.clear();
        for (int i = 0; i < kind_.count(); ++i)
            dots_.push_back(kind_.place(i, random_));
    }

    void restart() override { begin(); }

    void advance(double seconds) override {
        for (int n = ticker_.due(seconds); n > 0; --n)
            for (point& dot : dots_)
                kind_.move(dot, random_);
    }

    /// Moves the eye so that a dot at the distance of the runway's first column follows the
    /// pointer.
    void drag(int, int, int right, int down) override {
        constexpr double distance = 100;
        const double unit = distance / (2 * l3d_fov_term(100) * size().width);
        eye_ += point::of(-right * unit, down * unit, 0).from_origin;
    }

    /// Draws the dots. The eye looks along z. It sees 61.6 degrees, the book's 1 / tan 50.
    void draw_lesson(l3d_rasterizer_2d& rasterizer) override {
        l3d_camera_left_handed<l3d_real> camera(size());
        camera.fovx *= 2;
        camera.fovy *= 2;
        clear(rasterizer);
        const double side = is_classic() ? dot_side(size()) : smooth_dot_side(size());
        for (const point& dot : dots_) {
            auto [x, y] = camera.project(dot - eye_, size());
            if (is_classic()) {
                x = std::floor(x);
                y = std::floor(y);
            }
            draw_dot(rasterizer, x, y, side, 0xffffff);
        }
    }

    const dot_kind& kind_;
    std::uint64_t seed_;
    l3d_random random_;
    l3d_ticker ticker_;
    std::vector<point> dots_;
    point::vector eye_ = point::of(0, 0, 0).from_origin; ///< the eye's place
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("dots",
                        l3d_caption{.what = "Dots in space, in true perspective.",
                                    .teaches = "Perspective divides by the distance: what is far "
                                               "moves less, also when you move your eye.",
                                    .keys = l3d_lesson_keys("move the eye")},
                        {960, 720});
    const runway a_runway;
    const stars some_stars;
    const snow some_snow;
    const dot_kind* kind = &a_runway;
    program.options().add_choice<const dot_kind*>(
        "--scene", kind,
        "what the dots are (the book's "
        "0, 1 and 2)",
        {{"runway", &a_runway}, {"stars", &some_stars}, {"snow", &some_snow}});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        dots_pipeline pipeline(program.create_canvas(), *kind, program.seed());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
