// SPDX-License-Identifier: MIT
// cad_shape: Open CASCADE's reader and mesher; its own faces and edges judge the mesh.
#include "bench/cad_shape.h"

#include <stdexcept>

// make/lab.mk gives the folder of these headers where they are installed.
#if __has_include(<STEPCAFControl_Reader.hxx>)

#include "bench/seen_patch.h"
#include "bench/surface_error.h"
#include "cad/shapes.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

using vector = l3d_vector<double, 3>;

/// Steps to the nearest point of a surface or curve. Each squares what is left of the distance.
constexpr int newton_steps = 4;

vector vector_of(const gp_XYZ& p) {
    return {p.X(), p.Y(), p.Z()};
}

/// A face, and its mesh.
struct meshed_face {
    explicit meshed_face(const TopoDS_Face& f)
        : face(f), surface(f), mesh(BRep_Tool::Triangulation(f, location)),
          is_turned(f.Orientation() == TopAbs_REVERSED) {}

    gp_Pnt node(int i) const { return mesh->Node(i).Transformed(location.Transformation()); }

    vector normal(double u, double v) const {
        gp_Pnt at;
        gp_Vec along_u, along_v;
        surface.D1(u, v, at, along_u, along_v);
        const gp_Vec across = along_u.Crossed(along_v);
        const double length = across.Magnitude();
        // The pole of a surface has no normal by this rule. That of a place beside it is as good.
        if (!(length > 1e-9 * (along_u.SquareMagnitude() + along_v.SquareMagnitude())))
            return normal(u, 0.999 * v +
                                 0.0005 * (surface.FirstVParameter() + surface.LastVParameter()));
        return vector_of(across.XYZ()) * ((is_turned ? -1 : 1) / length);
    }

    TopLoc_Location location;
    TopoDS_Face face;
    BRepAdaptor_Surface surface;
    Handle(Poly_Triangulation) mesh;
    bool is_turned;
};

double grey_of(const vector& normal, const vector& light) {
    return 0.1 + 0.9 * std::max(0.0, l3d_dot(normal, light));
}

/// Collects distances in the picture.
class error_judge {
public:
    error_judge(const l3d_camera& camera, l3d_size size, const vector& light)
        : world_(camera, size), light_(light) {}

