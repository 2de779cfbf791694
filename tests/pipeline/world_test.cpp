// SPDX-License-Identifier: MIT
// Objects, worlds and the painter: the rows of the book's table from "Original vs. transformed" on.
#include "pipeline/worlds/world.h"

#include "geom/polygon_shapes.h"
#include "raster/shapes/rasterizer_2d_sw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace {

using real = l3d_real;

double uniform(std::mt19937& random) {
    return static_cast<double>(random()) / 0x1p31 - 1;
}

/// Turns 10 degrees about x per update of the book, at (x, 1, 1), as in fltsim.
class pyramid final : public l3d_object {
public:
    explicit pyramid(double x) : l3d_object(l3d_pyramid_mesh()) {
        set_transform(1, l3d_translation<real>(x, 1, 1));
    }

private:
    void do_update(double seconds) override {
        degrees_ += 10 * l3d_book_rate * seconds;
        set_transform(0, l3d_rotation_x<real>(degrees_));
    }
    std::unique_ptr<l3d_object> do_clone() const override {
        return std::make_unique<pyramid>(*this);
    }

    double degrees_ = 0;
};

/// A rectangle at z that fills x and y, clockwise from the viewer.
std::unique_ptr<l3d_object> card(double x0, double y0, double x1, double y1, double z,
                                 std::uint32_t color) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
    mesh.add_face({{0, 1, 2, 3}});
    mesh.face_colors = {color};
    return std::make_unique<l3d_object>(std::move(mesh));
}

/// A picture in memory.
struct picture {
    explicit picture(l3d_size size)
        : words(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)),
          pixels{words.data(), size.width, size.height, size.width}, imp(pixels), rasterizer(imp) {}
    std::uint32_t at(int x, int y) const {
        return words[static_cast<std::size_t>(y * pixels.width + x)];
    }

    std::vector<std::uint32_t> words;
    l3d_pixels pixels;
    l3d_rasterizer_2d_sw_imp imp;
    l3d_rasterizer_2d rasterizer;
};

/// The camera of fltsim.
l3d_camera_left_handed<real> camera_at(double x, double y, double z, l3d_size size) {
    l3d_camera_left_handed<real> camera(size);
    camera.place = l3d_point<real>::of(x, y, z);
    return camera;
}

/// Row "Projection": the values of the reference, and row "Shared vertices".
TEST(book_world, projection_of_fltsim) {
    const l3d_size size{640, 400};
    pyramid object(1);
    object.update(1 / l3d_book_rate);
    l3d_facet_list facets;
    facets.begin(camera_at(0, 0, -50, size), size);
    EXPECT_EQ(facets.add(object), 4u); // vertices transformed, not twelve
    ASSERT_EQ(facets.polygons(), 4u);
    const double wanted[4][2] = {
        {325.265, 194.735}, {377.914, 194.735}, {325.092, 144.766}, {324.413, 203.250}};
    for (std::size_t face = 0; face < 4; ++face)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = facets.corners(face)[k];
            const double* const w = wanted[object.mesh().face(face)[k]];
            EXPECT_NEAR(corner.x, w[0], 1e-3);
            EXPECT_NEAR(corner.y, w[1], 1e-3);
        }

    l3d_object plugged(l3d_pyramid_mesh()); // one that turns about z, further away
    plugged.set_transform(0, l3d_rotation_z<real>(1));
    plugged.set_transform(1, l3d_translation<real>(70, 0, 0));
    plugged.set_transform(2, l3d_translation<real>(0, 0, 50));
    facets.begin(camera_at(0, 0, -50, size), size);
    facets.add(plugged);
    EXPECT_NEAR(facets.corners(0)[0].x, 507.958, 1e-3);
    EXPECT_NEAR(facets.corners(0)[0].y, 200, 1e-3);
    EXPECT_NEAR(facets.corners(0)[1].x, 534.805, 1e-3);
    EXPECT_NEAR(facets.corners(0)[1].y, 199.531, 1e-3);
}

