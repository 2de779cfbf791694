# SPDX-License-Identifier: MIT
"""The types and the documentation of the module l3d.

Arrays are anything with the buffer protocol, such as NumPy's, or sequences within sequences.
Colours are numbers 0xRRGGBB, texts "#rrggbb", or three levels from 0 to 255.
"""

import os
from typing import Any, Literal, Optional, Protocol, Sequence, Union

__version__: str

class _HasArray(Protocol):
    def __array__(self) -> Any: ...

_Numbers = Union[Sequence[Any], _HasArray]
_Color = Union[int, str, Sequence[int]]
_Path = Union[str, bytes, os.PathLike[str], os.PathLike[bytes]]
_Vector = tuple[float, ...]
_Shade = Literal["lambert", "gouraud", "flat", "normals", "error", "zebra", "isophotes", "gaussian",
                 "mean", "draft"]
_Winding = Literal["nonzero", "even_odd"]
_Blending = Literal["coded", "linear"]
_Spread = Literal["pad", "repeat", "reflect"]

class Error(ValueError):
    """An argument or a file that makes no sense. `file` and `line` say where, if that is known."""
    file: Optional[str]
    line: Optional[int]

class FileError(Error, OSError):
    """A file that cannot be read or written."""

class Material:
    """The colour of a surface, and its highlights. A material never changes."""
    def __init__(self, color: _Color = 0xffffff, highlight: _Color = 0, sharpness: int = 32,
                 opacity: float = 1) -> None: ...
    @property
    def color(self) -> int:
        """The colour of light that is scattered to all sides, 0xRRGGBB."""
    @property
    def highlight(self) -> int:
        """The colour of mirrored light, 0xRRGGBB; black mirrors none."""
    @property
    def sharpness(self) -> int:
        """The exponent of highlights, from 1 to 1000."""
    @property
    def opacity(self) -> float:
        """From 0, invisible, to 1, opaque. Scene.add has one for a whole instance."""

class Camera:
    """A camera that looks from `eye` to `target`, y up. `fov` is the vertical angle in degrees."""
    def __init__(self, eye: _Numbers = (0, 0, 1), target: _Numbers = (0, 0, 0),
                 up: _Numbers = (0, 1, 0), fov: float = 38, near_z: float = 0.1, far_z: float = 1e16,
                 parallel: bool = False) -> None: ...
    @property
    def eye(self) -> _Vector:
        """The eye's place."""
    @eye.setter
    def eye(self, value: _Numbers) -> None: ...
    @property
    def target(self) -> _Vector:
        """The place in the middle of the picture."""
    @target.setter
    def target(self, value: _Numbers) -> None: ...
    @property
    def up(self) -> _Vector:
        """The direction that is upright in the picture."""
    @up.setter
    def up(self, value: _Numbers) -> None: ...
    @property
    def fov(self) -> float:
        """The vertical angle of view, in degrees."""
    @fov.setter
    def fov(self, value: float) -> None: ...
    @property
    def near_z(self) -> float:
        """The least distance along the view axis that is drawn."""
    @near_z.setter
    def near_z(self, value: float) -> None: ...
    @property
    def far_z(self) -> float:
        """The farthest distance along the view axis that is drawn."""
    @far_z.setter
    def far_z(self, value: float) -> None: ...
    @property
    def parallel(self) -> bool:
        """Whether far things look as large as near ones."""
    @parallel.setter
    def parallel(self, value: bool) -> None: ...
    def orbit(self, around_up: float, around_right: float = 0) -> None:
        """Turns the eye about the target, by degrees."""
    def approach(self, factor: float) -> None:
        """Multiplies the distance from the target."""
    def move(self, by: _Numbers) -> None:
        """Moves eye and target alike."""
    def copy(self) -> Camera:
        """Another camera with the same numbers."""

