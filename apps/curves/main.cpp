// SPDX-License-Identifier: MIT
// curves: walks along a cubic curve with handles by forward differences, in three arithmetics, in
// equal and in adaptive steps.
#include <l3d/forward_difference.h>
#include <l3d/fixed.h>
#include <l3d/font.h>
#include <l3d/image.h>
#include <l3d/path.h>
#include <l3d/placement_2d.h>
#include <l3d/program.h>

#include <algorithm>
#include <charconv>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <iterator>
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

/// The points of a walk in n steps of three additions, in the arithmetic T.
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

/// A walk, adaptive or in equal steps, and its measurements.
struct walk_seen {
    l3d_step_counts counts;
    std::vector<l3d_point_2d> places; ///< both ends of all steps
    double longest = 0;               ///< how far a step moves the larger coordinate, in pixels
    double worst = 0;                 ///< how far a place is from the exact one, in pixels

    void add(l3d_point_2d place, l3d_point_2d exact) {
        if (!places.empty())
            longest = std::max({longest, std::abs(place.x - places.back().x),
                                std::abs(place.y - places.back().y)});
        worst = std::max(worst, std::hypot(place.x - exact.x, place.y - exact.y));
        places.push_back(place);
    }
};

double at_parameter(const numbers& b, double t) {
    const double s = 1 - t;
    return s * s * s * b[0] + 3 * s * s * t * b[1] + 3 * s * t * t * b[2] + t * t * t * b[3];
}

/// A walk in adaptive steps. It begins with 2^4 steps, as the study's program does, and ends with
/// 2^12 at the most.
template <class T> walk_seen adaptive(const numbers& x, const numbers& y) {
    constexpr int first = 4, finest = 12;
    const auto build = [](const numbers& b) {
        // The control points, rounded to values that 16.16 and whole numbers hold.
        numbers on_grid = b;
        for (double& value : on_grid)
            value = std::round(64 * value) / 64;
        return l3d_forward_difference<T, 3>::build(on_grid, 1 << first);
    };
    walk_seen seen;
    seen.counts = l3d_walk_adaptively<T, 2>(
        {build(x), build(y)}, first, finest, T(1), [&](std::int64_t at, int, const auto& curve) {
            const double t = static_cast<double>(at) / (1 << finest);
            seen.add({static_cast<double>(curve[0].value()), static_cast<double>(curve[1].value())},
                     {at_parameter(x, t), at_parameter(y, t)});
        });
    return seen;
}

/// A walk in `steps` equal steps, in double.
walk_seen equal(const numbers& x, const numbers& y, int steps) {
    const auto places_x = walked<double>(x, steps), places_y = walked<double>(y, steps);
    walk_seen seen;
    for (std::size_t i = 0; i < places_x.size(); ++i) {
        const double t = static_cast<double>(i) / steps;
        seen.add({places_x[i], places_y[i]}, {at_parameter(x, t), at_parameter(y, t)});
    }
    return seen;
}

/// Step 2 of 5: the application is a pipeline.
class curves_pipeline final : public l3d_pipeline_2d {
public:
    explicit curves_pipeline(l3d_canvas canvas) : l3d_pipeline_2d(std::move(canvas)) {
        std::string why;
        font_ = l3d_font::of_system(why);
        if (!why.empty() && !screen().is_window()) // a window's caption tells the reason
            std::cerr << "curves: " << why << '\n';
    }

    void key_event(int key) override {
        l3d_pipeline_2d::key_event(key);
        if (key == 'm')
            change_steps(1);
        if (key == 'l')
            change_steps(-1);
        if (key == 'a')
            adaptive_ = !adaptive_;
        if (key == 'd')
            dashed_ = !dashed_;
        if (key == 'z')
            magnified_ = !magnified_;
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
            handles_[held_] = {std::clamp(at.x / size().width, 0.0, 1.0),
                               std::clamp(at.y / size().height, 0.0, 1.0)};
        fresh_ = false;
    }

    void resize_event(l3d_size size) override {
        l3d_pipeline_2d::resize_event(size);
        fresh_ = false;
    }

    bool is_at_rest() const override { return true; }
    bool needs_redraw() const override { return !fresh_; }

private:
    using fixed_16 = l3d_fixed<std::int32_t, 16>; ///< 32 bits, half of them after the point
    /// The whole numbers in which Klassen's method walks: a grid of 2^-6 pixel, and 3 bits for each
    /// of 12 halvings.
    using whole_42 = l3d_fixed<std::int64_t, 42>;

