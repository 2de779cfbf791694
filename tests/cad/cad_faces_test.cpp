// SPDX-License-Identifier: MIT
// Each face of files that the kernel wrote is there, where it is, and as large as the kernel says.
#include "cad/records.h"
#include "cad/shapes.h"
#include "geom/trims/trim_region.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace {

using vector = l3d_nurbs_surface::vector;

/// The kernel's faces of a file, in its order.
template <class Reader> std::vector<TopoDS_Face> faces_of(const std::string& path) {
    Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        return {};
    reader.TransferRoots();
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer face(reader.OneShape(), TopAbs_FACE); face.More(); face.Next())
        faces.push_back(TopoDS::Face(face.Current()));
    return faces;
}

vector cross(const vector& a, const vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The range of a face's parameters.
struct parameter_range {
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0, u_period = 0, v_period = 0;

    parameter_range(const TopoDS_Face& face, const Handle(Geom_Surface) & surface) {
        BRepTools::UVBounds(face, u0, u1, v0, v1);
        if (surface->IsUPeriodic())
            u_period = surface->UPeriod();
        if (surface->IsVPeriodic())
            v_period = surface->VPeriod();
    }
    double extent() const { return std::min(u1 - u0, v1 - v0); }
    /// The place, as many periods away as bring it nearest to another one.
    gp_Pnt2d moved(const gp_Pnt2d& p, double u, double v) const {
        return {near(p.X(), u, u_period), near(p.Y(), v, v_period)};
    }
    static double near(double x, double to, double period) {
        return period > 0 ? x + period * std::round((to - x) / period) : x;
    }
};

/// The distance of a place from the edges of a face, less what the file allows for them.
double distance_beyond_tolerance(const gp_Pnt& place, const TopoDS_Face& face) {
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(place);
    double least = std::numeric_limits<double>::infinity();
    for (TopExp_Explorer each(face, TopAbs_EDGE); each.More(); each.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(each.Current());
        double allowed = BRep_Tool::Tolerance(edge);
        for (TopExp_Explorer end(edge, TopAbs_VERTEX); end.More(); end.Next())
            allowed = std::max(allowed, BRep_Tool::Tolerance(TopoDS::Vertex(end.Current())));
        const BRepExtrema_DistShapeShape nearest(vertex, edge);
        if (nearest.IsDone())
            least = std::min(least, nearest.Value() - allowed);
    }
    return least;
}

/// What n by n places of a face say.
struct comparison {
    double area = 0;     ///< of the places that are inside
    double furthest = 0; ///< from the kernel's surface
    int places = 0, inside = 0,
        wrong = 0;  ///< places, and those that the kernel puts on the other side
    int turned = 0; ///< places whose outside is the kernel's inside
};

comparison compare(const l3d_nurbs_surface& ours, const TopoDS_Face& theirs, int n) {
    comparison result;
    l3d_trim_region region;
    l3d_flat_trims(ours.trims(), {1, 1},
                   1e-6 * std::max(ours.u().to - ours.u().from, ours.v().to - ours.v().from),
                   region);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(theirs);
    ShapeAnalysis_Surface nearest(surface);
    BRepClass_FaceClassifier classifier;
    const parameter_range inside(theirs, surface);
    const double side = theirs.Orientation() == TopAbs_REVERSED ? -1 : 1;
    const double du = (ours.u().to - ours.u().from) / n, dv = (ours.v().to - ours.v().from) / n;
    for (int i = 0; i < n * n; ++i) {
        const double u = ours.u().from + (i % n + 0.5) * du, v = ours.v().from + (i / n + 0.5) * dv;
        const auto at = ours.derivatives(u, v);
        const vector normal = cross(at.by_u, at.by_v);
        const bool is_inside = ours.trims().empty() || region.contains({u, v});
        const gp_Pnt p(at.place[0], at.place[1], at.place[2]);
        const gp_Pnt2d place = nearest.ValueOfUV(p, 1e-7);
        if (is_inside) {
            ++result.inside;
            result.area +=
                std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]) *
                du * dv;
            // The kernel's search for the nearest place of a spline stops early; its parameters
            // are ours.
            const gp_Pnt same = side > 0 ? surface->Value(u, v) : surface->Value(v, u);
            result.furthest = std::max(result.furthest, std::min(nearest.Gap(), same.Distance(p)));
            gp_Pnt q;
            gp_Vec by_u, by_v;
            surface->D1(place.X(), place.Y(), q, by_u, by_v);
            const gp_Vec outside = (by_u ^ by_v) * side;
            result.turned +=
                outside.X() * normal[0] + outside.Y() * normal[1] + outside.Z() * normal[2] < 0;
        }
        classifier.Perform(theirs, side > 0 ? inside.moved(place, u, v) : inside.moved(place, v, u),
                           0);
        ++result.places;
        // A place nearer to the border than the file's tolerance is on neither side.
        result.wrong += classifier.State() != TopAbs_ON &&
                        (classifier.State() == TopAbs_IN) != is_inside &&
                        distance_beyond_tolerance(p, theirs) > 0;
    }
    return result;
}

