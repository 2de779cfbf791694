// SPDX-License-Identifier: MIT
// Shapes for tests, by the kernel's own tools.
#include "cad/shapes.h"

#include <cmath>
#include <numbers>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

namespace {

constexpr double pi = std::numbers::pi;

const gp_Ax2 upright(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));

gp_Ax2 axis(double x, double y, double z, double dx = 0, double dy = 0, double dz = 1) {
    return {gp_Pnt(x, y, z), gp_Dir(dx, dy, dz)};
}

TopoDS_Shape filleted_box(double radius, double tolerance) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 10).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
        fillet.Add(radius, TopoDS::Edge(edge.Current()));
    const TopoDS_Shape result = fillet.Shape();
    ShapeFix_ShapeTolerance().SetTolerance(result, tolerance);
    return result;
}

TopoDS_Wire circle(const gp_Ax2& at, double radius) {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(at, radius))).Wire();
}

TopoDS_Wire square(double z, double side) {
    const gp_Pnt p[4] = {{-side, -side, z}, {side, -side, z}, {side, side, z}, {-side, side, z}};
    BRepBuilderAPI_MakeWire wire;
    for (int i = 0; i < 4; ++i)
        wire.Add(BRepBuilderAPI_MakeEdge(p[i], p[(i + 1) % 4]));
    return wire.Wire();
}

TopoDS_Shape loft(bool is_ruled) {
    BRepOffsetAPI_ThruSections sections(true, is_ruled);
    sections.AddWire(square(0, 10));
    sections.AddWire(square(12, 5));
    sections.AddWire(square(25, 8));
    return sections.Shape();
}

TopoDS_Shape loft_of_circles() {
    BRepOffsetAPI_ThruSections sections(true, false);
    sections.AddWire(circle(axis(0, 0, 0), 10));
    sections.AddWire(circle(axis(3, 0, 12), 6));
    sections.AddWire(circle(axis(0, 2, 25), 9));
    return sections.Shape();
}

Handle(Geom_BSplineCurve) spline(const std::vector<gp_Pnt>& points, bool is_closed) {
    const Handle(TColgp_HArray1OfPnt) all =
        new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
    for (int i = 1; i <= all->Length(); ++i)
        all->SetValue(i, points[static_cast<std::size_t>(i) - 1]);
    GeomAPI_Interpolate through(all, is_closed, 1e-7);
    through.Perform();
    return through.Curve();
}

TopoDS_Shape pipe() {
    const auto path = spline({{0, 0, 0}, {0, 5, 10}, {8, 10, 15}, {20, 8, 20}}, false);
    gp_Pnt start;
    gp_Vec along;
    path->D1(path->FirstParameter(), start, along);
    const TopoDS_Wire spine = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(path)).Wire();
    const TopoDS_Face disc =
        BRepBuilderAPI_MakeFace(circle(gp_Ax2(start, gp_Dir(along)), 2)).Face();
    return BRepOffsetAPI_MakePipe(spine, disc).Shape();
}

/// A body between two curves that climb two cylinders.
TopoDS_Shape thread() {
    const Handle(Geom_CylindricalSurface) inner =
        new Geom_CylindricalSurface(gp_Ax3(upright), 10 * 0.99);
    const Handle(Geom_CylindricalSurface) outer =
        new Geom_CylindricalSurface(gp_Ax3(upright), 10 * 1.05);
    const gp_Pnt2d middle(2 * pi, 6);
    const gp_Ax2d slope(middle, gp_Dir2d(2 * pi, 6));
    BRepOffsetAPI_ThruSections sections(true);
    for (int i = 0; i < 2; ++i) {
        const Handle(Geom2d_Ellipse) arc =
            new Geom2d_Ellipse(slope, 2 * pi, i == 0 ? 1.5 : 1.5 / 4);
        const Handle(Geom2d_TrimmedCurve) half = new Geom2d_TrimmedCurve(arc, 0, pi);
        const Handle(Geom2d_TrimmedCurve) chord =
            GCE2d_MakeSegment(arc->Value(0), arc->Value(pi)).Value();
        const auto on = i == 0 ? inner : outer;
        BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(half, on).Edge(),
                                     BRepBuilderAPI_MakeEdge(chord, on).Edge());
        TopoDS_Wire whole = wire.Wire();
        BRepLib::BuildCurves3d(whole);
        sections.AddWire(whole);
    }
    sections.CheckCompatibility(false);
    const TopoDS_Shape screw = sections.Shape();
    BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeCylinder(upright, 10, 20).Shape());
    builder.Add(both, screw);
    return both;
}

