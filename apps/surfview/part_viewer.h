// SPDX-License-Identifier: MIT
// part_viewer: keys and mouse for a list of parts and a section, on a viewer of either kind.
#ifndef APPS_SURFVIEW_PART_VIEWER_H
#define APPS_SURFVIEW_PART_VIEWER_H

#include "section_keys.h"
#include "shown_parts.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

/// A viewer whose user chooses parts in a list and moves a section plane, with keys and mouse.
/// `Shown` is patches_in_parts or polygons_in_parts.
template <class Shown> class part_viewer : public Shown {
public:
    /// The arguments are those of the constructor of `Shown`.
    template <class... Arguments>
    explicit part_viewer(Arguments&&... arguments) : Shown(std::forward<Arguments>(arguments)...) {
        add_rows();
    }

    /// Shows the model as the options ask for it at the start. `asked` changes the list of parts as
    /// the options say. The list is in the picture if `with_list` is true and there is more than
    /// one part.
    template <class Asked>
    void begin(const Asked& asked, const section_plane& section, bool with_list) {
        asked(this->list());
        section_ = section_keys(section);
        apply("");
        this->list().show(with_list && this->list().parts().size() > 1);
    }

    /// The command-line options that hide, colour and cut parts as the viewer does now, each after
    /// a blank.
    std::string part_options() {
        std::string text;
        const auto parts = this->list().parts();
        const auto hidden = std::ranges::count(parts, true, &l3d_listed_part::is_hidden);
        const bool names_shown = 2 * hidden > std::ssize(parts);
        for (const l3d_listed_part& part : parts) {
            if (names_shown && !part.is_hidden)
                text += " --show-only " + quoted(part.name);
            if (!names_shown && part.is_hidden)
                text += " --hide " + quoted(part.name);
            if (part.color) {
                char digits[8]; // # and six digits
                std::snprintf(digits, sizeof digits, "#%06x", *part.color & 0xffffffU);
                text += " --color " + quoted(part.name + '=' + digits);
            }
        }
        return text + section_.options();
    }

    void key_event(int key) override {
        Shown::key_event(key);
        if (this->is_turned())
            apply(this->controls().message());
    }

    /// Hands events of the pointer over the list to the list. A click beside the list chooses the
    /// part that is seen there.
    void pointer_event(const l3d_event& event) override {
        if (std::string said; this->list().pointer(event, said)) {
            apply(said);
            return;
        }
        Shown::pointer_event(event);
        const bool is_plain = event.button == 1 && !event.shift;
        if (event.type == l3d_event_type::button_press && is_plain) {
            pressed_x_ = event.x;
            pressed_y_ = event.y;
        }
        constexpr int still = 3; // pixels that a hand moves in a click
        if (event.type == l3d_event_type::button_release && is_plain &&
            std::abs(event.x - pressed_x_) <= still && std::abs(event.y - pressed_y_) <= still)
            choose_at(event);
    }

protected:
    void draw_overlay() override {
        Shown::draw_overlay();
        const l3d_panel_style style = this->controls().panel_style();
        const l3d_size size = this->screen().pixels().size();
        this->controls().set_left_margin(this->list().box(size, style).right);
        if (this->list().is_shown())
            this->list().draw(this->rasterizer(), size, style);
    }

private:
    void add_rows() {
        const auto part = [this](auto change) {
            return [this, change] { apply(change(this->list())); };
        };
        const auto section = [this](auto change) {
            return [this, change] {
                const std::string said = change(section_);
                apply(said);
            };
        };
        constexpr double step = 1.0 / 40;
        const auto move = [this](double by) {
            return [this, by](section_keys& keys) { return keys.move(by, this->reach_of_all()); };
        };
        auto& controls = this->controls();
        controls.add({"Tab", "list of parts", {{l3d_key_tab, [this] { switch_list(); }}}});
        if constexpr (!std::derived_from<Shown, patches_in_parts>) { // which has these keys
            controls.add({"e",
                          "choose the next part",
                          {{'e', part([](l3d_part_list& list) { return list.choose_next(); })}}});
            controls.add({"d",
                          "hide or show that part",
                          {{'d', part([](l3d_part_list& list) { return list.switch_chosen(); })}}});
        }
        controls.add({"E",
                      "choose the part before",
                      {{'E', part([](l3d_part_list& list) { return list.choose_next(-1); })}}});
        controls.add({"u",
                      "that part alone, all parts",
                      {{'u', part([](l3d_part_list& list) { return list.isolate_chosen(); })}}});
        controls.add({"C",
                      "another colour for that part",
                      {{'C', part([](l3d_part_list& list) { return list.color_chosen(); })}}});
        controls.add({"F", "show all of that part", {{'F', [this] { frame_part(); }}}});
        controls.add(
            {"/", "section across x, y, z, none", {{'/', section([this](section_keys& keys) {
                                                        return keys.take_next(this->reach_of_all());
                                                    })}}});
        controls.add(
            {", .", "move the section", {{',', section(move(-step))}, {'.', section(move(step))}}});
        controls.add({";",
                      "the other half",
                      {{';', section([](section_keys& keys) { return keys.flip(); })}}});
    }

    /// Draws the parts of the model that the list shows, cut by the section, and shows the line
    /// `said` to the user.
    void apply(const std::string& said) {
        const l3d_listed_part* const chosen = this->list().chosen();
        const std::string name = chosen ? chosen->name : "the part";
        const bool is_done = Shown::apply(section_.plane());
        this->controls().say(is_done ? said : name + " stays: without it nothing is left");
        this->redraw();
    }

    void switch_list() {
        l3d_part_list& list = this->list();
        list.show(!list.is_shown());
        if (list.parts().empty())
            this->controls().say("the model has no named parts");
    }

    void frame_part() {
        const l3d_listed_part* const part = this->list().chosen();
        if (!part)
            return this->controls().say("no part is chosen");
        this->camera() = l3d_framed(this->camera(), this->screen().pixels().size(),
                                    this->reach_of_part(part->name));
    }

    void choose_at(const l3d_event& event) {
        const auto found = this->pick(event.x + 0.5, event.y + 0.5);
        if (!found || found->part.empty())
            return;
        this->list().choose(found->part);
        this->redraw();
    }

    /// The word as a shell reads it, in quotes if needed.
    static std::string quoted(const std::string& word) {
        const bool is_plain = std::ranges::all_of(word, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   c == '_' || c == '-' || c == '.' || c == '/' || c == '=';
        });
        if (is_plain && !word.empty())
            return word;
        std::string result = "'";
        for (const char c : word)
            result += c == '\'' ? std::string("'\\''") : std::string(1, c);
        return result + "'";
    }

    section_keys section_{std::nullopt};
    int pressed_x_ = 0, pressed_y_ = 0;
};

#endif
