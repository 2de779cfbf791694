// SPDX-License-Identifier: MIT
// write_document: reads files with the kernel, and writes its document of parts and styles.
#include "document.h"

#include "faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <map>
#include <optional>
#include <stdexcept>
#include <streambuf>
#include <vector>

#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TCollection_AsciiString.hxx>
#include <Message_ProgressIndicator.hxx>
#include <NCollection_DataMap.hxx>
#include <NCollection_Map.hxx>
#include <TDF_LabelMapHasher.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs.hxx>
#include <XCAFPrs_DocumentExplorer.hxx>
#include <XCAFPrs_DocumentNode.hxx>
#include <XCAFPrs_IndexedDataMapOfShapeStyle.hxx>
#include <XCAFPrs_Style.hxx>
#include <sys/mman.h>
#include <unistd.h>

namespace cad {

namespace {

using l3d_detail::cad_record;

/// The look of faces and curves: colour and opacity.
struct look {
    std::uint64_t color = 0xffffff;
    double opacity = 1;

    friend bool operator==(const look&, const look&) = default;
};

std::uint64_t pixel_word(const Quantity_Color& color) {
    std::array<double, 3> levels{};
    color.Values(levels[0], levels[1], levels[2], Quantity_TOC_sRGB);
    std::uint64_t word = 0;
    for (const double level : levels)
        word =
            word << 8 | static_cast<std::uint64_t>(std::lround(255 * std::clamp(level, 0.0, 1.0)));
    return word;
}

look face_look(const XCAFPrs_Style& style) {
    if (!style.IsSetColorSurf())
        return {};
    return {pixel_word(style.GetColorSurf()),
            std::clamp<double>(style.GetColorSurfRGBA().Alpha(), 0, 1)};
}

look line_look(const XCAFPrs_Style& style) {
    return style.IsSetColorCurv() ? look{pixel_word(style.GetColorCurv()), 1} : face_look(style);
}

/// The name of a label in the document; empty if it only repeats the label's position.
std::string name_of(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name))
        return {};
    const std::string text = TCollection_AsciiString(name->Get()).ToCString();
    return text.starts_with("=>[") ? std::string() : text;
}

/// The path of a part: the names from the top of the assembly down to the part, separated by
/// slashes. If the file has only one part or assembly at the top, the path leaves out the name at
/// the top, unless it is the part's own name.
std::string path_of(const XCAFPrs_DocumentExplorer& at, bool has_one_root) {
    std::string path;
    const int depth = at.CurrentDepth();
    for (int i = has_one_root && depth > 0 ? 1 : 0; i <= depth; ++i) {
        const XCAFPrs_DocumentNode& node = at.Current(i);
        std::string name = name_of(node.Label);
        if (name.empty())
            name = name_of(node.RefLabel);
        std::ranges::replace(name, '/', '_'); // a slash stands between names
        if (!name.empty())
            path += (path.empty() ? "" : "/") + name;
    }
    return path.empty() ? "part" : path;
}

/// Whether a placement only turns and moves. Such a placement keeps lengths, and the outside of a
/// body stays outside.
bool is_rigid(const TopLoc_Location& place) {
    constexpr double rounding = 1e-12;
    const gp_Trsf by = place.Transformation();
    return !by.IsNegative() && std::abs(by.ScaleFactor() - 1) <= rounding;
}

/// Writes the parts of an assembly: each shape once, and each part's placement of its shape.
class part_writer {
public:
    part_writer(l3d_detail::cad_writer& to, const std::function<void()>& flush)
        : to_(to), flush_(flush), faces_(to) {}

    void write(const XCAFPrs_DocumentExplorer& at, bool has_one_root) {
        const XCAFPrs_DocumentNode& node = at.Current();
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(node.RefLabel);
        if (shape.IsNull())
            return;
        const bool stays = is_rigid(node.Location);
        const std::uint64_t number = !stays ? written(node.RefLabel, shape, node.Location)
                                     : numbers_.IsBound(node.RefLabel)
                                         ? numbers_.Find(node.RefLabel)
                                         : written(node.RefLabel, shape, {});
        if (stays)
            numbers_.Bind(node.RefLabel, number);
        to_.begin(cad_record::place);
        to_.count(number);
        std::string name = path_of(at, has_one_root);
        if (const int times = ++names_[name]; times > 1)
            name += " (" + std::to_string(times) + ')';
        to_.text(name);
        const bool shows_own = whole_[number] && !has_color(node);
        put(shows_own                     ? *whole_[number]
            : node.Style.IsSetColorSurf() ? face_look(node.Style)
                                          : line_look(node.Style));
        const gp_Trsf place = stays ? node.Location.Transformation() : gp_Trsf();
        for (int row = 1; row <= 3; ++row)
            for (int column = 1; column <= 4; ++column)
                to_.number(place.Value(row, column));
        flush_();
    }

