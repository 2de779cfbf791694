// SPDX-License-Identifier: MIT
// l3d_viewer_controls: the keys, the mouse and the lines of text of every viewer.
#ifndef L3D_PIPELINE_VIEWER_CONTROLS_H
#define L3D_PIPELINE_VIEWER_CONTROLS_H

#include "base/public.h"
#include "scene/camera.h"
#include "pipeline/picture_pace.h"
#include "pipeline/pipeline.h"
#include "pipeline/view_steering.h"
#include "raster/rasterizer_2d.h"
#include "raster/text/panel.h"
#include "tool_2d/screen.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// A row of a viewer's help, with the actions of its keys.
struct L3D_PUBLIC l3d_viewer_row {
    const char* keys; ///< as the help calls them
    const char* text; ///< their effect

    /// The action for each key, an ASCII code or l3d_key; none if the action is elsewhere.
    std::vector<std::pair<int, std::function<void()>>> actions{};
};

/// A panel that a viewer has in its picture all the time, and where.
struct L3D_PUBLIC l3d_standing_panel {
    l3d_panel panel{};                            ///< empty for none
    l3d_corner corner = l3d_corner::bottom_right; ///< where it stands
};

/// The controls of all viewers: the eye turns about its target and comes nearer, turntable, pause,
/// status, help, screenshot, the end. A viewer has one, hands events on to it, and adds rows of
/// keys of its own to the one table that help and keys both come from.
///
/// Calls that return a bool say whether another picture is needed.
/// Lives:   borrows pipeline, screen and camera.
class L3D_PUBLIC l3d_viewer_controls {
public:
    /// `rows` are the viewer's own; `reset` undoes its changes of the view beside the camera, and
    /// may be empty; `viewed` answers questions about the picture; `font` has the letters of all
    /// panels.
    /// Expects: no key is in two rows, ours included.
    l3d_viewer_controls(l3d_pipeline& viewer, l3d_screen& screen, l3d_camera& camera,
                        std::vector<l3d_viewer_row> rows, std::function<void()> reset = {},
                        l3d_viewed viewed = {}, l3d_font font = {});

    /// Turns the eye around the target by this angle from frame to frame, or per 1 / fps of a
    /// second where time is measured. The first frame is not turned. Units: degrees; frames a
    /// second.
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
    /// returns the view as the options that show it again, which are shown.
    void set_view_teller(std::function<std::string()> tell) { tell_view_ = std::move(tell); }

    /// The first view, which the key r returns to: l3d_view_steering::set_home.
    void set_home(std::function<l3d_camera()> home) { steering_.set_home(std::move(home)); }

    /// Shows everything along the line of sight, as the key f does.
    void frame_all() { steering_.frame_all(); }

    /// Adds a program's own key below the viewer's, above those of the program's window.
    /// Expects: its keys are in no other row.
    void add(l3d_viewer_row row);

    /// The picture has another size.
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
    /// Whether nothing turns.
    bool is_at_rest() const { return turntable_degrees_ == 0 || paused_; }
    /// The time for which nothing changes the picture while nothing turns: until the hint ends.
    /// Units: seconds.
    double rest_left() const {
        return hint_seconds_ > 0 ? hint_seconds_ : std::numeric_limits<double>::infinity();
    }
    /// Lets seconds of a rest pass. Returns whether the hint ends, so that a picture is due.
    bool rest(double seconds);
    /// Whether the user wants things to stand still, as after the key p.
    bool is_paused() const { return paused_; }

    /// Sets the letters of all panels.
    void set_font(l3d_font font) { font_ = std::move(font); }

    /// The looks of the panels, with letters as large as the window and its display ask for.
    l3d_panel_style panel_style() const;

    /// Shows a hint for so many seconds, or until the first key: which key lists all others.
    void show_hint(double seconds) { hint_seconds_ = seconds; }

    /// A line that is shown until the next key. Expects: an action of a row is running.
    void say(std::string line) { message_ = std::move(line); }

    /// Performs the key l of a viewer of surfaces: takes the other value, and says so.
    void switch_headlight(bool& is_on);

    /// The line of say(); "" if there is none.
    const std::string& message() const { return message_; }

    /// Sets the reason why the picture is empty, as l3d_why_unseen tells it; "" if it is not. The
    /// reason is shown with the key that mends it; 0 for none.
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

    /// Panels on top of a finished picture: status, help and message, as they are switched on, the
    /// viewer's own legend and its standing panel, if they are not empty. They fit into every
    /// window, and none covers another. Help without room beside them replaces those in its way,
    /// but for the message. `lines` are the viewer's own of the status, below that of pace().
    void draw(l3d_rasterizer_2d& rasterizer, std::span<const std::string> lines,
              const l3d_panel& legend = {}, const l3d_standing_panel& standing = {}) const;

    /// The pace of the viewer's pictures, for the viewer to measure.
    l3d_picture_pace& pace() { return pace_; }
    /// The same, read-only.
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
    std::string message_;
    std::string empty_line_;
    l3d_picture_pace pace_;
    std::function<std::string(const l3d_pixels&)> save_;
    std::function<std::string()> tell_view_;
};

#endif
