// SPDX-License-Identifier: MIT
// l3d_caption: rows of keys as text.
#include "pipeline/caption.h"

std::vector<l3d_caption_row> l3d_caption::all_keys() const {
    std::vector<l3d_caption_row> rows = keys;
    std::string shows_help;
    for (const char key : help)
        shows_help += (shows_help.empty() ? "" : ", ") + std::string(1, key);
    rows.push_back({"F11", "whole screen"});
    rows.push_back({shows_help, "help"});
    rows.push_back({"q, Escape", "quit"});
    return rows;
}

std::string l3d_caption::text() const {
    constexpr std::size_t widest_line = 79; // of a usual terminal
    std::string result = what + '\n', line = "Keys:";
    for (const l3d_caption_row& row : all_keys()) {
        const std::string words = ' ' + row.keys + ": " + row.text + ';';
        if (line.size() + words.size() > widest_line) {
            result += line + '\n';
            line = words.substr(1);
        } else {
            line += words;
        }
    }
    line.back() = '.';
    return result + line;
}