    void finish() {
        faces_.finish();
        to_.begin(cad_record::end);
        flush_();
    }

private:
    /// Writes a shape, moved by `by`, and returns the shape's number in the records.
    std::uint64_t written(const TDF_Label& label, const TopoDS_Shape& shape,
                          const TopLoc_Location& by) {
        to_.begin(cad_record::shape);
        XCAFPrs_IndexedDataMapOfShapeStyle styles;
        XCAFPrs::CollectStyleSettings(label, TopLoc_Location(), styles);
        TopTools_IndexedMapOfShape shapes;
        TopExp::MapShapes(shape, TopAbs_FACE, shapes);
        // The faces of a solid or a shell have its style, unless they have their own. A place
        // may have another style than the whole shape.
        std::vector<std::optional<look>> by_face(static_cast<std::size_t>(shapes.Size()));
        std::optional<look> whole;
        for (const TopAbs_ShapeEnum kind :
             {TopAbs_COMPOUND, TopAbs_COMPSOLID, TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE})
            for (int i = 1; i <= styles.Extent(); ++i) {
                if (styles.FindKey(i).ShapeType() != kind || !styles(i).IsSetColorSurf())
                    continue;
                TopTools_IndexedMapOfShape styled;
                TopExp::MapShapes(styles.FindKey(i), TopAbs_FACE, styled);
                if (kind != TopAbs_FACE && styled.Size() == shapes.Size()) {
                    whole = face_look(styles(i));
                    continue;
                }
                for (int k = 1; k <= styled.Size(); ++k)
                    if (const int index = shapes.FindIndex(styled(k)); index > 0)
                        by_face[static_cast<std::size_t>(index) - 1] = face_look(styles(i));
            }
        whole_.push_back(whole);
        use(std::nullopt);
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
            use(by_face[static_cast<std::size_t>(shapes.FindIndex(face.Current())) - 1]);
            faces_.write(TopoDS::Face(face.Current().Moved(by)));
            flush_();
        }
        for (TopExp_Explorer edge(shape, TopAbs_EDGE, TopAbs_FACE); edge.More(); edge.Next()) {
            use(styles.Contains(edge.Current())
                    ? std::optional(line_look(styles.FindFromKey(edge.Current())))
                    : std::nullopt);
            faces_.write_curve(TopoDS::Edge(edge.Current().Moved(by)));
        }
        return whole_.size() - 1;
    }

    /// Whether a part has a colour of its own, beside the colour of its shape.
    static bool has_color(const XCAFPrs_DocumentNode& node) {
        TDF_Label color;
        return node.Label != node.RefLabel &&
               (XCAFDoc_ColorTool::GetColor(node.Label, XCAFDoc_ColorSurf, color) ||
                XCAFDoc_ColorTool::GetColor(node.Label, XCAFDoc_ColorGen, color));
    }

    void put(const look& one) {
        to_.count(one.color);
        to_.number(one.opacity);
    }

    /// Sets the look of the faces and curves that are written next. Without a look, they get the
    /// look of the part that places their shape.
    void use(const std::optional<look>& now) {
        if (look_ == now)
            return;
        look_ = now;
        to_.begin(now ? cad_record::material : cad_record::of_place);
        if (now)
            put(*now);
    }

    l3d_detail::cad_writer& to_;
    const std::function<void()>& flush_;
    face_writer faces_;
    std::map<std::string, int> names_;
    std::optional<look> look_;
    /// The number of each written shape, by its label.
    NCollection_DataMap<TDF_Label, std::uint64_t, TDF_LabelMapHasher> numbers_;
    std::vector<std::optional<look>> whole_; ///< for each shape, the look that it has as a whole
};

/// The shares of the work that are done after three stages, in large files. The stages are reading
/// the text, making entities of the text, and making shapes of the entities. Then faces are
/// written. Reading takes about 60 % of the time of a STEP file's entities.
constexpr double when_read = 0.12, when_parsed = 0.2, when_made = 0.7;

