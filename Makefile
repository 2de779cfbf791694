# SPDX-License-Identifier: MIT
# The build of l3d begins with its architecture: who may include, call and link whom.

LAYERS        := base geom tool_2d raster scene dice pipeline system
uses_base     :=
uses_geom     := base
uses_tool_2d  := base
uses_raster   := base geom tool_2d
uses_scene    := base geom tool_2d raster
uses_dice     := base geom tool_2d raster scene
uses_pipeline := base geom tool_2d raster scene dice
uses_system   := base geom tool_2d raster scene dice pipeline
uses_apps     := $(LAYERS)
uses_python   := $(LAYERS)

# compare/ holds the methods that ours is measured against. It lies beside the library, on top of
# all layers, and only these use it.
uses_compare       := $(LAYERS)
tests_with_compare := compare bench stability
apps_with_compare  := teapot_afd

# tests/reference, the exact renderer, is a layer beside them that only these may use, and one
# program: its report of errors has no better judge.
uses_reference       := base geom
tests_with_reference := scene dice pipeline compare reference bench stability
apps_with_reference  := teapot_afd
uses_stability       := base geom tool_2d raster scene dice pipeline compare
uses_models          := base geom tool_2d raster scene dice

# What a layer links from outside.
links_tool_2d := -lpng -ljpeg -lXext -lX11-xcb -lX11 -lxcb-randr -lxcb-shm -lxcb-xinput -lxcb -lXau -lxkbcommon
links_raster  := -lhwy -lfreetype -lharfbuzz -lfribidi -lfontconfig

include config.mk
# Each file says in its first lines what it is for; `make help` lists the targets of all.
include make/variant.mk
include make/plugins.mk
include make/tree.mk
include make/build.mk
include make/lab.mk
include make/test.mk
include make/lint.mk
include packaging/install.mk
include make/python.mk

# A change of a list of objects makes anew what is linked of them.
$(foreach list,$(filter objects_%,$(.VARIABLES)),$(call remember,$(OUT)/list/$(list:objects_%=%),$($(list))))