/// Row "Numeric facade": whatever l3d_real is, pixels are within half a pixel of double's.
TEST(book_world, numeric_facade) {
    const l3d_size size{640, 400};
    std::mt19937 random(41);
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
        auto camera =
            camera_at(1000 * uniform(random), 1000 * uniform(random), 1000 * uniform(random), size);
        l3d_camera_left_handed<double> exact(size);
        exact.place =
            l3d_point<double>::of(l3d_to_double(camera.place[0]), l3d_to_double(camera.place[1]),
                                  l3d_to_double(camera.place[2]));
        const double yaw = 180 * uniform(random), pitch = 90 * uniform(random);
        camera.turn_about_up(yaw);
        camera.turn_about_right(pitch);
        exact.turn_about_up(yaw);
        exact.turn_about_right(pitch);
        const double p[3] = {1000 * uniform(random), 1000 * uniform(random),
                             1000 * uniform(random)};
        const auto seen_exactly =
            l3d_transformed(exact.viewing_transform(), l3d_point<double>(p[0], p[1], p[2]));
        if (seen_exactly[2] < 5.5)
            continue;
        const auto a = exact.project(seen_exactly, size);
        if (a.x < 0 || a.x >= size.width || a.y < 0 || a.y >= size.height)
            continue;
        ++seen;
        const auto b = camera.project(
            l3d_transformed(camera.viewing_transform(), l3d_point<real>::of(p[0], p[1], p[2])),
            size);
        ASSERT_NEAR(a.x, b.x, 0.5);
        ASSERT_NEAR(a.y, b.y, 0.5);
    }
    EXPECT_GT(seen, 200);
}

/// Row "No projection of z <= near": whatever the camera, corners are finite and not far away.
TEST(book_world, nothing_behind_the_eye_is_projected) {
    const l3d_size size{321, 199};
    std::mt19937 random(43);
    std::size_t drawn = 0;
    picture image(size);
    for (int i = 0; i < 3000; ++i) {
        auto camera =
            camera_at(12 * uniform(random), 12 * uniform(random), 12 * uniform(random), size);
        camera.near_z = i % 3 == 0 ? 0.01 : 1 + 0.9 * uniform(random);
        camera.fovx = 0.5 + 0.45 * uniform(random);
        camera.fovy = 2 + 1.9 * uniform(random);
        camera.turn_about_up(180 * uniform(random));
        camera.turn_about_right(180 * uniform(random));
        l3d_facet_list facets;
        facets.begin(camera, size);
        for (int k = 0; k < 3; ++k) {
            l3d_object object(l3d_pyramid_mesh());
            const double grow = std::exp(4 * uniform(random));
            object.set_transform(0, l3d_scaling<real>(grow, 1, 1 / grow));
            object.set_transform(1, l3d_rotation<real>({uniform(random), 1.1, 0.2}, 172.0 * k));
            facets.add(object);
        }
        for (std::size_t p = 0; p < facets.polygons(); ++p)
            for (const l3d_point_2d& corner : facets.corners(p)) {
                ASSERT_LT(std::abs(corner.x), 0x1p15 + size.width) << "case " << i;
                ASSERT_LT(std::abs(corner.y), 0x1p15 + size.height) << "case " << i;
            }
        facets.draw(image.rasterizer, l3d_draw_order::far_first);
        drawn += facets.polygons();
    }
    EXPECT_GT(drawn, 3000u);
}

/// A floor from below the camera to far away fills the lower half: clipping in front and to the
/// sides loses no pixel.
TEST(book_world, a_cut_polygon_covers_what_is_left) {
    const l3d_size size{101, 67};
    picture image(size);
    l3d_facet_list facets;
    auto camera = camera_at(3, 2, -1, size);
    camera.near_z = 0.5; // there the floor is 200 pixels below the centre
    camera.far_z = 1e7;
    facets.begin(camera, size);
    l3d_polygon_mesh floor;
    floor.vertices = {{-9e4, 0, -80}, {-9e4, 0, 9e6}, {9e4, 0, 9e6}, {9e4, 0, -80}};
    floor.add_face({{0, 1, 2, 3}});
    facets.add(l3d_object(floor));
    ASSERT_EQ(facets.polygons(), 1u);
    facets.draw(image.rasterizer, l3d_draw_order::as_added);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            ASSERT_EQ(image.at(x, y) != 0, y > 33) << x << ',' << y; // the horizon: 33.5
}

TEST(book_world, visibility) {
    const l3d_size size{80, 60};
    for (const bool near_first : {false, true}) {
        l3d_world world(size);
        world.camera.place = l3d_point<real>::of(0, 0, 0);
        auto near = card(-2, -2, 4, 4, 10, 0xff0000);
        auto far = card(-8, -8, 2, 2, 20, 0x0000ff);
        world.add(std::move(near_first ? near : far));
        world.add(std::move(near_first ? far : near));
        picture image(size);
        EXPECT_EQ(world.draw_all({image.rasterizer, image.pixels}), 2u);
        EXPECT_EQ(image.at(41, 29), 0xff0000u);
        EXPECT_EQ(image.at(30, 40), 0x0000ffu);
        world.order = l3d_draw_order::as_added;
        world.draw_all({image.rasterizer, image.pixels});
        EXPECT_EQ(image.at(41, 29), near_first ? 0x0000ffu : 0xff0000u);
    }
    // Equal depth: as added, frame after frame.
    l3d_world world(size);
    world.camera.place = l3d_point<real>::of(0, 0, 0);
    for (std::uint32_t i = 1; i <= 100; ++i)
        world.add(card(-2, -2, 4, 4, 10, i));
    picture image(size);
    for (int frame = 0; frame < 3; ++frame) {
        world.draw_all({image.rasterizer, image.pixels});
        EXPECT_EQ(image.at(41, 29), 100u);
    }
}

