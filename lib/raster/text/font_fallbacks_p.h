// SPDX-License-Identifier: MIT
// font_fallbacks: other fonts of this machine, for letters that a font does not have.
#ifndef L3D_RASTER_TEXT_FONT_FALLBACKS_P_H
#define L3D_RASTER_TEXT_FONT_FALLBACKS_P_H

#include "raster/text/font_source_p.h"

#include <map>
#include <memory>
#include <vector>

namespace l3d_detail {

/// Finds other fonts of this machine for letters that a font lacks. It asks fontconfig once for
/// each letter that no open font has. Before the first of these letters, fontconfig is not asked,
/// and no font is opened.
class font_fallbacks {
public:
    /// A font that has this letter; null if the machine has no such font.
    const font_source* find(char32_t code);

private:
    const font_source* ask(char32_t code);

    std::vector<std::unique_ptr<font_source>> open_;
    std::map<char32_t, const font_source*> known_;
};

} // namespace l3d_detail

#endif