    static constexpr std::size_t none = 4;
    static constexpr int steps_at_first = 24, most_steps = 512;
    /// The places of the control points at first, as shares of width and height, so that handles
    /// stay in a window of another size. They leave room for the numbers and the caption above, and
    /// for magnifier and bars below.
    static constexpr std::array<l3d_point_2d, 4> places_at_first{
        {{0.06, 0.38}, {0.3, 0.82}, {0.6, 0.34}, {0.94, 0.45}}};
    static constexpr std::uint32_t exact_color = 0x0060c0ff, fixed_color = 0x00ff5040,
                                   quiet_color = 0x00909aa4, step_color = 0x00f0f0f0,
                                   whole_color = 0x0080e090;

    void change_steps(int by) {
        const int more = std::max(steps_ / 4, 1);
        steps_ = std::clamp(steps_ + by * more, 1, most_steps);
    }

    l3d_point_2d place(std::size_t i) {
        return {handles_[i].x * size().width, handles_[i].y * size().height};
    }

    std::size_t nearest_handle(l3d_point_2d at) {
        const double reach = 12 * unit();
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
        if (adaptive_)
            return draw_adaptive(r);
        const std::array<l3d_point_2d, 4> p{place(0), place(1), place(2), place(3)};
        const numbers x{p[0].x, p[1].x, p[2].x, p[3].x}, y{p[0].y, p[1].y, p[2].y, p[3].y};
        const auto exact_x = walked<double>(x, steps_), exact_y = walked<double>(y, steps_);
        const auto fixed_x = walked<fixed_16>(x, steps_), fixed_y = walked<fixed_16>(y, steps_);
        const double u = unit();
        std::vector<double> errors;
        for (std::size_t i = 0; i < fixed_x.size(); ++i)
            errors.push_back(std::hypot(fixed_x[i] - exact_x[i], fixed_y[i] - exact_y[i]));
        const auto worst =
            static_cast<std::size_t>(std::ranges::max_element(errors) - errors.begin());

        l3d_path net, curve, steps, handles, fixed;
        net.move_to(p[0]);
        for (const l3d_point_2d& handle : {p[1], p[2], p[3]})
            net.line_to(handle);
        r.draw_path(l3d_stroked(net, {.width = u, .dashes = {4 * u, 4 * u}}),
                    {.color = quiet_color});
        curve.move_to(p[0]);
        curve.cubic_to(p[1], p[2], p[3]);
        const std::vector<double> dashes =
            dashed_ ? std::vector<double>{18 * u, 8 * u} : std::vector<double>{};
        r.draw_path(l3d_stroked(curve, {.width = 5 * u, .cap = l3d_cap::round, .dashes = dashes}),
                    {.color = exact_color, .alpha = 0.6});
        r.draw_curves(curve, exact_color);
        fixed.move_to({fixed_x[0], fixed_y[0]});
        for (std::size_t i = 0; i < fixed_x.size(); ++i) {
            fixed.line_to({fixed_x[i], fixed_y[i]});
            steps.add_circle({exact_x[i], exact_y[i]}, 1.7 * u);
        }
        r.draw_path(l3d_stroked(fixed, {.width = u, .join = l3d_join::round}),
                    {.color = fixed_color});
        // The pixels are copied before the marks are drawn, which would hide the red line.
        l3d_image seen = magnified_ ? around(r, {fixed_x[worst], fixed_y[worst]}) : l3d_image();
        r.draw_path(steps, {.color = step_color});
        for (const l3d_point_2d& handle : p)
            handles.add_circle(handle, 5 * u);
        r.draw_path(l3d_stroked(handles, {.width = 1.5 * u}), {.color = step_color});

        if (magnified_)
            draw_magnified(r, std::move(seen));
        draw_bars(r, errors, errors[worst]);
        draw_numbers(r, x, y, errors[worst]);
    }

    /// Draws two ribbons along the curve: above with adaptive steps, below with as many equal ones.
    /// Red steps are longer than a pixel and blue ones shorter than half a pixel.
    void draw_adaptive(l3d_rasterizer_2d& r) {
        const std::array<l3d_point_2d, 4> p{place(0), place(1), place(2), place(3)};
        const numbers x{p[0].x, p[1].x, p[2].x, p[3].x}, y{p[0].y, p[1].y, p[2].y, p[3].y};
        const walk_seen whole = adaptive<whole_42>(x, y), fixed = adaptive<fixed_16>(x, y);
        const walk_seen even = equal(x, y, static_cast<int>(whole.counts.steps));
        draw_ribbon(r, whole.places, -1);
        draw_ribbon(r, even.places, 1);
        l3d_path handles;
        for (const l3d_point_2d& handle : p)
            handles.add_circle(handle, 5 * unit());
        r.draw_path(l3d_stroked(handles, {.width = 1.5 * unit()}), {.color = step_color});

        const auto counted = [](std::int64_t count, const std::string& thing) {
            return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
        };
        const auto of = [](const walk_seen& seen) {
            return "the longest " + with_four_digits(seen.longest) + " px, off by " +
                   with_four_digits(seen.worst) + " px";
        };
        l3d_point_2d base{6 * unit(), 13 * unit()};
        const auto write = [&](std::uint32_t color, const std::string& line) {
            write_text(r, color, base, line);
            base.y += 13.5 * unit();
        };
        write(whole_color, "adaptive: " + counted(whole.counts.steps, "step") + ", " +
                               counted(whole.counts.halvings, "halving") + ", " +
                               counted(whole.counts.doublings, "doubling"));
        write(whole_color, of(whole));
        write(step_color, "equal: " + counted(std::ssize(even.places) - 1, "step"));
        write(step_color, of(even));
        write(fixed_color, "adaptive in 16.16: " + counted(fixed.counts.steps, "step"));
        write(fixed_color, of(fixed));
    }

