// SPDX-License-Identifier: MIT
// l3d_control_handles: joins equal places to one handle; finds, moves and draws handles.
#include "pipeline/pipeline_afd_editor.h"

#include "pipeline/wire_p.h"
#include "raster/paths/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace {

using vector = l3d_control_handles::vector;

constexpr std::uint32_t rim_color = 0x00101418, handle_color = 0x00f4f4f4,
                        marked_color = 0x00ffd873;
constexpr double pale = 0.35;  // the part of its colour that a hidden line keeps
constexpr double radius = 3.5; // the size of a handle, in pixels
constexpr double grasp = 10;   // most pixels from the pointer to a handle's middle
/// The factor by which a notch of the wheel changes a weight.
constexpr double notch_weight = 1.1;
/// A line counts as hidden only if its distance from the eye is more than this factor times that of
/// the surface. Otherwise rounding would hide the lines of a net that lie on the surface.
constexpr double just_behind = 1.004;

/// A place in the world as the picture shows it: its position from the picture's left upper corner,
/// and its distance along the view axis.
struct seen_place {
    double x, y, distance;
};

/// Projects a place into the picture. The result is nothing if the place is nearer than the near
/// plane.
std::optional<seen_place> seen(const l3d_matrix<double>& to_image, const l3d_handle_view& view,
                               const vector& place) {
    const auto h = to_image * l3d_vector<double, 4>(place[0], place[1], place[2], 1.0);
    if (!(h[3] >= view.camera.near_z))
        return std::nullopt;
    return seen_place{view.size.width / 2.0 + h[0] / h[3], view.size.height / 2.0 + h[1] / h[3],
                      h[3]};
}

bool is_hidden(const seen_place& place, const l3d_depth_buffer* depth) {
    if (depth == nullptr || !(place.x >= 0 && place.y >= 0 && place.x < depth->size().width &&
                              place.y < depth->size().height))
        return false;
    const float reciprocal =
        depth->row(static_cast<int>(place.y))[static_cast<std::size_t>(place.x)];
    return static_cast<double>(reciprocal) * place.distance > just_behind;
}

/// Two paths: one collects the visible parts of lines, and one the hidden parts.
struct two_paths {
    l3d_path seen, hidden;

    /// Adds a line, divided into short parts. Each part is visible or hidden as its middle is.
    void add_line(const seen_place& from, const seen_place& to, const l3d_depth_buffer* depth) {
        constexpr double part = 6; // pixels
        constexpr int most = 256;  // parts of a line that leaves the picture
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        const int parts =
            depth == nullptr ? 1 : std::clamp(static_cast<int>(length / part), 1, most);
        const auto at = [&](double t) {
            return seen_place{from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t,
                              1 / ((1 - t) / from.distance + t / to.distance)};
        };
        const l3d_path* before = nullptr;
        for (int i = 0; i < parts; ++i) {
            l3d_path& path = is_hidden(at((i + 0.5) / parts), depth) ? hidden : seen;
            const seen_place a = at(static_cast<double>(i) / parts), b = at((i + 1.0) / parts);
            if (&path != before)
                path.move_to({a.x - 0.5, a.y - 0.5});
            path.line_to({b.x - 0.5, b.y - 0.5});
            before = &path;
        }
    }
};

} // namespace

l3d_control_handles::l3d_control_handles(std::vector<l3d_nurbs_surface> surfaces)
    : surfaces_(std::move(surfaces)) {
    std::map<std::array<double, 3>, std::size_t> places;
    std::set<std::pair<std::size_t, std::size_t>> lines;
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
        const l3d_nurbs_surface& surface = surfaces_[s];
        const std::size_t columns = surface.u().points();
        std::vector<std::size_t> handles;
        const auto join = [&](std::size_t a, std::size_t b) {
            const auto line = std::minmax(handles[a], handles[b]);
            if (line.first != line.second && lines.insert(line).second)
                net_.emplace_back(line);
        };
        for (std::size_t i = 0; i < surface.points().size(); ++i) {
            const vector& p = surface.points()[i];
            const auto [there, is_new] = places.try_emplace({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0},
                                                            members_.size()); // -0 becomes 0
            if (is_new)
                members_.emplace_back();
            handles.push_back(there->second);
            members_[there->second].push_back({s, i});
            if (i % columns > 0)
                join(i - 1, i);
            if (i >= columns)
                join(i - columns, i);
        }
    }
}