class Light:
    """A light beside the first one: far away in a direction, or near at a position.

    A light with a `reach` is as bright as its colour at that distance, and fades with the square of it.
    """
    def __init__(self, *, direction: Optional[_Numbers] = None, position: Optional[_Numbers] = None,
                 color: _Numbers = (1, 1, 1), reach: float = 0) -> None: ...

class Curve:
    """A NURBS curve through space. Without knots it begins at the first point and ends at the last.

    A closed curve is as smooth where it closes as elsewhere.
    """
    def __init__(self, points: _Numbers, degree: int = 3, *, knots: Optional[_Numbers] = None,
                 weights: Optional[_Numbers] = None, closed: bool = False) -> None: ...
    @staticmethod
    def circle(radius: float) -> Curve:
        """A circle about the origin, exact: from the x axis towards the y axis."""
    @staticmethod
    def polyline(points: _Numbers) -> Curve:
        """Straight lines from point to point."""
    def evaluate(self, t: float) -> _Vector:
        """The place at a parameter within `range`."""
    @property
    def range(self) -> _Vector:
        """The first and the last parameter."""
    @property
    def points(self) -> memoryview:
        """The control points: n x 3 doubles."""

class Surface:
    """A NURBS surface of rows x columns control points; u runs along rows."""
    def __init__(self, points: _Numbers, degree_u: int = 3, degree_v: int = 3, *,
                 knots_u: Optional[_Numbers] = None, knots_v: Optional[_Numbers] = None,
                 weights: Optional[_Numbers] = None) -> None: ...
    def evaluate(self, u: float, v: float) -> _Vector:
        """The place at parameters within `range_u` and `range_v`."""
    @property
    def range_u(self) -> _Vector:
        """The first and the last parameter u."""
    @property
    def range_v(self) -> _Vector:
        """The first and the last parameter v."""
    @property
    def points(self) -> memoryview:
        """The control points: rows x columns x 3 doubles."""

def revolved(curve: Curve) -> Surface:
    """The surface of a curve that turns once around the y axis, exact."""
def extruded(curve: Curve, by: _Numbers) -> Surface:
    """The surface of a curve that moves straight by a vector, exact."""
def ruled(first: Curve, second: Curve) -> Surface:
    """The surface of all lines between points of two curves of the same parameter."""
def pipe(curve: Curve, radius: float, tolerance: Optional[float] = None) -> Surface:
    """The pipe around a curve, within a tolerance: a thousandth of the radius unless it is given."""
def shape(name: str) -> list[Surface]:
    """The surfaces of a cone, cylinder, disc, sphere or torus, exact."""

class Model:
    """Patches, or polygons. A model never changes, and copies share it."""
    @staticmethod
    def load(file: _Path) -> Model:
        """Reads a file of any format that l3d knows, or the model of a name.

        Names are teapot, cone, cylinder, disc, sphere, torus, and those of installed models.
        """
    @staticmethod
    def from_patches(points: _Numbers, weights: Optional[_Numbers] = None) -> Model:
        """Bezier patches: n x rows x columns x 3 control points; 4 x 4 are bicubic ones.

        A patch has 2 to 16 points along each side. Weights make patches rational.
        """
    @staticmethod
    def from_polygons(vertices: _Numbers, faces: Union[_Numbers, Sequence[_Numbers]], *,
                      colors: Optional[_Numbers] = None, face_colors: Optional[_Numbers] = None,
                      normals: Optional[_Numbers] = None, crease_angle: float = 30) -> Model:
        """Polygons: n x 3 vertices, and faces that name them, counterclockwise from outside.

        Faces are an array of m x corners, or a list of faces of any lengths. `colors` are of vertices.
        The vertices are copied once, since a model never changes; `vertices` shows them without a copy.
        """
    @staticmethod
    def from_heights(heights: _Numbers, spacing: float = 1) -> Model:
        """A smooth surface through rows x columns heights along y; NaN leaves a hole."""
    @staticmethod
    def from_surfaces(surfaces: Union[Surface, Sequence[Surface]]) -> Model:
        """The patches of NURBS surfaces, exact."""
    def painted(self, material: Material, part: Optional[str] = None) -> Model:
        """The same model of another material, or with another one for the part of that name."""
    def only(self, names: Union[str, Sequence[str]]) -> Model:
        """A model of some parts alone."""
    def without(self, names: Union[str, Sequence[str]]) -> Model:
        """A model without some parts."""
    @property
    def kind(self) -> str:
        """"patches" or "polygons"."""
    @property
    def parts(self) -> list[str]:
        """The names of its parts."""
    @property
    def bounds(self) -> tuple[_Vector, _Vector]:
        """The least and the largest coordinates of its points."""
    @property
    def patches(self) -> Optional[memoryview]:
        """The control points as n x 4 x 4 x 3 doubles, without a copy; None for polygons."""
    @property
    def vertices(self) -> Optional[memoryview]:
        """The vertices as n x 3 doubles, without a copy; None for patches."""
    @property
    def triangles(self) -> Optional[memoryview]:
        """The faces cut into triangles: m x 3 places of vertices, without a copy; None for patches."""
    def _repr_png_(self) -> bytes:
        """The picture of a notebook."""

