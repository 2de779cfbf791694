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

/// The place of a model that is seen at a position in the picture, and what is known of the surface
/// at this place.
struct L3D_PUBLIC l3d_pointed_place {
    l3d_camera::vector place{0.0, 0.0, 0.0}; ///< the place in the world
    double error = 0; ///< the largest distance of `place` from the exact place, in world units
    std::string text; ///< a line of text about the surface at `place`, for the user
    /// The unit normal of the surface at `place`, turned to the eye; zero if there is no normal.
    l3d_camera::vector normal{0.0, 0.0, 0.0};
    /// The largest length of the difference of `normal` from the exact normal.
    double normal_error = 0;
};

/// Functions by which a viewer tells its controls about its picture. If a function is empty, the
/// controls that need it do nothing.
struct L3D_PUBLIC l3d_viewed {
    /// Makes the camera that shows the whole model, with the direction of view of the given camera.
    std::function<l3d_camera(const l3d_camera&)> framed{};
    /// Finds the place that is seen at a position. Positions are in pixels from the picture's left
    /// upper corner. The result is nothing if no surface is there.
    std::function<std::optional<l3d_pointed_place>(double x, double y)> place_at{};
};

/// Moves a viewer's camera by keys and mouse. The camera turns about its target, and is dragged and
/// zoomed by the place under the pointer. It can show the model from each of its sides, or show the
/// whole model.
///
/// Lives: borrows screen and camera.
class L3D_PUBLIC l3d_view_steering {
public:
    /// A place or a direction in the world.
    using vector = l3d_camera::vector;

    /// Steers `camera`, by which the pictures on `screen` are drawn. `viewed` answers questions
    /// about these pictures.
    l3d_view_steering(l3d_screen& screen, l3d_camera& camera, l3d_viewed viewed);

    /// Sets the function that makes the camera of the first view. It is called at once, at each
    /// reset, and at each change of the picture's size until the camera is moved.
    void set_home(std::function<l3d_camera()> home);

    /// Returns to the first view. It is the camera of set_home() or, without set_home(), the camera
    /// at construction.
    void go_home();
    /// Moves the camera, without turning it, so that the picture shows the whole model.
    void frame_all();
    /// Adapts the camera to a new size of the picture, so that the model is seen as before. Without
    /// an earlier set_home() or frame_all(), the camera stays as it is.
    void resized();

    /// Sets the factor that multiplies the usual angles of turning by drags.
    /// Expects: factor > 0.
    void set_turn_speed(double factor) { turn_speed_ = factor; }

    /// Moves the eye around the target: about the axis that points up in the model, and about the
    /// picture's horizontal axis.
    /// Units: degrees.
    void turn(double around_up, double around_right);
    /// Turns the picture's content about the line of sight. Afterwards turn() takes the picture's
    /// direction up as its axis, until look_from() or go_home().
    /// Units: degrees.
    void roll(double degrees);
    /// Moves the eye sideways, so that things at the target's depth go to the right and down in the
    /// picture by these distances. Units: pixels.
    void pan(double right, double down);
    /// Multiplies the eye's distance from the target by a factor, unless the eye would come too
    /// near or go too far.
    void approach(double factor) { approach(factor, camera_.target); }
    /// Moves the eye to the side of the target that a direction points to, at the same distance.
    /// The three numbers are the direction's coordinates along the axes of l3d_upright: (0, 0, 1)
    /// looks from the front. Expects: not all 0.
    void look_from(double right, double up, double front);
    /// Switches between perspective and parallel projection. Returns true if the new projection is
    /// parallel.
    bool switch_projection();
    /// Moves the eye to the opposite side of the target.
    void look_from_opposite();

    /// Moves the camera so that the place seen at (x, y) becomes its target: the middle of the
    /// picture, which the eye turns about. Returns false if no surface is at (x, y).
    bool turn_about(double x, double y);

    /// The position in the picture at which a place in the world is seen. Coordinates are those of
    /// rasterizers, in which whole numbers are the middles of pixels. In perspective, the result is
    /// nothing if the place is nearer than the near plane.
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
    /// The place in the world under the pointer. It lies on the surface that is seen there or,
    /// without a surface, at the target's depth.
    vector place_under(double x, double y) const;
    double depth_of(const vector& place) const;
    void leave_pole();
    bool sees_along_up() const { return camera_.up != up_; }

    l3d_screen& screen_;
    l3d_camera& camera_;
    l3d_viewed viewed_;
    std::function<l3d_camera()> home_;
    l3d_camera first_; ///< the camera at construction: the first view if there is no home_
    /// The camera that go_home or frame_all set. Once the user has moved the view, camera_ differs
    /// from it.
    l3d_camera kept_;
    bool is_home_ = false, is_framed_ = false; ///< whether go_home or frame_all set kept_
    vector upright_; ///< the model's direction up, even if the view is rolled or from above
    vector up_;      ///< the axis for turn(): upright_, or the picture's direction up after roll()
    double turn_speed_ = 1;
    l3d_size size_;
    drag drag_ = drag::none;
    vector grabbed_{0.0, 0.0, 0.0};
    int x_ = 0, y_ = 0;
};

