// SPDX-License-Identifier: MIT
// l3d_options: the command line that all programs share, with room for a program's own options.
#ifndef L3D_SYSTEM_OPTIONS_OPTIONS_H
#define L3D_SYSTEM_OPTIONS_OPTIONS_H

#include "base/public.h"
#include "geom/vector.h"
#include "raster/background.h"
#include "base/error.h"
#include "tool_2d/pixels.h"
#include "tool_2d/screen.h"
#include "system/frame_writer.h"

#include <initializer_list>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The values of the options that every program has.
struct L3D_PUBLIC l3d_common_options {
    std::string backend;               ///< a back-end's name, "ask" or "auto"; empty: not given
    std::string usual_backend{};       ///< taken if the user names none; empty: any that serves
    bool no_input = false;             ///< never ask anything
    bool list_backends = false;        ///< list the back-ends and end
    bool diagnose = false;             ///< tell what the choice of a back-end depends on, and end
    bool verbose = false;              ///< tell what was chosen
    l3d_size size{};                   ///< size of the picture, in pixels
    int scale = 0;                     ///< display pixels along the side of a pixel; 0: not given
    std::string title{};               ///< title of the window; empty: the program's choice
    l3d_remote remote{};               ///< whether pictures travel sparingly
    int first_frame = 0;               ///< number of the first frame that is drawn
    int frames = 0;                    ///< number of frames, the end of a range; 0: go on
    bool resume = false;               ///< leave out frames whose file is there
    std::optional<double> fps;         ///< frames per second, 0: no limit; nothing: not given
    std::uint64_t seed = 1;            ///< the number that random numbers start with
    l3d_alpha alpha = l3d_alpha::none; ///< whether files hold transparency
    std::string output; ///< file of the last picture, of every picture, or "-"; empty: none
};

/// A command line: declared with add(), then read once with parse().
///
/// Every add() borrows a variable. Its present value is the default that --help prints, and parse()
/// replaces it. `name` is "--long" or "-s,--long".
/// Expects: the variables outlive parse(); names are not used twice.
class L3D_PUBLIC l3d_options {
public:
    /// Declares the options that all programs have. --help prints `purpose`.
    l3d_options(std::string program, const std::string& purpose, l3d_size default_size);
    l3d_options(const l3d_options&) = delete;
    l3d_options& operator=(const l3d_options&) = delete;
    ~l3d_options();

    /// Begins a group of options: --help lists those that are added from now on under this heading.
    void begin_group(const std::string& heading);

    /// Adds a paragraph at the end of --help, such as the meaning of a word in capitals.
    void add_note(const std::string& text);

    /// Adds an example at the end of --help: arguments of the program, and their purpose.
    void add_example(const std::string& arguments, const std::string& purpose);

    /// A number from `least` to `most`; NaN and trailing text are refused.
    void add(const std::string& name, double& value, const std::string& help, double least,
             double most);
    /// A whole number from `least` to `most`.
    void add(const std::string& name, int& value, const std::string& help, int least, int most);

    /// A whole number that may be absent, since its default is found out later, if at all.
    void add(const std::string& name, std::optional<int>& value, const std::string& help, int least,
             int most);

    /// A number that may be absent; --help prints `preset`.
    void add(const std::string& name, std::optional<double>& value, double preset,
             const std::string& help, double least, double most);

    /// Any text but the empty one; --help calls it `kind`, such as FILE. If the name begins with
    /// "FILE,", the user may give one such text without the option's name.
    void add(const std::string& name, std::string& value, const std::string& help,
             const std::string& kind);

    /// A flag: true when given.
    void add(const std::string& name, bool& value, const std::string& help);

    /// Three finite numbers X,Y,Z.
    void add(const std::string& name, l3d_vector<double, 3>& value, const std::string& help);
    /// An option that may be given several times. `take` gets each text in turn. It throws an
    /// l3d_error that names the text if it refuses that. --help prints `preset`.
    void add_each(const std::string& name, const std::string& help, const std::string& kind,
                  const std::string& preset, std::function<void(const std::string&)> take);

    /// A background: "gradient", "none", or a colour. A colour is R,G,B of whole numbers from 0 to
    /// 255, #RGB, #RRGGBB or a name of CSS. The value stays empty unless given, and `help` says
    /// what that means. With "none", written files have alpha.
    void add(const std::string& name, std::optional<l3d_background>& value,
             const std::string& help);

    /// Three numbers that may be absent, since their default is found out later.
    void add(const std::string& name, std::optional<l3d_vector<double, 3>>& value,
             const std::string& help);

    /// Two finite numbers X,Y, which may be absent.
    void add(const std::string& name, std::optional<l3d_vector<double, 2>>& value,
             const std::string& help);

    /// A size WIDTHxHEIGHT, each from 1 to l3d_largest_side.
    void add(const std::string& name, l3d_size& value, const std::string& help);

