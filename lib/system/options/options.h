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
    std::string backend;               ///< back-end's name, "ask" or "auto"; empty if not given
    std::string usual_backend{};       ///< back-end to take if the user names none; empty for any
    bool no_input = false;             ///< whether the user is never asked which back-end to take
    bool list_backends = false;        ///< whether to list the back-ends and end
    bool diagnose = false;             ///< whether to tell what back-ends depend on, and end
    bool verbose = false;              ///< whether to tell which back-end was chosen
    l3d_size size{};                   ///< size of the picture, in pixels
    int scale = 0;                     ///< display pixels along a side of a pixel; 0 if not given
    std::string title{};               ///< title of the window; empty for the program's choice
    l3d_remote remote{};               ///< whether pictures are sent sparingly, for slow displays
    int first_frame = 0;               ///< number of the first frame that is drawn
    int frames = 0;                    ///< number of the frame before which to end; 0 for no end
    bool resume = false;               ///< whether to leave out frames whose file exists
    std::optional<double> fps;         ///< frames per second, 0 for no limit; nothing if not given
    std::uint64_t seed = 1;            ///< the number that random numbers start with
    l3d_alpha alpha = l3d_alpha::none; ///< whether files hold transparency
    std::string output; ///< file of the last picture, of every picture, or "-"; empty for none
};

/// A command line. The program declares its options by add(), and then reads the command line once
/// by parse().
///
/// Every add() borrows a variable for the option's value. The variable's present value is the
/// default, which --help prints; parse() replaces it. `name` is "--long" or "-s,--long".
/// Expects: the variables outlive parse(), and no name is used twice.
class L3D_PUBLIC l3d_options {
public:
    /// Declares the options that all programs have. --help begins with `purpose`.
    l3d_options(std::string program, const std::string& purpose, l3d_size default_size);
    l3d_options(const l3d_options&) = delete;
    l3d_options& operator=(const l3d_options&) = delete;
    ~l3d_options();

    /// Begins a group of options: --help lists the options that are added from now on under this
    /// heading.
    void begin_group(const std::string& heading);

    /// Adds a paragraph at the end of --help, such as the meaning of a word in capitals.
    void add_note(const std::string& text);

    /// Adds an example at the end of --help: arguments of the program, and what they are for.
    void add_example(const std::string& arguments, const std::string& purpose);

    /// Adds an option with a number from `least` to `most`; NaN and trailing text are refused.
    void add(const std::string& name, double& value, const std::string& help, double least,
             double most);
    /// Adds an option with a whole number from `least` to `most`.
    void add(const std::string& name, int& value, const std::string& help, int least, int most);

    /// Adds an option with a whole number. `value` stays empty if the option is not given, since
    /// the program finds a default later, or has none.
    void add(const std::string& name, std::optional<int>& value, const std::string& help, int least,
             int most);

    /// Adds an option with a number. `value` stays empty if the option is not given; --help prints
    /// `preset` as the default.
    void add(const std::string& name, std::optional<double>& value, double preset,
             const std::string& help, double least, double most);

    /// Adds an option with any text but the empty one; --help calls the text `kind`, such as FILE.
    /// If `name` begins with "FILE,", the user may give one text without the option's name.
    void add(const std::string& name, std::string& value, const std::string& help,
             const std::string& kind);

    /// Adds a flag: an option without a value, which sets `value` to true.
    void add(const std::string& name, bool& value, const std::string& help);

    /// Adds an option with three finite numbers X,Y,Z.
    void add(const std::string& name, l3d_vector<double, 3>& value, const std::string& help);
    /// Adds an option that may be given several times. The function `take` gets the text of each
    /// option in turn. If `take` refuses a text, it throws an l3d_error that names the text. --help
    /// prints `preset` as the default.
    void add_each(const std::string& name, const std::string& help, const std::string& kind,
                  const std::string& preset, std::function<void(const std::string&)> take);

    /// Adds an option with a background: "gradient", "none", or a colour. A colour is R,G,B of
    /// whole numbers from 0 to 255, #RGB, #RRGGBB or a name of CSS. `value` stays empty if the
    /// option is not given; `help` says which background is drawn then. With "none", written files
    /// hold transparency.
    void add(const std::string& name, std::optional<l3d_background>& value,
             const std::string& help);

