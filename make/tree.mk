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

# Headers are most of what a source takes to compile, and sources of a folder share them: AT_ONCE are compiled
# together, as a unit, which takes half of the time; a last one is compiled as it is. These stay alone: what may see
# the headers of window systems, which take common words away from what follows; what is compiled once for each set
# of instructions; and what a rule names.
named   := lib/geom/teapot.cpp lib/geom/files/plugin.cpp lib/system/plugin_loader.cpp
lanes   := $(shell grep -l foreach_target lib/*/*.cpp lib/*/*/*.cpp)
alone    = $(filter $(named) $(lanes),$(1)) $(foreach s,$(1),$(if $(findstring x11,$(s))$(findstring mesa,$(s)),$(s)))
beyond  := $(shell expr $(AT_ONCE) + 1)
unit     = $(if $(word 2,$(2)),$(eval unit_$(1) := $(2))$(1),$(2:.cpp=))
# An archive tells its objects apart by their last names.
units    = $(if $(2),$(call unit,$(1)$(subst /,_,$(1))$(words $(3) x)$(4),$(wordlist 1,$(AT_ONCE),$(2))) \
           $(call units,$(1),$(wordlist $(beyond),9999,$(2)),$(3) x,$(4)))
# The objects of a folder's sources; what its units' names end with.
together = $(patsubst %,$(OUT)/%.o,$(basename $(call alone,$(2))) $(call units,$(1),$(filter-out $(call alone,$(2)),$(2)),,$(3)))

# A layer is a folder; large ones have rooms, folders in it, that the law knows nothing of.
rooms     = $(sort $(dir $(wildcard lib/$(1)/*.cpp lib/$(1)/*/*.cpp)))
folder    = $(call together,$(1),$(sort $(wildcard $(1)*.cpp)))
$(foreach l,$(LAYERS),$(eval objects_$(l) := $(foreach r,$(call rooms,$(l)),$(call folder,$(r)))))
objects_python    := $(call objects,$(wildcard python/*.cpp))
objects_compare   := $(call objects,$(wildcard compare/*.cpp compare/*/*.cpp))
helpers            = $(call objects,$(filter-out %_test.cpp,$(wildcard tests/$(1)/*.cpp)))
objects_reference := $(call helpers,reference)
apps := $(patsubst apps/%/main.cpp,%,$(wildcard apps/*/main.cpp))
$(foreach a,$(apps),$(eval objects_apps/$(a) := $(call folder,apps/$(a)/)))
$(foreach p,$(library_plugins),$(eval objects_plugins/$(p) := $(call folder,plugins/$(p)/)))

tested    := $(foreach l,$(LAYERS) compare reference $(library_plugins),$(if $(wildcard tests/$(l)/*_test.cpp),$(l)))
# Scenes and judges of dicing serve the tests of whole frames, too. Those of the reference are a layer.
helped_dice     := scene
helped_pipeline := scene dice
helped_compare  := scene dice
$(foreach l,$(tested),$(eval objects_tests/$(l) := \
    $(foreach h,$(filter-out reference,$(l)) $(helped_$(l)),$(call helpers,$(h))) \
    $(call together,tests/$(l)/,$(sort $(wildcard tests/$(l)/*_test.cpp)),_test)))
# Only the lab compiles these, and tests WITH=lab.
objects_stability := $(call helpers,stability)
objects_models    := $(call helpers,models)
UNITS     := $(patsubst unit_%,$(OUT)/%.cpp,$(filter unit_%,$(.VARIABLES)))
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
