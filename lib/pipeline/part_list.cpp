// SPDX-License-Identifier: MIT
// l3d_part_list: keeps the states of parts, and chooses the lines that have room.
#include "pipeline/part_list.h"

#include "base/counted_p.h"
#include "base/printable_p.h"
#include "raster/paths/path.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace {

using l3d_detail::printable;

/// Colours for parts. They differ in hue and in lightness, so that users can tell parts side by
/// side apart.
constexpr std::array<l3d_color, 8> palette{0x00e69f00, 0x0056b4e9, 0x00009e73, 0x00f0e442,
                                           0x000072b2, 0x00d55e00, 0x00cc79a7, 0x00999999};

/// A name, cut if it is wider than `width`: its first letters, followed by three dots.
std::string shortened(const std::string& name, int width, const l3d_panel_style& style) {
    const std::string whole = printable(name);
    if (style.font.width(whole, style.size) <= width)
        return whole;
    std::string result;
    for (std::size_t end = 0; end < whole.size();) {
        end += std::max<std::size_t>(
            1, l3d_detail::printable_size(std::string_view(whole).substr(end)));
        std::string longer = whole.substr(0, end) + "...";
        if (style.font.width(longer, style.size) > width)
            break;
        result = std::move(longer);
    }
    return result;
}

void fill(l3d_rasterizer_2d& rasterizer, const l3d_pixel_box& box, l3d_color color, double alpha) {
    l3d_path path;
    path.add_box(box);
    rasterizer.draw_path(path, {.color = color, .alpha = alpha});
}

} // namespace

void l3d_part_list::set_names(std::span<const std::string> names) {
    const bool is_same = std::ranges::equal(names, parts_, {}, {}, &l3d_listed_part::name);
    if (is_same)
        return;
    std::unordered_map<std::string, l3d_listed_part> known;
    for (const l3d_listed_part& part : parts_)
        known.emplace(part.name, part);
    const std::string was_chosen = chosen_ ? parts_[*chosen_].name : "";
    parts_.clear();
    for (const std::string& name : names) {
        const auto at = known.find(name);
        parts_.push_back(at == known.end() ? l3d_listed_part{.name = name} : at->second);
    }
    before_ = parts_;
    make_lines();
    choose(was_chosen);
}

/// Makes the lines of the tree. A group holds parts that follow each other and whose names begin
/// with the group's path.
void l3d_part_list::make_lines() {
    tree_.clear();
    line_of_.clear();
    std::vector<std::size_t> open; // the groups that the last part is in, as indices in tree_
    std::vector<std::string> path; // their names
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        std::vector<std::string> words;
        for (std::string_view rest = parts_[i].name;;) {
            const std::size_t slash = rest.find('/');
            words.emplace_back(rest.substr(0, slash));
            if (slash == rest.npos)
                break;
            rest.remove_prefix(slash + 1);
        }
        const std::string name = words.back();
        words.pop_back();
        const auto same =
            static_cast<std::size_t>(std::ranges::mismatch(path, words).in1 - path.begin());
        path = words;
        open.resize(same);
        for (std::size_t depth = same; depth < words.size(); ++depth) {
            open.push_back(tree_.size());
            tree_.push_back({words[depth], i, i, static_cast<int>(depth), true});
        }
        for (const std::size_t group : open)
            tree_[group].end = i + 1;
        line_of_.push_back(tree_.size());
        tree_.push_back({name, i, i + 1, static_cast<int>(words.size()), false});
    }
}

const l3d_listed_part* l3d_part_list::find(const std::string& name) const {
    const auto at = std::ranges::find(parts_, name, &l3d_listed_part::name);
    return at == parts_.end() ? nullptr : &*at;
}

std::string l3d_part_list::state_of(std::size_t part) const {
    return "part " + std::to_string(part + 1) + " of " + std::to_string(parts_.size()) + ": " +
           printable(parts_[part].name) + (parts_[part].is_hidden ? ", hidden" : "");
}

std::string l3d_part_list::choose_next(int step) {
    if (parts_.empty())
        return no_parts();
    const auto count = static_cast<std::ptrdiff_t>(parts_.size());
    const std::ptrdiff_t from = chosen_ ? static_cast<std::ptrdiff_t>(*chosen_) : step > 0 ? -1 : 0;
    chosen_ = static_cast<std::size_t>(((from + step) % count + count) % count);
    follows_chosen_ = true;
    return state_of(*chosen_);
}

