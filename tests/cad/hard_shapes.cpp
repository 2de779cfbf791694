// SPDX-License-Identifier: MIT
// Shapes that are hard to read: threads, helices, poles and seams that are cut, gaps, sizes.
#include "cad/shapes.h"

#include <cmath>
#include <numbers>

#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFill.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Quantity_Color.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

namespace {

constexpr double pi = std::numbers::pi;

const gp_Ax2 upright(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

TopoDS_Shape drum(const gp_Ax2& at, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(at, radius, height).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& what) {
    return BRepAlgoAPI_Cut(from, what).Shape();
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& points) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < points.size(); ++i)
        wire.Add(BRepBuilderAPI_MakeEdge(points[i], points[(i + 1) % points.size()]));
    return wire.Wire();
}

TopoDS_Wire circle(const gp_Ax2& at, double radius) {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(at, radius))).Wire();
}

/// A helix about z from z0 on.
TopoDS_Wire helix(double radius, double pitch, double turns, double z0) {
    const Handle(Geom_CylindricalSurface) on = new Geom_CylindricalSurface(gp_Ax3(upright), radius);
    const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, z0), gp_Dir2d(2 * pi, pitch));
    const double length = turns * std::hypot(2 * pi, pitch);
    TopoDS_Wire wire =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(line, on, 0, length).Edge()).Wire();
    BRepLib::BuildCurves3d(wire);
    return wire;
}

/// A bolt's shank: a groove of three corners winds around a cylinder.
TopoDS_Shape cut_thread() {
    BRepOffsetAPI_MakePipeShell groove(helix(10, 3, 4, 2));
    groove.SetMode(gp_Dir(0, 0, 1));
    groove.Add(polygon({{8.5, 0, 2}, {10.5, 0, 1}, {10.5, 0, 3}}));
    groove.Build();
    groove.MakeSolid();
    return cut(drum(upright, 10, 20), groove.Shape());
}

TopoDS_Shape spring() {
    const TopoDS_Face disc =
        BRepBuilderAPI_MakeFace(circle(gp_Ax2(gp_Pnt(10, 0, 0), gp_Dir(0, 1, 0)), 1.5)).Face();
    return BRepOffsetAPI_MakePipe(helix(10, 5, 3, 0), disc).Shape();
}

TopoDS_Shape spiral_stair() {
    TopExp_Explorer inner(helix(4, 6, 2.5, 0), TopAbs_EDGE),
        outer(helix(9, 6, 2.5, 0), TopAbs_EDGE);
    return BRepFill::Face(TopoDS::Edge(inner.Current()), TopoDS::Edge(outer.Current()));
}

/// An arc between two places of the axis turns about it.
TopoDS_Shape lemon() {
    const Handle(Geom_TrimmedCurve) arc =
        GC_MakeArcOfCircle(gp_Pnt(0, 0, -8), gp_Pnt(5, 0, 0), gp_Pnt(0, 0, 8)).Value();
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(arc).Edge(),
                                 gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)))
        .Shape();
}

TopoDS_Shape loft_to_a_point() {
    BRepOffsetAPI_ThruSections sections(true, false);
    sections.AddWire(polygon({{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}}));
    sections.AddWire(polygon({{-6, -6, 9}, {6, -6, 9}, {6, 6, 9}, {-6, 6, 9}}));
    sections.AddVertex(BRepBuilderAPI_MakeVertex(gp_Pnt(1, 1, 20)).Vertex());
    return sections.Shape();
}

TopoDS_Shape twisted_sweep() {
    const TopoDS_Wire spine =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 20))).Wire();
    BRepOffsetAPI_MakePipeShell sweep(spine);
    sweep.SetMode(helix(20, 40, 0.5, 0), true);
    sweep.Add(polygon({{-5, -3, 0}, {5, -3, 0}, {5, 3, 0}, {-5, 3, 0}}));
    sweep.Build();
    sweep.MakeSolid();
    return sweep.Shape();
}

