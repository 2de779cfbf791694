// SPDX-License-Identifier: MIT
// x11_colormap: what is seen through it, beside programs that took all cells, and what is left.
#include "onlooker_x11.h"

#include "tool_2d/image.h"
#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11/x11_colormap_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <algorithm>
#include <set>

namespace {

using namespace l3d_detail;
using enum l3d_color_class;

/// A visual of the screen and the colormap that was made for it.
struct made_map {
    std::unique_ptr<x11_connection> connection;
    std::unique_ptr<x11_colormap> map;
    x11_visual visual;
};

/// The colormap of the screen's default visual, or of the first of a class.
made_map make_map(std::optional<l3d_color_class> color_class = std::nullopt) {
    std::string why;
    made_map made{x11_connection::open(why), nullptr, {}};
    const auto* usual = DefaultVisual(made.connection->display(), made.connection->screen());
    for (const auto& visual : offered_x11_visuals(*made.connection)) {
        if (made.visual.visual == nullptr &&
            (color_class ? visual.layout.color_class == *color_class : visual.visual == usual))
            made.visual = visual;
    }
    l3d_service refusal;
    made.map = x11_colormap::make(*made.connection, made.visual, refusal);
    EXPECT_NE(made.map, nullptr) << refusal.why;
    return made;
}

/// The colour of a pixel on a monitor: the display's own word on it, 16 bits per channel.
XColor seen(const made_map& made, std::uint32_t pixel) {
    XColor color{};
    color.pixel = pixel;
    XQueryColor(made.connection->display(), made.map->id(), &color);
    return color;
}

/// The largest difference, of 255, between a word and what a pixel looks like.
double difference(const made_map& made, std::uint32_t pixel, std::uint32_t word, bool gray) {
    const auto color = seen(made, pixel);
    const auto off = [&](unsigned short channel, int shift) {
        const auto value = gray ? l3d_screen_info::gray_of(word) : word >> shift & 255;
        return std::abs(channel / 257.0 - value);
    };
    return std::max({off(color.red, 16), off(color.green, 8), off(color.blue, 0)});
}

struct seen_case {
    const char* name;
    const char* screen;
    std::vector<std::string> more;
    l3d_color_class color_class;
    const char* palette; ///< how info().describe() ends
    double farthest;     ///< of a pixel from its word, of 255
    bool shared;
};

class seen_colors : public testing::TestWithParam<seen_case> {};

/// Random words, as they are seen through the map; and the levels, which have to be exact.
TEST_P(seen_colors, are_near) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server(GetParam().screen, GetParam().more);
    L3D_REQUIRE_SERVER(server);
    const auto made = make_map();
    ASSERT_EQ(made.visual.layout.color_class, GetParam().color_class);
    const auto& info = made.map->info();
    EXPECT_TRUE(info.describe().ends_with(GetParam().palette)) << info.describe();
    EXPECT_EQ(made.map->is_shared(), GetParam().shared);
    EXPECT_EQ(info.palette().deviation, 0);
    const bool gray = info.has_palette() && info.palette().is_ramp();
    std::mt19937 random(seed);
    double farthest = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::uint32_t word = random() & 0xFFFFFF;
        farthest = std::max(farthest, difference(made, info.to_display(word), word, gray));
    }
    EXPECT_LE(farthest, GetParam().farthest);
    EXPECT_GT(farthest, 0.9 * GetParam().farthest - 1) << "the bound is idle";
    for (const std::uint32_t word : {0x000000U, 0xFFFFFFU})
        EXPECT_LE(difference(made, info.to_display(word), word, gray), 1e-9) << word;
}