class Scene:
    """Models of patches, each placed any number of times."""
    def __init__(self, model: Optional[Model] = None) -> None: ...
    @staticmethod
    def load(file: _Path) -> Scene:
        """Reads a file of patches, such as a STEP assembly, whose places share the shapes that they repeat."""
    def add(self, model: Model, placement: Optional[_Numbers] = None, *, at: _Numbers = (0, 0, 0),
            turn: _Numbers = (0, 0, 0), scale: float = 1, material: Optional[Material] = None,
            opacity: float = 1) -> int:
        """Adds an instance and returns its index.

        The model is scaled, turned about x, y and z by degrees, and moved, or a 4 x 4 matrix places it.
        """
    def place(self, index: int, placement: Optional[_Numbers] = None, *, at: _Numbers = (0, 0, 0),
              turn: _Numbers = (0, 0, 0), scale: float = 1) -> None:
        """Puts an instance elsewhere."""
    def paint(self, index: int, material: Optional[Material] = None) -> None:
        """Gives all of an instance one material; without one, its model's own are seen again."""
    def set_opacity(self, index: int, opacity: float) -> None:
        """Makes an instance transparent: 0 is invisible, and 1 is opaque. Eight may be below 1."""
    def lay(self, index: int, picture: Optional[Picture] = None) -> None:
        """Lays a picture on each patch of an instance, or takes it away."""
    def clear(self) -> None:
        """Takes all instances away."""
    def __len__(self) -> int: ...
    @property
    def bounds(self) -> tuple[_Vector, _Vector]:
        """The least and the largest coordinates of all that it holds."""
    def _repr_png_(self) -> bytes:
        """The picture of a notebook."""

class Picture:
    """Pixels that never change. The buffer protocol shows them without a copy.

    The array is height x width x 3 bytes: red, green and blue. Row 0 is on top. The last stride is -1,
    and rows have gaps between them, so that bytes(picture) or numpy.ascontiguousarray makes a dense copy.
    """
    @staticmethod
    def load(file: _Path) -> Picture:
        """Reads a PNG, JPEG or binary PPM file."""
    @staticmethod
    def from_array(pixels: _Numbers) -> Picture:
        """A picture of height x width levels of grey, or x 3 of red, green and blue, or x 4 with alpha."""
    def save(self, file: _Path) -> None:
        """Writes a .png or .ppm file, which appears when it is complete."""
    @property
    def size(self) -> tuple[int, int]:
        """Width and height."""
    @property
    def words(self) -> memoryview:
        """The pixels as height x width words, without a copy: 0xTTRRGGBB.

        T is how transparent a pixel is, in pictures without background.
        """
    @property
    def report(self) -> dict[str, Any]:
        """What the frame cost and how exact it is; empty for other pictures.

        For patches, `error_bound_px` bounds the error of places in pixels.
        """
    @property
    def depth(self) -> Optional[memoryview]:
        """The distance of each pixel along the view axis, floats, if the frame was drawn with depth."""
    @property
    def error_map(self) -> Optional[memoryview]:
        """The bound of each pixel's error in levels of 255, floats: the map of doubt.

        The frame must have been drawn with error_map. None where such a bound is not known.
        """
    def __buffer__(self, flags: int, /) -> memoryview: ...
    def _repr_png_(self) -> bytes:
        """The picture of a notebook."""