TopoDS_Shape flange() {
    TopoDS_Shape body = BRepPrimAPI_MakeCylinder(upright, 30, 6).Shape();
    body = BRepAlgoAPI_Fuse(body, BRepPrimAPI_MakeCylinder(upright, 15, 25).Shape()).Shape();
    body = BRepAlgoAPI_Cut(body, BRepPrimAPI_MakeCylinder(upright, 11, 25).Shape()).Shape();
    for (int i = 0; i < 6; ++i)
        body = BRepAlgoAPI_Cut(
                   body, BRepPrimAPI_MakeCylinder(
                             axis(22 * std::cos(i * pi / 3), 22 * std::sin(i * pi / 3), 0), 2.5, 6)
                             .Shape())
                   .Shape();
    return body;
}

TopoDS_Shape crossing_cylinders() {
    const TopoDS_Shape body =
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(axis(0, 0, -20), 8, 40).Shape(),
                         BRepPrimAPI_MakeCylinder(axis(0, 0, 0, 1, 0, 0), 5, 20).Shape())
            .Shape();
    BRepFilletAPI_MakeFillet fillet(body);
    for (TopExp_Explorer edge(body, TopAbs_EDGE); edge.More(); edge.Next()) {
        TopoDS_Vertex first, last;
        const TopoDS_Edge e = TopoDS::Edge(edge.Current());
        double from = 0, to = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(e, from, to);
        // The curve where the cylinders meet is no conic.
        if (!curve.IsNull() && curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve)))
            fillet.Add(1, e);
    }
    return fillet.Shape();
}

/// A surface through a bumpy grid of points.
Handle(Geom_BSplineSurface) bumpy() {
    TColgp_Array2OfPnt points(1, 6, 1, 6);
    for (int i = 1; i <= 6; ++i)
        for (int j = 1; j <= 6; ++j)
            points.SetValue(i, j, gp_Pnt(5 * i, 5 * j, 3 * std::sin(1.3 * i) * std::cos(0.9 * j)));
    return GeomAPI_PointsToBSplineSurface(points).Surface();
}

TopoDS_Shape closed_spline_prism() {
    const auto profile = spline({{10, 0, 0}, {4, 7, 0}, {-8, 6, 0}, {-6, -7, 0}, {5, -5, 0}}, true);
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(profile)).Wire();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(2, 0, 15)).Shape();
}

TopoDS_Shape vase(double angle) {
    const auto profile = spline({{5, 0, 0}, {9, 0, 6}, {4, 0, 14}, {7, 0, 20}}, false);
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(profile).Edge(),
                                 gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), angle)
        .Shape();
}

TopoDS_Shape elliptic_prism() {
    const TopoDS_Wire wire =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Elips(upright, 12, 5))).Wire();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, 9)).Shape();
}

/// A cone cut by planes: along its axis, whose edge is a hyperbola, and along its side, a parabola.
TopoDS_Shape cut_cone() {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(upright, 10, 0, 20).Shape();
    const TopoDS_Shape aside = BRepPrimAPI_MakeBox(gp_Pnt(4, -20, -1), gp_Pnt(20, 20, 30)).Shape();
    return BRepAlgoAPI_Cut(cone, aside).Shape();
}

TopoDS_Shape hollow_ball() {
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 10).Shape(),
                           BRepPrimAPI_MakeSphere(gp_Pnt(1, 0, 0), 6).Shape())
        .Shape();
}

TopoDS_Shape chamfered_box() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 12, 14).Shape();
    BRepFilletAPI_MakeChamfer chamfer(box);
    for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
        chamfer.Add(1.5, TopoDS::Edge(edge.Current()));
    return chamfer.Shape();
}

} // namespace

TopoDS_Shape plate_with_holes(int n) {
    BRepBuilderAPI_MakeFace face(gp_Pln(), 0, 100, 0, 100);
    const double step = 100.0 / n;
    for (int i = 0; i < n * n; ++i)
        face.Add(TopoDS::Wire(
            circle(axis(step * (i % n + 0.5), step * (i / n + 0.5), 0), 0.35 * step).Reversed()));
    return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, 5)).Shape();
}