void l3d_part_list::choose(const std::string& name) {
    const l3d_listed_part* const part = find(name);
    chosen_.reset();
    if (part)
        chosen_ = static_cast<std::size_t>(part - parts_.data());
    follows_chosen_ = true;
}

/// Makes sure that a part is chosen, and keeps the state for undo(). Returns false if there are no
/// parts.
bool l3d_part_list::choose_any() {
    if (!chosen_ && !parts_.empty())
        choose_next();
    before_ = parts_;
    return chosen_.has_value();
}

std::string l3d_part_list::switch_chosen() {
    if (!choose_any())
        return no_parts();
    l3d_listed_part& part = parts_[*chosen_];
    part.is_hidden = !part.is_hidden;
    return printable(part.name) + (part.is_hidden ? " is hidden" : " is shown");
}

std::string l3d_part_list::isolate_chosen() {
    if (!choose_any())
        return no_parts();
    const auto shown = std::ranges::count(parts_, false, &l3d_listed_part::is_hidden);
    const bool is_alone = shown == 1 && parts_.size() > 1 && !parts_[*chosen_].is_hidden;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        parts_[i].is_hidden = !is_alone && i != *chosen_;
    return is_alone ? "all parts are shown"
                    : "only " + printable(parts_[*chosen_].name) + " is shown";
}

std::string l3d_part_list::color_chosen() {
    if (!choose_any())
        return no_parts();
    l3d_listed_part& part = parts_[*chosen_];
    const auto at = part.color ? std::ranges::find(palette, *part.color) : palette.end();
    const auto next = !part.color ? palette.begin() : at == palette.end() ? at : at + 1;
    part.color = next == palette.end() ? std::nullopt : std::optional(*next);
    return printable(part.name) + (part.color ? " has another colour" : " has its own colour");
}

void l3d_part_list::show_all() {
    before_ = parts_;
    for (l3d_listed_part& part : parts_)
        part.is_hidden = false;
}

void l3d_part_list::set(const l3d_listed_part& part) {
    *std::ranges::find(parts_, part.name, &l3d_listed_part::name) = part;
}

l3d_pixel_box l3d_part_list::box(l3d_size picture, const l3d_panel_style& style) const {
    if (!is_shown())
        return {};
    // In a wide picture, two thirds are left for the model. Sixteen letters tell most names apart.
    const int least = 16 * style.size;
    return {0, 0, std::min(std::max(picture.width / 3, least), picture.width / 2), picture.height};
}

/// The number of lines that have room below the title.
std::size_t l3d_part_list::lines() const {
    const int room = box_.bottom - box_.top - 2 * padding_ - line_;
    return static_cast<std::size_t>(std::max(room / line_, 0));
}

/// Scrolls until the chosen part's line is in the picture, if the part was chosen since the last
/// picture.
void l3d_part_list::reveal_chosen() {
    const std::size_t count = std::max<std::size_t>(lines(), 1);
    if (follows_chosen_ && chosen_) {
        const std::size_t chosen = line_of_[*chosen_];
        first_ = std::min(first_, chosen);
        first_ = std::max(first_, chosen + 1 > count ? chosen + 1 - count : 0);
    }
    follows_chosen_ = false;
    first_ = std::min(first_, tree_.size() > count ? tree_.size() - count : 0);
}