    /// One of a few words, each meaning a value, as in {{"afd", kind::afd}, {"exact",
    /// kind::exact}}.
    /// Expects: `value` is among them.
    template <class T>
    void add_choice(const std::string& name, T& value, const std::string& help,
                    const std::vector<std::pair<std::string, T>>& choices);

    /// Reads the command line. Returns false if --help or --version was printed, and the program
    /// should end well. Standard streams that are closed are first opened on /dev/null. Otherwise a
    /// socket would get the number of a standard stream, and all that is printed.
    ///
    /// Errors:  l3d_error(usage) that names the option and the value; also if two options name one
    ///          file, or the standard output.
    bool parse(int argc, const char* const* argv);
    /// Reads the command line, and prints --help and --version on `out`.
    bool parse(int argc, const char* const* argv, std::ostream& out);

    /// Says that an option has a result beside pictures, such as a report. Expects: the option was
    /// added.
    void has_result(const std::string& name) { with_results_.push_back(name); }

    /// As has_result(), for a result on the standard output. Then no file may go there.
    /// Expects: the option was added.
    void prints_result(const std::string& name) {
        has_result(name);
        printed_.push_back(name);
    }

    /// Whether the command line has an option that has_result() named.
    bool wants_result() const;

    /// The program's name, for titles and files.
    const std::string& program() const { return program_; }

    /// The command that the user typed, without its folder, for --help and messages.
    const std::string& command() const { return command_; }
    /// The values of the options that all programs have. Expects: parse() is done.
    const l3d_common_options& common() const { return common_; }

    /// Replaces --output, for a program or factory manager that has a better default.
    void set_output(const std::string& name) { common_.output = name; }

    /// Sets the back-end that is taken unless the user names one.
    void prefer_backend(const std::string& name) { common_.usual_backend = name; }

    /// Sets a function that hears of a model file while it is read: its name, and the share that is
    /// done, from 0 to 1. Reading ends if it returns false.
    void watch_loads(std::function<bool(const std::string& file, double share)> watch) {
        load_watch_ = std::move(watch);
    }
    /// The function that watch_loads() set; empty if there is none.
    const std::function<bool(const std::string& file, double share)>& load_watch() const {
        return load_watch_;
    }

    /// The request for a screen. Its title is the program's name unless the user gives another.
    l3d_screen_request screen_request() const;

    /// The settings of a dispatcher. With --frames, time goes by fixed steps, so that windows and
    /// memory show the same pictures.
    l3d_frame_settings frame_settings() const;

private:
    struct parser;

    void add_words(const std::string& name, const std::string& help,
                   const std::vector<std::string>& words, std::size_t preset,
                   std::function<void(std::size_t)> chosen);
    void add_common(l3d_size default_size);
    void add_batch();
    void refuse_one_file_for_two() const;
    std::string end_of_help() const;

    struct example {
        std::string arguments, purpose;
    };

    /// An option that names a file. Lives: borrows the value.
    struct named_file {
        std::string option;
        const std::string* value;
    };

    std::string program_, command_;
    l3d_common_options common_;
    std::vector<std::string> with_results_, printed_, notes_;
    std::vector<example> examples_;
    std::vector<named_file> files_;
    std::function<bool(const std::string&, double)> load_watch_;
    std::unique_ptr<parser> parser_;
};

/// Prints one line on stderr, "program: text". Returns the exit code for main: that of an
/// l3d_error, or l3d_exit::failure.
L3D_PUBLIC int l3d_report(std::string_view program, const std::exception& error);

/// Reports the code that l3d_dispatcher::start returned, and returns it. Says nothing if all went
/// well.
L3D_PUBLIC int l3d_report(std::string_view program, l3d_exit code);

template <class T>
void l3d_options::add_choice(const std::string& name, T& value, const std::string& help,
                             const std::vector<std::pair<std::string, T>>& choices) {
    std::vector<std::string> words;
    std::vector<T> values;
    std::size_t preset = 0;
    for (const auto& [word, meaning] : choices) {
        if (meaning == value)
            preset = words.size();
        words.push_back(word);
        values.push_back(meaning);
    }
    add_words(name, help, words, preset, [values, &value](std::size_t i) { value = values[i]; });
}

/// A row of a table of options. Its option is refused if it was given where nothing uses it.
struct l3d_refusal {
    const char* option;
    bool is_refused;
    std::string why; ///< begins in small letters, for it follows the option's name and a colon
};

/// Throws if an option of the table is to be refused.
/// Errors:  l3d_error(usage) that names the first such option, and why.
inline void l3d_refuse(std::initializer_list<l3d_refusal> table) {
    for (const l3d_refusal& row : table)
        if (row.is_refused)
            throw l3d_error(l3d_exit::usage, std::string(row.option) + ": " + row.why);
}

#endif
