// SPDX-License-Identifier: MIT
// l3d_painter: spans, cut where planes meet, and shaded.
#include "raster/zsort/painter.h"

#include "raster/depth_buffer.h"
#include "raster/parallel/chunks_p.h"
#include "raster/lines/line_cover_p.h"
#include "raster/zsort/overdraw_p.h"
#include "raster/zsort/painted_triangle_p.h"
#include "raster/shapes/piece_pixels_p.h"
#include "raster/shaders/lit_shader_p.h"
#include "raster/shaders/surface_shader_p.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace {

using namespace l3d_detail;

/// The same word everywhere in a triangle.
struct own_color_shader {
    static constexpr std::size_t components = 0;
    std::uint32_t color = 0;

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void corner(const l3d_micro_vertex&, float*) const {}
    std::uint32_t word(const float*) const { return color; }
};

/// What there is to paint.
struct painted_things {
    std::span<const l3d_painter_triangle> triangles;
    std::span<const l3d_painter_piece> pieces;
    std::span<const l3d_painter_cut> cuts;
};

/// All rows in which a piece may have pixels, or its sides if its pixels are not known. Smooth ones
/// have two pixels side by side in each step, and a step may begin a pixel before the end of a
/// side.
scan_rows reach_of(const l3d_painter_piece& piece, const painted_things& what) {
    if (piece.cover != 0)
        return {piece.top, piece.top + l3d_painter_piece::small_side};
    const auto& v = what.triangles[piece.triangle].v;
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    return {first_centre(top) - 2, first_centre(bottom) + 2};
}

} // namespace

struct l3d_painter::work_space {
    explicit work_space(l3d_workers& by) : workers(by), of_worker(std::size_t(by.count())) {}

    /// With four, the last band to be done is an eighth of two workers' work. More would share it
    /// more evenly; but a triangle is set up in each band that it reaches.
    static constexpr int bands_per_worker = 4;
    /// Of so many pieces, finding their bands is one item of work: some 10^4 cycles.
    static constexpr std::size_t chunk_pieces = 1024;
    /// So many pieces before their turn, triangles are asked for: some hundred cycles each, more
    /// than memory takes.
    static constexpr std::size_t ahead = 8, cache_line = 64;

    l3d_workers& workers;
    std::vector<painting> of_worker;
    /// The pieces of each chunk that reach each band: list band + bands chunk. A single band has
    /// all. A worker writes to the lists of a chunk at each piece: eight bands begin lines of the
    /// caches, which no two workers share.
    using list_of_pieces = std::vector<std::uint32_t>;
    std::vector<list_of_pieces, line_allocator<list_of_pieces>> lists;
    l3d_depth_buffer line_depths; ///< of lines in fog

    void begin(l3d_pixels target, bool from_front) {
        for (painting& to : of_worker) {
            to.paint_to(target);
            to.from_front = from_front;
            to.written = 0;
            to.foggy = nullptr;
            to.painter.reset();
            to.color = painting::white;
        }
    }

    /// Clears each band and calls paint(piece, to) for the pieces that reach it, where `paint` is a
    /// copy of what is given. From front to back, what is left open is cleared afterwards.
    template <class Paint>
    void paint_bands(const painted_things& what, const l3d_background& background,
                     const Paint& prototype) {
        const int height = of_worker.front().target.height;
        const int bands =
            workers.count() > 1 ? std::min(bands_per_worker * workers.count(), height) : 1;
        if (bands > 1)
            list_pieces(what, bands, height);
        workers.for_each(bands, [&](int band, int worker) {
            painting& to = of_worker[static_cast<std::size_t>(worker)];
            to.rows = rows_of(band, bands, height);
            to.scan.set_rows(to.rows);
            if (to.from_front)
                to.open.open(to.rows, to.target.width);
            else
                background.fill(to.target, {0, to.rows.top, to.target.width, to.rows.bottom});
            Paint paint = prototype;
            visit_pieces(what, to.from_front, band, bands, [&](const l3d_painter_piece& piece) {
                if (to.from_front && piece.cover != 0 && !to.open.any(piece))
                    return;
                place_cuts(piece, what.triangles, what.cuts, to.cuts);
                paint(piece, what.triangles[piece.triangle], to);
            });
            to.light.finish();
            if (to.from_front)
                clear_open(to, background);
            if constexpr (requires { paint.finish(to); })
                paint.finish(to);
        });
    }