// Half the gap of two levels; of masks the whole, since they round down.
INSTANTIATE_TEST_SUITE_P(
    servers, seen_colors,
    testing::Values(
        seen_case{"static_gray", "301x207x8", {"-cc", "0"}, static_gray, "256 grays", 0, true},
        seen_case{"gray_scale", "301x207x8", {"-cc", "1"}, gray_scale, "64 grays", 2.5, true},
        seen_case{
            "static_color", "301x207x8", {"-cc", "2"}, static_color, "8x8x4 colours", 43, true},
        seen_case{"pseudo_color",
                  "301x207x8",
                  {"-cc", "3", "-extension", "RENDER"},
                  pseudo_color,
                  "6x6x6 colours",
                  25.5,
                  true},
        // Render has taken 73 cells, where 6x6x6 finds only few of its colours.
        seen_case{"pseudo_color_render",
                  "301x207x8",
                  {"-cc", "3"},
                  pseudo_color,
                  "5x5x5 colours",
                  32,
                  true},
        seen_case{"true_color_8", "301x207x8", {"-cc", "4"}, true_color, "8x8x4 colours", 43, true},
        seen_case{
            "direct_color_8", "301x207x8", {"-cc", "5"}, direct_color, "8x8x4 colours", 43, false},
        seen_case{"direct_color_16",
                  "301x207x16",
                  {"-cc", "5"},
                  direct_color,
                  "f800/7e0/1f",
                  255 / 31.0,
                  false},
        seen_case{"direct_color_24",
                  "301x207x24",
                  {"-cc", "5"},
                  direct_color,
                  "ff0000/ff00/ff",
                  0,
                  false},
        seen_case{"depth_15", "301x207x15", {}, true_color, "7c00/3e0/1f", 255 / 31.0, true},
        seen_case{"depth_24", "301x207x24", {}, true_color, "ff0000/ff00/ff", 0, true},
        seen_case{"depth_30", "301x207x30", {}, true_color, "3ff00000/ffc00/3ff", 0.25, true}),
    [](const auto& kind) { return std::string(kind.param.name); });

/// Another program takes cells of the default map.
class greedy {
public:
    greedy() : map_(DefaultColormap(other_.display(), DefaultScreen(other_.display()))) {}

    /// Cells that nobody can share; all that are free, less some.
    void take_for_itself(int left = 0) {
        unsigned long cell = 0;
        while (XAllocColorCells(other_.display(), map_, False, nullptr, 0, &cell, 1) != 0)
            cells_.push_back(cell);
        XFreeColors(other_.display(), map_, cells_.data(), left, 0);
        cells_.erase(cells_.begin(), cells_.begin() + left);
        // Colours that lie near some of every cube: to look at, not to have.
        for (std::size_t i = 0; i < cells_.size(); ++i)
            store(i, static_cast<std::uint32_t>(i) * 0x010101);
        XSync(other_.display(), False);
    }

    /// Changes the colour of one of its private cells.
    void store(std::size_t number, std::uint32_t word) {
        auto color = color_of(word);
        color.pixel = cells_.at(number);
        XStoreColors(other_.display(), map_, &color, 1);
    }

    /// The colours of a cube of 8x8x4, for everybody; as many as there is room for.
    void share() {
        const palette_shape shape{8, 8, 4};
        for (int place = 0; place < shape.size(); ++place) {
            auto color = color_of(shape.color(place));
            taken_ += XAllocColor(other_.display(), map_, &color) != 0;
        }
    }

    int taken() const { return taken_; }

    /// How many cells are free. They are freed again.
    int free_cells() {
        std::vector<unsigned long> cells;
        unsigned long cell = 0;
        while (XAllocColorCells(other_.display(), map_, False, nullptr, 0, &cell, 1) != 0)
            cells.push_back(cell);
        XFreeColors(other_.display(), map_, cells.data(), static_cast<int>(cells.size()), 0);
        XSync(other_.display(), False);
        return static_cast<int>(cells.size());
    }

private:
    static XColor color_of(std::uint32_t word) {
        const auto channel = [&](int shift) {
            return static_cast<unsigned short>((word >> shift & 255) * 257);
        };
        return {0, channel(16), channel(8), channel(0), DoRed | DoGreen | DoBlue, 0};
    }

    onlooker other_;
    Colormap map_;
    std::vector<unsigned long> cells_;
    int taken_ = 0;
};

// Which takes cells of its own.
const std::vector<std::string> no_render{"-cc", "3", "-extension", "RENDER"};

