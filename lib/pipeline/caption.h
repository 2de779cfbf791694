// SPDX-License-Identifier: MIT
// l3d_caption: tells people what a program shows and which keys it obeys.
#ifndef L3D_PIPELINE_CAPTION_H
#define L3D_PIPELINE_CAPTION_H

#include "base/public.h"
#include "raster/text/panel.h"

#include <string>
#include <vector>

/// Keys, as the help calls them, and their effect.
struct L3D_PUBLIC l3d_caption_row {
    std::string keys; ///< such as "h j k l"
    std::string text; ///< such as "left, down, up, right"
};

/// Text on a program and its keys. The program's --help shows it, and so does a panel in its
/// window, for some seconds and whenever the user asks for help.
///
///     l3d_program program("dot", l3d_caption{.what = "A dot moves.", .keys = {{"p", "rest"}}},
///                         {320, 200});
///
/// Lives: a value.
struct L3D_PUBLIC l3d_caption {
    /// A sentence or two.
    std::string what;

    /// The lesson that the program teaches, in a sentence or two; makes the program a lesson of the
    /// book.
    std::string teaches{};

    /// The program's own keys. The keys of every program are added automatically.
    std::vector<l3d_caption_row> keys{};

    /// The keys that show and hide the help. A program that needs one of them leaves it out.
    std::string help = "h?";

    /// The corner in which the window shows its caption for some seconds, or until a button is
    /// pressed. Choose one where the program has nothing to see.
    l3d_corner corner = l3d_corner::bottom_left;

    /// All keys: the program's own, F11, those of help, and the end.
    std::vector<l3d_caption_row> all_keys() const;

    /// The text of --help: the sentences, and a list of all keys below them.
    std::string text() const;
};

#endif
