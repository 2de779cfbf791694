// SPDX-License-Identifier: MIT
// l3d_viewer_controls: the keys, the mouse and the lines of text of every viewer; how they steer
// its camera.
#ifndef L3D_PIPELINE_VIEWER_CONTROLS_H
#define L3D_PIPELINE_VIEWER_CONTROLS_H

#include "base/public.h"
#include "pipeline/pipeline.h"
#include "raster/rasterizer_2d.h"
#include "raster/text/panel.h"
#include "scene/camera.h"
#include "tool_2d/event.h"
#include "tool_2d/screen.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// The nearest place of a model at a position in the picture.
struct L3D_PUBLIC l3d_pointed_place {
    l3d_camera::vector place{0.0, 0.0, 0.0}; ///< in the world
    double error = 0; ///< the largest distance from the exact place, in world units
    std::string text; ///< a line about the surface there
    /// The unit normal of the surface, turned to the eye; zero if there is none.
    l3d_camera::vector normal{0.0, 0.0, 0.0};
    double normal_error = 0; ///< the length of the normal's difference from the exact one
};

/// Functions that answer the controls' questions about a viewer's picture. An empty function leaves
/// out the controls that need it.
struct L3D_PUBLIC l3d_viewed {
    /// Makes the camera that shows everything along the line of sight of the given one.
    std::function<l3d_camera(const l3d_camera&)> framed{};
    /// The nearest place at a position, in pixels from the picture's left upper corner; none if
    /// there is no surface.
    std::function<std::optional<l3d_pointed_place>(double x, double y)> place_at{};
};

/// Moves a viewer's camera: turns it about its target, moves and zooms it by the place under the
/// pointer, shows a model from its sides, and frames it.
///
/// Lives: borrows screen and camera.
class L3D_PUBLIC l3d_view_steering {
public:
    /// A place or a direction in the world.
    using vector = l3d_camera::vector;

    /// Steers the camera of pictures on that screen.
    l3d_view_steering(l3d_screen& screen, l3d_camera& camera, l3d_viewed viewed);

    /// Sets the function that makes the first view: now, at each reset, and at each change of the
    /// picture's size until the camera is moved.
    void set_home(std::function<l3d_camera()> home);

    /// Returns to the first view.
    void go_home();
    /// Shows everything along the line of sight.
    void frame_all();
    /// Adapts the camera to a new size of the picture, so that the view of the model stays the
    /// same. A camera that a program placed itself stays as it is.
    void resized();

    /// Sets the factor by which keys and the pointer turn more than usual. Expects: more than 0.
    void set_turn_speed(double factor) { turn_speed_ = factor; }

    /// Moves the eye around the target. Units: degrees, about the upright axis and about the
    /// picture's right.
    void turn(double around_up, double around_right);
    /// Turns the picture about its middle, clockwise. The picture's new upright direction holds for
    /// turn() until look_from or go_home. Units: degrees.
    void roll(double degrees);
    /// Moves the eye so that things at the target's depth go to the right and down. Units: pixels.
    void pan(double right, double down);
    /// Multiplies the eye's distance from the target, unless that leads too near or too far.
    void approach(double factor) { approach(factor, camera_.target); }
    /// Moves the eye to this direction from the target, at the same distance. The three numbers are
    /// steps along the axes of l3d_upright, such as (0, 0, 1) for the front. Expects: not all 0.
    void look_from(double right, double up, double front);
    /// Switches between perspective and parallel projection. Returns true if it is parallel then.
    bool switch_projection();
    /// Moves the eye to the opposite side.
    void look_from_opposite();

    /// Makes the place under the pointer the middle of the picture, which the eye turns about.
    /// Returns false if nothing is there.
    bool turn_about(double x, double y);

    /// The position of a place of the world in the picture, in the coordinates of rasterizers:
    /// whole numbers are the middles of pixels. The result is nothing if the place is nearer than
    /// the near plane.
    std::optional<l3d_point_2d> position(const vector& place) const;

    /// Turns, moves or zooms when a button goes down, the pointer moves or the wheel turns. Returns
    /// true if another picture is needed.
    bool pointer(const l3d_event& event);

private:
    enum class drag { none, turn, move, zoom };

    void begin(const l3d_event& press);
    bool go_on(const l3d_event& motion);
    void approach(double factor, const vector& place);
    void move(double x, double y);
    /// The place under the pointer; without a surface, at the target's depth.
    vector place_under(double x, double y) const;
    double depth_of(const vector& place) const;
    void leave_pole();
    bool sees_along_up() const { return camera_.up != up_; }

    l3d_screen& screen_;
    l3d_camera& camera_;
    l3d_viewed viewed_;
    std::function<l3d_camera()> home_;
    l3d_camera first_; ///< the program's own view, without a home
    l3d_camera kept_;  ///< the view that home or frame set; camera_ differs once it was moved
    bool is_home_ = false, is_framed_ = false; ///< whether home or frame set kept_
    vector upright_;                           ///< the model's own, whatever the picture shows
    vector up_; ///< the eye's axis of turning: upright_, unless rolled
    double turn_speed_ = 1;
    l3d_size size_;
    drag drag_ = drag::none;
    vector grabbed_{0.0, 0.0, 0.0};
    int x_ = 0, y_ = 0;
};