TEST(x11_colormap, cells_are_shared_and_given_back) {
    const xvfb server("301x207x8", no_render);
    L3D_REQUIRE_SERVER(server);
    greedy other;
    const int before = other.free_cells();
    auto one = make_map(), another = make_map();
    const auto pixels = one.map->info().palette().pixels;
    EXPECT_EQ(pixels, another.map->info().palette().pixels);
    EXPECT_EQ(std::set(pixels.begin(), pixels.end()).size(), pixels.size());
    // Black and white were there.
    EXPECT_EQ(other.free_cells(), before - (6 * 6 * 6 - 2));
    // With the map, not only with the connection.
    for (auto* made : {&one, &another}) {
        made->map.reset();
        XSync(made->connection->display(), False);
    }
    EXPECT_EQ(other.free_cells(), before);
}

TEST(x11_colormap, full_of_cells_that_can_be_shared) {
    const xvfb server("301x207x8", no_render);
    L3D_REQUIRE_SERVER(server);
    greedy other;
    other.share();
    ASSERT_GE(other.taken(), 254);
    ASSERT_EQ(other.free_cells(), 0);
    const auto made = make_map();
    const auto& palette = made.map->info().palette();
    EXPECT_TRUE(made.map->is_shared());
    // Blue has the levels 0, 85, 170, 255 in both; of the others, 2 / 7 is nearest to 1 / 3.
    EXPECT_EQ(palette.red, 4);
    EXPECT_EQ(palette.deviation, 85 - 73) << made.map->info().describe();
    const palette_shape shape = palette_shape::cube(4);
    int farthest = 0;
    for (int place = 0; place < shape.size(); ++place) {
        const auto pixel = palette.pixels[static_cast<std::size_t>(place)];
        farthest = std::max(farthest, static_cast<int>(std::lround(
                                          difference(made, pixel, shape.color(place), false))));
    }
    EXPECT_EQ(farthest, palette.deviation);
    EXPECT_TRUE(made.map->info().describe().ends_with("4x4x4 colours, exact within 12/255"));
}

TEST(x11_colormap, full_of_cells_that_cannot_be_shared) {
    const xvfb server("301x207x8", no_render);
    L3D_REQUIRE_SERVER(server);
    greedy other;
    other.take_for_itself();
    ASSERT_EQ(other.free_cells(), 0);
    const auto made = make_map();
    EXPECT_FALSE(made.map->is_shared());
    EXPECT_TRUE(made.map->info().describe().ends_with("6x6x6 colours"));
    const palette_shape shape = palette_shape::cube(6);
    for (int place = 0; place < shape.size(); ++place) {
        const auto pixel = made.map->info().palette().pixels[static_cast<std::size_t>(place)];
        EXPECT_EQ(difference(made, pixel, shape.color(place), false), 0) << place;
    }
    // The forty cells left over look as they do in the default map.
    XColor theirs{};
    for (std::uint32_t cell = 0; cell < 40; ++cell) {
        theirs.pixel = cell;
        XQueryColor(made.connection->display(),
                    DefaultColormap(made.connection->display(), made.connection->screen()),
                    &theirs);
        const auto ours = seen(made, cell);
        EXPECT_TRUE(ours.red == theirs.red && ours.green == theirs.green &&
                    ours.blue == theirs.blue)
            << cell;
    }
}

/// A cube that does not fit is not tried cell by cell.
TEST(x11_colormap, nearly_full) {
    const xvfb server("301x207x8", no_render);
    L3D_REQUIRE_SERVER(server);
    greedy other;
    other.take_for_itself(130);
    const int before = other.free_cells();
    ASSERT_EQ(before, 130);
    const auto made = make_map();
    EXPECT_TRUE(made.map->is_shared());
    EXPECT_TRUE(made.map->info().describe().ends_with("5x5x5 colours"));
    EXPECT_EQ(other.free_cells(), before - (5 * 5 * 5 - 2));
    // To connect takes some, the colours 125, to look and to find room 4.
    EXPECT_LT(NextRequest(made.connection->display()), 125 + 4 + 20);
}

/// Cells taken before it was clear that they will not do are given back.
TEST(x11_colormap, hardly_any_room) {
    const xvfb server("301x207x8", no_render);
    L3D_REQUIRE_SERVER(server);
    greedy other;
    other.take_for_itself(30);
    ASSERT_EQ(other.free_cells(), 30);
    const auto made = make_map();
    EXPECT_FALSE(made.map->is_shared());
    EXPECT_EQ(other.free_cells(), 30);
}