void l3d_part_list::draw(l3d_rasterizer_2d& rasterizer, l3d_size picture,
                         const l3d_panel_style& style) {
    box_ = box(picture, style);
    if (box_.empty())
        return;
    constexpr double whole_coverage = 255;
    fill(rasterizer, box_, style.ground, style.ground_coverage / whole_coverage);
    line_ = style.font.line(style.size);
    padding_ = style.size / 2;
    reveal_chosen();
    const int left = box_.left + padding_, width = box_.right - padding_ - left;
    const std::size_t end = std::min(tree_.size(), first_ + lines());
    int y = box_.top + padding_;
    const std::string title =
        l3d_detail::counted(parts_.size(), "parts") +
        (end - first_ < tree_.size() ? ", " + std::to_string(tree_[first_].first + 1) + " to " +
                                           std::to_string(end > 0 ? tree_[end - 1].end : 0)
                                     : "");
    style.font.draw(rasterizer, left, y, shortened(title, width, style), style.key, style.size);
    for (std::size_t i = first_; i < end; ++i) {
        y += line_;
        const line& of = tree_[i];
        const l3d_listed_part& part = parts_[of.first];
        const bool is_chosen = !of.is_group && chosen_ == of.first;
        const bool is_hidden =
            std::all_of(parts_.begin() + static_cast<std::ptrdiff_t>(of.first),
                        parts_.begin() + static_cast<std::ptrdiff_t>(of.end),
                        [](const l3d_listed_part& each) { return each.is_hidden; });
        if (is_chosen)
            fill(rasterizer, {box_.left, y, box_.right, y + line_}, style.key, 0.25);
        const int side = style.size * 3 / 4, top = y + (line_ - side) / 2;
        const int in = std::min(of.depth * line_, width / 2);
        const l3d_pixel_box square{left + in, top, left + in + side, top + side};
        fill(rasterizer, square, style.text, is_hidden ? 0.5 : 1);
        fill(rasterizer, {square.left + 1, square.top + 1, square.right - 1, square.bottom - 1},
             is_hidden     ? style.ground
             : of.is_group ? style.text
                           : part.color.value_or(style.text),
             1);
        style.font.draw(rasterizer, left + in + line_, y,
                        shortened(of.text, width - in - line_, style),
                        is_chosen || of.is_group ? style.key : style.text, style.size);
    }
}

/// The line of the list at row y of the picture; null if there is none.
const l3d_part_list::line* l3d_part_list::line_at(int y) const {
    const int below = y - box_.top - padding_ - line_;
    if (below < 0)
        return nullptr;
    const auto row = static_cast<std::size_t>(below / line_);
    if (row >= lines() || first_ + row >= tree_.size())
        return nullptr;
    return &tree_[first_ + row];
}

/// Hides, shows, colours or isolates all parts of a group, as a click on the group's line asks.
/// Returns the text that tells the user the change.
std::string l3d_part_list::of_group(const line& of, const l3d_event& event, bool on_square) {
    const bool colors = event.button == 3, isolates = event.button == 1 && event.clicks == 2;
    const std::string count = l3d_detail::counted(of.end - of.first, "parts");
    if (!colors && !isolates && !(event.button == 1 && on_square))
        return printable(of.text) + ": " + count;
    before_ = parts_;
    chosen_ = of.first;
    if (colors)
        color_chosen();
    const l3d_listed_part first = parts_[of.first];
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const bool is_in = i >= of.first && i < of.end;
        if (is_in && colors)
            parts_[i].color = first.color;
        else if (isolates && !on_square)
            parts_[i].is_hidden = !is_in;
        else if (is_in && !colors)
            parts_[i].is_hidden = !first.is_hidden;
    }
    return printable(of.text) + ": " + count +
           (colors                   ? " have another colour"
            : isolates && !on_square ? " are shown alone"
            : first.is_hidden        ? " are shown"
                                     : " are hidden");
}

bool l3d_part_list::pointer(const l3d_event& event, std::string& said) {
    const bool is_inside = is_shown() && event.x >= box_.left && event.x < box_.right &&
                           event.y >= box_.top && event.y < box_.bottom;
    if (!is_inside)
        return false;
    if (event.type == l3d_event_type::wheel) {
        constexpr std::size_t lines_a_notch = 3;
        for (int notch = std::abs(event.notches); notch > 0; --notch)
            first_ = event.notches < 0        ? first_ + lines_a_notch
                     : first_ > lines_a_notch ? first_ - lines_a_notch
                                              : 0;
        return true;
    }
    if (event.type != l3d_event_type::button_press)
        return false; // a drag that began beside the list goes on
    const line* const of = line_at(event.y);
    if (!of)
        return true;
    const int in = std::min(of->depth * line_, (box_.right - box_.left - 2 * padding_) / 2);
    const bool on_square = event.x < box_.left + padding_ + in + line_;
    if (of->is_group) {
        said = of_group(*of, event, on_square);
        return true;
    }
    chosen_ = of->first;
    if (event.button == 3)
        said = color_chosen();
    else if (event.button == 1 && on_square)
        said = switch_chosen();
    else if (event.button == 1 && event.clicks == 2)
        said = isolate_chosen();
    else
        said = state_of(*chosen_);
    return true;
}