    /// Draws steps as strokes across the curve, all on one side of it.
    void draw_ribbon(l3d_rasterizer_2d& r, const std::vector<l3d_point_2d>& places, double side) {
        for (std::size_t i = 1; i < places.size(); ++i) {
            const l3d_point_2d from = places[i - 1], to = places[i];
            const double x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
            if (length == 0)
                continue;
            const double moves = std::max(std::abs(x), std::abs(y));
            const double near = 3 * unit() * side / length, far = 14 * unit() * side / length;
            l3d_path step;
            step.add_polygon(std::array<l3d_point_2d, 4>{{{from.x - y * near, from.y + x * near},
                                                          {to.x - y * near, to.y + x * near},
                                                          {to.x - y * far, to.y + x * far},
                                                          {from.x - y * far, from.y + x * far}}});
            r.draw_path(step, {.color = moves > 1     ? fixed_color
                                        : moves < 0.5 ? exact_color
                                                      : whole_color,
                               .alpha = i % 2 == 0 ? 0.9 : 0.6}); // neighbours look different
        }
    }

    /// The factor on thin lines and letters: 1 in windows of 480 x 320 pixels. In larger windows it
    /// grows more slowly than the window. On a fine display, sizes are in units of the display's
    /// text, so that windows look as they do elsewhere.
    double unit() {
        const double dots = std::max(1.0, screen().text_scale());
        const double larger = std::min(size().width / 480.0, size().height / 320.0) / dots;
        constexpr double slower = 0.75;
        constexpr double least = 0.75; // smaller letters could not be read
        return dots * std::max(least, std::pow(larger, slower));
    }

    static constexpr int magnified_columns = 24, magnified_rows = 16;

    /// Copies the pixels around a place, as they are now.
    l3d_image around(l3d_rasterizer_2d& r, l3d_point_2d place) {
        r.finish();
        const l3d_pixels all = screen().pixels();
        const int wide = std::min(magnified_columns, all.width);
        const int high = std::min(magnified_rows, all.height);
        const int left = std::clamp(static_cast<int>(place.x) - wide / 2, 0, all.width - wide);
        const int top = std::clamp(static_cast<int>(place.y) - high / 2, 0, all.height - high);
        l3d_image copy({wide, high}, wide);
        for (int y = 0; y < high; ++y)
            std::ranges::copy(l3d_row(all, top + y, {left, 0, left + wide, 0}),
                              copy.pixels().row(y).begin());
        return copy;
    }

    /// Draws pixels as squares, above the bars on the right. They show the red line beside the blue
    /// one.
    void draw_magnified(l3d_rasterizer_2d& r, l3d_image copy) {
        const l3d_size all = size();
        const int wide = copy.pixels().width, high = copy.pixels().height;
        const double above_bars = all.height * 7 / 8.0 - 12 * unit();
        const double room = std::max(above_bars - 6 * unit(), 0.0);
        const double width = std::min(all.width / 3.0, room * wide / high);
        const double height = width * high / wide;
        const l3d_point_2d corner{all.width - width - 6 * unit(), above_bars - height};
        r.draw_image(
            {copy.pixels(),
             l3d_placement_2d::image_in_box({wide, high}, corner.x, corner.y, width, height),
             l3d_image_filter::area});
        l3d_path frame;
        const double from_x = corner.x - 0.5, from_y = corner.y - 0.5;
        frame.add_polygon(std::array<l3d_point_2d, 4>{{{from_x, from_y},
                                                       {from_x + width, from_y},
                                                       {from_x + width, from_y + height},
                                                       {from_x, from_y + height}}});
        r.draw_path(l3d_stroked(frame, {.width = 1.5 * unit()}), {.color = quiet_color});
    }

    /// Draws the error of each step in 16.16 as a bar; the largest is an eighth of the window high.
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

    void write_text(l3d_rasterizer_2d& r, std::uint32_t color, l3d_point_2d base,
                    const std::string& text) {
        const double letters = 10 * unit();
        l3d_path path;
        font_.outline(path, base, text, letters);
        // a dark rim, so that letters can be read upon lines
        r.draw_path(l3d_stroked(path, {.width = letters / 3, .join = l3d_join::round}),
                    {.color = 0, .alpha = 0.7});
        r.draw_path(path, {.color = color});
    }

