// SPDX-License-Identifier: MIT
// curves: a cubic curve with handles, walked by forward differences in two arithmetics.
#include <l3d/fixed.h>
#include <l3d/path.h>
#include <l3d/program.h>
#include <l3d/stroke.h>
#include <l3d/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

using numbers = std::array<double, 4>;

/// Value, first, second and third difference of a cubic with these control values, for n steps.
numbers differences(const numbers& b, int n) {
    const double first = 3 * (b[1] - b[0]) / n, second = 3 * (b[2] - 2 * b[1] + b[0]) / n / n;
    const double third = (b[3] - 3 * b[2] + 3 * b[1] - b[0]) / n / n / n;
    return {b[0], first + second + third, 2 * second + 6 * third, 6 * third};
}

/// The points that n steps of three additions lead to, in one arithmetic.
template <class T> std::vector<double> walked(const numbers& b, int n) {
    const numbers d = differences(b, n);
    std::array<T, 4> r{T(d[0]), T(d[1]), T(d[2]), T(d[3])};
    std::vector<double> result{static_cast<double>(r[0])};
    for (int i = 0; i < n; ++i) {
        r[0] = r[0] + r[1];
        r[1] = r[1] + r[2];
        r[2] = r[2] + r[3];
        result.push_back(static_cast<double>(r[0]));
    }
    return result;
}

/// Step 2 of 5: the application is a pipeline.
class curves_pipeline final : public l3d_pipeline_2d {
public:
    explicit curves_pipeline(l3d_canvas canvas) : l3d_pipeline_2d(std::move(canvas)) {}

    void key_event(int key) override {
        l3d_pipeline_2d::key_event(key);
        if (key == 'm')
            change_steps(1);
        if (key == 'l')
            change_steps(-1);
        if (key == 'd')
            dashed_ = !dashed_;
        if (key == 'r') {
            handles_ = places_at_first;
            steps_ = steps_at_first;
        }
        fresh_ = false;
    }

    void pointer_event(const l3d_event& event) override {
        const l3d_point_2d at{double(event.x), double(event.y)};
        if (event.type == l3d_event_type::wheel)
            change_steps(event.notches);
        if (event.type == l3d_event_type::button_press)
            held_ = nearest_handle(at);
        if (event.type == l3d_event_type::button_release)
            held_ = none;
        if (held_ != none)
            handles_[held_] = {at.x / size().width, at.y / size().height};
        fresh_ = false;
    }

    void resize_event(l3d_size size) override {
        l3d_pipeline_2d::resize_event(size);
        fresh_ = false;
    }

    bool needs_redraw() const override { return !fresh_; }

private:
    using fixed_16 = l3d_fixed<std::int32_t, 16>; ///< what the dissertation had

    static constexpr std::size_t none = 4;
    static constexpr int steps_at_first = 24, most_steps = 512;
    /// Shares of width and height, so that handles stay in a window of another size.
    static constexpr std::array<l3d_point_2d, 4> places_at_first{
        {{0.08, 0.62}, {0.3, 0.02}, {0.62, 0.85}, {0.92, 0.12}}};
    static constexpr std::uint32_t exact_color = 0x0060c0ff, fixed_color = 0x00ff5040,
                                   quiet_color = 0x00707880, step_color = 0x00f0f0f0;

    void change_steps(int by) {
        const int more = std::max(steps_ / 4, 1);
        steps_ = std::clamp(steps_ + by * more, 1, most_steps);
    }

    l3d_point_2d place(std::size_t i) {
        return {handles_[i].x * size().width, handles_[i].y * size().height};
    }

