#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A hundred wrong uses: an exception with a sentence each, and the module works on."""

import array
import math
import os
import tempfile

from checks import expect, run_all

import l3d

teapot = l3d.Model.load("teapot")
box = l3d.Model.from_polygons([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
scene = l3d.Scene(teapot)
small = (16, 16)
path = l3d.Path().move_to((0, 0)).line_to((9, 9))
line = l3d.Curve.polyline([(0, 0, 0), (1, 1, 1)])
canvas = l3d.Canvas(small)
picture = canvas.picture()
view = l3d.View(teapot, small)
floats = array.array("d", range(96))
nan, inf = math.nan, math.inf
nothing = os.path.join(tempfile.mkdtemp(), "nothing")


def file_of(text):
    with open(nothing + "_there", "w") as file:
        file.write(text)
    return nothing + "_there"


PATCH = [[[(x, y, 0) for x in range(4)] for y in range(4)]]

# What is done, the exception, and a part of its sentence.
USES = """
l3d.Model.load()                                        TypeError  needs 'file'
l3d.Model.load(3)                                       TypeError  path of a file
l3d.Model.load(nothing)                                 FileError  nothing
l3d.Model.load("no such model")                         FileError  no such model
l3d.Model.load(file_of("v 1 2"))                        Error      v 1 2|:1:|nothing_there
l3d.Model.load(file_of("v 1 2 x\\nf 1 2 3"))            Error      :1:
l3d.Model.load(file_of(""))                             Error      nothing_there
l3d.Model.load("/")                                     Error      /
l3d.Model.load("a\\0b")                                 ValueError null
l3d.Model.load("teapot", "torus")                       TypeError  1 arguments
l3d.Model.load(name="teapot")                           TypeError  no argument 'name'
l3d.Model()                                             TypeError  cannot create
l3d.Model.from_patches(PATCH[0])                        Error      shape n x n x n x 3
l3d.Model.from_patches("teapot")                        TypeError  sequence of numbers
l3d.Model.from_patches(floats)                          Error      not 96
l3d.Model.from_patches([[[(0, 0, nan)] * 4] * 4])       Error      points[0, 0, 0, 2] is nan
l3d.Model.from_patches([[[(0, 0, inf)] * 4] * 4])       Error      points[0, 0, 0, 2]
l3d.Model.from_patches([[[(0, 0, 1e13)] * 4] * 4])      Error      points[0, 0, 0, 2]
l3d.Model.from_patches([[[(0, 0, 0)] * 4] * 17])        Error      2 to 16
l3d.Model.from_patches([[[(0, 0, 0)]] * 4])             Error      2 to 16
l3d.Model.from_patches([[[(0, 0, 0)] * 4] * 3 + [[]]])  Error      different lengths
l3d.Model.from_patches(PATCH, [1])                      Error      weights
l3d.Model.from_patches(PATCH, [[[0] * 4] * 4])          Error      weight
l3d.Model.from_patches(PATCH, [[[-1] * 4] * 4])         Error      weight
l3d.Model.from_polygons([(0, 0, 0)], [(0, 1, 2)])       Error      faces[0][1]
l3d.Model.from_polygons([(0, 0, 0)] * 3, [(0, 1)])      Error      three corners
l3d.Model.from_polygons([(0, 0, 0)] * 3, [(0, 1, -1)])  Error      faces[0][2]
l3d.Model.from_polygons([(0, 0, 0)] * 3, [(0, 1, .5)])  Error      whole number
l3d.Model.from_polygons([(0, 0)] * 3, [(0, 1, 2)])      Error      n x 3
l3d.Model.from_polygons([], [])                         Error      shape
l3d.Model.from_polygons([(0, 0, nan)] * 3, [(0, 1, 2)]) Error      vertices[0, 2] is nan
l3d.Model.from_polygons([(0, 0, 0)] * 3, 7)             TypeError  list of faces
l3d.Model.from_polygons([(0, 0, 0)] * 3, memoryview(floats).cast("B").cast("d", (32, 3)))  TypeError  not floats
l3d.Model.from_polygons([(0, 0, 0)] * 3, [(0, 1, 2)], colors=[1])              Error  colors
l3d.Model.from_polygons([(0, 0, 0)] * 3, [(0, 1, 2)], colors=[(1, 2, 256)] * 3)  Error  255
l3d.Model.from_polygons([(0, 0, 0)] * 3, [(0, 1, 2)], normals=[(0, 0, 1)])     Error  normals
l3d.Model.from_polygons([(0, 0, 0)] * 3, [(0, 1, 2)], crease_angle=200)        Error  crease_angle
l3d.Model.from_heights([1, 2])                          Error      n x n
l3d.Model.from_heights([[1, 2]])                        Error      from_heights
l3d.Model.from_heights([[1, 2], [3, 4]], 0)             Error      spacing
l3d.Model.from_heights([[1, inf], [3, 4]])              Error      heights[0, 1]
l3d.Model.from_surfaces([teapot])                       TypeError  Surface
l3d.Model.from_surfaces(3)                              TypeError  list
l3d.Model.from_surfaces([])                             Error      surfaces
teapot.painted("red")                                   TypeError  Material
teapot.painted(l3d.Material(), "wheel")                 Error      wheel
teapot.only("wheel")                                    Error      wheel
teapot.without(3)                                       TypeError  names
teapot.patches.tolist().append() or memoryview(b"")[9]  TypeError  append
teapot.kind.x                                           AttributeError  x
l3d.Material(color="red")                               Error      #ff8000
l3d.Material(color=-1)                                  Error      0 to 16777215
l3d.Material(color=(1, 2))                              Error      shape 3
l3d.Material(color=(1, 2, 300))                         Error      255
l3d.Material(sharpness=0)                               Error      1 to 1000
l3d.Material(sharpness=1.5)                             TypeError  whole number
l3d.Material(opacity=2)                                 Error      0.0 to 1.0
l3d.Camera(eye=(0, 0))                                  Error      shape 3
l3d.Camera(eye=(0, 0, 0))                               Error      eye
l3d.Camera(eye=(0, 5, 0), up=(0, 1, 0))                 Error      up
l3d.Camera(eye=(nan, 0, 1))                             Error      eye[0] is nan
l3d.Camera(fov=0)                                       Error      fov
l3d.Camera(fov="wide")                                  TypeError  number
l3d.Camera(near_z=2, far_z=1)                           Error      near
setattr(l3d.Camera(), "eye", "there")                   TypeError  sequence
setattr(l3d.Camera(), "zoom", 3)                        AttributeError  zoom
delattr(l3d.Camera(), "eye")                            TypeError  deleted
l3d.Camera().orbit(inf)                                 Error      finite
l3d.Camera().approach(0)                                Error      factor
l3d.Light()                                             TypeError  either
l3d.Light(direction=(0, 0, 0))                          Error      direction
l3d.Light(direction=(0, 0, 1), position=(0, 0, 0))      TypeError  either
l3d.Light(position=(0, 0, 0), color=(1, -1, 1))         Error      light away
l3d.Scene.load(nothing)                                 FileError  nothing
l3d.Scene.load("data/head.obj")                         Error      polygons
scene.add(box)                                          Error      polygons
scene.add(teapot, [[1]])                                Error      4 x 4
scene.add(teapot, [[0] * 4] * 4)                        Error      placement
scene.add(teapot, [[nan] * 4] * 4)                      Error      placement[0, 0] is nan
scene.add(teapot, scale=0)                              Error      scale
scene.add(teapot, [[1] * 4] * 4, at=(0, 0, 1))          TypeError  matrix
scene.place(1)                                          Error      0 to 0
scene.paint(0, 3)                                       TypeError  Material
scene.set_opacity(0, -1)                                Error      opacity
scene.lay(0, "wood.png")                                TypeError  Picture
l3d.Scene(box)                                          Error      polygons
l3d.draw()                                              TypeError  needs 'what'
l3d.draw(None)                                          TypeError  needs 'what'
l3d.draw("teapot")                                      TypeError  Model or a Scene
l3d.draw(teapot, 640)                                   Error      shape 2
l3d.draw(teapot, (640, 0))                              Error      at least 1
l3d.draw(teapot, (640, 480, 3))                         Error      shape 2
l3d.draw(teapot, (20000, 10))                           Error      16384
l3d.draw(teapot, (16.5, 16))                            Error      whole number
l3d.draw(teapot, small, tolerance=0)                    Error      tolerance
l3d.draw(teapot, small, tolerance=nan)                  Error      finite
l3d.draw(teapot, small, tolerence=1)                    TypeError  no argument 'tolerence'
l3d.draw(teapot, small, shade="zebras")                 Error      zebra
l3d.draw(teapot, small, light=(0, 0, 0))                Error      light
l3d.draw(teapot, small, lights=[(0, 0, 1)])             TypeError  lights[0]: a Light
l3d.draw(teapot, small, lights=[l3d.Light(direction=(0, 0, 1))] * 8)   Error  7
l3d.draw(teapot, small, lights=[l3d.Light(position=(0, 0, 1))] * 9)    Error  8
l3d.draw(teapot, small, fog=3)                          TypeError  fog
l3d.draw(teapot, small, fog=(9, 3))                     Error      nearer
l3d.draw(teapot, small, fog=(3, 9), background=None)    Error      colour
l3d.draw(teapot, small, background="sky")               Error      #ff8000
l3d.draw(teapot, small, threads=0)                      Error      threads
l3d.draw(teapot, small, threads=5000)                   Error      threads
l3d.draw(teapot, small, curves=[3])                     TypeError  Curve
l3d.draw(teapot, small, curves=[(line, 0, 0)])          Error      width
l3d.draw(teapot, small, style="wireframe")              Error      polygons
l3d.draw(teapot, small, camera=(0, 0, 1))               TypeError  Camera
l3d.draw(teapot, small, shade="draft", inspection_direction=(0, 0, 0))  Error  direction
l3d.draw(box, small, tolerance=1)                       Error      patches
l3d.draw(box, small, shade="zebra")                     Error      lambert
l3d.draw(box, small, style="dots")                      Error      hidden_lines
l3d.View(teapot, small).change(threads=2)               Error      threads
l3d.View(teapot, small).pick("a", 0)                    TypeError  number
setattr(l3d.View(teapot, small), "camera", 3)           TypeError  Camera
setattr(view.camera, "eye", view.camera.target) or view.draw()   Error  eye
picture.save("x.gif")                                   Error      .png or .ppm
picture.save(nothing + "/x.png")                        FileError  nothing/x.png
picture.save()                                          TypeError  needs 'file'
l3d.Canvas(small, background=None).save("x.ppm")        Error      only a .png
l3d.Picture()                                           TypeError  cannot create
l3d.Picture.load(nothing)                               FileError  nothing
l3d.Picture.load(file_of("GIF89a"))                     Error      neither PNG
l3d.Picture.load(file_of("P6\\n999 999\\n255\\n"))      Error      ends
l3d.Picture.from_array([1, 2, 3])                       Error      height x width
l3d.Picture.from_array([[[1, 2]]])                      Error      height x width
l3d.Picture.from_array([[256]])                         Error      255
l3d.Picture.from_array([[]])                            Error      sides
memoryview(picture)[0, 0, 0].x                          AttributeError  x
memoryview(picture).cast("I")                           TypeError  contiguous
bytearray(b"1").__class__(memoryview(picture))[10**9]   IndexError range
setattr(picture, "size", (1, 1))                        AttributeError  size
canvas.draw_path([(0, 0)])                              TypeError  Path
canvas.draw_path(path, alpha=2)                         Error      alpha
canvas.draw_path(path, gradient=path)                   TypeError  Gradient
canvas.draw_path(path, inside="odd")                    Error      even_odd
canvas.draw_line((0, 0), (nan, 0))                      Error      to[0] is nan
canvas.draw_line((0, 0), (1e10, 0))                     Error      to[0]
canvas.draw_points([1, 2, 3])                           Error      n x 2
canvas.draw_mesh([[(0, 0)] * 5], [[0] * 4])             Error      12 x 2
canvas.draw_mesh([[(0, 0)] * 12], [[0] * 3])            Error      colors
canvas.draw_image(teapot)                               TypeError  Picture
canvas.draw_image(picture, size=(0, 1))                 Error      above 0
canvas.draw_image(picture, filter="cubic")              Error      area
canvas.draw_text((0, 0), 3)                             TypeError  text
canvas.draw_text((0, 0), "\\ud800")                     Error      Unicode
canvas.draw_text((0, 0), "a", size=0)                   Error      size
l3d.Canvas("large")                                     TypeError  sequence
l3d.Path().arc_to((0, 0), (1, 1), 0, 1e9)               Error      sweep
l3d.Path().add_circle((0, 0), -1)                       Error      radius
l3d.Path().add(3)                                       TypeError  Path
path.stroked(-1)                                        Error      width
path.stroked(dashes=(0, 0))                             Error      dashes
path.stroked(dashes=(2, -1))                            Error      negative
path.stroked(cap="flat")                                Error      butt
l3d.Gradient.linear((0, 0), (0, 0), [(0, 0)])           Error      another place
l3d.Gradient.linear((0, 0), (1, 0), [])                 Error      none
l3d.Gradient.linear((0, 0), (1, 0), [(1, 0), (0, 0)])   Error      order
l3d.Gradient.radial((0, 0), 0, [(0, 0)])                Error      radius
l3d.Font(nothing)                                       FileError  nothing
l3d.Font(file_of("no font"))                            Error      nothing_there
l3d.Curve([(0, 0, 0)])                                  Error      4 points
l3d.Curve([(0, 0, 0)] * 4, 16)                          Error      degree
l3d.Curve([(0, 0, 0)] * 4, knots=[0, 1])                Error      8 are wanted
l3d.Curve([(0, 0, 0)] * 4, knots=[0, 1, 0, 1, 2, 3, 4, 5])   Error  knot
l3d.Curve([(0, 0, 0)] * 4, weights=[1, 1, 1, 0])        Error      weight
l3d.Curve.circle(0)                                     Error      radius
l3d.Curve.polyline([(0, 0, 0)])                         Error      point
line.evaluate(7)                                        Error      t
l3d.Surface([[(0, 0, 0)] * 4] * 4, 7)                   Error      degree_u
l3d.ruled(line, l3d.Curve.circle(1))                    Error      degree
l3d.pipe(line, 0)                                       Error      radius
l3d.shape("cube")                                       Error      torus
l3d.revolved(teapot)                                    TypeError  Curve
"""


def check_hundred_wrong_uses():
    rows = [row for row in USES.splitlines() if row]
    expect(len(rows) >= 100, len(rows))
    wrong = []
    for row in rows:
        code, kind, part = [cell.strip() for cell in split(row)]
        wanted = getattr(l3d, kind, None) or getattr(__builtins__, kind)
        try:
            eval(code.replace("\\\\", "\\"))
            wrong.append(f"{code} is allowed")
        except wanted as error:
            words = str(error).split()
            if kind == "Error" and isinstance(error, l3d.FileError) or len(words) < 3:
                wrong.append(f"{code} says {type(error).__name__} {error}")
            if not any(one in str(error) for one in part.split("|")):
                wrong.append(f"{code} says '{error}', without '{part}'")
        except Exception as error:
            wrong.append(f"{code} raises {type(error).__name__}: {error}")
    expect(not wrong, len(wrong), "\n".join(wrong))


def split(row):
    """Code, exception and sentence, which two blanks or more divide."""
    for kind in (" TypeError ", " FileError ", " Error ", " ValueError ", " AttributeError ", " IndexError "):
        if kind in row:
            code, part = row.split(kind, 1)
            return code, kind, part
    raise ValueError(row)


def check_the_module_works_on():
    expect(l3d.draw(teapot, small).report["error_bound_px"] <= 0.25)
    expect(len(l3d.Scene(teapot)) == 1 and len(scene) == 1, len(scene))


def check_errors_have_file_and_line():
    name = file_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n")
    try:
        l3d.Model.load(name)
    except l3d.Error as error:
        expect(error.file == name and error.line == 5, error.file, error.line, str(error))
        expect(isinstance(error, ValueError) and not isinstance(error, OSError))
    try:
        l3d.Model.load(nothing)
    except OSError as error:
        expect(error.file == nothing and error.line is None, error.file, error.line)
        expect(isinstance(error, l3d.Error))


if __name__ == "__main__":
    run_all(globals(), "python_wrong_uses")
