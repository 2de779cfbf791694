// SPDX-License-Identifier: MIT
// l3d_options: wraps CLI11, which is slow to compile and which no other source includes.
#include "system/options/options.h"

#include "base/did_you_mean_p.h"
#include "base/printable_p.h"
#include "base/version.h"

#include "geom/real.h"
#include "system/options/color_text_p.h"
#include "system/frame_writer.h"
#include "system/options/number_text.h"
#include "system/options/output_names_p.h"
#include "system/reason_p.h"
#include "system/standard_output_p.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <fcntl.h>
#include <iostream>
#include <limits>
#include <sstream>
#include <type_traits>
#include <utility>

struct l3d_options::parser {
    CLI::App app;
};

namespace {

/// The long name "--long" of an option "-s,--long", for messages.
std::string long_name(const std::string& name) {
    return name.substr(name.rfind(',') + 1);
}

[[noreturn]] void refuse(const std::string& name, const std::string& text,
                         const std::string& wanted) {
    throw l3d_error(l3d_exit::usage, long_name(name) + ": '" + text + "' is not " + wanted);
}

/// Adds an option whose value `read` converts. The conversions of the library CLI11 refuse neither
/// NaN nor numbers out of a range, and their messages leave out the value.
void add_text(CLI::App& app, const std::string& name, const std::string& help,
              const std::string& kind, const std::string& preset,
              const std::function<void(const std::string&)>& read) {
    app.add_option_function<std::string>(name, read, help)
        ->type_name(kind)
        ->default_str(preset)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

/// Columns of --help: the width of a terminal, and the place where the options' texts begin.
constexpr std::size_t help_width = 80, help_indent = 26;
constexpr const char* first_heading = "Help";

/// Breaks a text's words into lines of at most `width` columns.
std::string wrapped(const std::string& text, std::size_t width) {
    std::istringstream words(text);
    std::string result, line;
    for (std::string word; words >> word; line += word) {
        if (!line.empty() && line.size() + 1 + word.size() > width)
            result += std::exchange(line, "") + '\n';
        line += line.empty() ? "" : " ";
    }
    return result + line;
}

/// Formats --help in lines that fit a terminal. The text has no section of positional arguments,
/// which would list options a second time.
class help_formatter : public CLI::Formatter {
    std::string make_positionals(const CLI::App*) const override { return ""; }
    /// The text of a group of options, with one blank line before it; CLI11 itself has two blank
    /// lines.
    std::string make_group(std::string heading, bool is_positional,
                           std::vector<const CLI::Option*> options) const override {
        const std::string group = Formatter::make_group(heading, is_positional, options);
        return heading == first_heading ? group : group.substr(1);
    }
    std::string make_option_desc(const CLI::Option* option) const override {
        return wrapped(option->get_description(), help_width - help_indent);
    }
};

/// Adds an option with a number from `least` to `most`. `preset` is the default as text, since some
/// options have no default.
template <class T, class Value>
void add_number(CLI::App& app, const std::string& name, Value& value, const std::string& preset,
                const std::string& help, const std::string& kind, T least, T most) {
    const auto read = [name, &value, least, most](const std::string& text) {
        T number{};
        if (!l3d_read_number(text, number) || !(number >= least && number <= most))
            refuse(name, text,
                   (std::is_integral_v<T> ? "a whole number from " : "a number from ") +
                       l3d_number_text(least) + " to " + l3d_number_text(most));
        value = number;
    };
    add_text(app, name, help, kind, preset, read);
}

l3d_vector<double, 3> read_vector(const std::string& name, const std::string& text) {
    std::array<double, 3> numbers{};
    if (!l3d_read_numbers(text, ',', numbers))
        refuse(name, text, "three numbers X,Y,Z");
    return {numbers[0], numbers[1], numbers[2]};
}

void print(std::ostream& out, const std::string& text) {
    out << text;
    l3d_detail::check_written(out);
}

/// Refuses "--name=", for which CLI11 would take the next argument as the value.
void refuse_empty_value(const std::string& argument) {
    if (argument.rfind("--", 0) == 0 && argument.find('=') == argument.size() - 1)
        throw l3d_error(l3d_exit::usage, argument.substr(0, argument.size() - 1) + ": '' is empty");
}

/// Refuses the first argument that no option took, if there is any. Arguments after "--" are no
/// options.
void refuse_what_is_left(const CLI::App& app) {
    const std::vector<std::string> left = app.remaining();
    const bool are_options = left.empty() || left.front() != "--";
    if (left.size() == (are_options ? 0U : 1U))
        return;
    const std::string& first = left[are_options ? 0 : 1];
    if (!are_options || !first.starts_with('-'))
        throw l3d_error(l3d_exit::usage, "one argument too many: '" + first + "' (see --help)");
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    throw l3d_error(l3d_exit::usage,
                    "unknown option '" + first + '\'' +
                        l3d_detail::did_you_mean(first.substr(0, first.find('=')), names) +
                        " (see --help)");
}

/// Opens the file descriptors 0, 1 and 2 on /dev/null if they are closed. /dev/null is opened for
/// reading only, so that writing to a closed standard output is still an error.
void open_standard_streams() {
    for (int descriptor = 0; descriptor < 3; ++descriptor)
        if (fcntl(descriptor, F_GETFD) == -1)
            // The lowest free number is this one. A process without /dev/null has to live without
            // it.
            static_cast<void>(open("/dev/null", O_RDONLY));
}

} // namespace

l3d_options::l3d_options(std::string program, const std::string& purpose, l3d_size default_size)
    : program_(std::move(program)), command_(program_), parser_(std::make_unique<parser>()) {
    parser_->app.description(purpose);
    begin_group(first_heading);
    parser_->app.set_help_flag("-h,--help", "this text");
    parser_->app.set_version_flag(
        "--version", program_ + " (l3d) " + L3D_VERSION_TEXT + ", real numbers: " + l3d_real_name(),
        "the version");
    parser_->app.allow_extras();
    parser_->app.formatter(std::make_shared<help_formatter>());
    parser_->app.get_formatter()->column_width(help_indent);
    add_common(default_size);
}

l3d_options::~l3d_options() = default;

void l3d_options::add_common(l3d_size default_size) {
    common_.size = default_size;
    CLI::App& app = parser_->app;
    add("--list-backends", common_.list_backends, "list them and whether they can serve here");
    add("--diagnose", common_.diagnose, "tell all that the choice of a back-end depends on");
    add("--verbose", common_.verbose, "tell what was chosen");
    begin_group("Back-end and window");
    add_text(app, "--backend", "what shows the pictures; see --list-backends", "NAME", "",
             [this](const std::string& text) { common_.backend = text; });
    add("--no-input", common_.no_input, "never ask anything");
    add("--size", common_.size, "size of the picture");
    add_number(
        app, "--scale", common_.scale, "",
        "side of a pixel in the window, in the display's pixels; without it, the window grows as "
        "Xft.dpi exceeds 96",
        "NUMBER", 1, l3d_largest_scale);
    add("--title", common_.title,
        "title of the window (without it, what it shows, and the program)", "TEXT");
    add_choice("--remote", common_.remote,
               "send only what changed, coarse while it moves, and share no memory; auto: if the "
               "display is reached over a network",
               {{"auto", l3d_remote::automatic}, {"on", l3d_remote::on}, {"off", l3d_remote::off}});
    add_number(app, "--fps", common_.fps, "",
               "frames per second; 0: no limit (without it 60, or 15 on a remote display)",
               "NUMBER", 0.0, 1000.0);
    begin_group("Pictures and sequences");
    add("--output", common_.output,
        "write the last frame (.png, .ppm), every frame (frame%04d.png), or - for a PPM stream",
        "FILE");
    add_batch();
    add_number(app, "--seed", common_.seed, l3d_number_text(common_.seed),
               "where random numbers start", "NUMBER", std::uint64_t{0},
               std::numeric_limits<std::uint64_t>::max());
    begin_group("Of this program");
}

void l3d_options::begin_group(const std::string& heading) {
    parser_->app.option_defaults()->group(heading);
}

void l3d_options::add_note(const std::string& text) {
    notes_.push_back(text);
}

void l3d_options::add_example(const std::string& arguments, const std::string& purpose) {
    examples_.push_back({arguments, purpose});
}

std::string l3d_options::end_of_help() const {
    std::string text;
    for (const std::string& note : notes_)
        text += wrapped(note, help_width) + "\n\n";
    text += wrapped("Environment: DISPLAY; L3D_BACKEND, as --backend; L3D_NO_SHM, if not empty: "
                    "share no memory with the display; L3D_MESA=auto|egl|osmesa, where to look for "
                    "software GL; L3D_FONT=FILE|built-in, for text on panels; "
                    "L3D_PLUGIN_PATH, folders with plug-ins for STEP and IGES.",
                    help_width);
    if (!examples_.empty())
        text += "\n\nExamples:";
    for (const example& each : examples_)
        text += "\n  " + command_ + ' ' + each.arguments + "\n      " + each.purpose;
    return text;
}

/// Adds the options for a process that makes only some frames of a sequence, or only frames that
/// are missing.
void l3d_options::add_batch() {
    const auto read = [this](const std::string& text) {
        std::array<int, 2> range{};
        const bool is_range = text.find(':') != std::string::npos;
        const bool read_it =
            is_range ? l3d_read_numbers(text, ':', range) : l3d_read_number(text, range[1]);
        if (!read_it || range[0] < 0 || range[1] < range[0] || (is_range && range[0] == range[1]))
            refuse("--frames", text, "a number of frames, nor A:B with A less than B");
        common_.first_frame = range[0];
        common_.frames = range[1];
    };
    add_text(parser_->app, "--frames",
             "stop after so many frames, in fixed steps of time; 0: go on (without a display: 1); "
             "A:B: only those from number A to B - 1, each as it is in the whole sequence",
             "N|A:B", "0", read);
    add("--resume", common_.resume,
        "leave out frames whose file is there, whole and of this size; with a numbered --output");
}

void l3d_options::add(const std::string& name, double& value, const std::string& help, double least,
                      double most) {
    add_number(parser_->app, name, value, l3d_number_text(value), help, "NUMBER", least, most);
}

void l3d_options::add(const std::string& name, int& value, const std::string& help, int least,
                      int most) {
    add_number(parser_->app, name, value, l3d_number_text(value), help, "NUMBER", least, most);
}

void l3d_options::add(const std::string& name, std::optional<int>& value, const std::string& help,
                      int least, int most) {
    add_number(parser_->app, name, value, "", help, "NUMBER", least, most);
}

void l3d_options::add(const std::string& name, std::optional<double>& value, double preset,
                      const std::string& help, double least, double most) {
    add_number(parser_->app, name, value, l3d_number_text(preset), help, "NUMBER", least, most);
}

void l3d_options::add(const std::string& name, std::string& value, const std::string& help,
                      const std::string& kind) {
    add_text(parser_->app, name, help, kind, value, [name, kind, &value](const std::string& text) {
        if (text.empty())
            refuse(name, text, "a " + kind);
        value = text;
    });
    if (kind == "FILE")
        files_.push_back({long_name(name), &value});
}

void l3d_options::add(const std::string& name, bool& value, const std::string& help) {
    parser_->app.add_flag(name, value, help);
}

void l3d_options::add(const std::string& name, l3d_vector<double, 3>& value,
                      const std::string& help) {
    const std::string preset = l3d_number_text(value[0]) + ',' + l3d_number_text(value[1]) + ',' +
                               l3d_number_text(value[2]);
    add_text(parser_->app, name, help, "X,Y,Z", preset,
             [name, &value](const std::string& text) { value = read_vector(name, text); });
}

void l3d_options::add(const std::string& name, std::optional<l3d_vector<double, 3>>& value,
                      const std::string& help) {
    add_text(parser_->app, name, help, "X,Y,Z", "",
             [name, &value](const std::string& text) { value = read_vector(name, text); });
}

void l3d_options::add(const std::string& name, std::optional<l3d_vector<double, 2>>& value,
                      const std::string& help) {
    add_text(parser_->app, name, help, "X,Y", "", [name, &value](const std::string& text) {
        std::array<double, 2> numbers{};
        if (!l3d_read_numbers(text, ',', numbers))
            refuse(name, text, "two numbers X,Y");
        value = {numbers[0], numbers[1]};
    });
}

void l3d_options::add(const std::string& name, std::optional<l3d_background>& value,
                      const std::string& help) {
    const auto read = [name, &value](const std::string& text) {
        if (text == "gradient")
            value = l3d_background::gradient();
        else if (text == "none")
            value = l3d_background::none();
        else if (const auto color = l3d_detail::read_paint(text))
            value = l3d_background::color(*color);
        else
            refuse(name, text,
                   std::string("gradient, none or ") + l3d_detail::color_forms +
                       l3d_detail::meant_color(text));
    };
    const auto read_and_tell = [this, read, &value](const std::string& text) {
        read(text);
        common_.alpha = value->is_none() ? l3d_alpha::transparency : l3d_alpha::none;
    };
    add_text(parser_->app, name, help, std::string("gradient|none|") + l3d_detail::color_kind, "",
             read_and_tell);
}

void l3d_options::add(const std::string& name, l3d_size& value, const std::string& help) {
    const std::string preset = std::to_string(value.width) + 'x' + std::to_string(value.height);
    const auto read = [name, &value](const std::string& text) {
        const auto fits = [](int side) { return side >= 1 && side <= l3d_largest_side; };
        std::array<int, 2> sides{};
        if (!l3d_read_numbers(text, 'x', sides) || !fits(sides[0]) || !fits(sides[1]))
            refuse(name, text, "WIDTHxHEIGHT, each from 1 to " + std::to_string(l3d_largest_side));
        value = {sides[0], sides[1]};
    };
    add_text(parser_->app, name, help, "WxH", preset, read);
}

void l3d_options::add_each(const std::string& name, const std::string& help,
                           const std::string& kind, const std::string& preset,
                           std::function<void(const std::string&)> take) {
    const auto read = [take = std::move(take)](const std::vector<std::string>& texts) {
        for (const std::string& text : texts)
            take(text);
    };
    parser_->app.add_option_function<std::vector<std::string>>(name, read, help)
        ->type_name(kind)
        ->default_str(preset)
        ->expected(1)
        ->allow_extra_args(false) // the next word is an argument of its own
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void l3d_options::add_words(const std::string& name, const std::string& help,
                            const std::vector<std::string>& words, std::size_t preset,
                            std::function<void(std::size_t)> chosen) {
    std::string list;
    for (const std::string& word : words)
        list += (list.empty() ? "" : "|") + word;
    const auto read = [name, words, list, chosen = std::move(chosen)](const std::string& text) {
        const auto found = std::find(words.begin(), words.end(), text);
        if (found == words.end())
            refuse(name, text, "one of " + list + l3d_detail::did_you_mean(text, words));
        chosen(static_cast<std::size_t>(found - words.begin()));
    };
    add_text(parser_->app, name, help, list, words.at(preset), read);
}

bool l3d_options::wants_result() const {
    return std::ranges::any_of(with_results_,
                               [&](const auto& name) { return parser_->app.count(name) > 0; });
}

bool l3d_options::parse(int argc, const char* const* argv) {
    open_standard_streams();
    return parse(argc, argv, std::cout);
}

bool l3d_options::parse(int argc, const char* const* argv, std::ostream& out) {
    if (argc > 0 && argv[0] && *argv[0])
        command_ = l3d_detail::printable(std::filesystem::path(argv[0]).filename().string());
    parser_->app.name(command_);
    parser_->app.footer(end_of_help());
    // The library takes the arguments in reverse order.
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    std::for_each(arguments.begin(), std::ranges::find(arguments, "--"), refuse_empty_value);
    std::ranges::reverse(arguments);
    try {
        parser_->app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        print(out, parser_->app.help());
        return false;
    } catch (const CLI::CallForVersion& version) {
        print(out, std::string(version.what()) + '\n');
        return false;
    } catch (const CLI::ParseError& error) {
        throw l3d_error(l3d_exit::usage, std::string(error.what()) + " (see --help)");
    }
    refuse_what_is_left(parser_->app);
    refuse_one_file_for_two();
    // The writer is made early, so that faults in --output are told before the user is asked for a
    // back-end.
    const l3d_frame_writer frames(common_.output, common_.alpha);
    for (const named_file& file : files_)
        if (file.value != &common_.output && frames.has_frame_in(*file.value))
            throw l3d_error(l3d_exit::usage, file.option + ": '" + *file.value +
                                                 "' is the file of a frame of --output, too");
    if (common_.resume && !frames.is_numbered())
        throw l3d_error(l3d_exit::usage,
                        "--resume: needs a numbered --output, as in frame%04d.png");
    return true;
}

void l3d_options::refuse_one_file_for_two() const {
    for (auto second = files_.begin(); second != files_.end(); ++second)
        for (auto first = files_.begin(); first != second; ++first)
            if (l3d_detail::mean_one_file(*first->value, *second->value))
                throw l3d_error(l3d_exit::usage, second->option + ": '" + *second->value +
                                                     "' is the file of " + first->option + ", too");
    for (const std::string& name : printed_)
        for (const named_file& file : files_)
            if (parser_->app.count(name) > 0 && *file.value == "-")
                throw l3d_error(l3d_exit::usage, name +
                                                     ": its text goes to the standard output, "
                                                     "as that of " +
                                                     file.option + " does");
}

l3d_screen_request l3d_options::screen_request() const {
    // Pictures that are counted or written have exactly the wanted size, whatever the display.
    const bool is_exact = common_.frames != 0 || !common_.output.empty();
    const int scale = common_.scale == 0 && is_exact ? 1 : common_.scale;
    return {.size = common_.size,
            .title = common_.title.empty() ? program_ : common_.title,
            .name = program_,
            .scale = scale,
            .remote = common_.remote};
}

l3d_frame_settings l3d_options::frame_settings() const {
    return {.frames = common_.frames,
            .first_frame = common_.first_frame,
            .resume = common_.resume,
            .fps = common_.fps,
            .fixed_step = common_.frames > 0,
            .output = common_.output,
            .alpha = common_.alpha,
            .program = command_};
}

int l3d_report(std::string_view program, const std::exception& error) {
    std::cerr << program << ": " << l3d_detail::printable(l3d_detail::reason_of(error)) << '\n';
    const auto* known = dynamic_cast<const l3d_error*>(&error);
    return static_cast<int>(known ? known->code() : l3d_exit::failure);
}

int l3d_report(std::string_view program, l3d_exit code) {
    if (code == l3d_exit::display_lost)
        std::cerr << program << ": the display was lost\n";
    return static_cast<int>(code);
}
