// SPDX-License-Identifier: MIT
// l3d_part_list: states of parts, their lines in the picture, and the mouse over them.
#include "pipeline/part_list.h"

#include "hard_edged.h"
#include "pipeline/pipeline_afd_viewer.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace {

constexpr l3d_size size{300, 200};

std::vector<std::string> names(std::size_t count) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back("part number " + std::to_string(i) + " of a plate with many screws");
    return result;
}

/// A list in a picture, by the letters that are the same on every machine.
class drawn_list {
public:
    explicit drawn_list(std::size_t count) {
        list.set_names(names(count));
        list.show(true);
        style.size = 10;
        draw();
    }

    void draw() {
        std::ranges::fill(words_, 0U);
        l3d_rasterizer_2d_sw_imp imp(pixels());
        l3d_rasterizer_2d rasterizer(imp);
        list.draw(rasterizer, size, style);
        rasterizer.finish();
    }

    /// A press in a line of the list, over its square or its name.
    std::string press(int line, bool on_square, int button = 1, int clicks = 1) {
        l3d_event event{.type = l3d_event_type::button_press};
        event.button = button;
        event.clicks = clicks;
        event.x = on_square ? style.size : 4 * style.size;
        event.y = style.size / 2 + (line + 1) * style.font.line(style.size) + 3;
        std::string said;
        EXPECT_TRUE(list.pointer(event, said));
        return said;
    }

    void turn(int notches) {
        l3d_event event{.type = l3d_event_type::wheel};
        event.notches = notches;
        event.x = event.y = 40;
        std::string said;
        EXPECT_TRUE(list.pointer(event, said));
        draw();
    }

    std::vector<std::uint32_t> picture() const { return words_; }

    l3d_part_list list;
    l3d_panel_style style;

private:
    l3d_pixels pixels() { return {words_.data(), size.width, size.height, size.width}; }