    void add_face(const meshed_face& of) {
        std::vector<mesh_corner> corners;
        std::vector<double> greys;
        for (int i = 1; i <= of.mesh->NbNodes(); ++i) {
            const gp_Pnt2d uv = of.mesh->UVNode(i);
            corners.push_back(world_.corner(uv.X(), uv.Y(), vector_of(of.node(i).XYZ())));
            greys.push_back(grey_of(of.normal(uv.X(), uv.Y()), light_));
        }
        for (int t = 1; t <= of.mesh->NbTriangles(); ++t) {
            std::array<int, 3> n{};
            of.mesh->Triangle(t).Get(n[0], n[1], n[2]);
            const auto at = [&](std::size_t k) { return static_cast<std::size_t>(n[k] - 1); };
            const mesh_corner &a = corners[at(0)], &b = corners[at(1)], &c = corners[at(2)];
            if (!may_be_seen({a, b, c}))
                continue;
            for_triangle_lattice([&](double p, double q, double r) {
                add_point(of, a.position * p + b.position * q + c.position * r,
                          a.u * p + b.u * q + c.u * r, a.v * p + b.v * q + c.v * r,
                          greys[at(0)] * p + greys[at(1)] * q + greys[at(2)] * r);
            });
        }
        for (TopExp_Explorer edge(of.face, TopAbs_EDGE); edge.More(); edge.Next())
            if (!BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
                add_border(of, corners, TopoDS::Edge(edge.Current()));
    }

    cad_error error;

private:
    bool is_in_window(const vector& place) const {
        const mesh_corner seen = world_.corner(0, 0, place);
        return seen.image[2] > 0 && std::abs(seen.x) < half_width() &&
               std::abs(seen.y) < half_height();
    }
    double half_width() const { return world_.window.right; }
    double half_height() const { return world_.window.bottom; }

    bool may_be_seen(const std::array<mesh_corner, 3>& corners) const {
        const auto all = [&](auto is_beyond) { return std::ranges::all_of(corners, is_beyond); };
        if (std::ranges::any_of(corners, [](const auto& c) { return c.image[2] <= 0; }))
            return true;
        return !all([&](const auto& c) { return c.x < -half_width(); }) &&
               !all([&](const auto& c) { return c.x > half_width(); }) &&
               !all([&](const auto& c) { return c.y < -half_height(); }) &&
               !all([&](const auto& c) { return c.y > half_height(); });
    }

    void add_distance(const vector& drawn, const vector& exact) {
        const mesh_corner a = world_.corner(0, 0, drawn), b = world_.corner(0, 0, exact);
        error.places = std::max(error.places, std::hypot(a.x - b.x, a.y - b.y));
    }

    void add_point(const meshed_face& of, const vector& drawn, double u, double v, double grey) {
        if (!is_in_window(drawn))
            return;
        gp_Pnt at;
        gp_Vec du, dv;
        const gp_Pnt p(drawn[0], drawn[1], drawn[2]);
        for (int i = 0; i < newton_steps; ++i) {
            of.surface.D1(u, v, at, du, dv);
            const gp_Vec off(at, p);
            const double uu = du.Dot(du), uv = du.Dot(dv), vv = dv.Dot(dv);
            const double determinant = uu * vv - uv * uv;
            if (!(determinant > 1e-12 * uu * vv))
                break; // at a pole
            u += (off.Dot(du) * vv - off.Dot(dv) * uv) / determinant;
            v += (off.Dot(dv) * uu - off.Dot(du) * uv) / determinant;
        }
        of.surface.D0(u, v, at);
        add_distance(drawn, vector_of(at.XYZ()));
        constexpr double levels = 255;
        error.shades =
            std::max(error.shades, levels * std::abs(grey - grey_of(of.normal(u, v), light_)));
    }

    void add_border(const meshed_face& of, const std::vector<mesh_corner>& corners,
                    const TopoDS_Edge& edge) {
        const Handle(Poly_PolygonOnTriangulation) polygon =
            BRep_Tool::PolygonOnTriangulation(edge, of.mesh, of.location);
        if (polygon.IsNull() || !polygon->HasParameters())
            return;
        const BRepAdaptor_Curve curve(edge);
        for (int i = 1; i < polygon->NbNodes(); ++i) {
            const auto place = [&](int k) {
                return corners[static_cast<std::size_t>(polygon->Nodes()(k) - 1)].position;
            };
            for (int k = 1; k < error_lattice; ++k) {
                const double share = k / double{error_lattice};
                const vector drawn = place(i) * (1 - share) + place(i + 1) * share;
                if (!is_in_window(drawn))
                    continue;
                double t = polygon->Parameters()->Value(i) * (1 - share) +
                           polygon->Parameters()->Value(i + 1) * share;
                gp_Pnt at;
                gp_Vec along;
                for (int step = 0; step < newton_steps; ++step) {
                    curve.D1(t, at, along);
                    t += gp_Vec(at, gp_Pnt(drawn[0], drawn[1], drawn[2])).Dot(along) /
                         along.SquareMagnitude();
                }
                add_distance(drawn, vector_of(curve.Value(t).XYZ()));
            }
        }
    }

    seen_world world_;
    vector light_;
};

} // namespace

struct cad_shape::kernel {
    Handle(TDocStd_Document) document;
    TopoDS_Shape shape;

    /// Calls act(face) for all meshed faces.
    template <class Act> void each_face(Act act) const {
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
            if (const meshed_face meshed(TopoDS::Face(face.Current())); !meshed.mesh.IsNull())
                act(meshed);
    }
};

