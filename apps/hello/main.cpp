// SPDX-License-Identifier: MIT
// hello: gives the first lessons: a window, its events, and a picture made word by word.
#include <l3d/font.h>
#include <l3d/lesson.h>
#include <l3d/random.h>
#include <l3d/program.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace {

enum class lesson { window, event, image };

/// The name that X gives an event, with its values; empty for events that X does not know.
std::string name_of(const l3d_event& event) {
    const std::string place = ' ' + std::to_string(event.x) + ',' + std::to_string(event.y);
    const std::string button = " button " + std::to_string(event.button);
    const std::string key = event.key > ' ' && event.key < 127
                                ? std::string(1, static_cast<char>(event.key))
                            : event.key == 0 ? event.text
                                             : "code " + std::to_string(event.key);
    switch (event.type) {
    case l3d_event_type::key_press:
        return "KeyPress " + key;
    case l3d_event_type::key_release:
        return "KeyRelease " + key;
    case l3d_event_type::button_press:
        return "ButtonPress" + button + place;
    case l3d_event_type::button_release:
        return "ButtonRelease" + button + place;
    case l3d_event_type::pointer_motion:
        return "MotionNotify" + place;
    case l3d_event_type::wheel:
        return "ButtonPress wheel " + std::to_string(event.notches);
    case l3d_event_type::resize:
        return "ConfigureNotify " + std::to_string(event.size.width) + 'x' +
               std::to_string(event.size.height);
    case l3d_event_type::expose:
        return "Expose";
    case l3d_event_type::hide:
        return "VisibilityNotify hidden";
    case l3d_event_type::reveal:
        return "VisibilityNotify seen";
    case l3d_event_type::close:
        return "ClientMessage WM_DELETE_WINDOW";
    case l3d_event_type::fullscreen:
    case l3d_event_type::display_lost:
        break;
    }
    return {};
}

// Step 2 of 5: the application is a pipeline.
class hello_pipeline final : public l3d_lesson {
public:
    hello_pipeline(l3d_canvas canvas, lesson which, std::uint64_t seed)
        : l3d_lesson(std::move(canvas)), lesson_(which), seed_(seed), random_(seed) {
        if (lesson_ == lesson::event)
            std::cerr << screen().describe() << '\n';
        // Pictures in files have the built-in font, the same on every machine.
        std::string told_beside_the_caption;
        if (screen().is_window())
            font_ = l3d_font::of_system(told_beside_the_caption);
        restart();
    }

    void any_event(const l3d_event& event) override {
        l3d_lesson::any_event(event);
        const std::string name = name_of(event);
        if (name.empty())
            return;
        if (lesson_ == lesson::event)
            std::cerr << name << '\n';
        const bool goes_on = event.type == l3d_event_type::pointer_motion && !events_.empty() &&
                             events_.back().starts_with("MotionNotify");
        if (goes_on || events_.size() == most_events)
            events_.erase(goes_on ? events_.end() - 1 : events_.begin());
        events_.push_back(name);
    }

    void pointer_event(const l3d_event& event) override {
        x_ = event.x;
        y_ = event.y;
    }

    /// Whether only events change the picture: its words are not random, or they are stopped.
    bool is_at_rest() const override { return lesson_ != lesson::image || is_stopped(); }

    /// The last events, the latest one at the bottom.
    std::string message() const override {
        std::string lines = "What happens to this window:";
        for (const std::string& event : events_)
            lines += '\n' + event;
        return lesson_ == lesson::image ? l3d_lesson::message() : lines;
    }

private:
    static constexpr std::size_t most_events = 12;

    void advance(double) override {}

    void restart() override {
        random_ = l3d_random(seed_);
        events_.clear();
        x_ = is_classic() ? 20 : size().width / 3;
        y_ = is_classic() ? 20 : size().height / 2;
    }

    void draw_lesson(l3d_rasterizer_2d& rasterizer) override {
        if (lesson_ == lesson::image) {
            for (int y = 0; y < size().height; ++y)
                for (std::uint32_t& word : screen().pixels().row(y))
                    word = random_.next() & 0xFFFFFF;
            return;
        }
        clear(rasterizer);
        const int scale = std::max(1, size().height / 200); // legible in large windows
        say(rasterizer, x_, y_, "Hello, X!", 0xFFFFFF, 2 * scale);
        if (lesson_ == lesson::event)
            say(rasterizer, 50 * scale, 50 * scale,
                events_.empty() ? "no event yet" : events_.back(), 0x00FF80, scale);
    }

    /// Writes a text with dots of a size. The built-in font has capitals of seven dots below an
    /// empty one, and an em of ten.
    void say(l3d_rasterizer_2d& rasterizer, int x, int y, const std::string& text,
             std::uint32_t color, int dot) const {
        font_.draw(rasterizer, x, y - dot, text, color, 10 * dot);
    }

    lesson lesson_;
    std::uint64_t seed_;
    l3d_random random_;
    l3d_font font_;
    int x_ = 0, y_ = 0; ///< place of the greeting, which follows the pointer
    std::vector<std::string> events_;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("hello",
                        l3d_caption{.what = "A window, and what happens to it.",
                                    .teaches = "A program does not ask for keys and the mouse: it "
                                               "is told of events, and answers them.",
                                    .keys = l3d_lesson_keys("move the greeting")},
                        {640, 400});
    lesson which = lesson::window;
    program.options().add_choice(
        "--lesson", which, "a greeting; what happens to the window; words of random colours",
        {{"window", lesson::window}, {"event", lesson::event}, {"image", lesson::image}});
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        hello_pipeline pipeline(program.create_canvas(), which, program.seed());
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    });
}