std::vector<named_shape> shapes_of_many_kinds() {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 10).Shape();
    const TopoDS_Shape drum = BRepPrimAPI_MakeCylinder(upright, 10, 20).Shape();
    return {
        {"filleted box", filleted_box(2, 1e-7)},
        {"loose filleted box", filleted_box(3, 1e-2)},
        {"ruled loft", loft(true)},
        {"smooth loft", loft(false)},
        {"loft of circles", loft_of_circles()},
        {"pipe", pipe()},
        {"thread", thread()},
        {"ball", ball},
        {"torus", BRepPrimAPI_MakeTorus(upright, 12, 4).Shape()},
        {"part of a torus", BRepPrimAPI_MakeTorus(upright, 12, 4, -1, 2, 4).Shape()},
        {"cone with a tip", BRepPrimAPI_MakeCone(upright, 10, 0, 20).Shape()},
        {"cut cone", cut_cone()},
        {"ball cut by a cylinder",
         BRepAlgoAPI_Cut(ball, BRepPrimAPI_MakeCylinder(axis(4, 0, -20), 4, 40).Shape()).Shape()},
        {"drum cut over its seam",
         BRepAlgoAPI_Common(drum,
                            BRepPrimAPI_MakeBox(gp_Pnt(3, -20, 2), gp_Pnt(20, 20, 18)).Shape())
             .Shape()},
        {"octant of a ball", BRepPrimAPI_MakeSphere(upright, 10, 0, pi / 2, pi / 2).Shape()},
        {"plate with 25 holes", plate_with_holes(5)},
        {"flange", flange()},
        {"cylinders that meet in a fillet", crossing_cylinders()},
        {"bumpy surface", BRepBuilderAPI_MakeFace(bumpy(), 1e-6).Face()},
        {"offset of a bumpy surface",
         BRepBuilderAPI_MakeFace(new Geom_OffsetSurface(bumpy(), 1), 1e-6).Face()},
        {"prism of a closed spline", closed_spline_prism()},
        {"vase", vase(2 * pi)},
        {"part of a vase", vase(4)},
        {"elliptic prism", elliptic_prism()},
        {"hollow ball", hollow_ball()},
        {"chamfered box", chamfered_box()},
        {"ball of splines", BRepBuilderAPI_NurbsConvert(ball).Shape()},
    };
}

void write_step(const TopoDS_Shape& shape, const std::string& path, const std::string& schema,
                const std::string& unit) {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.schema", schema.c_str());
    Interface_Static::SetCVal("write.step.unit", unit.c_str());
    STEPControl_Writer writer; // takes what was set before
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write(path.c_str());
}

void write_iges(const TopoDS_Shape& shape, const std::string& path, bool of_solids) {
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", of_solids ? 1 : 0);
    writer.AddShape(shape);
    writer.ComputeModel();
    writer.Write(path.c_str());
}

void write_document(const Handle(TDocStd_Document) & document, const std::string& path) {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetCVal("write.step.unit", "MM");
    STEPCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    writer.Transfer(document, STEPControl_AsIs);
    writer.Write(path.c_str());
}

void write_assembly(const std::string& path) {
    const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TDF_Label cart = shapes->NewShape();
    TDataStd_Name::Set(cart, "cart");
    const TopoDS_Shape round = BRepPrimAPI_MakeCylinder(axis(0, 0, 0), 10, 4).Shape();
    const TDF_Label wheel = shapes->AddShape(round, false);
    TDataStd_Name::Set(wheel, "wheel");
    colors->SetColor(wheel, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    const TopoDS_Shape long_one = BRepPrimAPI_MakeBox(gp_Pnt(-30, -2, 4), gp_Pnt(30, 2, 6)).Shape();
    const TDF_Label beam = shapes->AddShape(long_one, false);
    TDataStd_Name::Set(beam, "beam");
    TopExp_Explorer first(long_one, TopAbs_FACE);
    const TDF_Label face = shapes->AddSubShape(beam, first.Current());
    colors->SetColor(face, Quantity_ColorRGBA(Quantity_Color(0, 0, 1, Quantity_TOC_sRGB), 0.5F),
                     XCAFDoc_ColorSurf);
    gp_Trsf left, right;
    left.SetTranslation(gp_Vec(-30, 0, 0));
    right.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), pi / 2);
    right.SetTranslationPart(gp_Vec(30, 0, 0));
    TDataStd_Name::Set(shapes->AddComponent(cart, wheel, TopLoc_Location(left)), "left");
    TDataStd_Name::Set(shapes->AddComponent(cart, wheel, TopLoc_Location(right)), "right");
    TDataStd_Name::Set(shapes->AddComponent(cart, beam, TopLoc_Location()), "middle");
    shapes->UpdateAssemblies();
    write_document(document, path);
}