class View:
    """An eye that draws one frame after another: quicker than draw(), since it keeps threads and memory.

    Frames follow the scene and the camera. One thread at a time may use a view.
    """
    def __init__(self, what: Union[Model, Scene], size: _Numbers = (640, 480), *,
                 camera: Optional[Camera] = None, frame: Optional[bool] = None,
                 tolerance: float = 0.25, shade_tolerance: float = 2, lateral_only: bool = False,
                 shade: _Shade = "lambert", inspection_direction: _Numbers = (0, 1, 0),
                 inspection_scale: float = 0, inspection_stripe: float = 10,
                 light: _Numbers = (0.4, 0.8, 0.45), light_color: _Numbers = (1, 1, 1),
                 lights: Sequence[Light] = (), ambient: _Numbers = (0.1, 0.1, 0.1),
                 headlight: bool = False, antialias: bool = True,
                 fog: Optional[tuple[Any, ...]] = None,
                 background: Union[None, _Color, tuple[_Color, _Color]] = (0x333b46, 0x707a86),
                 wireframe: bool = False, net: bool = False, one_sided: bool = False,
                 depth: bool = False, most_samples: int = 0, error_map: bool = False,
                 curves: Sequence[Union[Curve, tuple[Any, ...]]] = (),
                 style: Literal["solid", "wireframe", "hidden_lines"] = "solid",
                 rotation: _Numbers = (0, 0, 0), cull: bool = False,
                 material: Optional[Material] = None, count_pixels: bool = False,
                 threads: Optional[int] = None) -> None: ...
    def draw(self) -> Picture:
        """Draws a frame. Other threads of Python run meanwhile."""
    def change(self, *, tolerance: float = ..., shade_tolerance: float = ..., lateral_only: bool = ...,
               shade: _Shade = ..., inspection_direction: _Numbers = ..., inspection_scale: float = ...,
               inspection_stripe: float = ..., light: _Numbers = ..., light_color: _Numbers = ...,
               lights: Sequence[Light] = ..., ambient: _Numbers = ..., headlight: bool = ...,
               antialias: bool = ..., fog: tuple[Any, ...] = ...,
               background: Union[None, _Color, tuple[_Color, _Color]] = ..., wireframe: bool = ...,
               net: bool = ..., one_sided: bool = ..., depth: bool = ..., most_samples: int = ...,
               error_map: bool = ..., curves: Sequence[Union[Curve, tuple[Any, ...]]] = ...,
               style: Literal["solid", "wireframe", "hidden_lines"] = ..., rotation: _Numbers = ...,
               cull: bool = ..., material: Material = ..., count_pixels: bool = ...) -> View:
        """Changes settings of the next frames; others stay."""
    def frame_all(self) -> View:
        """Moves the camera so that everything is seen."""
    def pick(self, x: float, y: float) -> Optional[dict[str, Any]]:
        """The nearest surface at a place of the picture: point, normal, curvatures, and their errors."""
    def lines(self, *, tolerance: float = 0.1, hidden: bool = True,
              joints: bool = False) -> dict[str, Any]:
        """Contours, creases and borders of patches as polylines: their `bound` in pixels, `lines` and an `svg` file.

        A line has a `kind`, `is_seen`, the `instance` and the `pieces` that it lies on, and `points`: x, y
        and depth. With joints=True, edges of a model at which faces meet smoothly are lines as well.
        """
    @property
    def camera(self) -> Camera:
        """The eye of the next frame."""
    @camera.setter
    def camera(self, value: Camera) -> None: ...
    @property
    def what(self) -> Union[Model, Scene]:
        """The model or the scene that is drawn."""
    @property
    def why_empty(self) -> str:
        """Why the last picture shows nothing; empty if it may show something."""

