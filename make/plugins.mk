# SPDX-License-Identifier: MIT
# Plug-ins of the library: each is a folder of plugins/, made where the library that it needs is installed.

# A plug-in NAME has sources in plugins/NAME/, tests in tests/NAME/, and here: a header that proves its library to be
# there, where headers are, what it links, and what its tests use besides. The core links nothing of it.
ALL_PLUGINS  := cad subdivision
proof_cad    := /usr/include/opencascade/STEPCAFControl_Reader.hxx
includes_cad := -isystem /usr/include/opencascade
links_cad    := -lTKXDESTEP -lTKXDEIGES -lTKXCAF -lTKLCAF -lTKCDF -lTKSTEP -lTKIGES -lTKXSBase -lTKShHealing -lTKFillet -lTKOffset \
                -lTKBool -lTKBO -lTKPrim -lTKTopAlgo -lTKGeomAlgo -lTKBRep -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel
uses_cad     := base geom

proof_subdivision    := /usr/include/opensubdiv/far/patchTableFactory.h
includes_subdivision := -isystem /usr/include/opensubdiv
links_subdivision    := -losdCPU
uses_subdivision     := base geom tool_2d raster scene dice pipeline

library_plugins := $(foreach p,$(ALL_PLUGINS),$(if $(wildcard $(proof_$(p))),$(p)))
missing_plugins := $(filter-out $(library_plugins),$(ALL_PLUGINS))
LIBRARY_PLUGINS := $(library_plugins:%=$(OUT)/lib/l3d/libl3d_%.so)
