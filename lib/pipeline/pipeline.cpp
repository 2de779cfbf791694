// SPDX-License-Identifier: MIT
// l3d_caption: writes rows of keys as text.
#include "pipeline/pipeline.h"

#include <sstream>
#include <utility>

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
    constexpr std::size_t widest_line = 79; // the width of a usual terminal
    std::string result = what + '\n', line;
    const auto add = [&](const std::string& words) {
        if (!line.empty() && line.size() + 1 + words.size() > widest_line)
            result += std::exchange(line, {}) + '\n';
        line += (line.empty() ? "" : " ") + words;
    };
    std::istringstream lesson(teaches);
    for (std::string word; lesson >> word;)
        add(word);
    if (!line.empty())
        result += std::exchange(line, {}) + '\n';
    add("Keys:");
    for (const l3d_caption_row& row : all_keys())
        add(row.keys + ": " + row.text + ';');
    line.back() = '.';
    return result + line;
}
