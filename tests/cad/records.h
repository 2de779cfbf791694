// SPDX-License-Identifier: MIT
// What the plug-in says of a file: its faces as surfaces, one by one.
#ifndef L3D_TESTS_CAD_RECORDS_H
#define L3D_TESTS_CAD_RECORDS_H

#include "geom/files/cad_plugin_p.h"
#include "geom/nurbs_surface.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

/// A folder that is gone after the test, unless L3D_CAD_FILES names one that stays. The kernel
/// tells the terminal of each file that it writes.
class cad_folder {
public:
    cad_folder() {
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        std::filesystem::create_directories(path_);
    }
    cad_folder(const cad_folder&) = delete;
    cad_folder& operator=(const cad_folder&) = delete;
    ~cad_folder() {
        if (!kept_)
            std::filesystem::remove_all(path_);
    }

    std::string file(const std::string& name) const { return path_ + '/' + name; }

private:
    const char* kept_ = std::getenv("L3D_CAD_FILES");
    std::string path_ = kept_ ? kept_ : testing::TempDir() + "l3d_cad_" + std::to_string(getpid());
};

/// The records of a file, without what was made of them.
struct cad_records {
    std::vector<l3d_nurbs_surface> faces;
    std::vector<std::uint64_t> colors; ///< of each face
    std::vector<std::string> parts;    ///< of each face
    std::vector<std::string> notes;
    std::vector<l3d_nurbs_curve> edges, curves;
    std::vector<double> tolerances; ///< of each edge
    bool is_complete = false;
    double seconds = -1, bytes = 0;
    std::string why; ///< if the plug-in failed

    static std::string text_of(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    static cad_records of(const std::string& text, bool is_iges) {
        cad_records result;
        const auto* const plugin =
            static_cast<const l3d_detail::cad_plugin*>(l3d_detail::load_plugin(
                "cad", l3d_detail::cad_version, sizeof(l3d_detail::cad_plugin), result.why));
        if (!plugin)
            return result;
        std::string bytes;
        std::array<char, 512> why{};
        const auto take = [](void* to, const void* from, std::size_t size) {
            static_cast<std::string*>(to)->append(static_cast<const char*>(from), size);
        };
        const auto tell = [](void*, double) { return 1; };
        if (plugin->read(text.data(), text.size(), is_iges, &bytes, take, tell, why.data(),
                         why.size()) == 0)
            result.why = why.data();
        l3d_detail::cad_reader from(bytes);
        std::uint64_t color = of_place;
        std::vector<std::vector<shape_face>> shapes;
        while (!from.is_over())
            switch (static_cast<l3d_detail::cad_record>(from.count())) {
            case l3d_detail::cad_record::end:
                result.is_complete = true;
                break;
            case l3d_detail::cad_record::effort:
                result.seconds = from.number();
                result.bytes = from.number();
                break;
            case l3d_detail::cad_record::note:
                result.notes.push_back(from.text());
                break;
            case l3d_detail::cad_record::material:
                color = from.count();
                from.number();
                break;
            case l3d_detail::cad_record::of_place:
                color = of_place;
                break;
            case l3d_detail::cad_record::shape:
                shapes.emplace_back();
                break;
            case l3d_detail::cad_record::place:
                result.place(from, shapes);
                break;
            case l3d_detail::cad_record::edge:
                result.tolerances.push_back(from.number());
                result.edges.push_back(curve(from));
                break;
            case l3d_detail::cad_record::curve:
                result.curves.push_back(curve(from));
                break;
            case l3d_detail::cad_record::face:
                shapes.back().push_back({face(from), color});
                break;
            }
        return result;
    }

private:
    static constexpr std::uint64_t of_place = ~std::uint64_t{0};
    struct shape_face {
        l3d_nurbs_surface surface;
        std::uint64_t color;
    };

    /// Adds the faces of a shape at its place.
    void place(l3d_detail::cad_reader& from, const std::vector<std::vector<shape_face>>& shapes) {
        const std::uint64_t shape = from.count();
        const std::string part = from.text();
        const std::uint64_t color = from.count();
        from.number();
        double m[3][4];
        for (auto& row : m)
            for (double& number : row)
                number = from.number();
        for (const shape_face& one : shapes[shape]) {
            std::vector<l3d_nurbs_surface::vector> points;
            for (const auto& p : one.surface.points()) {
                auto& q = points.emplace_back();
                for (int i = 0; i < 3; ++i)
                    q[i] = m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3];
            }
            const l3d_nurbs_surface whole(one.surface.u(), one.surface.v(), std::move(points),
                                          one.surface.weights());
            faces.push_back(whole.trimmed(one.surface.trims()));
            colors.push_back(one.color == of_place ? color : one.color);
            parts.push_back(part);
        }
    }

    static l3d_bspline_direction direction(l3d_detail::cad_reader& from) {
        l3d_bspline_direction result;
        result.degree = static_cast<int>(from.count());
        result.knots = from.numbers();
        result.from = result.knots.front();
        result.to = result.knots.back();
        return result;
    }

    static l3d_nurbs_curve curve(l3d_detail::cad_reader& from) {
        auto along = direction(from);
        std::vector<double> weights;
        auto points = points_of(from, weights);
        return {std::move(along), std::move(points), std::move(weights)};
    }

    static std::vector<l3d_nurbs_surface::vector> points_of(l3d_detail::cad_reader& from,
                                                            std::vector<double>& weights) {
        const std::vector<double> n = from.numbers();
        std::vector<l3d_nurbs_surface::vector> points;
        for (std::size_t i = 0; i + 3 < n.size(); i += 4) {
            points.push_back({n[i], n[i + 1], n[i + 2]});
            weights.push_back(n[i + 3]);
        }
        return points;
    }

    static l3d_nurbs_surface face(l3d_detail::cad_reader& from) {
        auto u = direction(from), v = direction(from);
        std::vector<double> weights;
        auto points = points_of(from, weights);
        const l3d_nurbs_surface whole(std::move(u), std::move(v), std::move(points),
                                      std::move(weights));
        std::vector<l3d_trim_loop> loops;
        for (std::uint64_t n = from.count(); n > 0; --n) {
            std::vector<l3d_nurbs_curve> curves;
            std::vector<l3d_edge_use> uses;
            for (std::uint64_t m = from.count(); m > 0; --m) {
                const auto edge = static_cast<std::uint32_t>(from.count());
                const double first = from.number(), last = from.number();
                uses.push_back({edge, first, last});
                curves.push_back(curve(from));
            }
            loops.push_back(l3d_trim_loop_of(curves, uses));
        }
        return whole.trimmed(std::move(loops));
    }
};

#endif