/// Measures how long pictures take to draw, and how many are drawn per second, over the last
/// second. Time and rate are means over the same pictures, by one clock. So the mean time of a
/// picture never exceeds the mean time between two pictures.
///
/// A second without a picture counts as rest, and the rate begins anew with the next two pictures.
class L3D_PUBLIC l3d_picture_pace {
public:
    /// A clock that is never set back.
    using clock = std::chrono::steady_clock;
    /// A function that tells the time; tests pass their own.
    using teller = std::function<clock::time_point()>;

    /// Measures by the times that `now` tells.
    explicit l3d_picture_pace(teller now = clock::now) : now_(std::move(now)) {}

    /// Notes that drawing a picture begins. A picture without an end() is not counted.
    void begin();
    /// Notes that drawing the picture has ended, and counts it. Expects: begin() was called.
    void end();

    /// The mean time that drawing a picture takes; 0 before the first end(). Units: milliseconds.
    double milliseconds() const;
    /// Pictures per second, counted from the first picture of the last second to the last begin().
    /// It is 0 at rest.
    double per_second() const;
    /// Time and rate as text for the user. At rest, the text tells the time alone. Before the first
    /// end(), it is "".
    std::string text() const;

private:
    struct picture {
        clock::time_point begin, end;
    };

    teller now_;
    std::deque<picture> done_; ///< begin and end of the pictures of the last second
    clock::time_point begin_{};
    /// Whether less than a second lies between the last picture's end and begin_.
    bool follows_ = false;
};

/// A row of a viewer's help, with the actions of the row's keys.
struct L3D_PUBLIC l3d_viewer_row {
    const char* keys; ///< the names of the keys in the help
    const char* text; ///< the keys' effect, for the help

    /// The row's keys, each an ASCII code or l3d_key, with their actions. The list is empty if
    /// other code acts on the keys.
    std::vector<std::pair<int, std::function<void()>>> actions{};
};

/// A panel that a viewer shows in every picture, and the corner for it.
struct L3D_PUBLIC l3d_standing_panel {
    l3d_panel panel{}; ///< the panel; empty if there is none
    /// The corner of the picture in which the panel stands.
    l3d_corner corner = l3d_corner::bottom_right;
};

/// The controls that all viewers share: turning and moving the eye, turntable, pause, status, help,
/// screenshot, and the end. A viewer has one l3d_viewer_controls and hands events on to it. Help
/// and keys come from one table of rows, to which the viewer adds its own rows.
///
/// key(), pointer(), update() and rest() return whether a new picture is needed.
/// Lives: borrows pipeline, screen and camera.
class L3D_PUBLIC l3d_viewer_controls {
public:
    /// Makes the controls of a viewer. `rows` are the viewer's own rows of help. The key r calls
    /// `reset`, unless it is empty, to undo all changes by the viewer's own keys except those of
    /// the camera. `viewed` answers questions about the picture. `font` has the letters of all
    /// panels.
    /// Expects: no key has actions in two rows; the rows of this class count, too.
    l3d_viewer_controls(l3d_pipeline& viewer, l3d_screen& screen, l3d_camera& camera,
                        std::vector<l3d_viewer_row> rows, std::function<void()> reset = {},
                        l3d_viewed viewed = {}, l3d_font font = {});

    /// Switches the turntable on: the eye turns around the target by this angle in each 1 / fps of
    /// a second. So it turns by this angle per frame at `fps` frames a second. The first frame is
    /// not turned.
    /// Units: degrees; frames a second.
    void set_turntable(double degrees_per_frame, double fps) {
        turntable_degrees_ = degrees_per_frame * fps;
    }

    /// Sets the factor that multiplies the usual angles of turning, by keys and by drags.
    /// Expects: factor > 0.
    void set_turn_speed(double factor) {
        turn_speed_ = factor;
        steering_.set_turn_speed(factor);
    }

    /// Sets the function that the key s calls with the picture, to save it; without a function the
    /// key does nothing. The function returns a line for the viewer to show, such as the file's
    /// name.
    void set_screenshot(std::function<std::string(const l3d_pixels&)> save) {
        save_ = std::move(save);
    }

    /// Sets the function that the key g calls; without a function the key does nothing. The
    /// function returns the command-line options that show the present view again, and the viewer
    /// shows them.
    void set_view_teller(std::function<std::string()> tell) { tell_view_ = std::move(tell); }

    /// Sets the function that makes the camera of the first view, which the key r returns to, as
    /// l3d_view_steering::set_home does.
    void set_home(std::function<l3d_camera()> home) { steering_.set_home(std::move(home)); }

    /// Moves the camera, without turning it, so that the picture shows the whole model, as the key
    /// f does.
    void frame_all() { steering_.frame_all(); }

    /// Adds a row for a program's own keys to the help: below the viewer's rows, and above the rows
    /// for status, help and end.
    /// Expects: the keys have actions in no other row.
    void add(l3d_viewer_row row);

