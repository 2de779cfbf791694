// SPDX-License-Identifier: MIT
// l3d_svg_of: writes lines as paths, in two layers.
#include "scene/line_drawing.h"

#include <array>
#include <charconv>
#include <string>

namespace {

/// A number with three decimals at most, whatever the locale.
std::string number(double value) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0,
                                   std::chars_format::fixed, 3);
    std::string result(text.data(), end.ptr);
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.')
        result.pop_back();
    return result == "-0" ? "0" : result;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        default:
            // XML has no other control characters.
            result += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? '?' : c;
        }
    }
    return result;
}

const char* name_of(l3d_line_kind kind) {
    switch (kind) {
    case l3d_line_kind::contour:
        return "contour";
    case l3d_line_kind::crease:
        return "crease";
    case l3d_line_kind::joint:
        return "joint";
    default:
        return "border";
    }
}

std::string path_of(const l3d_drawn_line& line) {
    const bool is_closed = line.points.size() > 2 && line.points.front() == line.points.back();
    std::string result = "    <path class=\"" + std::string(name_of(line.kind)) + "\" d=\"M";
    for (std::size_t i = 0; i + (is_closed ? 1 : 0) < line.points.size(); ++i)
        result += (i == 0   ? ""
                   : i == 1 ? " L"
                            : " ") +
                  number(line.points[i].x) + ',' + number(line.points[i].y);
    return result + (is_closed ? " Z" : "") + "\"/>\n";
}

} // namespace

std::string l3d_svg_of(const l3d_line_drawing& drawing, const l3d_svg_look& look) {
    const std::string width = std::to_string(drawing.size.width);
    const std::string height = std::to_string(drawing.size.height);
    std::string result = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                         "<svg xmlns=\"http://www.w3.org/2000/svg\"\n"
                         "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
                         "     width=\"" +
                         width + "px\" height=\"" + height + "px\" viewBox=\"0 0 " + width + ' ' +
                         height + "\">\n";
    if (!look.title.empty())
        result += "  <title>" + escaped(look.title) + "</title>\n";
    result += "  <desc>No line is farther than " + number(drawing.bound) +
              " px from the exact one.</desc>\n";
    for (const bool is_seen : {false, true}) {
        const std::string layer = is_seen ? "seen" : "hidden";
        result += "  <g id=\"" + layer + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" +
                  layer + "\"\n     fill=\"none\" stroke=\"#000000\" stroke-width=\"" +
                  number(is_seen ? look.seen_width : look.hidden_width) +
                  "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"" +
                  (is_seen ? "" : " stroke-dasharray=\"4 3\"") + ">\n";
        for (const l3d_drawn_line& line : drawing.lines)
            if (line.is_seen == is_seen)
                result += path_of(line);
        result += "  </g>\n";
    }
    return result + "</svg>\n";
}
