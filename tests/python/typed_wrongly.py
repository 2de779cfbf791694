# SPDX-License-Identifier: MIT
"""A program whose every line `mypy --strict` refuses."""

import l3d

l3d.draw("teapot")
l3d.draw(l3d.Model.load("teapot"), shade="zebras")
l3d.Camera(fov="wide")
l3d.Model.load("teapot").kind = "polygons"
l3d.Scene().add(l3d.Material())
l3d.Picture.save("teapot.png")
l3d.no_such_name