const vector& l3d_control_handles::place(std::size_t handle) const {
    const auto& [surface, point] = members_[handle].front();
    return surfaces_[surface].points()[point];
}

double l3d_control_handles::weight_of(const member& m) const {
    const std::vector<double>& weights = surfaces_[m.surface].weights();
    return weights.empty() ? 1 : weights[m.point];
}

double l3d_control_handles::weight(std::size_t handle) const {
    return weight_of(members_[handle].front());
}

std::string l3d_control_handles::name(std::size_t handle) const {
    const auto& [surface, point] = members_[handle].front();
    const std::size_t columns = surfaces_[surface].u().points();
    const std::string of =
        surfaces_.size() == 1 ? "" : "surface " + std::to_string(surface + 1) + ", ";
    return of + "row " + std::to_string(point / columns + 1) + ", column " +
           std::to_string(point % columns + 1);
}

std::optional<std::size_t> l3d_control_handles::find(double x, double y,
                                                     const l3d_handle_view& view) const {
    const l3d_matrix<double> to_image = view.camera.image_matrix(view.size);
    constexpr double same = 3; // pixels, about a handle's radius
    std::optional<std::size_t> best;
    std::pair<double, double> least;
    for (std::size_t i = 0; i < count(); ++i) {
        const auto there = seen(to_image, view, place(i));
        if (!there)
            continue;
        const double off = std::hypot(there->x - x, there->y - y) / view.text_scale;
        const std::pair now{std::floor(off / same), there->distance};
        if (off > grasp || (best && !(now < least)))
            continue;
        best = i;
        least = now;
    }
    return best;
}

l3d_reach l3d_control_handles::reach() const {
    return [this](const vector& direction) {
        double farthest = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < count(); ++i)
            farthest = std::max(farthest, l3d_dot(direction, place(i)));
        return farthest;
    };
}

void l3d_control_handles::keep_for_undo(std::size_t handle, change kind) {
    if (going_on_ == std::pair{handle, kind})
        return;
    state before{handle, place(handle), {}};
    for (const member& m : members_[handle])
        before.weights.push_back(weight_of(m));
    undo_.push_back(std::move(before));
    going_on_ = {handle, kind};
}

bool l3d_control_handles::move(std::size_t handle, const vector& to) {
    for (int k = 0; k < 3; ++k)
        if (!(std::abs(to[k]) <= l3d_bpt_largest_coordinate))
            return false;
    keep_for_undo(handle, change::place);
    for (const member& m : members_[handle])
        surfaces_[m.surface].set_point(m.point, to, weight_of(m));
    return true;
}

bool l3d_control_handles::scale_weight(std::size_t handle, double factor) {
    for (const member& m : members_[handle])
        if (const double w = weight_of(m) * factor; !(w >= least_weight && w <= most_weight))
            return false;
    keep_for_undo(handle, change::weight);
    for (const member& m : members_[handle])
        surfaces_[m.surface].set_point(m.point, place(handle), weight_of(m) * factor);
    return true;
}

bool l3d_control_handles::undo() {
    if (undo_.empty())
        return false;
    const auto& [handle, place, weights] = undo_.back();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const member& m = members_[handle][i];
        surfaces_[m.surface].set_point(m.point, place, weights[i]);
    }
    undo_.pop_back();
    going_on_.reset();
    return true;
}

l3d_control_handles::effect l3d_control_handles::mark(std::optional<std::size_t> handle) {
    if (marked_ == handle)
        return effect::none;
    marked_ = handle;
    return effect::seen;
}