TEST(book_world, far_away_is_nothing) {
    const l3d_size size{80, 60};
    l3d_world world(size);
    world.camera.place = l3d_point<real>::of(0, 0, 0);
    world.add(card(-2, -2, 4, 4, 499, 0xff0000));
    world.add(card(-2, -2, 4, 4, 501, 0x0000ff));
    picture image(size);
    EXPECT_EQ(world.draw_all({image.rasterizer, image.pixels}), 1u);
    world.camera.far_z = 502;
    EXPECT_EQ(world.draw_all({image.rasterizer, image.pixels}), 2u);
}

TEST(book_world, no_fixed_limits) {
    const l3d_size size{200, 100};
    l3d_polygon_mesh mesh;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const double x = i % 200 - 100.0, y = i / 200 - 50.0;
        mesh.vertices.insert(mesh.vertices.end(),
                             {{x, y, 100}, {x, y + 1, 100}, {x + 1, y + 1, 100}, {x + 1, y, 100}});
        mesh.add_face({{4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3}});
        mesh.face_colors.push_back(i + 1);
    }
    l3d_world world(size);
    world.camera.place = l3d_point<real>::of(0, 0, 0);
    world.camera.fovx = 0.5; // a unit at z = 100 is a pixel
    world.camera.fovy = 1;
    world.add(std::make_unique<l3d_object>(mesh));
    picture image(size);
    EXPECT_EQ(world.draw_all({image.rasterizer, image.pixels}), 20000u);
    std::size_t covered = 0;
    for (const std::uint32_t word : image.words)
        covered += word != 0;
    EXPECT_EQ(covered, image.words.size());
}

TEST(book_object, geometry_is_never_modified) {
    pyramid object(21);
    const auto before = object.mesh();
    const std::vector<l3d_point<real>> vertices(object.vertices().begin(), object.vertices().end());
    const l3d_size size{64, 40};
    l3d_facet_list facets;
    for (int i = 0; i < 1000000; ++i) {
        object.update(1 / l3d_book_rate);
        if (i % 1000 == 0) {
            facets.begin(camera_at(0, 0, -5, size), size);
            facets.add(object);
        }
    }
    EXPECT_EQ(object.mesh(), before);
    EXPECT_TRUE(std::equal(vertices.begin(), vertices.end(), object.vertices().begin()));
}

TEST(book_object, copies_are_deep) {
    auto original = std::make_unique<pyramid>(1);
    original->name = "first";
    original->update(0.1);
    const auto before = original->modeling_transform();
    auto copy = original->clone();
    EXPECT_NE(dynamic_cast<pyramid*>(copy.get()), nullptr); // of the same class
    EXPECT_EQ(copy->name, "first");
    EXPECT_EQ(copy->modeling_transform(), before);
    copy->set_transform(1, l3d_translation<real>(5, 6, 7));
    copy->update(0.1);
    auto mesh = copy->mesh();
    mesh.vertices[0] = {9, 9, 9};
    copy->set_mesh(mesh);
    EXPECT_EQ(original->modeling_transform(), before);
    EXPECT_EQ(original->mesh(), l3d_pyramid_mesh());
    EXPECT_NE(copy->modeling_transform(), before);
    original.reset();
    EXPECT_EQ(copy->vertices()[0], l3d_point<real>::of(9, 9, 9));
}

TEST(book_object, composite_transform) {
    l3d_object object(l3d_pyramid_mesh());
    EXPECT_EQ(object.modeling_transform(), l3d_identity<real>());
    object.set_transform(2, l3d_translation<real>(10, 0, 0));
    object.set_transform(0, l3d_rotation_z<real>(90));
    const auto p = l3d_point<real>::of(1, 0, 0);
    EXPECT_EQ(l3d_transformed(object.modeling_transform(), p), l3d_point<real>::of(10, 1, 0));
    object.set_transform(1, l3d_scaling<real>(3, 3, 3));
    EXPECT_EQ(l3d_transformed(object.modeling_transform(), p), l3d_point<real>::of(10, 3, 0));
    object.set_transform(2, l3d_translation<real>(0, 0, 4));
    EXPECT_EQ(l3d_transformed(object.modeling_transform(), p), l3d_point<real>::of(0, 3, 4));
}

