# SPDX-License-Identifier: MIT
# What there is: the sources in the folders, and what is made of them.

reverse    = $(if $(1),$(call reverse,$(wordlist 2,99,$(1))) $(firstword $(1)))
TOP_DOWN  := reference compare $(call reverse,$(LAYERS))
objects    = $(patsubst %.cpp,$(OUT)/%.o,$(sort $(1)))
archives   = $(patsubst %,$(OUT)/libl3d_%.a,$(filter $(1),$(TOP_DOWN)))
links      = $(foreach layer,$(1),$(links_$(layer)))
may_use    = $(1) $(uses_$(1)) $(if $(filter $(1),$(tests_with_reference)),reference)
# Programs come in by the front door, as everybody's do, but for those that look inside. Sources
# beside the library also include by paths from the top, tests by paths from tests/, too.
looks_inside  = $(filter compare/% tests/% $(apps_with_compare:%=apps/%/%),$(1))
include_paths = $(if $(filter apps/% python/%,$(1)),-I$(OUT)/include) \
                $(if $(call looks_inside,$(1)),-Ilib -I. -Itests,$(if $(filter lib/% plugins/%,$(1)),-Ilib)) \
                $(foreach p,$(library_plugins),$(if $(filter plugins/$(p)/% tests/$(p)/% tests/bench/$(p)_%,$(1)),$(includes_$(p))))

# A layer is a folder; large ones have rooms, folders in it, that the law knows nothing of.
$(foreach l,$(LAYERS),$(eval objects_$(l) := $(call objects,$(wildcard lib/$(l)/*.cpp lib/$(l)/*/*.cpp))))
objects_python    := $(call objects,$(wildcard python/*.cpp))
objects_compare   := $(call objects,$(wildcard compare/*.cpp compare/*/*.cpp))
helpers            = $(call objects,$(filter-out %_test.cpp,$(wildcard tests/$(1)/*.cpp)))
objects_reference := $(call helpers,reference)
apps := $(patsubst apps/%/main.cpp,%,$(wildcard apps/*/main.cpp))
$(foreach a,$(apps),$(eval objects_apps/$(a) := $(call objects,$(wildcard apps/$(a)/*.cpp))))
$(foreach p,$(library_plugins),$(eval objects_plugins/$(p) := $(call objects,$(wildcard plugins/$(p)/*.cpp))))

tested    := $(foreach l,$(LAYERS) compare reference $(library_plugins),$(if $(wildcard tests/$(l)/*_test.cpp),$(l)))
plugins   := $(wildcard apps/*/plugins/*.cpp tests/*/plugins/*.cpp)
# A variant's bin, lib/l3d and share/l3d lie as they are installed.
plugged    = $(patsubst %.cpp,$(OUT)/lib/l3d/%.so,$(notdir $(1)))
PLUGINS   := $(call plugged,$(plugins))
TEST_PLUGINS := $(call plugged,$(filter tests/%,$(plugins)))
data      := $(wildcard data/*) apps/vidflat/plugins/spaceship.obj
# What makes pages of the numbers of teapot_afd --error-report, which tells how to start it.
reports   := $(wildcard apps/teapot_afd/report_page*)
REPORTS   := $(addprefix $(OUT)/share/l3d/report/,$(notdir $(reports)))
DATA      := $(addprefix $(OUT)/share/l3d/,$(notdir $(data))) $(REPORTS)

ARCHIVES  := $(call archives,$(LAYERS))
APPS      := $(apps:%=$(OUT)/bin/%)
# The front door: what others may include, as <l3d/name.h>, is made of the headers that are listed.
PUBLIC    := $(shell sed '/^\#/d' packaging/public_headers)
DOOR      := $(addprefix $(OUT)/include/l3d/,l3d.h $(notdir $(PUBLIC)))
HEADERS   := $(sort $(wildcard lib/*/*.h lib/*/*/*.h compare/*.h compare/*/*.h))
SOURCES   := $(sort $(wildcard lib/*/*.cpp lib/*/*/*.cpp compare/*.cpp compare/*/*.cpp apps/*/*.cpp tests/*/*.cpp $(library_plugins:%=plugins/%/*.cpp)))
FORMATTED := $(SOURCES) $(HEADERS) $(plugins) $(sort $(wildcard apps/*/*.h plugins/*/*.h plugins/*/*.cpp python/*.h python/*.cpp tests/*.h tests/*/*.h))
LINTED    := $(filter-out tests/fail/% tests/bench/% tests/fuzz/% $(missing_plugins:%=tests/%/%),$(SOURCES))