    std::size_t nearest_handle(l3d_point_2d at) {
        constexpr double reach = 12;
        std::size_t best = none;
        double least = reach;
        for (std::size_t i = 0; i < none; ++i) {
            const l3d_point_2d p = place(i);
            const double distance = std::hypot(p.x - at.x, p.y - at.y);
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }

    void draw(l3d_rasterizer_2d& r) override {
        fresh_ = true;
        r.clear_buffer();
        const std::array<l3d_point_2d, 4> p{place(0), place(1), place(2), place(3)};
        const numbers x{p[0].x, p[1].x, p[2].x, p[3].x}, y{p[0].y, p[1].y, p[2].y, p[3].y};
        const auto exact_x = walked<double>(x, steps_), exact_y = walked<double>(y, steps_);
        const auto fixed_x = walked<fixed_16>(x, steps_), fixed_y = walked<fixed_16>(y, steps_);

        l3d_path net, curve, steps, handles, fixed;
        net.add_polygon(std::array{p[0], p[1], p[2], p[3], p[2], p[1]});
        r.draw_path(l3d_stroked(net, {.dashes = {4, 4}}), {.color = quiet_color});
        curve.move_to(p[0]);
        curve.cubic_to(p[1], p[2], p[3]);
        const std::vector<double> dashes =
            dashed_ ? std::vector<double>{18, 8} : std::vector<double>{};
        r.draw_path(l3d_stroked(curve, {.width = 5, .cap = l3d_cap::round, .dashes = dashes}),
                    {.color = exact_color, .alpha = 0.6});
        r.draw_curves(curve, exact_color);
        fixed.move_to({fixed_x[0], fixed_y[0]});
        for (std::size_t i = 0; i < fixed_x.size(); ++i) {
            fixed.line_to({fixed_x[i], fixed_y[i]});
            steps.add_circle({exact_x[i], exact_y[i]}, 1.7);
        }
        r.draw_path(l3d_stroked(fixed, {.join = l3d_join::round}), {.color = fixed_color});
        r.draw_path(steps, {.color = step_color});
        for (const l3d_point_2d& handle : p)
            handles.add_circle(handle, 5);
        r.draw_path(l3d_stroked(handles, {.width = 1.5}), {.color = step_color});

        double worst = 0;
        std::vector<double> errors;
        for (std::size_t i = 0; i < fixed_x.size(); ++i) {
            errors.push_back(std::hypot(fixed_x[i] - exact_x[i], fixed_y[i] - exact_y[i]));
            worst = std::max(worst, errors.back());
        }
        draw_bars(r, errors, worst);
        draw_numbers(r, differences(x, steps_), differences(y, steps_), worst);
    }

    /// The error of each step in 16.16, the largest one an eighth of the window high.
    void draw_bars(l3d_rasterizer_2d& r, const std::vector<double>& errors, double worst) {
        const double height = size().height / 8.0, bottom = size().height - 4;
        const double left = 6, wide = (size().width - 12.0) / static_cast<double>(errors.size());
        l3d_path bars;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const double from = left + wide * static_cast<double>(i);
            const double top = bottom - (worst > 0 ? height * errors[i] / worst : 0);
            bars.add_polygon(std::array<l3d_point_2d, 4>{{{from, bottom},
                                                          {from + wide * 0.8, bottom},
                                                          {from + wide * 0.8, top},
                                                          {from, top}}});
        }
        r.draw_path(bars, {.color = fixed_color, .alpha = 0.8});
    }

    void draw_numbers(l3d_rasterizer_2d& r, const numbers& dx, const numbers& dy, double worst) {
        std::array<char, 100> line{};
        int row = 0;
        const auto show = [&](std::uint32_t color, const char* form, auto... values) {
            std::snprintf(line.data(), line.size(), form, values...);
            l3d_draw_text(r, 4, 4 + l3d_text_line * row++, line.data(), color);
        };
        show(step_color, "%d steps", steps_);
        for (std::size_t k = 1; k < 4; ++k)
            show(quiet_color, "d%d %10.4f %10.4f", int(k), dx[k], dy[k]);
        show(fixed_color, "16.16 off by %.4f px", worst);
    }

    std::array<l3d_point_2d, 4> handles_ = places_at_first;
    std::size_t held_ = none;
    int steps_ = steps_at_first;
    bool dashed_ = false, fresh_ = false;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "curves",
        "A curve walked by forward differences, exactly and in 16.16 (red), and how "
        "far each step of the latter is off. Drag the handles. Keys: m more steps, l "
        "less, d dashes, r as at first, F11, q. The wheel changes steps, too.",
        {480, 320});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        curves_pipeline pipeline(program.create_canvas());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