TEST(book_object, behaviour_by_subclass) {
    pyramid object(41);
    object.update(0);
    const auto start = object.modeling_transform();
    for (int i = 0; i < 36; ++i) {
        object.update(1 / l3d_book_rate);
        if (i == 17) {
            EXPECT_NE(object.modeling_transform(), start);
        }
    }
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k)
            EXPECT_NEAR(l3d_to_double(object.modeling_transform()(i, k)),
                        l3d_to_double(start(i, k)), 1e-6);
}

TEST(book_world, updates_objects_and_camera) {
    l3d_world world({64, 40});
    world.add(std::make_unique<pyramid>(1));
    world.camera.push({0, 0, 1});
    world.update_all(0.1);
    const auto turned = world.objects()[0]->modeling_transform();
    EXPECT_NE(turned, l3d_translation<real>(1, 1, 1));
    const auto place = world.camera.place;
    EXPECT_NE(place, l3d_point<real>::of(50, 5, 50));
    world.frozen = true;
    world.update_all(0.1);
    EXPECT_EQ(world.objects()[0]->modeling_transform(), turned);
    EXPECT_NE(world.camera.place, place);
}

/// Leaves copies of itself, and goes after so many updates.
class spawner final : public l3d_object {
public:
    spawner(l3d_world& world, int lives, int& updates)
        : l3d_object(l3d_pyramid_mesh()), world_(world), lives_(lives), updates_(updates) {}
    ~spawner() override { mark_ = 0; }

private:
    void do_update(double) override {
        ++updates_;
        for (int i = 0; i < 20 && lives_ > 1; ++i) // enough to make any list move
            world_.add(std::make_unique<spawner>(world_, 1, updates_));
        if (--lives_ == 0) {
            EXPECT_TRUE(world_.remove(*this));
            EXPECT_FALSE(world_.remove(*this)); // once is enough
        }
        EXPECT_EQ(mark_, 7); // it lives until its update ends
    }

    l3d_world& world_;
    int lives_, mark_ = 7;
    int& updates_;
};

TEST(book_world, objects_come_and_go_while_they_are_updated) {
    l3d_world world({64, 40});
    int updates = 0;
    world.add(std::make_unique<spawner>(world, 3, updates));
    world.update_all(0.1); // twenty come
    EXPECT_EQ(updates, 1);
    EXPECT_EQ(world.objects().size(), 21u);
    world.update_all(0.1); // they go, and twenty others come
    EXPECT_EQ(updates, 22);
    EXPECT_EQ(world.objects().size(), 21u);
    world.update_all(0.1); // all go
    EXPECT_EQ(updates, 43);
    EXPECT_TRUE(world.objects().empty());
    const l3d_object stranger;
    EXPECT_FALSE(world.remove(stranger));
}

/// Takes another object with it when it goes.
class taker final : public l3d_object {
public:
    taker(l3d_world& world, const l3d_object& other) : world_(world), other_(other) {}
    taker(const taker&) = delete;
    taker& operator=(const taker&) = delete;
    ~taker() override { EXPECT_TRUE(world_.remove(other_)); }
    bool goes = false; ///< with the next update

private:
    void do_update(double) override {
        if (goes) {
            EXPECT_TRUE(world_.remove(*this));
        }
    }

    l3d_world& world_;
    const l3d_object& other_;
};

TEST(book_world, what_goes_may_take_others_with_it) {
    for (const bool while_updated : {false, true}) {
        l3d_world world({64, 40});
        const l3d_object& last = world.add(std::make_unique<l3d_object>());
        const l3d_object& middle = world.add(std::make_unique<taker>(world, last));
        auto owned = std::make_unique<taker>(world, middle);
        taker& first = *owned;
        world.add(std::move(owned));
        world.add(std::make_unique<l3d_object>());
        first.goes = while_updated;
        world.update_all(0.1);
        EXPECT_EQ(world.objects().size(), while_updated ? 1u : 4u);
        if (!while_updated) {
            EXPECT_TRUE(world.remove(first));
        }
        EXPECT_EQ(world.objects().size(), 1u);
    }
}