double area_of(const TopoDS_Face& face) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return std::abs(properties.Mass());
}

void expect_faces(const std::string& name, const cad_records& read,
                  const std::vector<TopoDS_Face>& theirs) {
    ASSERT_EQ(read.why, "") << name;
    ASSERT_TRUE(read.is_complete) << name;
    ASSERT_EQ(read.faces.size(), theirs.size()) << name;
    ASSERT_FALSE(theirs.empty()) << name;
    const bool is_thorough = std::getenv("L3D_THOROUGH") != nullptr;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        // 10^4 places of each face, or a fraction; more where there are many holes.
        const auto loops = static_cast<double>(read.faces[i].trims().size());
        int n = is_thorough ? 100 : std::max(10, static_cast<int>(8 * std::sqrt(loops)));
        comparison is = compare(read.faces[i], theirs[i], n);
        while (is.inside < 100 && n < 200) // a narrow face in a wide range of parameters
            is = compare(read.faces[i], theirs[i], n *= 2);
        const double exact = area_of(theirs[i]);
        const std::string where = name + ", face " + std::to_string(i);
        EXPECT_EQ(is.wrong, 0) << where << " of " << is.places;
        EXPECT_EQ(is.turned, 0) << where;
        EXPECT_LT(is.furthest, 2e-6) << where;
        // Each of the cells that a border crosses is wrong by half of itself, at random.
        EXPECT_NEAR(is.area / exact, 1, 3 / std::sqrt(is.inside)) << where;
    }
}

TEST(cad_faces, of_step_files_are_all_there_and_as_large_as_the_kernel_says) {
    const cad_folder folder;
    const char* const schemas[] = {"AP203", "AP214IS", "AP242DIS"};
    std::size_t i = 0;
    for (const named_shape& one : shapes_of_many_kinds()) {
        const std::string path = folder.file(one.name + ".step");
        write_step(one.shape, path, schemas[i++ % 3]);
        expect_faces(one.name, cad_records::of(cad_records::text_of(path), false),
                     faces_of<STEPControl_Reader>(path));
    }
}

TEST(cad_faces, of_hard_shapes_are_all_there_and_as_large_as_the_kernel_says) {
    const cad_folder folder;
    for (const named_shape& one : hard_shapes()) {
        const std::string path = folder.file(one.name + ".step");
        write_step(one.shape, path, "AP242DIS");
        expect_faces(one.name, cad_records::of(cad_records::text_of(path), false),
                     faces_of<STEPControl_Reader>(path));
    }
}

