# SPDX-License-Identifier: MIT
"""Pictures of curved surfaces, polygons and paths, with bounds of their errors, drawn by processors.

docs/PYTHON.md has ten short programs. help(l3d.draw) and the like tell of each function and class.
"""

from l3d._l3d import *
from l3d._l3d import __version__