TopoDS_Shape drafted_box() {
    const TopoDS_Shape body = box(0, 0, 0, 20, 15, 10);
    BRepOffsetAPI_DraftAngle draft(body);
    int i = 0;
    for (TopExp_Explorer face(body, TopAbs_FACE); face.More() && i < 4; face.Next(), ++i)
        draft.Add(TopoDS::Face(face.Current()), gp_Dir(0, 0, 1), 0.1,
                  gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
    draft.Build();
    return draft.Shape();
}

/// A box with a fillet whose radius grows along the edge.
TopoDS_Shape growing_fillet() {
    const TopoDS_Shape body = box(0, 0, 0, 20, 15, 10);
    BRepFilletAPI_MakeFillet fillet(body);
    int i = 0;
    for (TopExp_Explorer edge(body, TopAbs_EDGE); edge.More() && i < 3; edge.Next(), ++i)
        fillet.Add(1, 3, TopoDS::Edge(edge.Current()));
    return fillet.Shape();
}

TopoDS_Shape filleted(const TopoDS_Shape& body, double radius) {
    BRepFilletAPI_MakeFillet fillet(body);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(body, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i)
        fillet.Add(radius, TopoDS::Edge(edges(i)));
    return fillet.Shape();
}

TopoDS_Shape open_shell() {
    const TopoDS_Shape body = filleted(box(0, 0, 0, 30, 20, 10), 3);
    TopTools_ListOfShape open;
    open.Append(TopExp_Explorer(body, TopAbs_FACE).Current());
    BRepOffsetAPI_MakeThickSolid shell;
    shell.MakeThickSolidByJoin(body, open, -1, 1e-3);
    return shell.Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& by) {
    return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

/// Five squares that leave gaps of 0.008 mm between them, sewn with a tolerance of 0.01 mm.
TopoDS_Shape sewn_with_gaps() {
    BRepBuilderAPI_Sewing sewing(1e-2);
    for (int i = 0; i < 5; ++i) {
        const double x = 10.008 * i, z = std::sin(i), next = std::sin(i + 1);
        sewing.Add(BRepBuilderAPI_MakeFace(
            polygon({{x, 0, z}, {x + 10, 0, next}, {x + 10, 10, next}, {x, 10, z}})));
    }
    sewing.Perform();
    return sewing.SewedShape();
}

/// Three bodies with faces in common.
TopoDS_Shape cells() {
    BOPAlgo_Builder builder;
    builder.AddArgument(box(0, 0, 0, 10, 10, 10));
    builder.AddArgument(box(10, 2, 0, 20, 12, 10));
    builder.AddArgument(drum(gp_Ax2(gp_Pnt(5, 5, 10), gp_Dir(0, 0, 1)), 3, 5));
    builder.Perform();
    return builder.Shape();
}

/// A plate with slits of 0.001 mm, and with an island in a hole.
TopoDS_Shape slit_plate() {
    BRepBuilderAPI_MakeFace plate(gp_Pln(), 0, 20, 0, 10);
    for (int i = 0; i < 4; ++i) {
        const double x = 2 + 2.0 * i;
        plate.Add(TopoDS::Wire(
            polygon({{x, 1, 0}, {x + 1e-3, 1, 0}, {x + 1e-3, 9, 0}, {x, 9, 0}}).Reversed()));
    }
    plate.Add(TopoDS::Wire(circle(gp_Ax2(gp_Pnt(15, 5, 0), gp_Dir(0, 0, 1)), 4).Reversed()));
    BRepBuilderAPI_MakeFace island(circle(gp_Ax2(gp_Pnt(15, 5, 0), gp_Dir(0, 0, 1)), 2));
    BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, plate.Face());
    builder.Add(both, island.Face());
    return BRepPrimAPI_MakePrism(both, gp_Vec(0, 0, 2)).Shape();
}

} // namespace