/// Takes its neighbour out of the world, wherever the two stand in the list.
class remover final : public l3d_object {
public:
    remover(l3d_world& world, const l3d_object*& victim) : world_(world), victim_(victim) {}

private:
    void do_update(double) override {
        if (const l3d_object* const victim = std::exchange(victim_, nullptr)) {
            EXPECT_TRUE(world_.remove(*victim));
        }
    }

    l3d_world& world_;
    const l3d_object*& victim_;
};

TEST(book_world, what_was_removed_is_not_updated) {
    for (const bool victim_first : {false, true}) {
        l3d_world world({64, 40});
        int updates = 0;
        const l3d_object* victim = nullptr;
        if (victim_first)
            victim = &world.add(std::make_unique<spawner>(world, 9, updates));
        world.add(std::make_unique<remover>(world, victim));
        if (!victim_first)
            victim = &world.add(std::make_unique<spawner>(world, 9, updates));
        world.update_all(0.1);
        EXPECT_EQ(updates, victim_first ? 1 : 0);
        EXPECT_EQ(world.objects().size(), victim_first ? 21u : 1u);
    }
}

/// An object that throws leaves the world as whole as it was.
TEST(book_world, goes_on_after_an_object_threw) {
    class thrower final : public l3d_object {
    public:
        explicit thrower(l3d_world& world) : world_(world) {}

    private:
        void do_update(double) override {
            world_.remove(*this);
            throw 1;
        }
        l3d_world& world_;
    };
    l3d_world world({64, 40});
    world.add(std::make_unique<thrower>(world));
    EXPECT_THROW(world.update_all(0.1), int);
    EXPECT_TRUE(world.objects().empty());
    world.update_all(0.1);
}

/// The book's portals override these two, and its cameras override update.
TEST(book_world, what_the_book_overrides_can_be_overridden) {
    class falling final : public l3d_world::camera_type {
    public:
        using l3d_world::camera_type::l3d_camera_left_handed;
        void update(double seconds) override {
            place += l3d_point<real>::of(0, -10 * seconds, 0).from_origin;
        }
    };
    class twice final : public l3d_world {
    public:
        explicit twice(l3d_size size) : l3d_world(std::make_unique<falling>(size)) {}
        void update_all(double seconds) override { l3d_world::update_all(2 * seconds); }
        std::size_t draw_all(const l3d_world_target& target) override {
            return 100 + l3d_world::draw_all(target);
        }
    };
    twice own({64, 40});
    l3d_world& world = own;
    world.camera.place = l3d_point<real>::of(0, 0, 0);
    world.update_all(0.5);
    EXPECT_NEAR(l3d_to_double(world.camera.place[1]), -10, 1e-6);
    picture image({64, 40});
    EXPECT_EQ(world.draw_all({image.rasterizer, image.pixels}), 100u);
}

TEST(book_object, moves_with_its_parent) {
    auto sun = std::make_unique<l3d_object>(), earth = std::make_unique<l3d_object>();
    l3d_object moon;
    EXPECT_TRUE(earth->set_parent(sun.get()));
    EXPECT_TRUE(moon.set_parent(earth.get()));
    EXPECT_EQ(moon.parent(), earth.get());
    sun->set_transform(0, l3d_translation<real>(0, 0, 100));
    earth->set_transform(0, l3d_translation<real>(10, 0, 0));
    earth->set_transform(1, l3d_rotation_z<real>(90));
    moon.set_transform(0, l3d_translation<real>(1, 0, 0));
    const auto centre = l3d_point<real>::of(0, 0, 0);
    EXPECT_EQ(l3d_transformed(moon.world_transform(), centre), l3d_point<real>::of(0, 11, 100));
    EXPECT_EQ(l3d_transformed(moon.modeling_transform(), centre), l3d_point<real>::of(1, 0, 0));
    sun->set_transform(0, l3d_translation<real>(0, 0, 200));
    EXPECT_EQ(l3d_transformed(moon.world_transform(), centre), l3d_point<real>::of(0, 11, 200));
    // No circles.
    EXPECT_FALSE(sun->set_parent(&moon));
    EXPECT_FALSE(sun->set_parent(sun.get()));
    EXPECT_EQ(sun->parent(), nullptr);
    // A copy hangs from the same parent and has no children; who loses a parent stands alone.
    const auto copy = earth->clone();
    EXPECT_EQ(copy->parent(), sun.get());
    sun.reset();
    EXPECT_EQ(earth->parent(), nullptr);
    EXPECT_EQ(copy->parent(), nullptr);
    EXPECT_EQ(l3d_transformed(moon.world_transform(), centre), l3d_point<real>::of(0, 11, 0));
    earth.reset();
    EXPECT_EQ(moon.parent(), nullptr);
}

} // namespace
