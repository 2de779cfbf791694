// SPDX-License-Identifier: MIT
// captioned: shows and hides the panel, and keeps the pixels below it.
#include "pipeline/captioned_p.h"

#include "pipeline/panel_places_p.h"

#include <algorithm>
#include <utility>

namespace l3d_detail {

namespace {

/// A hint covers at most 1 / largest_share of the picture, since a larger hint would hide the
/// program's subject.
constexpr int largest_share = 5, largest_share_of_lesson = 4;

} // namespace

captioned::captioned(l3d_pipeline& shown, l3d_screen& screen, l3d_caption caption, l3d_font font,
                     double hint_seconds)
    : shown_(shown), screen_(screen), caption_(std::move(caption)), font_(std::move(font)),
      hint_seconds_(hint_seconds) {
    follow();
}

void captioned::any_event(const l3d_event& event) {
    shown_.any_event(event);
    follow();
}

void captioned::key_event(int key) {
    if (key > 0 && key < 128 && caption_.help.find(static_cast<char>(key)) != std::string::npos) {
        help_page_ = help_page_ < help_pages().size() ? help_page_ + 1 : 0;
        hint_seconds_ = 0;
        is_old_ = true;
        return;
    }
    shown_.key_event(key);
    follow();
}

/// Hides the hint when a button is pressed. From then on, the user looks at the picture, not at
/// words on top.
void captioned::pointer_event(const l3d_event& event) {
    if (event.type == l3d_event_type::button_press && hint_is_shown()) {
        hint_seconds_ = 0;
        is_old_ = true;
    }
    shown_.pointer_event(event);
    follow();
}

/// Forgets the covered pixels, since nothing of the old picture is left.
void captioned::resize_event(l3d_size size) {
    covered_ = {};
    std::vector<std::uint32_t>().swap(picture_); // {} would keep the memory
    shown_.resize_event(size);
    follow();
}

void captioned::update_event(double seconds) {
    pass_hint(seconds);
    shown_.update_event(seconds);
    follow();
}

double captioned::rest_left() const {
    return hint_is_shown() ? std::min(hint_seconds_, shown_.rest_left()) : shown_.rest_left();
}

void captioned::rest_event(double seconds) {
    pass_hint(seconds);
    shown_.rest_event(seconds);
    follow();
}

void captioned::pass_hint(double seconds) {
    if (!hint_is_shown())
        return;
    hint_seconds_ -= seconds;
    is_old_ |= !hint_is_shown();
}

void captioned::draw_event() {
    const l3d_pixel_box before = covered_;
    uncover();
    shown_.draw_event();
    cover();
    changed_ = shown_.changed().united(before).united(covered_);
    is_old_ = false;
    follow();
}

void captioned::frame_event(const l3d_frame_times& times) {
    shown_.frame_event(times);
    follow();
}

bool captioned::skip_event() {
    return shown_.skip_event();
}

/// Restores the pixels that panels cover.
void captioned::uncover() {
    const l3d_pixels pixels = screen_.pixels();
    for (int y = covered_.top; y < covered_.bottom; ++y) {
        const auto hidden = picture_.begin() + std::ptrdiff_t{y} * pixels.width;
        std::copy(hidden + covered_.left, hidden + covered_.right,
                  l3d_row(pixels, y, covered_).begin());
    }
    covered_ = {};
}

/// Draws the panels that are to be seen, and keeps the pixels below the panels for uncover().
void captioned::cover() {
    texts_.clear();
    l3d_panel message;
    if (const std::string words = shown_.message(); !words.empty())
        message.add(words);
    if (help_page_ > 0 || hint_is_shown() || !message.empty()) {
        const l3d_pixels pixels = screen_.pixels();
        picture_.clear();
        for (int y = 0; y < pixels.height; ++y)
            picture_.insert(picture_.end(), pixels.row(y).begin(), pixels.row(y).end());
        l3d_rasterizer_2d_sw_imp imp(pixels);
        l3d_rasterizer_2d rasterizer(imp);
        if (help_page_ > 0) {
            const std::vector<l3d_panel> pages = help_pages();
            draw(rasterizer, pages[std::min(help_page_, pages.size()) - 1], l3d_corner::top_right);
        } else {
            if (hint_is_shown() && !draws_a_hint(rasterizer))
                hint_seconds_ = 0;
            draw(rasterizer, message, l3d_corner::top_left);
        }
    }
    screen_.set_text(texts_);
}

void captioned::draw(l3d_rasterizer_2d& rasterizer, const l3d_panel& panel, l3d_corner corner) {
    l3d_pixel_box free = l3d_whole(screen_.pixels().size());
    const l3d_pixel_box box = panel.draw(rasterizer, free, corner, style());
    if (box.empty())
        return;
    covered_ = covered_.united(box);
    texts_.push_back(box);
}

/// Draws the first of hints() that leaves most of the picture free. Returns whether a hint is
/// drawn.
bool captioned::draws_a_hint(l3d_rasterizer_2d& rasterizer) {
    const int share = caption_.teaches.empty() ? largest_share : largest_share_of_lesson;
    for (const l3d_panel& hint : hints()) {
        draw(rasterizer, hint, caption_.corner);
        if (share * covered_.area() <= l3d_whole(screen_.pixels().size()).area())
            return true;
        uncover();
        texts_.clear();
    }
    return false;
}

l3d_panel_style captioned::style() const {
    return panel_style_of(screen_, font_);
}

std::vector<l3d_panel> captioned::help_pages() const {
    l3d_panel all;
    all.add_title(caption_.what);
    if (!caption_.teaches.empty())
        all.add_title(caption_.teaches);
    for (const l3d_caption_row& row : caption_.all_keys())
        all.add(row.keys, row.text);
    return all.pages(screen_.pixels().size(), caption_.help.substr(0, 1), style());
}

/// The hints to choose from: from the longest one down to the key for help alone.
std::vector<l3d_panel> captioned::hints() const {
    constexpr std::size_t most_keys = 4; // as many as users remember
    l3d_panel what, taught;
    what.add_title(caption_.what);
    taught = what;
    if (!caption_.teaches.empty())
        taught.add_title(caption_.teaches);
    std::vector<l3d_panel> result{taught, taught, what, {}};
    if (!caption_.teaches.empty())
        for (std::size_t i = 0; i < std::min(most_keys, caption_.keys.size()); ++i)
            result[0].add(caption_.keys[i].keys, caption_.keys[i].text);
    for (l3d_panel& hint : result)
        hint.add(caption_.help.substr(0, 1), "shows all keys");
    return result;
}

} // namespace l3d_detail