    /// Keeps panels out of the leftmost `pixels` columns of the picture, such as for a list of
    /// parts.
    void set_left_margin(int pixels) { left_margin_ = pixels; }

    /// Adapts the camera when the picture has got another size (l3d_view_steering::resized).
    void resized() { steering_.resized(); }

    /// Learns from an event whether Ctrl and Shift are held. The viewer calls it with each event,
    /// before key() or pointer().
    void note(const l3d_event& event) {
        control_ = event.control;
        shift_ = event.shift;
    }

    /// Does the action of a key. `key` is an ASCII code or an l3d_key.
    bool key(int key);
    /// Turns, moves or zooms by the pointer and the wheel. A double click sets the centre of
    /// turning; clicks with Ctrl measure distances.
    bool pointer(const l3d_event& event);
    /// Lets time pass: the turntable turns, and the hint ends. Units: seconds.
    bool update(double seconds);
    /// Whether nothing in the picture moves by itself: the turntable is off or paused.
    bool is_at_rest() const { return turntable_degrees_ == 0 || paused_; }
    /// The time until the hint ends; infinite without a hint. At rest, only the hint's end changes
    /// the picture. Units: seconds.
    double rest_left() const {
        return hint_seconds_ > 0 ? hint_seconds_ : std::numeric_limits<double>::infinity();
    }
    /// Lets the time of a rest pass. Returns true if the hint ends during this time. Units:
    /// seconds.
    bool rest(double seconds);
    /// Whether the user has stopped all motion by the key p or space.
    bool is_paused() const { return paused_; }

    /// Sets the letters of all panels.
    void set_font(l3d_font font) { font_ = std::move(font); }

    /// The style of the panels, with letters of a size that suits the window and its display.
    l3d_panel_style panel_style() const;

    /// Shows the hint that the key h lists all keys, for some seconds or until the first key.
    void show_hint(double seconds) { hint_seconds_ = seconds; }

    /// Shows a line of text until the next key. Expects: the call comes from a key's action.
    void say(std::string line) { message_ = std::move(line); }

    /// Switches the headlight on or off, and tells the user by say(). This is the action of the key
    /// l in viewers of surfaces. `is_on` is the viewer's setting.
    void switch_headlight(bool& is_on);

    /// Switches between perspective and parallel projection, and tells the user by say().
    void switch_projection();

    /// The line of text of say(); "" if none is shown.
    const std::string& message() const { return message_; }

    /// Tells the user why the picture is empty. `reason` is a text of l3d_why_unseen, or "" if the
    /// picture is not empty. The text names `key`, which moves the model back into view; 0 stands
    /// for no key.
    void set_empty(const std::string& reason, char key = 'f') {
        empty_line_ = reason.empty() ? "" : "The model is " + reason;
        if (!reason.empty())
            empty_line_ += key == 0 ? "." : std::string(": press ") + key + " to see it.";
    }

    /// Whether draw() draws anything, apart from `legend` and `standing`.
    bool shows_text() const {
        return status_shown_ || help_page_ > 0 || !message_.empty() || !empty_line_.empty() ||
               hint_seconds_ > 0 || !marks_.empty();
    }

    /// Draws panels on top of a finished picture: status, help and message if they are switched on,
    /// and `legend` and `standing` if they are not empty. Panels fit into every window, and none
    /// covers another. If the help finds no room, it replaces the panels in its way, except the
    /// message. `lines` are the viewer's own lines of the status, below the line with the pace.
    void draw(l3d_rasterizer_2d& rasterizer, std::span<const std::string> lines,
              const l3d_panel& legend = {}, const l3d_standing_panel& standing = {}) const;

    /// The pace of the viewer's pictures. The viewer calls the pace's begin() and end().
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
    /// Seconds for which the hint still shows. It is not positive if no hint shows.
    double hint_seconds_ = 0;
    l3d_viewed viewed_;
    l3d_view_steering steering_;
    std::vector<l3d_viewer_row> rows_;
    std::ptrdiff_t own_end_ = 0; ///< index in rows_ behind the viewer's and the program's own rows
    /// The place that the user clicked on to measure from.
    std::optional<l3d_pointed_place> measured_;
    /// The places that the user clicked on to measure, for draw_marks.
    std::vector<l3d_camera::vector> marks_;
    bool control_ = false, shift_ = false;
    double turn_speed_ = 1;
    double turntable_degrees_ = 0; ///< degrees per second; 0 if the turntable is off
    bool first_frame_ = true;
    bool paused_ = false;
    bool status_shown_ = false;
    std::size_t help_page_ = 0; ///< number of the page of help that is shown, from 1; 0 if none is
    int left_margin_ = 0;       ///< width of the column that panels leave free, in pixels
    std::string message_;
    std::string empty_line_;
    l3d_picture_pace pace_;
    std::function<std::string(const l3d_pixels&)> save_;
    std::function<std::string()> tell_view_;
};

#endif