std::vector<named_shape> hard_shapes() {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 10).Shape();
    const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(upright, 12, 4).Shape();
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(upright, 10, 0, 20).Shape();
    const TopoDS_Shape rounded = filleted(box(0, 0, 0, 30, 20, 10), 2);
    gp_Trsf away, smaller, larger, mirrored;
    away.SetTranslation(gp_Vec(1e6, -2e6, 3e5));
    smaller.SetScale(gp_Pnt(0, 0, 0), 1e-2);
    larger.SetScale(gp_Pnt(0, 0, 0), 1e4);
    mirrored.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)));
    const gp_Ax2 slanted(gp_Pnt(-14, -3, -14), gp_Dir(1, 0.3, 1));
    return {
        {"cut thread", cut_thread()},
        {"spring", spring()},
        {"spiral stair", spiral_stair()},
        {"lemon", lemon()},
        {"loft to a point", loft_to_a_point()},
        {"twisted sweep", twisted_sweep()},
        {"drafted box", drafted_box()},
        {"fillets that grow", growing_fillet()},
        {"open shell", open_shell()},
        {"box far away", moved(rounded, away)},
        {"small box", moved(rounded, smaller)},
        {"large box", moved(rounded, larger)},
        {"mirrored cut cone", moved(cut(cone, drum(slanted, 3, 40)), mirrored)},
        {"squares sewn with gaps", sewn_with_gaps()},
        {"cells with common faces", cells()},
        {"plate with slits and an island", slit_plate()},
        {"ball without a corner at its pole", cut(ball, box(-3, -2, 5, 20, 20, 20))},
        {"ball with a hole over its seam",
         cut(ball, drum(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 3, 20))},
        {"ball with a slanting hole", cut(ball, drum(slanted, 3, 40))},
        {"ring with a slanting hole", cut(ring, drum(slanted, 3, 40))},
        {"part of a ring", BRepAlgoAPI_Common(ring, box(2, -20, -3, 20, 20, 3.5)).Shape()},
        {"ring of splines with a hole",
         cut(BRepBuilderAPI_NurbsConvert(ring).Shape(), drum(slanted, 3, 40))},
        {"cone without its tip's half", cut(cone, box(0, -20, 8, 20, 20, 30))},
    };
}

void write_rows_of_bolts(const std::string& path, int n) {
    const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const auto name = [](const TDF_Label& label, const std::string& text) {
        TDataStd_Name::Set(label, text.c_str());
    };
    const auto at = [](double x, double y) {
        gp_Trsf place;
        place.SetTranslation(gp_Vec(x, y, 0));
        return TopLoc_Location(place);
    };
    std::vector<gp_Pnt> corners;
    for (int i = 0; i < 6; ++i)
        corners.emplace_back(5 * std::cos(i * pi / 3), 5 * std::sin(i * pi / 3), 0);
    const TopoDS_Shape head =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon(corners)).Face(), gp_Vec(0, 0, -4))
            .Shape();
    gp_Trsf smaller;
    smaller.SetScale(gp_Pnt(0, 0, 0), 0.3);
    const TopoDS_Shape body = BRepAlgoAPI_Fuse(moved(cut_thread(), smaller), head).Shape();
    const TDF_Label plate = shapes->NewShape(), row = shapes->NewShape();
    name(plate, "plate");
    name(row, "row");
    const TDF_Label bolt = shapes->AddShape(body, false);
    name(bolt, "bolt");
    colors->SetColor(bolt, Quantity_Color(0.5, 0.55, 0.6, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    for (int i = 0; i < n; ++i) {
        const TDF_Label place = shapes->AddComponent(row, bolt, at(12 * i, 0));
        name(place, "bolt " + std::to_string(i + 1));
        if (i % 10 == 9)
            colors->SetColor(place, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    }
    for (int i = 0; i < 10; ++i)
        name(shapes->AddComponent(plate, row, at(0, 12 * i)), "row " + std::to_string(i + 1));
    shapes->UpdateAssemblies();
    write_document(document, path);
}