    void draw_numbers(l3d_rasterizer_2d& r, const numbers& x, const numbers& y, double worst) {
        const double letters = 10 * unit();
        l3d_point_2d base{0.6 * letters, 1.3 * letters};
        const auto write = [&](std::uint32_t color, double from, const std::string& text) {
            write_text(r, color, {base.x + from, base.y}, text);
        };
        const auto width = [&](const std::string& text) {
            l3d_path nowhere;
            return font_.outline(nowhere, {}, text, letters);
        };
        const double line = 1.35 * letters;
        const auto next_line = [&] { base.y += line; };
        write(step_color, 0, counted_steps(steps_));
        const numbers dx = differences(x, steps_), dy = differences(y, steps_);
        const double gap = letters / 2;
        double widest_x = 0, widest_y = 0;
        for (std::size_t k = 1; k < 4; ++k) {
            widest_x = std::max(widest_x, width(with_four_digits(dx[k])));
            widest_y = std::max(widest_y, width(with_four_digits(dy[k])));
        }
        const double end_x = std::max(7 * letters, width("d1") + gap + widest_x);
        const double end_y = std::max(13 * letters, end_x + gap + widest_y);
        const auto number = [&](double end, double value) {
            const std::string text = with_four_digits(value);
            write(quiet_color, end - width(text), text);
        };
        constexpr double lines = 7, most_of_height = 0.31; // the room above the first handles
        const bool has_room = lines * line <= most_of_height * size().height;
        for (std::size_t k = 1; k < 4 && has_room; ++k) {
            next_line();
            write(quiet_color, 0, "d" + std::to_string(k));
            number(end_x, dx[k]);
            number(end_y, dy[k]);
        }
        next_line();
        write(fixed_color, 0, "16.16 off by " + with_four_digits(worst) + " px");
        next_line();
        const int doublings = doublings_for(steps_);
        write(whole_color, 0,
              "whole numbers off by " + with_four_digits(whole_error(x, y, doublings)) + " px");
        if (1 << doublings == steps_)
            return;
        next_line();
        write(whole_color, 0, "in " + counted_steps(1 << doublings) + ", the next power of two");
    }

    static std::string counted_steps(int steps) {
        return std::to_string(steps) + (steps == 1 ? " step" : " steps");
    }

    static std::string with_four_digits(double value) {
        std::array<char, 40> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                       std::chars_format::fixed, 4);
        return {text.data(), end.ptr};
    }

    /// The number of doublings by Klassen's method for `steps` steps or more. The method takes
    /// 2^doublings steps.
    static int doublings_for(int steps) {
        int doublings = 0;
        while (1 << doublings < steps)
            ++doublings;
        return doublings;
    }

    /// The largest error of the walk in whole numbers. It comes from rounding the control points
    /// alone.
    static double whole_error(const numbers& x, const numbers& y, int doublings) {
        constexpr double lattice = 256; // parts of a pixel
        const auto offs = [&](const numbers& b) {
            std::array<std::int64_t, 4> control{};
            for (std::size_t i = 0; i < 4; ++i)
                control[i] = std::llround(b[i] * lattice);
            std::vector<double> result;
            const double parts = lattice * std::pow(8.0, doublings);
            const double n = 1 << doublings;
            l3d_integer_cubic(control).walk_halved(
                doublings / 2, doublings - doublings / 2, [&](std::int64_t value) {
                    const double t = static_cast<double>(result.size()) / n;
                    result.push_back(static_cast<double>(value) / parts - at_parameter(b, t));
                });
            return result;
        };
        const auto off_x = offs(x), off_y = offs(y);
        double worst = 0;
        for (std::size_t i = 0; i < off_x.size(); ++i)
            worst = std::max(worst, std::hypot(off_x[i], off_y[i]));
        return worst;
    }

    std::array<l3d_point_2d, 4> handles_ = places_at_first;
    std::size_t held_ = none;
    int steps_ = steps_at_first;
    bool adaptive_ = false, dashed_ = false, magnified_ = false, fresh_ = false;
    l3d_font font_;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "curves",
        l3d_caption{.what =
                        "A curve walked by forward differences in 16.16 (red),\nand how far each "
                        "step is off. Drag the handles.",
                    .keys = {{"m, l, wheel", "more or less steps"},
                             {"a", "adaptive steps beside equal ones"},
                             {"d", "dashes"},
                             {"z", "magnify where 16.16 is worst"},
                             {"r", "as at first"}},
                    .corner = l3d_corner::top_right},
        {960, 640});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        curves_pipeline pipeline(program.create_canvas());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