def draw(what: Union[Model, Scene], size: _Numbers = (640, 480), *, camera: Optional[Camera] = None,
         frame: Optional[bool] = None, tolerance: float = 0.25, shade_tolerance: float = 2,
         lateral_only: bool = False, shade: _Shade = "lambert",
         inspection_direction: _Numbers = (0, 1, 0), inspection_scale: float = 0,
         inspection_stripe: float = 10, light: _Numbers = (0.4, 0.8, 0.45),
         light_color: _Numbers = (1, 1, 1), lights: Sequence[Light] = (),
         ambient: _Numbers = (0.1, 0.1, 0.1), headlight: bool = False, antialias: bool = True,
         fog: Optional[tuple[Any, ...]] = None,
         background: Union[None, _Color, tuple[_Color, _Color]] = (0x333b46, 0x707a86),
         wireframe: bool = False, net: bool = False, one_sided: bool = False, depth: bool = False,
         most_samples: int = 0, error_map: bool = False,
         curves: Sequence[Union[Curve, tuple[Any, ...]]] = (),
         style: Literal["solid", "wireframe", "hidden_lines"] = "solid",
         rotation: _Numbers = (0, 0, 0), cull: bool = False, material: Optional[Material] = None,
         count_pixels: bool = False, threads: Optional[int] = None) -> Picture:
    """Draws a picture of a model or a scene, size = (width, height).

    Without a camera, or with frame=True, the whole is seen: from the right, from above and from the front.
    `tolerance` is the largest error of places in pixels. `background` is a colour, or one for the top and
    one for the bottom; None leaves the picture transparent. `fog` is (near, far) or (near, far, color).
    `curves` are Curve objects or tuples (curve, color, width). docs/PYTHON.md explains all settings.
    """

class Path:
    """Outlines of lines and curves, to be filled or stroked. Methods that add return the path.

    Whole coordinates are the middles of pixels, and y points down.
    """
    def __init__(self) -> None: ...
    def move_to(self, to: _Numbers) -> Path:
        """Begins another outline."""
    def line_to(self, to: _Numbers) -> Path:
        """Adds a straight line."""
    def quadratic_to(self, control: _Numbers, to: _Numbers) -> Path:
        """Adds a quadratic Bezier curve."""
    def cubic_to(self, first: _Numbers, second: _Numbers, to: _Numbers) -> Path:
        """Adds a cubic Bezier curve."""
    def arc_to(self, center: _Numbers, radii: _Numbers, begin: float, sweep: float,
               turn: float = 0) -> Path:
        """Adds an arc of an ellipse, and first a line to its beginning. Angles are degrees."""
    def close(self) -> Path:
        """Closes the outline."""
    def add_circle(self, center: _Numbers, radius: float) -> Path:
        """Adds a circle."""
    def add_box(self, left: int, top: int, right: int, bottom: int) -> Path:
        """Adds whole pixels: columns from left to right, and rows from top to bottom, the last not included."""
    def add_polygon(self, points: _Numbers) -> Path:
        """Adds a closed polygon of n x 2 points."""
    def add_lines(self, points: _Numbers) -> Path:
        """Adds an open line through n x 2 points."""
    def add(self, path: Path, *, at: _Numbers = (0, 0), turn: float = 0, scale: float = 1) -> Path:
        """Adds another path, scaled, turned by degrees, and moved."""
    def stroked(self, width: float = 1, *, cap: Literal["butt", "round", "square"] = "butt",
                join: Literal["miter", "round", "bevel"] = "miter", miter_limit: float = 4,
                dashes: _Numbers = (), dash_begin: float = 0) -> Path:
        """The path that a pen covers which goes along this one."""
    def copy(self) -> Path:
        """Another path with the same outlines."""
    @property
    def is_empty(self) -> bool:
        """Whether it has no outline."""