    static scan_rows rows_of(int band, int bands, int height) {
        return {band * height / bands, (band + 1) * height / bands};
    }

    void list_pieces(const painted_things& what, int bands, int height) {
        const auto of_chunk = static_cast<std::size_t>(bands);
        const std::size_t wanted = of_chunk * chunks_of(what.pieces.size(), chunk_pieces);
        if (lists.size() < wanted)
            lists.resize(wanted);
        for_each_chunk(workers, what.pieces.size(), chunk_pieces,
                       [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                           const std::span own =
                               std::span(lists).subspan(chunk * of_chunk, of_chunk);
                           for (auto& list : own)
                               list.clear();
                           for (std::size_t i = begin; i < end; ++i)
                               list_piece(reach_of(what.pieces[i], what), height,
                                          static_cast<std::uint32_t>(i), own);
                       });
    }

    /// A row is in the last band whose first row is not below it, as rows_of divides them.
    static void list_piece(scan_rows reach, int height, std::uint32_t piece,
                           std::span<list_of_pieces> lists) {
        const int bands = static_cast<int>(lists.size());
        const auto band_of = [&](std::int32_t row) { return ((row + 1) * bands - 1) / height; };
        const std::int32_t top = std::max(reach.top, 0), bottom = std::min(reach.bottom, height);
        if (top >= bottom)
            return;
        for (int band = band_of(top); band <= band_of(bottom - 1); ++band)
            lists[static_cast<std::size_t>(band)].push_back(piece);
    }

    /// Calls visit(piece) for those that reach a band, in the order in which they are painted.
    template <class Visit>
    void visit_pieces(const painted_things& what, bool from_front, int band, int bands,
                      const Visit& visit) const {
        const std::size_t all = what.pieces.size();
        if (bands == 1)
            return visit_some(
                what, from_front, all, [](std::size_t k) { return k; }, visit);
        const std::size_t chunks = chunks_of(all, chunk_pieces);
        for (std::size_t k = 0; k < chunks; ++k) {
            const std::size_t chunk = from_front ? chunks - 1 - k : k;
            const auto& list =
                lists[chunk * static_cast<std::size_t>(bands) + static_cast<std::size_t>(band)];
            visit_some(
                what, from_front, list.size(), [&](std::size_t i) { return list[i]; }, visit);
        }
    }

    /// Calls visit for pieces number_of(0) up to number_of(count - 1), or the other way round.
    template <class Numbers, class Visit>
    static void visit_some(const painted_things& what, bool from_front, std::size_t count,
                           const Numbers& number_of, const Visit& visit) {
        const auto piece = [&](std::size_t k) -> const l3d_painter_piece& {
            return what.pieces[number_of(from_front ? count - 1 - k : k)];
        };
        for (std::size_t k = 0; k < count; ++k) {
            if (k + ahead < count)
                fetch(what.triangles[piece(k + ahead).triangle]);
            visit(piece(k));
        }
    }

    /// In their order, triangles lie anywhere in memory.
    static void fetch(const l3d_painter_triangle& triangle) {
        const auto* const from = reinterpret_cast<const char*>(&triangle);
        for (std::size_t byte = 0; byte < sizeof(triangle); byte += cache_line)
            __builtin_prefetch(from + byte);
        __builtin_prefetch(from + sizeof(triangle) - 1);
    }

    static void clear_open(painting& to, const l3d_background& background) {
        for (std::int32_t row = to.rows.top; row < to.rows.bottom; ++row)
            to.open.take(row, {0, to.target.width}, [&](columns of) {
                background.fill(to.target, {of.begin, row, of.end, row + 1});
            });
    }

    std::int64_t written() const {
        std::int64_t sum = 0;
        for (const painting& to : of_worker)
            sum += to.written;
        return sum;
    }
};