/// Measures the time that pictures take, and their rate, over the last second. Both are means over
/// the same pictures, by one clock. So the mean time of a picture never exceeds the time between
/// two.
///
/// A second without a picture counts as rest, and the rate begins anew with the next two pictures.
class L3D_PUBLIC l3d_picture_pace {
public:
    /// A clock that is never set back.
    using clock = std::chrono::steady_clock;
    /// The type of function that tells the time.
    using teller = std::function<clock::time_point()>;

    /// Measures with this clock.
    explicit l3d_picture_pace(teller now = clock::now) : now_(std::move(now)) {}

    /// Notes that drawing begins, also of a picture that is not counted in the end.
    void begin();
    /// Notes that drawing has ended, and counts the picture. Expects: begin() was called.
    void end();

    /// The time that drawing a picture takes. Units: milliseconds. 0 before the first end().
    double milliseconds() const;
    /// Pictures a second. It counts from the first picture of the last second to the last begin(),
    /// and is 0 at rest.
    double per_second() const;
    /// Both numbers as text for people. At rest it is the time alone, and "" before the first
    /// end().
    std::string text() const;

private:
    struct picture {
        clock::time_point begin, end;
    };

    teller now_;
    std::deque<picture> done_; ///< the pictures that count
    clock::time_point begin_{};
    bool follows_ = false; ///< begin_ follows done_ without a rest
};

/// A row of a viewer's help, with the actions of its keys.
struct L3D_PUBLIC l3d_viewer_row {
    const char* keys; ///< as the help calls them
    const char* text; ///< their effect

    /// The action for each key, an ASCII code or l3d_key; none if the action is elsewhere.
    std::vector<std::pair<int, std::function<void()>>> actions{};
};

/// A panel that a viewer has in its picture all the time, and its corner.
struct L3D_PUBLIC l3d_standing_panel {
    l3d_panel panel{};                            ///< empty for none
    l3d_corner corner = l3d_corner::bottom_right; ///< where it stands
};

/// The controls of all viewers: turning and moving the eye, turntable, pause, status, help,
/// screenshot, the end. A viewer has one such object and hands events on to it. Help and keys come
/// from one table of rows, to which the viewer adds its own.
///
/// Calls that return a bool say whether another picture is needed.
/// Lives: borrows pipeline, screen and camera.
class L3D_PUBLIC l3d_viewer_controls {
public:
    /// Makes the controls of a viewer. `rows` are the viewer's own rows of help. `reset` undoes the
    /// viewer's own changes of the view, other than those of the camera; it may be empty. `viewed`
    /// answers questions about the picture. `font` has the letters of all panels.
    /// Expects: no key is in two rows, those of this class included.
    l3d_viewer_controls(l3d_pipeline& viewer, l3d_screen& screen, l3d_camera& camera,
                        std::vector<l3d_viewer_row> rows, std::function<void()> reset = {},
                        l3d_viewed viewed = {}, l3d_font font = {});

    /// Lets the eye turn around the target by this angle per frame. If time is measured, it turns
    /// by this angle in each 1 / fps of a second. The first frame is not turned.
    /// Units: degrees; frames a second.
    void set_turntable(double degrees_per_frame, double fps) {
        turntable_degrees_ = degrees_per_frame * fps;
    }

    /// Sets the factor by which keys and the pointer turn more than usual. Expects: more than 0.
    void set_turn_speed(double factor) {
        turn_speed_ = factor;
        steering_.set_turn_speed(factor);
    }

    /// Sets the function that the key s calls with the picture; without one the key does nothing.
    /// The function returns a line to show, such as the file's name.
    void set_screenshot(std::function<std::string(const l3d_pixels&)> save) {
        save_ = std::move(save);
    }

    /// Sets the function that the key g calls; without one the key does nothing. The function
    /// returns the command-line options that show the present view again, and the viewer shows
    /// them.
    void set_view_teller(std::function<std::string()> tell) { tell_view_ = std::move(tell); }

    /// Sets the function that makes the first view, which the key r returns to:
    /// l3d_view_steering::set_home.
    void set_home(std::function<l3d_camera()> home) { steering_.set_home(std::move(home)); }

    /// Shows everything along the line of sight, as the key f does.
    void frame_all() { steering_.frame_all(); }

    /// Adds a program's own key to the table: below the viewer's keys, above the window's keys.
    /// Expects: its keys are in no other row.
    void add(l3d_viewer_row row);

    /// Keeps panels out of a column at the left of the picture, of this many pixels.
    void set_left_margin(int pixels) { left_margin_ = pixels; }

    /// Adapts the view when the picture has got another size.
    void resized() { steering_.resized(); }