/// A private cell may have the very colour; the next best one that is not private is taken.
TEST(x11_colormap, private_cells_among_those_to_share) {
    const xvfb server("301x207x8", no_render);
    L3D_REQUIRE_SERVER(server);
    greedy other;
    other.take_for_itself(250);
    // Black and white and four private cells are taken; the third private one is grey.
    other.store(2, 0x555555);
    other.share();
    ASSERT_EQ(other.free_cells(), 0);
    const auto made = make_map();
    const auto& palette = made.map->info().palette();
    EXPECT_TRUE(made.map->is_shared());
    EXPECT_EQ(palette.red, 4) << made.map->info().describe();
    const palette_shape shape = palette_shape::cube(4);
    const auto grey = palette.pixels[(1 * 4 + 1) * 4 + 1];
    EXPECT_EQ(shape.color((1 * 4 + 1) * 4 + 1), 0x555555U);
    EXPECT_EQ(difference(made, grey, 0x494955, false), 0);
}

TEST(x11_colormap, grays_of_a_full_map) {
    const xvfb server("301x207x8", {"-cc", "1"});
    L3D_REQUIRE_SERVER(server);
    greedy other;
    other.take_for_itself();
    const auto made = make_map();
    EXPECT_FALSE(made.map->is_shared());
    EXPECT_TRUE(made.map->info().describe().ends_with("256 grays"));
    for (std::uint32_t value : {0U, 1U, 77U, 254U, 255U})
        EXPECT_EQ(
            difference(made, made.map->info().to_display(value * 0x010101), value * 0x010101, true),
            0);
}

/// The maps that the display's hardware uses now.
std::vector<Colormap> installed_maps(const onlooker& other) {
    int count = 0;
    Colormap* list = XListInstalledColormaps(other.display(), other.root(), &count);
    std::vector<Colormap> maps(list, list + count);
    XFree(list);
    return maps;
}

/// Where no window manager does it, the window shows its colours itself, once it has the focus.
TEST(x11_colormap, is_installed_if_nobody_else_does) {
    const xvfb server("301x207x8", no_render);
    L3D_REQUIRE_SERVER(server);
    greedy other;
    other.take_for_itself();
    const onlooker looker;
    const auto before = installed_maps(looker);
    auto made = make_map();
    EXPECT_EQ(installed_maps(looker), before);
    made.map.reset();
    l3d_service refusal;
    const auto window =
        x11_window::open(std::move(made.connection), made.visual, {odd_size, "map"}, refusal);
    ASSERT_NE(window, nullptr) << refusal.why;
    EXPECT_FALSE(window->colormap().is_shared());
    window->map();
    window->take_focus();
    XSync(window->display(), False);
    EXPECT_EQ(installed_maps(looker), std::vector{window->colormap().id()});
}

/// A visual that is not the default one has a map of its own.
TEST(x11_colormap, other_visuals_own_their_map) {
    const xvfb server("301x207x8", {"-cc", "0"});
    L3D_REQUIRE_SERVER(server);
    for (const auto color_class : {gray_scale, pseudo_color, static_color}) {
        const auto made = make_map(color_class);
        EXPECT_FALSE(made.map->is_shared());
        for (const std::uint32_t word : {0x000000U, 0xFFFFFFU, 0x555555U})
            EXPECT_LE(difference(made, made.map->info().to_display(word), word, true), 25.5)
                << l3d_name_of(color_class);
    }
}

TEST(x11_colormap, of_a_server_that_went_away) {
    for (const auto color_class :
         {static_gray, gray_scale, static_color, pseudo_color, true_color, direct_color}) {
        xvfb server("301x207x8", {"-cc", std::to_string(static_cast<int>(color_class))});
        L3D_REQUIRE_SERVER(server);
        const auto made = make_map();
        server.end(SIGKILL);
        // Requests that need no answer may be done before it is known.
        l3d_service refusal;
        if (x11_colormap::make(*made.connection, made.visual, refusal) == nullptr) {
            EXPECT_EQ(refusal.how, l3d_service::level::display_lost);
            EXPECT_TRUE(made.connection->lost());
        } else {
            EXPECT_TRUE(color_class == true_color || color_class == direct_color);
        }
    }
}

} // namespace