namespace {

/// Paints triangles of a picture by one shader.
template <class Shader> struct shaded_paint {
    Shader shader;
    std::span<const l3d_material> materials;

    void operator()(const l3d_painter_piece& piece, const l3d_painter_triangle& triangle,
                    painting& to) {
        if constexpr (std::is_same_v<Shader, own_color_shader>)
            shader.color = triangle.color;
        if constexpr (has_materials<Shader>)
            shader.use_material(triangle.material);
        else if (to.painter)
            to.name = triangle.material;
        else if (!materials.empty())
            to.color = materials[triangle.material].color;
        if constexpr (has_lanes<Shader>)
            if (piece.cover != 0 && to.by_lanes())
                return paint_covered(to, shader, piece, triangle.v);
        paint_triangle(to, shader, triangle.v);
    }
};

/// Hides what is behind a triangle, and covers what its sides cover.
struct sides_paint {
    const l3d_shading& shading;
    l3d_line_look look;
    l3d_depth_buffer& depths; ///< of lines in fog
    own_color_shader nothing{};

    void operator()(const l3d_painter_piece&, const l3d_painter_triangle& triangle, painting& to) {
        paint_triangle(to, nothing, triangle.v);
        visit_sides(triangle, to.cuts, to.target.size(), look.smooth,
                    [&](int x, int y, int coverage, double inv_w) {
                        if (y < to.rows.top || y >= to.rows.bottom)
                            return;
                        const auto column = static_cast<std::size_t>(x);
                        std::uint32_t& word = to.target.row(y)[column];
                        if (shading.fog.is_on())
                            cover_pixel(word, depths.row(y)[column], coverage, inv_w);
                        else
                            cover_pixel(word, coverage);
                    });
    }
    void finish(painting& to) const {
        color_cover(to.target, to.rows, shading, look.color, depths);
    }
};

/// Calls visit(shader) with that of a mode.
template <class Visit>
void with_shader(const l3d_shading& shading, std::span<const l3d_material> materials,
                 const Visit& visit) {
    if (shading.is_lit(materials))
        return shading.paints ? visit(painted_lit_shader(shading, materials))
                              : visit(lit_shader(shading, materials));
    switch (shading.mode) {
    case l3d_shade::lambert:
        return visit(lambert_shader(shading));
    case l3d_shade::gouraud:
        return visit(gouraud_shader(shading));
    case l3d_shade::flat:
        return visit(flat_shader(shading));
    case l3d_shade::normals:
        return visit(normals_shader(shading));
    case l3d_shade::error:
        return visit(own_color_shader());
    default:
        assert(false); // only diced surfaces have levels or parameters
    }
}

} // namespace

l3d_painter::l3d_painter(l3d_workers& workers) : work_(std::make_unique<work_space>(workers)) {}

l3d_painter::~l3d_painter() = default;

void l3d_painter::paint(l3d_pixels target, const l3d_shading& shading,
                        std::span<const l3d_material> materials,
                        std::span<const l3d_painter_triangle> triangles,
                        std::span<const l3d_painter_piece> pieces,
                        std::span<const l3d_painter_cut> cuts) {
    work_->begin(target, has_overdraw(triangles, pieces));
    for (painting& to : work_->of_worker) {
        if (shading.fog.is_on())
            to.foggy = &shading;
        if (shading.paints)
            to.painter.emplace(*shading.paints, materials);
    }
    const std::span<const l3d_material> of_light =
        l3d_is_light(shading.mode) ? materials : std::span<const l3d_material>();
    with_shader(shading, materials, [&](const auto& shader) {
        using shader_type = std::remove_cvref_t<decltype(shader)>;
        work_->paint_bands({triangles, pieces, cuts}, shading.background,
                           shaded_paint<shader_type>{shader, of_light});
    });
    count(pieces.size());
}

void l3d_painter::paint_lines(l3d_pixels target, const l3d_shading& shading,
                              std::span<const l3d_painter_triangle> triangles,
                              std::span<const l3d_painter_piece> pieces,
                              std::span<const l3d_painter_cut> cuts, const l3d_line_look& look) {
    work_->begin(target, false);
    if (shading.fog.is_on())
        work_->line_depths.resize(target.size());
    work_->paint_bands({triangles, pieces, cuts}, l3d_background(),
                       sides_paint{shading, look, work_->line_depths});
    count(pieces.size());
}

void l3d_painter::count(std::size_t pieces) {
    counts_ = {};
    counts_.quads = static_cast<std::int64_t>(pieces);
    counts_.samples = counts_.written = work_->written();
    counts_.covered = l3d_surface_counts::none_counted;
}