TEST(cad_faces, of_iges_files_are_all_there_and_as_large_as_the_kernel_says) {
    const cad_folder folder;
    std::size_t i = 0;
    for (const named_shape& one : shapes_of_many_kinds()) {
        const std::string path = folder.file(one.name + ".igs");
        write_iges(one.shape, path, i++ % 2 == 0);
        expect_faces(one.name, cad_records::of(cad_records::text_of(path), true),
                     faces_of<IGESControl_Reader>(path));
    }
}

/// Bodies as gmsh's script makes them: a box with a hole and fillets, a torus, a ball, a cone, and
/// a pipe along a helix.
constexpr const char* gmsh_script = R"(SetFactory("OpenCASCADE");
Box(1) = {0,0,0, 3,2,1}; Cylinder(2) = {1.5,1,-1, 0,0,3, 0.5};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Fillet{3}{1:4}{0.1}
Torus(10) = {0,0,5, 2,0.5}; Sphere(11) = {6,0,0, 1.2}; Cone(12) = {6,5,0, 0,0,2, 1,0};
For i In {0:19}
  t = i * 2 * Pi * 3 / 20; Point(1000 + i) = {20 + Cos(t), Sin(t), i / 20};
EndFor
Spline(1000) = {1000:1019}; Wire(1000) = {1000};
Disk(1000) = {21,0,0, 0.2}; Rotate {{1,0,0}, {21,0,0}, Pi/2} { Surface{1000}; }
Extrude { Surface{1000}; } Using Wire {1000}
Delete { Surface{1000}; }
)";

/// The same for FreeCAD, which writes the bodies of its list to files of their own.
constexpr const char* freecad_script = R"(import FreeCAD, Part
V = FreeCAD.Vector
box = Part.makeBox(30, 20, 10)
loops = Part.makePolygon([V(-5,-5,0), V(5,-5,0), V(5,5,0), V(-5,5,0), V(-5,-5,0)])
ring = Part.Wire(Part.makeCircle(1, V(8,0,0), V(0,1,0)))
bodies = [box.makeFillet(2, box.Edges),
          Part.makeCylinder(8, 40).cut(Part.makeCylinder(3, 40)),
          Part.makeSphere(10).cut(Part.makeCylinder(4, 40, V(3,0,-20))),
          Part.makeLoft([loops, Part.Wire(Part.makeCircle(3, V(0,0,15)))], True),
          Part.makeTorus(12, 4).common(Part.makeBox(20, 20, 20)),
          Part.Wire(Part.makeHelix(3, 12, 8)).makePipeShell([ring], True, False)]
for i, body in enumerate(bodies):
    body.exportStep('freecad %d.step' % i)
)";

bool is_installed(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

TEST(cad_faces, of_files_of_other_programs_are_all_there_and_as_large_as_the_kernel_says) {
    const cad_folder folder;
    const std::string in_folder = "cd '" + folder.file("") + "' && HOME=$PWD timeout 100 ";
    const bool has_gmsh = is_installed("gmsh"), has_freecad = is_installed("freecadcmd");
    if (!has_gmsh && !has_freecad)
        GTEST_SKIP() << "neither gmsh nor freecadcmd is installed";
    std::vector<std::string> names;
    if (has_gmsh) {
        std::ofstream(folder.file("gmsh.geo")) << gmsh_script;
        ASSERT_EQ(std::system((in_folder + "gmsh -v 0 -0 gmsh.geo -format step -o gmsh.step "
                                           ">/dev/null 2>&1")
                                  .c_str()),
                  0);
        names.emplace_back("gmsh.step");
    }
    if (has_freecad) {
        std::ofstream(folder.file("bodies.py")) << freecad_script;
        ASSERT_EQ(
            std::system((in_folder + "freecadcmd bodies.py </dev/null >/dev/null 2>&1").c_str()),
            0);
        for (int i = 0; i < 6; ++i)
            names.push_back("freecad " + std::to_string(i) + ".step");
    }
    for (const std::string& name : names)
        expect_faces(name, cad_records::of(cad_records::text_of(folder.file(name)), false),
                     faces_of<STEPControl_Reader>(folder.file(name)));
}

} // namespace