void cad_shape::expect_open_cascade() {
    // The kernel tells the terminal of each file that it reads or writes.
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

std::vector<std::string> cad_shape::write_examples(const std::string& folder) {
    constexpr int across = 32; // 1024 holes
    std::vector<std::string> files;
    const auto write = [&](const std::string& name, const TopoDS_Shape& shape) {
        TopoDS_Compound all; // of solids whose fronts are outside
        const BRep_Builder builder;
        builder.MakeCompound(all);
        for (TopExp_Explorer of(shape, TopAbs_SOLID); of.More(); of.Next()) {
            TopoDS_Solid solid = TopoDS::Solid(of.Current());
            BRepLib::OrientClosedSolid(solid);
            builder.Add(all, solid);
        }
        write_step(all, files.emplace_back(folder + '/' + name + ".step"));
    };
    write("plate", plate_with_holes(across));
    for (const named_shape& one : shapes_of_many_kinds())
        if (one.name == "flange" || one.name == "thread")
            write(one.name, one.shape);
        else if (one.name == "cylinders that meet in a fillet")
            write("fillet", one.shape);
        else if (one.name == "ball cut by a cylinder")
            write("ball", one.shape);
    return files;
}

cad_shape::cad_shape(const std::string& path) : kernel_(std::make_unique<kernel>()) {
    STEPCAFControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(false);
    kernel_->document = new TDocStd_Document("BinXCAF");
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || !reader.Transfer(kernel_->document))
        throw std::runtime_error(path + ": Open CASCADE cannot read it as STEP");
    TDF_LabelSequence roots;
    XCAFDoc_DocumentTool::ShapeTool(kernel_->document->Main())->GetFreeShapes(roots);
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const TDF_Label& root : roots)
        builder.Add(all, XCAFDoc_ShapeTool::GetShape(root));
    kernel_->shape = all;
}

cad_shape::cad_shape(cad_shape&&) noexcept = default;
cad_shape::~cad_shape() = default;

void cad_shape::mesh(const cad_fineness& fineness) {
    BRepTools::Clean(kernel_->shape);
    IMeshTools_Parameters wish;
    wish.Deflection = fineness.deflection;
    wish.Angle = fineness.angle;
    wish.InParallel = fineness.in_parallel;
    const BRepMesh_IncrementalMesh mesher(kernel_->shape, wish);
}

peer_mesh cad_shape::vertices(const vector& light) const {
    peer_mesh result;
    result.kind = "occt";
    kernel_->each_face([&](const meshed_face& of) {
        const auto first = static_cast<std::uint32_t>(result.vertices());
        for (int i = 1; i <= of.mesh->NbNodes(); ++i) {
            const gp_Pnt p = of.node(i);
            for (const double c : {p.X(), p.Y(), p.Z()})
                result.positions.push_back(static_cast<float>(c));
            const gp_Pnt2d uv = of.mesh->UVNode(i);
            result.greys.push_back(static_cast<float>(grey_of(of.normal(uv.X(), uv.Y()), light)));
        }
        for (int t = 1; t <= of.mesh->NbTriangles(); ++t) {
            std::array<int, 3> n{};
            of.mesh->Triangle(t).Get(n[0], n[1], n[2]);
            if (of.is_turned)
                std::swap(n[1], n[2]);
            for (const int i : n)
                result.indices.push_back(first + static_cast<std::uint32_t>(i - 1));
        }
    });
    return result;
}

cad_error cad_shape::error(const l3d_camera& camera, l3d_size size, const vector& light) const {
    error_judge judge(camera, size, light);
    kernel_->each_face([&](const meshed_face& of) { judge.add_face(of); });
    return judge.error;
}

vector cad_shape::round_edge_near(const vector& eye) const {
    vector nearest = eye;
    double least = std::numeric_limits<double>::infinity();
    for (TopExp_Explorer edge(kernel_->shape, TopAbs_EDGE); edge.More(); edge.Next()) {
        if (BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
            continue;
        const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
        const vector middle =
            vector_of(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2).XYZ());
        const double distance = l3d_length(middle - eye);
        if (curve.GetType() == GeomAbs_Line || distance >= least)
            continue;
        least = distance;
        nearest = middle;
    }
    return nearest;
}

#else

struct cad_shape::kernel {};

void cad_shape::expect_open_cascade() {
    throw std::runtime_error("this peers_bench was built without Open CASCADE");
}
std::vector<std::string> cad_shape::write_examples(const std::string&) {
    return {};
}
cad_shape::cad_shape(const std::string&) {}
cad_shape::cad_shape(cad_shape&&) noexcept = default;
cad_shape::~cad_shape() = default;
void cad_shape::mesh(const cad_fineness&) {}
peer_mesh cad_shape::vertices(const l3d_vector<double, 3>&) const {
    return {};
}
cad_error cad_shape::error(const l3d_camera&, l3d_size, const l3d_vector<double, 3>&) const {
    return {};
}
l3d_vector<double, 3> cad_shape::round_edge_near(const l3d_vector<double, 3>& eye) const {
    return eye;
}

#endif