    /// Learns whether Ctrl and Shift are held: called with each event, before key() or pointer().
    void note(const l3d_event& event) {
        control_ = event.control;
        shift_ = event.shift;
    }

    /// Does what the key means. Expects: an ASCII code or an l3d_key.
    bool key(int key);
    /// Turns, moves or zooms by the pointer and its wheel; sets the centre of turning, and
    /// measures.
    bool pointer(const l3d_event& event);
    /// Lets time pass: the turntable turns. Units: seconds.
    bool update(double seconds);
    /// Whether nothing moves by itself: the turntable is off or paused.
    bool is_at_rest() const { return turntable_degrees_ == 0 || paused_; }
    /// The time until the hint ends, the only change of the picture while nothing turns; infinite
    /// without a hint. Units: seconds.
    double rest_left() const {
        return hint_seconds_ > 0 ? hint_seconds_ : std::numeric_limits<double>::infinity();
    }
    /// Lets the time of a rest pass. Returns true if the hint ends by that, so that a picture is
    /// due. Units: seconds.
    bool rest(double seconds);
    /// Whether the user wants things to stand still, as after the key p.
    bool is_paused() const { return paused_; }

    /// Sets the letters of all panels.
    void set_font(l3d_font font) { font_ = std::move(font); }

    /// The looks of the panels, with letters as large as the window and its display ask for.
    l3d_panel_style panel_style() const;

    /// Shows a hint for some seconds, or until the first key: it names the key that lists all
    /// others.
    void show_hint(double seconds) { hint_seconds_ = seconds; }

    /// Shows a line until the next key. Expects: the call comes from an action of a row.
    void say(std::string line) { message_ = std::move(line); }

    /// Switches the headlight on or off, and says so: the effect of the key l in viewers of
    /// surfaces.
    void switch_headlight(bool& is_on);

    /// Switches between perspective and parallel projection, and says so.
    void switch_projection();

    /// The line of say(); "" if there is none.
    const std::string& message() const { return message_; }

    /// Tells why the picture is empty, by a text of l3d_why_unseen; "" if it is not empty. The
    /// viewer shows the reason with the key that mends it; `key` is 0 if none does.
    void set_empty(const std::string& reason, char key = 'f') {
        empty_line_ = reason.empty() ? "" : "The model is " + reason;
        if (!reason.empty())
            empty_line_ += key == 0 ? "." : std::string(": press ") + key + " to see it.";
    }

    /// Whether draw() draws anything.
    bool shows_text() const {
        return status_shown_ || help_page_ > 0 || !message_.empty() || !empty_line_.empty() ||
               hint_seconds_ > 0 || !marks_.empty();
    }

    /// Draws panels on top of a finished picture: status, help and message, as they are switched
    /// on, and `legend` and `standing`, if they are not empty. They fit into every window, and none
    /// covers another. If the help finds no room, it replaces the panels in its way, except the
    /// message. `lines` are the viewer's own lines of the status, below that of pace().
    void draw(l3d_rasterizer_2d& rasterizer, std::span<const std::string> lines,
              const l3d_panel& legend = {}, const l3d_standing_panel& standing = {}) const;

    /// The pace of the viewer's pictures, for the viewer to measure.
    l3d_picture_pace& pace() { return pace_; }
    /// The pace of the viewer's pictures, read-only.
    const l3d_picture_pace& pace() const { return pace_; }

private:
    void draw_marks(l3d_rasterizer_2d& rasterizer) const;
    std::vector<l3d_panel> help_pages() const;
    l3d_panel message_panel() const;
    l3d_panel status_panel(std::span<const std::string> lines) const;
    std::vector<l3d_viewer_row> first_rows();
    std::vector<l3d_viewer_row> side_rows();
    void arrow(int right, int down);
    bool zoom_key(int key);
    void measure(double x, double y);
    std::vector<l3d_viewer_row> last_rows(l3d_pipeline& viewer, l3d_screen& screen,
                                          std::function<void()> reset);

    l3d_screen& screen_;
    l3d_font font_;
    double hint_seconds_ = 0; ///< seconds that are left
    l3d_viewed viewed_;
    l3d_view_steering steering_;
    std::vector<l3d_viewer_row> rows_;
    std::ptrdiff_t own_end_ = 0;                ///< end of the viewer's own rows
    std::optional<l3d_pointed_place> measured_; ///< the first end of a distance
    std::vector<l3d_camera::vector> marks_;     ///< places that were clicked on
    bool control_ = false, shift_ = false;
    double turn_speed_ = 1;
    double turntable_degrees_ = 0; ///< per second
    bool first_frame_ = true;
    bool paused_ = false;
    bool status_shown_ = false;
    std::size_t help_page_ = 0; ///< the page shown, from 1; 0 for none
    int left_margin_ = 0;       ///< pixels that panels leave free
    std::string message_;
    std::string empty_line_;
    l3d_picture_pace pace_;
    std::function<std::string(const l3d_pixels&)> save_;
    std::function<std::string()> tell_view_;
};

#endif