/// The text of a file as a stream, which tells which share of the text was read.
class told_text : public std::streambuf {
public:
    told_text(std::string_view text, std::atomic<double>& share) : text_(text), share_(share) {}

private:
    int_type underflow() override {
        constexpr std::size_t step = std::size_t{1} << 16; // a percent has several in large files
        const std::string_view next = text_.substr(at_, step);
        if (next.empty())
            return traits_type::eof();
        at_ += next.size();
        share_ = when_read * static_cast<double>(at_) / static_cast<double>(text_.size());
        char* const first = const_cast<char*>(next.data()); // a stream that is only read
        setg(first, first, first + next.size());
        return traits_type::to_int_type(*first);
    }

    std::string_view text_;
    std::atomic<double>& share_;
    std::size_t at_ = 0;
};

/// Takes the CAD kernel's reports of its progress with shapes, and sets the share of the work that
/// is done.
class told_share : public Message_ProgressIndicator {
public:
    explicit told_share(std::atomic<double>& share) : share_(share) {}
    void Show(const Message_ProgressScope&, Standard_Boolean) override {
        share_ = when_parsed + (when_made - when_parsed) * GetPosition();
    }

private:
    std::atomic<double>& share_;
};

IFSelect_ReturnStatus parse(STEPCAFControl_Reader& reader, std::string_view text,
                            std::atomic<double>& share) {
    told_text told(text, share);
    std::istream stream(&told);
    // The reader looks for files that this one names in the folder of its name: there are none.
    return reader.ChangeReader().ReadStream("/dev/null/part.step", stream);
}

/// Parses the text of an IGES file. The CAD kernel can read IGES only from a file with a name. This
/// takes some 3 % of the time, so its progress is not told.
IFSelect_ReturnStatus parse(IGESCAFControl_Reader& reader, std::string_view text,
                            std::atomic<double>&) {
    const int file = memfd_create("l3d_cad", MFD_CLOEXEC);
    const std::string path = "/proc/self/fd/" + std::to_string(file);
    if (!(std::ofstream(path, std::ios::binary) << text << std::flush))
        throw std::runtime_error("there is no memory for a copy of the file");
    const IFSelect_ReturnStatus status = reader.ReadFile(path.c_str());
    close(file);
    return status;
}

/// Reads a file's text into a document. Returns the reason of a failure, or "".
template <class Reader>
std::string read(std::string_view text, const Handle(TDocStd_Document) & document,
                 const char* format, std::atomic<double>& share) {
    Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(false);
    if (parse(reader, text, share) != IFSelect_RetDone)
        return std::string("Open CASCADE cannot read it as ") + format;
    share = when_parsed;
    Handle(TDocStd_Document) to = document;
    const Handle(told_share) told = new told_share(share);
    return reader.Transfer(to, told->Start()) ? ""
                                              : "it holds no shapes that Open CASCADE can make";
}

} // namespace

std::string write_document(std::string_view text, bool is_iges, l3d_detail::cad_writer& to,
                           const std::function<void()>& flush, std::atomic<double>& share) {
    try {
        const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
        std::string why = is_iges ? read<IGESCAFControl_Reader>(text, document, "IGES", share)
                                  : read<STEPCAFControl_Reader>(text, document, "STEP", share);
        if (!why.empty())
            return why;
        TDF_LabelSequence roots;
        XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
        constexpr auto leaves = XCAFPrs_DocumentExplorerFlags_OnlyLeafNodes;
        double count = 1, done = 0; // faces and places; flush is called after each, and at the end
        NCollection_Map<TDF_Label, TDF_LabelMapHasher> known;
        for (XCAFPrs_DocumentExplorer at(document, leaves); at.More(); at.Next()) {
            ++count;
            if (known.Add(at.Current().RefLabel))
                for (TopExp_Explorer face(XCAFDoc_ShapeTool::GetShape(at.Current().RefLabel),
                                          TopAbs_FACE);
                     face.More(); face.Next())
                    ++count;
        }
        const std::function<void()> flush_and_tell = [&] {
            flush();
            share = std::min(1.0, when_made + (1 - when_made) * ++done / count);
        };
        part_writer parts(to, flush_and_tell);
        for (XCAFPrs_DocumentExplorer at(document, leaves); at.More(); at.Next())
            parts.write(at, roots.Length() == 1);
        parts.finish();
        return {};
    } catch (const Standard_Failure& failure) {
        return std::string("Open CASCADE fails: ") + failure.DynamicType()->Name() + ' ' +
               failure.GetMessageString();
    }
}

} // namespace cad