class Gradient:
    """Colours along a line, or around a place. Stops are tuples (at, color) or (at, color, alpha)."""
    @staticmethod
    def linear(from_: _Numbers, to: _Numbers, stops: Sequence[tuple[Any, ...]],
               spread: _Spread = "pad") -> Gradient:
        """A gradient from one place to another."""
    @staticmethod
    def radial(center: _Numbers, radius: float, stops: Sequence[tuple[Any, ...]],
               focus: Optional[_Numbers] = None, spread: _Spread = "pad") -> Gradient:
        """A gradient from a focus, which is the centre unless it is given, to a circle."""

class Font:
    """The letters of a font file, or built-in ones that are the same on every machine."""
    def __init__(self, file: Optional[_Path] = None) -> None: ...
    @staticmethod
    def system() -> Font:
        """The letters of this machine; built-in ones if it has none."""
    def width(self, text: str, size: int = 14) -> int:
        """The width of a line of text, in pixels."""
    def line(self, size: int = 14) -> int:
        """The distance from one line of text to the next, in pixels."""
    def outline(self, text: str, size: float = 14, at: _Numbers = (0, 0)) -> Path:
        """The outlines of a line of text whose base line begins at a place."""
    @property
    def name(self) -> str:
        """The file, or "built-in"."""

class Canvas:
    """A picture that is drawn on: paths, lines, meshes, images and text. Methods that draw return it.

    It is white unless `background` is another colour, or None for a transparent one. A Picture in place
    of a size is copied, to be drawn on.
    """
    def __init__(self, size: Union[_Numbers, Picture] = (640, 480), *,
                 background: Optional[_Color] = 0xffffff) -> None: ...
    def clear(self, color: _Color = 0xffffff) -> Canvas:
        """Makes everything one colour."""
    def draw_path(self, path: Path, color: _Color = 0, *, gradient: Optional[Gradient] = None,
                  alpha: float = 1, inside: _Winding = "nonzero", clip: Optional[Path] = None,
                  blending: _Blending = "coded") -> Canvas:
        """Fills a path with smooth edges, within another path if that is given as `clip`."""
    def draw_curves(self, path: Path, color: _Color = 0) -> Canvas:
        """Draws the lines of a path one pixel wide, with hard edges."""
    def draw_line(self, from_: _Numbers, to: _Numbers, color: _Color = 0) -> Canvas:
        """Draws a smooth line one pixel wide."""
    def draw_points(self, points: _Numbers, color: _Color = 0) -> Canvas:
        """Gives the pixels nearest to n x 2 points a colour."""
    def draw_mesh(self, points: _Numbers, colors: _Numbers) -> Canvas:
        """Fills patches with the colours of their corners: n x 4 x 4 x 2 points, n x 4 colours.

        n x 12 x 2 points are those around Coons patches.
        """
    def draw_image(self, picture: Picture, at: _Numbers = (0, 0), size: Optional[_Numbers] = None, *,
                   turn: float = 0, filter: Literal["nearest", "linear", "area"] = "area",
                   alpha: float = 1, clip: Optional[Path] = None,
                   blending: _Blending = "coded") -> Canvas:
        """Draws a picture from a place on, in a size of its own, turned about that place by degrees."""
    def draw_text(self, at: _Numbers, text: str, color: _Color = 0, size: int = 14,
                  font: Optional[Font] = None) -> Canvas:
        """Draws a line of text whose top left corner is at a place, with the letters of this machine."""
    def picture(self) -> Picture:
        """The picture as it is now."""
    def save(self, file: _Path) -> Canvas:
        """Writes a .png or .ppm file."""
    @property
    def size(self) -> tuple[int, int]:
        """Width and height."""
    def _repr_png_(self) -> bytes:
        """The picture of a notebook."""
