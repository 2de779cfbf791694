// SPDX-License-Identifier: MIT
// Shapes of many kinds, made by Open CASCADE, and files of them.
#ifndef L3D_TESTS_CAD_SHAPES_H
#define L3D_TESTS_CAD_SHAPES_H

#include <string>
#include <vector>

#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>

/// A shape for a file.
struct named_shape {
    std::string name;
    TopoDS_Shape shape;
};

/// Fillets, lofts, sweeps, a thread, conics, periodic and degenerate faces, faces over the seam,
/// voids, tolerances from 1e-7 to 1e-2 mm.
std::vector<named_shape> shapes_of_many_kinds();

/// Threads and helices that are cut, poles and seams that are, points at the ends of lofts, gaps,
/// slits, shapes that are far away, small, large or mirrored.
std::vector<named_shape> hard_shapes();

/// A plate of 100 by 100 by 5 mm with n by n holes.
TopoDS_Shape plate_with_holes(int n);

/// Writes a STEP file. `schema` is as the kernel calls it: AP203, AP214IS or AP242DIS.
/// Units: `unit` is MM, INCH or M.
void write_step(const TopoDS_Shape& shape, const std::string& path,
                const std::string& schema = "AP214IS", const std::string& unit = "MM");

/// Writes an IGES file: of a solid's faces, or of solids.
void write_iges(const TopoDS_Shape& shape, const std::string& path, bool of_solids);

/// Writes a document of shapes, with names and colours, as STEP.
void write_document(const Handle(TDocStd_Document) & document, const std::string& path);

/// Writes an assembly: two red wheels and a beam, whose first face is blue and half transparent.
/// The wheels are at x = -30 and x = 30, the second one turned by 90 degrees about z.
void write_assembly(const std::string& path);

/// Writes an assembly of 10 rows, each of n bolts, 12 mm apart: one bolt and one row, at many
/// places. Each tenth bolt of a row is red, all others are steel. Names are "row 3/bolt 7", from 1.
void write_rows_of_bolts(const std::string& path, int n);

#endif