l3d_control_handles::effect l3d_control_handles::pointer(const l3d_event& event,
                                                         const l3d_handle_view& view) {
    switch (event.type) {
    case l3d_event_type::button_press:
        return press(event, view);
    case l3d_event_type::button_release:
        grab_.reset();
        going_on_.reset();
        return effect::none;
    case l3d_event_type::pointer_motion:
        if (grab_)
            return drag(event, view);
        return event.button == 0 ? mark(find(event.x + 0.5, event.y + 0.5, view)) : effect::none;
    case l3d_event_type::wheel:
        if (!marked_)
            return effect::none;
        return scale_weight(*marked_, std::pow(notch_weight, event.turn)) ? effect::changed
                                                                          : effect::seen;
    default:
        return effect::none;
    }
}

/// Marks the handle at a press, and takes hold of it for a drag. The place of the press is the
/// middle of the pixel under the pointer.
l3d_control_handles::effect l3d_control_handles::press(const l3d_event& event,
                                                       const l3d_handle_view& view) {
    const double x = event.x + 0.5, y = event.y + 0.5;
    mark(find(x, y, view));
    if (!marked_ || event.button == 2)
        return effect::none;
    const auto there = seen(view.camera.image_matrix(view.size), view, place(*marked_));
    grab_ = {there->x - x, there->y - y, event.button == 3, event.y};
    going_on_.reset();
    return effect::seen;
}

l3d_control_handles::effect l3d_control_handles::drag(const l3d_event& motion,
                                                      const l3d_handle_view& view) {
    const vector from = place(*marked_);
    const double distance = view.camera.depth_of(from);
    if (!grab_->is_along_view)
        return move(*marked_,
                    view.camera.place_at(motion.x + 0.5 + grab_->right,
                                         motion.y + 0.5 + grab_->down, distance, view.size))
                   ? effect::changed
                   : effect::seen;
    // A motion along the line of sight is as long as the same motion to the side would be. Handles
    // must not come nearer than the near plane, where they would be lost.
    const double way = (std::exchange(grab_->y, motion.y) - motion.y) * distance /
                       view.camera.focal_length(view.size);
    const bool stays = distance + way >= 2 * view.camera.near_z;
    return stays && move(*marked_, from + view.camera.axes().forward * way) ? effect::changed
                                                                            : effect::seen;
}

void l3d_control_handles::draw(l3d_rasterizer_2d& rasterizer, const l3d_handle_view& view,
                               const l3d_depth_buffer* depth) const {
    const l3d_matrix<double> to_image = view.camera.image_matrix(view.size);
    std::vector<std::optional<seen_place>> there;
    for (std::size_t i = 0; i < count(); ++i)
        there.push_back(seen(to_image, view, place(i)));

    two_paths lines, handles;
    for (const auto& [from, to] : net_)
        if (there[from] && there[to])
            lines.add_line(*there[from], *there[to], depth);
    l3d_path marked;
    for (std::size_t i = 0; i < count(); ++i) {
        if (!there[i])
            continue;
        const l3d_point_2d middle{there[i]->x - 0.5, there[i]->y - 0.5};
        if (marked_ == i)
            marked.add_circle(middle, 1.6 * radius * view.text_scale);
        else
            (is_hidden(*there[i], depth) ? handles.hidden : handles.seen)
                .add_circle(middle, radius * view.text_scale);
    }
    const auto draw_lines = [&](const l3d_path& path, double alpha) {
        rasterizer.draw_path(l3d_stroked(path, {.width = 1.4 * view.text_scale}),
                             {.color = l3d_detail::net_color, .alpha = alpha});
    };
    const auto draw_handles = [&](const l3d_path& path, std::uint32_t color, double alpha) {
        rasterizer.draw_path(path, {.color = color, .alpha = alpha});
        rasterizer.draw_path(l3d_stroked(path, {.width = 1.4 * view.text_scale}),
                             {.color = rim_color, .alpha = alpha});
    };
    draw_lines(lines.hidden, pale);
    draw_handles(handles.hidden, handle_color, pale);
    draw_lines(lines.seen, 1);
    draw_handles(handles.seen, handle_color, 1);
    draw_handles(marked, marked_color, 1);
}