    std::vector<std::uint32_t> words_ = std::vector<std::uint32_t>(
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
};

std::vector<bool> hidden(const l3d_part_list& list) {
    std::vector<bool> result;
    for (const l3d_listed_part& part : list.parts())
        result.push_back(part.is_hidden);
    return result;
}

TEST(part_list, chooses_hides_isolates_and_colors) {
    l3d_part_list list;
    EXPECT_EQ(list.choose_next(), "the model has no named parts");
    list.set_names(std::array<std::string, 3>{"lid", "body", "spout"});
    EXPECT_EQ(list.choose_next(-1), "part 3 of 3: spout");
    EXPECT_EQ(list.choose_next(), "part 1 of 3: lid");
    EXPECT_EQ(list.switch_chosen(), "lid is hidden");
    EXPECT_EQ(hidden(list), std::vector<bool>({true, false, false}));
    list.undo();
    EXPECT_EQ(hidden(list), std::vector<bool>({false, false, false}));
    list.choose("body");
    EXPECT_EQ(list.isolate_chosen(), "only body is shown");
    EXPECT_EQ(hidden(list), std::vector<bool>({true, false, true}));
    EXPECT_EQ(list.isolate_chosen(), "all parts are shown");
    EXPECT_EQ(hidden(list), std::vector<bool>({false, false, false}));
    EXPECT_EQ(list.color_chosen(), "body has another colour");
    EXPECT_TRUE(list.find("body")->color);
    int colors = 1;
    while (list.color_chosen() != "body has its own colour")
        ++colors;
    EXPECT_EQ(colors, 8);
    EXPECT_FALSE(list.find("body")->color);
    list.switch_chosen();
    list.set_names(std::array<std::string, 2>{"new", "body"}); // what stays is as it was
    EXPECT_EQ(hidden(list), std::vector<bool>({false, true}));
    EXPECT_EQ(list.chosen()->name, "body");
}

TEST(part_list, takes_the_mouse_over_its_lines_alone) {
    drawn_list drawn(40);
    EXPECT_EQ(drawn.press(2, false), "part 3 of 40: part number 2 of a plate with many screws");
    EXPECT_EQ(drawn.press(1, true), "part number 1 of a plate with many screws is hidden");
    EXPECT_EQ(drawn.press(4, false, 1, 2),
              "only part number 4 of a plate with many screws is shown");
    EXPECT_EQ(std::ranges::count(hidden(drawn.list), false), 1);
    EXPECT_NE(drawn.press(4, false, 3), "");
    EXPECT_TRUE(drawn.list.chosen()->color);
    l3d_event beside{.type = l3d_event_type::button_press};
    beside.button = 1;
    beside.x = drawn.list.box(size, drawn.style).right;
    std::string said;
    EXPECT_FALSE(drawn.list.pointer(beside, said));
    beside.x = 1;
    drawn.list.show(false);
    EXPECT_FALSE(drawn.list.pointer(beside, said));
}

TEST(part_list, scrolls_by_the_wheel_and_to_the_chosen_part) {
    drawn_list drawn(1000);
    drawn.turn(-1);
    EXPECT_EQ(drawn.press(0, false).substr(0, 14), "part 4 of 1000");
    drawn.turn(1000);
    EXPECT_EQ(drawn.press(0, false).substr(0, 14), "part 1 of 1000");
    drawn.turn(-1000);
    const std::string last = drawn.press(0, false);
    drawn.list.choose_next(-1); // the one before: the list follows
    drawn.list.choose("part number 0 of a plate with many screws");
    drawn.draw();
    EXPECT_EQ(drawn.press(0, false).substr(0, 14), "part 1 of 1000");
    drawn.list.choose_next(-1);
    drawn.draw();
    EXPECT_EQ(drawn.press(0, false), last);
}

/// Nothing is drawn beside its box, however long names are.
TEST(part_list, is_a_tree_where_names_have_slashes) {
    drawn_list drawn(0);
    l3d_part_list& list = drawn.list;
    list.set_names(std::vector<std::string>{"arm/left/bolt", "arm/left/nut", "arm/bolt", "base"});
    drawn.draw();
    const auto hidden = [&] {
        std::string result;
        for (const l3d_listed_part& part : list.parts())
            result += part.is_hidden ? 'h' : '-';
        return result;
    };
    // Lines: arm, left, bolt, nut, bolt, base.
    EXPECT_EQ(drawn.press(0, true), "arm: 3 parts are hidden");
    EXPECT_EQ(hidden(), "hhh-");
    EXPECT_EQ(drawn.press(0, true), "arm: 3 parts are shown");
    EXPECT_EQ(hidden(), "----");
    EXPECT_EQ(drawn.press(5, true), "base is hidden");
    list.show_all();
    EXPECT_EQ(drawn.press(0, false, 1, 2), "arm: 3 parts are shown alone");
    EXPECT_EQ(hidden(), "---h");
    EXPECT_EQ(drawn.press(0, false, 3), "arm: 3 parts have another colour");
    EXPECT_TRUE(list.parts()[0].color && list.parts()[0].color == list.parts()[2].color);
    EXPECT_FALSE(list.parts()[3].color);
    EXPECT_EQ(drawn.press(0, false), "arm: 3 parts");
    drawn.press(3, false);
    ASSERT_TRUE(list.chosen());
    EXPECT_EQ(list.chosen()->name, "arm/left/nut");
}

TEST(part_list, stays_in_its_box) {
    drawn_list drawn(1000);
    const l3d_pixel_box box = drawn.list.box(size, drawn.style);
    EXPECT_EQ(box.right, size.width / 2); // 16 letters take more than a third
    const auto words = drawn.picture();
    int outside = 0, inside = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const bool is_drawn = words[static_cast<std::size_t>(y * size.width + x)] != 0;
            (x < box.right ? inside : outside) += is_drawn;
        }
    EXPECT_EQ(outside, 0);
    EXPECT_GT(inside, 1000);
    drawn.list.show(false);
    drawn.draw();
    EXPECT_EQ(std::ranges::count(drawn.picture(), 0U), size.width * size.height);
}

TEST(part_list, colors_and_hides_patches) {
    l3d_patch_scene scene(l3d_patch_model::teapot());
    l3d_part_switch parts(scene);
    const std::string name = parts.list().parts()[0].name;
    parts.list().set({.name = name, .color = 0x00ff0000});
    EXPECT_TRUE(parts.apply());
    const l3d_patch_model& model = scene.instances()[0].model();
    const auto part = model.parts().find(name);
    ASSERT_TRUE(part);
    for (std::size_t i = 0; i < model.patches().size(); ++i)
        EXPECT_EQ(model.materials()[model.material_of(i)].color,
                  model.parts().of(i) == *part ? 0x00ff0000U : 0x00ffffffU);
    parts.list().set({.name = name});
    EXPECT_TRUE(parts.apply());
    EXPECT_TRUE(scene.instances()[0].model().materials().empty());
    parts.list().choose(name);
    parts.list().isolate_chosen();
    EXPECT_TRUE(parts.apply());
    EXPECT_EQ(scene.instances()[0].model().parts().names().size(), 1u);
    EXPECT_EQ(parts.switch_chosen(), name + " stays: without it nothing is left");
}

} // namespace
