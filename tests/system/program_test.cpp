// SPDX-License-Identifier: MIT
// l3d_program: the steps run if there is something to show, and no exception leaves main.
#include "system/program.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <stdexcept>

namespace {

/// Runs a program with the memory back-end; returns its exit code and counts its steps.
int run(std::initializer_list<const char*> arguments, int& runs,
        const std::function<l3d_exit(l3d_program&)>& steps) {
    l3d_program program("sketch", "Draws nothing.", {53, 31});
    std::vector<const char*> line{"sketch", "--backend", "memory"};
    line.insert(line.end(), arguments);
    return program.run(static_cast<int>(line.size()), line.data(), [&] {
        ++runs;
        return steps(program);
    });
}

l3d_exit nothing(l3d_program&) {
    return l3d_exit::success;
}

} // namespace

TEST(program, gives_the_steps_what_the_command_line_says) {
    int runs = 0;
    EXPECT_EQ(run({"--size", "19x7", "--seed", "77"}, runs,
                  [](l3d_program& program) {
                      EXPECT_EQ(program.seed(), 77u);
                      const l3d_canvas canvas = program.create_canvas();
                      EXPECT_EQ(canvas.screen->pixels().size(), (l3d_size{19, 7}));
                      EXPECT_NE(canvas.rasterizers->create_2d(canvas.screen->pixels()), nullptr);
                      EXPECT_NE(program.create_dispatcher(), nullptr);
                      return l3d_exit::success;
                  }),
              0);
    EXPECT_EQ(runs, 1);
}

TEST(program, leaves_the_steps_out_if_there_is_nothing_to_show) {
    int runs = 0;
    EXPECT_EQ(run({"--version"}, runs, nothing), 0);
    EXPECT_EQ(run({"--list-backends"}, runs, nothing), 0);
    EXPECT_EQ(run({"--size", "0x5"}, runs, nothing), static_cast<int>(l3d_exit::usage));
    EXPECT_EQ(runs, 0);
}

TEST(program, returns_the_exit_code_of_what_went_wrong) {
    int runs = 0;
    EXPECT_EQ(run({}, runs, [](l3d_program&) { return l3d_exit::display_lost; }),
              static_cast<int>(l3d_exit::display_lost));
    EXPECT_EQ(run({}, runs,
                  [](l3d_program&) -> l3d_exit {
                      throw l3d_error(l3d_exit::bad_input, "spikes.asc:7: no number");
                  }),
              static_cast<int>(l3d_exit::bad_input));
    EXPECT_EQ(run({}, runs, [](l3d_program&) -> l3d_exit { throw std::runtime_error("no"); }),
              static_cast<int>(l3d_exit::failure));
    EXPECT_EQ(runs, 3);
}
