// SPDX-License-Identifier: MIT
// l3d_part_list: the parts of a model as a list in the picture, to choose, hide and colour them.
#ifndef L3D_PIPELINE_PART_LIST_H
#define L3D_PIPELINE_PART_LIST_H

#include "base/color.h"
#include "base/public.h"
#include "raster/rasterizer_2d.h"
#include "raster/text/panel.h"
#include "tool_2d/event.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// A part of a model, with the user's choices for the part.
struct L3D_PUBLIC l3d_listed_part {
    std::string name;       ///< the part's name in the model
    bool is_hidden = false; ///< whether the part is not to be drawn
    /// The part's colour; nothing stands for its colour in the model.
    std::optional<l3d_color> color{};

    friend bool operator==(const l3d_listed_part&, const l3d_listed_part&) = default;
};

/// Lists a model's parts at the left of the picture, so that the user can choose, hide and colour
/// them. The list knows no model: its owner draws each part as the list says. Functions that return
/// text tell the change to the user, such as "lid is hidden".
///
/// A line of the list has a square and the part's name. The square is filled with the part's
/// colour, or empty if the part is hidden. A name that is too long ends in three dots. A click on a
/// name chooses the part, and a double click shows this part alone. A click on a part's square
/// hides or shows the part. A click with the right button on the line gives the part the next
/// colour. The wheel scrolls.
///
/// Slashes in names make a tree. "arm/bolt" stands, moved to the right, below a line "arm" for all
/// parts of the arm. Clicks on the line "arm" hide, show or colour all parts of the arm. A single
/// click on the name "arm" tells the number of these parts.
///
/// Lives: a value.
/// Cost:  a picture draws only the lines that have room. Finding a part by its name looks at all
///        parts.
class L3D_PUBLIC l3d_part_list {
public:
    /// Takes the names of a model's parts. Parts that the list had before keep their states and
    /// colours.
    void set_names(std::span<const std::string> names);

    /// All parts in the model's order.
    std::span<const l3d_listed_part> parts() const { return parts_; }
    /// The first part of this name; null if no part has it.
    const l3d_listed_part* find(const std::string& name) const;
    /// The chosen part; null if none is chosen.
    const l3d_listed_part* chosen() const { return chosen_ ? &parts_[*chosen_] : nullptr; }

    /// Chooses the part that is `step` parts after the chosen part. After the last part, it goes on
    /// with the first part. If no part is chosen yet, a step of 1 chooses the first part, and a
    /// step of -1 the last.
    std::string choose_next(int step = 1);
    /// Chooses the part of this name, such as a part that was picked; "" chooses none.
    void choose(const std::string& name);
    /// Hides the chosen part, or shows it again. If no part is chosen, the list first chooses the
    /// model's first part.
    std::string switch_chosen();
    /// Hides all parts but the chosen one. If only the chosen part is shown already, all parts are
    /// shown again. If no part is chosen, the list first chooses the model's first part.
    std::string isolate_chosen();
    /// Gives the chosen part the next colour of a palette; after the palette's last colour, the
    /// part gets its own colour in the model again. If no part is chosen, the list first chooses
    /// the model's first part.
    std::string color_chosen();
    /// Shows all parts.
    void show_all();
    /// Replaces the state and colour of the part with this name. Expects: a name of parts().
    void set(const l3d_listed_part& part);
    /// Takes the user's last change back: parts get the states and colours from before the change.
    /// The owner calls this if no part would be left to see.
    void undo() { parts_ = before_; }

    /// Whether the list is in the picture.
    bool is_shown() const { return is_shown_ && !parts_.empty(); }
    /// Shows the list in the picture, or takes it away.
    void show(bool is_shown) { is_shown_ = is_shown; }

    /// The box that the list takes in a picture: a third of the picture's width, or more if sixteen
    /// letters need it, but at most half. It is empty if the list is not shown.
    l3d_pixel_box box(l3d_size picture, const l3d_panel_style& style) const;

    /// Draws the list into its box.
    void draw(l3d_rasterizer_2d& rasterizer, l3d_size picture, const l3d_panel_style& style);

    /// Answers a press of a button or a turn of the wheel over the list. Returns false, and does
    /// nothing, for events elsewhere, motions and releases. `said` gets the text that tells the
    /// change to the user.
    /// Expects: draw() has drawn the present picture.
    bool pointer(const l3d_event& event, std::string& said);

private:
    /// A line of the list. It is a part, or a group: the common beginning of the names of the parts
    /// below.
    struct line {
        std::string text;
        std::size_t first, end; ///< indices of the line's parts: from `first` to before `end`
        int depth = 0;
        bool is_group = false;
    };

    void make_lines();
    std::string of_group(const line& of, const l3d_event& event, bool on_square);
    bool choose_any();
    std::string no_parts() const { return "the model has no named parts"; }
    std::string state_of(std::size_t part) const;
    void reveal_chosen();
    std::size_t lines() const;
    const line* line_at(int y) const;

    std::vector<l3d_listed_part> parts_, before_;
    std::vector<line> tree_; ///< all lines of the list; parts stand in the order of parts_
    std::vector<std::size_t> line_of_; ///< the line of each part, in tree_
    std::optional<std::size_t> chosen_;
    bool is_shown_ = false, follows_chosen_ = false;
    std::size_t first_ = 0; ///< the uppermost line in the picture, as an index in tree_
    // The box, the line's height and the padding are those of the last picture.
    l3d_pixel_box box_;
    int line_ = 1, padding_ = 0; ///< height of a line; distance from the box's edge to its text
};

#endif