    /// Adds an option with three numbers X,Y,Z. `value` stays empty if the option is not given,
    /// since the program finds the default later.
    void add(const std::string& name, std::optional<l3d_vector<double, 3>>& value,
             const std::string& help);

    /// Adds an option with two finite numbers X,Y. `value` stays empty if the option is not given.
    void add(const std::string& name, std::optional<l3d_vector<double, 2>>& value,
             const std::string& help);

    /// Adds an option with a size WIDTHxHEIGHT. Width and height are from 1 to l3d_largest_side.
    void add(const std::string& name, l3d_size& value, const std::string& help);

    /// Adds an option with one of a few words. Each word stands for a value, as in {{"afd",
    /// kind::afd}, {"exact", kind::exact}}.
    /// Expects: `value` is among these values.
    template <class T>
    void add_choice(const std::string& name, T& value, const std::string& help,
                    const std::vector<std::pair<std::string, T>>& choices);

    /// Reads the command line. Returns false if --help or --version was printed, so that the
    /// program should end with success. Standard streams that are closed are first opened on
    /// /dev/null. Otherwise a socket could get the number of a standard stream, and then all
    /// printed text would go to the socket.
    ///
    /// Errors:  l3d_error(usage) that names the option and the value. It is also thrown if two
    ///          options name the same file, or both name the standard output.
    bool parse(int argc, const char* const* argv);
    /// As parse(argc, argv), but prints the texts of --help and --version on `out`.
    bool parse(int argc, const char* const* argv, std::ostream& out);

    /// Declares that an option has a result beside pictures, such as a report. Expects: the option
    /// was added.
    void has_result(const std::string& name) { with_results_.push_back(name); }

    /// As has_result(), for a result that is printed on the standard output. If the option is
    /// given, no file may be written to the standard output.
    /// Expects: the option was added.
    void prints_result(const std::string& name) {
        has_result(name);
        printed_.push_back(name);
    }

    /// Whether the user gave an option that was declared by has_result().
    bool wants_result() const;

    /// The program's name, for titles and files.
    const std::string& program() const { return program_; }

    /// The command that the user typed, without its folder, for --help and messages.
    const std::string& command() const { return command_; }
    /// The values of the options that all programs have. Expects: parse() is done.
    const l3d_common_options& common() const { return common_; }

    /// Replaces the value of --output, for a program or factory manager that has a better default.
    void set_output(const std::string& name) { common_.output = name; }

    /// Sets the back-end that is taken if the user names none.
    void prefer_backend(const std::string& name) { common_.usual_backend = name; }

    /// Sets a function that is called while a model file is read. It gets the file's name and the
    /// share of the file that is read, from 0 to 1. If `watch` returns false, reading stops.
    void watch_loads(std::function<bool(const std::string& file, double share)> watch) {
        load_watch_ = std::move(watch);
    }
    /// The function that watch_loads() set; empty if there is none.
    const std::function<bool(const std::string& file, double share)>& load_watch() const {
        return load_watch_;
    }

    /// The request for a screen, as the options ask for it. The title is the program's name, unless
    /// the user gives another title.
    l3d_screen_request screen_request() const;

    /// The settings for a dispatcher. With --frames, time goes by fixed steps, so that windows and
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

    /// An option whose value names a file. Lives: borrows the value.
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

/// Prints an error as one line on stderr, "program: text". Returns the exit code for main: the code
/// of an l3d_error, or l3d_exit::failure.
L3D_PUBLIC int l3d_report(std::string_view program, const std::exception& error);

/// Prints a line on stderr about the code that l3d_dispatcher::start returned, unless it is
/// success. Returns the code as the exit code for main.
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

/// A row of a table for l3d_refuse: an option, whether it is refused, and why. Options are refused
/// if they were given and would have no effect.
struct l3d_refusal {
    const char* option;
    bool is_refused;
    /// The reason. Its first letter is small, since it follows the option's name and a colon.
    std::string why;
};

/// Throws if a row of the table says that its option is refused.
/// Errors:  l3d_error(usage) that names the first such option, and why.
inline void l3d_refuse(std::initializer_list<l3d_refusal> table) {
    for (const l3d_refusal& row : table)
        if (row.is_refused)
            throw l3d_error(l3d_exit::usage, std::string(row.option) + ": " + row.why);
}

#endif
