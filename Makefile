# SPDX-License-Identifier: MIT
# The build of l3d. Its first lines are the architecture: who may include, call and link whom.

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
links_tool_2d := -lpng -ljpeg -lXext -lX11-xcb -lX11 -lxcb-randr -lxcb -lXau -lxkbcommon
links_raster  := -lhwy -lfreetype -lharfbuzz -lfribidi -lfontconfig

include config.mk

# ---- variant: one folder per choice of scalar, mode and compiler --------------------------------

flags_float   := -DL3D_REAL_FLOAT
flags_double  := -DL3D_REAL_DOUBLE
flags_fixed   := -DL3D_REAL_FIXED
# What makes mistakes harder to misuse: guarded stacks, checked calls of the C library, addresses
# that nobody can guess, and tables that nobody can write to after the start.
HARDENED      := -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fPIE
flags_release := -O3 -DNDEBUG $(HARDENED)
link_release := -Wl,-z,relro,-z,now
pie_release   := -pie
flags_debug   := -O0 -g
flags_asan    := -O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=all \
                 -fsanitize=address,undefined,float-cast-overflow
flags_tsan    := -O1 -g -fsanitize=thread
flags_cov     := -O0 -g --coverage
flags_fuzz    := -O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=all \
                 -fsanitize=fuzzer-no-link,address,undefined

# Leaks in libraries that are not ours to mend.
export LSAN_OPTIONS ?= suppressions=$(CURDIR)/tests/lint/leaks.supp:print_suppressions=0

ifeq ($(filter $(REAL),float double fixed),)
$(error REAL=$(REAL) is unknown; choose float, double or fixed)
endif
ifeq ($(filter $(MODE),release debug asan tsan cov fuzz),)
$(error MODE=$(MODE) is unknown; choose release, debug, asan, tsan, cov or fuzz)
endif

compiler := $(notdir $(lastword $(CXX)))
OUT      := $(BUILD)/$(REAL)-$(MODE)$(if $(filter-out g++,$(compiler)),-$(compiler))

# -ffp-contract=off: float results must not depend on whether the machine has fused operations.
# -Wno-...: g++ 12 sees overlaps and endless copies in std::string's own code (GCC bug 105651).
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion $(WERROR) \
            $(if $(findstring clang,$(compiler)),,-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
FLAGS     = -std=c++20 $(WARNINGS) -ffp-contract=off -fno-math-errno -pthread \
            $(flags_$(REAL)) $(flags_$(MODE)) -I$(OUT) -isystem $(FREETYPE) $(CPPFLAGS) $(CXXFLAGS)
# A source is of the library, a test, or of the rest, and so are its flags.
kind = $(if $(filter lib/%,$(1)),lib,$(if $(filter %_test.cpp,$(1)),test,rest))
# What the shared library is made of serves the static one, too: without interposition the code is
# that of -fPIE, which programs get anyway, and one compilation is enough.
# L3D_PUBLIC marks what the shared library exports.
FLAGS_lib  := -fPIC -fno-semantic-interposition -fvisibility=hidden
# Tests take longer to compile than to run: they are optimised less. The files beside them that do
# the work, such as judges of pictures, are not.
FLAGS_test := $(if $(filter release,$(MODE)),-O1)
# The standard library's headers are half of what a source takes to compile: each kind has them
# precompiled. A source includes what it uses all the same, as `make tidy` sees.
headers_lib  := lib/base/precompiled.h
headers_test := tests/precompiled.h
headers_rest := lib/base/precompiled.h
precompiled   = $(OUT)/precompiled/$(call kind,$(1)).h
LINK      = $(CXX) $(FLAGS) -Wl,--as-needed $(link_$(MODE)) $(LDFLAGS)

# ---- what there is ------------------------------------------------------------------------------

reverse    = $(if $(1),$(call reverse,$(wordlist 2,99,$(1))) $(firstword $(1)))
TOP_DOWN  := reference compare $(call reverse,$(LAYERS))
objects    = $(patsubst %.cpp,$(OUT)/%.o,$(sort $(1)))
archives   = $(patsubst %,$(OUT)/libl3d_%.a,$(filter $(1),$(TOP_DOWN)))
links      = $(foreach layer,$(1),$(links_$(layer)))
may_use    = $(1) $(uses_$(1)) $(if $(filter $(1),$(tests_with_reference)),reference)
# Programs come in by the front door, as everybody's do, but for those that look inside. Sources
# beside the library also include by paths from the top, tests by paths from tests/, too.
looks_inside  = $(filter compare/% tests/% $(apps_with_compare:%=apps/%/%),$(1))
include_paths = $(if $(filter apps/%,$(1)),-I$(OUT)/include) \
                $(if $(call looks_inside,$(1)),-Ilib -I. -Itests,$(if $(filter lib/%,$(1)),-Ilib))

# A layer is a folder; large ones have rooms, folders in it, that the law knows nothing of.
$(foreach l,$(LAYERS),$(eval objects_$(l) := $(call objects,$(wildcard lib/$(l)/*.cpp lib/$(l)/*/*.cpp))))
$(foreach l,$(LAYERS),$(eval objects_tests/$(l) := $(call objects,$(wildcard tests/$(l)/*.cpp))))
objects_compare       := $(call objects,$(wildcard compare/*.cpp compare/*/*.cpp))
objects_tests/compare := $(call objects,$(wildcard tests/compare/*.cpp))
# Scenes and judges of dicing serve the tests of whole frames, too.
helpers = $(call objects,$(filter-out %_test.cpp,$(wildcard tests/$(1)/*.cpp)))
objects_tests/dice     += $(call helpers,scene)
objects_tests/pipeline += $(call helpers,scene) $(call helpers,dice)
objects_tests/compare  += $(call helpers,scene) $(call helpers,dice)
objects_tests/reference := $(call objects,$(wildcard tests/reference/*_test.cpp))
objects_reference := $(filter-out $(objects_tests/reference),\
                     $(call objects,$(wildcard tests/reference/*.cpp)))
apps := $(patsubst apps/%/main.cpp,%,$(wildcard apps/*/main.cpp))
$(foreach a,$(apps),$(eval objects_apps/$(a) := $(call objects,$(wildcard apps/$(a)/*.cpp))))

tested    := $(foreach l,$(LAYERS) compare reference,$(if $(objects_tests/$(l)),$(l)))
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
TESTERS   := $(tested:%=$(OUT)/tests/%_tests)
objects_bench := $(call objects,$(filter-out %_bench.cpp,$(wildcard tests/bench/*.cpp)) \
                     tests/scene/bodies.cpp tests/dice/scene.cpp)
objects_stability := $(call objects,$(wildcard tests/stability/*.cpp))
STABILITY := $(OUT)/tests/stability/stability
BENCHES   := $(patsubst %.cpp,$(OUT)/%,$(wildcard tests/bench/*_bench.cpp))
FUZZERS   := $(patsubst tests/fuzz/corpus/%,$(OUT)/fuzz/%,$(wildcard tests/fuzz/corpus/*))
SCRIPTS   := $(wildcard tests/x11/*_test.sh tests/x11/*_test.py)
STRESS    := $(wildcard tests/x11/stress/*_test.py)
# The front door: what others may include, as <l3d/name.h>, is made of the headers that are listed.
PUBLIC    := $(shell sed '/^\#/d' packaging/public_headers)
DOOR      := $(addprefix $(OUT)/include/l3d/,l3d.h $(notdir $(PUBLIC)))
HEADERS   := $(sort $(wildcard lib/*/*.h lib/*/*/*.h compare/*.h compare/*/*.h))
SOURCES   := $(sort $(wildcard lib/*/*.cpp lib/*/*/*.cpp compare/*.cpp compare/*/*.cpp apps/*/*.cpp tests/*/*.cpp))
FORMATTED := $(SOURCES) $(HEADERS) $(plugins) $(sort $(wildcard apps/*/*.h tests/*.h tests/*/*.h))
OBJECTS   := $(call objects,$(filter-out tests/fail/% tests/bench/% tests/fuzz/%,$(SOURCES)))
LONE      := $(HEADERS:%=$(OUT)/%.ok)

# A check writes a log; summary.awk judges any set of logs.
CHECKS    := format-check headers front-door layers errors-doc sentences fail
LINT_LOGS := $(CHECKS:%=$(OUT)/log/%.log) $(OUT)/log/x11/docs_test.py.log $(OUT)/log/tidy.log
SERVER_LOGS := $(STRESS:tests/%=$(OUT)/log/%.log)
STRESS_LOGS := $(SERVER_LOGS) $(OUT)/log/raster-stress.log $(OUT)/log/pipeline-stress.log
# What takes longest to compile is begun first, so that no processor waits for it in the end.
SLOW_FIRST := $(patsubst %,$(OUT)/lib/%.o,raster/surfaces/fill_kernel system/options/options scene/bends/surface_bends_lanes)
# What is tested is made before anything is run, and what runs longest is begun first.
MADE_FIRST = $(TESTERS) $(STABILITY) $(APPS) $(PLUGINS) $(DATA) \
             $(if $(filter install,$(WITH)),$(PAGES) $(STATIC) $(SHARED) $(OUT)/$(NAME).pc)
LONGEST   := pipeline dice
TEST_LOGS := $(LONGEST:%=$(OUT)/log/%.log) \
             $(if $(filter install,$(WITH)),$(OUT)/log/installcheck.log) \
             $(if $(filter stress,$(WITH)),$(STRESS_LOGS)) \
             $(if $(filter servers,$(WITH)),$(SERVER_LOGS)) \
             $(patsubst %,$(OUT)/log/%.log,$(filter-out $(LONGEST),$(tested))) \
             $(SCRIPTS:tests/%=$(OUT)/log/%.log) $(OUT)/log/stability.log $(OUT)/log/layers.log \
             $(OUT)/log/fail.log $(OUT)/log/front-door.log $(OUT)/log/sentences.log

# ---- targets ------------------------------------------------------------------------------------

MAKEFLAGS += -rR --no-print-directory
.SUFFIXES:
.SECONDEXPANSION:
.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: FORCE all run test stress faults models displays stability matrix lint $(CHECKS) tidy format golden pictures docs reference bench report report-pages \
        fuzz fuzz-each packages hooks clean help

Q    := $(if $(V),,@)
# STEPS, counted by a dry run, makes each step say how far the build is.
progress = $(if $(STEPS),echo >> $(OUT)/steps; printf '[%d/%d]' $$(wc -l < $(OUT)/steps) $(STEPS);)
say   = $(if $(V),,@$(progress) printf '  %-5s %s\n' $(1) $(2:$(OUT)/%=%))
# As many processes as processors, unless the user said how many; two more for checks, many of which
# wait for somebody.
jobs  = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(shell expr $$(nproc 2>/dev/null || echo 2) + $(1)))
# Silent of what is up to date. A recipe of these begins with +, or make -jN keeps its N to itself.
again = $(MAKE) $(if $(V),,-s) $(call jobs,0)
count = rm -f $(OUT)/steps; steps=$$($(MAKE) -n STEPS=1 $(1) 2>/dev/null | grep -c '^echo >> $(OUT)/steps')
build = $(if $(dry_run),: $(1),$(call count,$(1)); $(again) STEPS=$$steps $(1))
judge = $(if $(dry_run),: $(1),\
        rm -f $(1); $(MAKE) $(call jobs,2) -k $(1) || true; awk -f tests/lint/summary.awk $(1))

all: ## build the library and the programs (the default)
	+@$(call build,$(SLOW_FIRST) $(APPS) $(PLUGINS) $(DATA) $(ARCHIVES))

run: packages-run ## build, then show the teapot: in a window, or as a PNG where there is no display
	+@$(call build,$(SLOW_FIRST) $(OUT)/bin/teapot_afd)
	@if [ -n "$$DISPLAY" ]; then $(OUT)/bin/teapot_afd --no-input --backend auto; else \
	    $(OUT)/bin/teapot_afd --no-input --backend memory --output $(OUT)/teapot.png && \
	    echo $(OUT)/teapot.png; fi

test: packages-test $(if $(filter install,$(WITH)),packages-install) ## build and run every test; ends with "N passed, N failed"
	+@$(call build,-k $(SLOW_FIRST) $(MADE_FIRST)) || true
	+@$(if $(filter install,$(WITH)),$(build_other) || true)
	+@$(call judge,$(TEST_LOGS))

stress: packages-test ## what takes minutes: servers that die, a million shapes (make test WITH=stress adds all)
	+@$(call judge,$(STRESS_LOGS))

test-%: packages-test ## the tests of one layer: make test-geom
	+@$(call judge,$(OUT)/log/$*.log)

faults: packages-faults $(OUT)/bin/teapot_afd ## batches killed, out of disk or without power at each call that writes
	L3D_BIN=$(abspath $(OUT)/bin) tests/faults/batch_faults.py

models: packages-models $(OUT)/tests/models/model_polygons ## files of every dialect, read by us and by assimp; ARGS="--folder PATH" for others
	L3D_TESTS=$(abspath $(OUT)/tests/models) PYTHONDONTWRITEBYTECODE=1 tests/models/assimp_test.py $(ARGS)

displays: packages-displays $(OUT)/bin/teapot_afd ## every X server with every window manager of Debian; ARGS="--server Xvfb" for some
	L3D_BIN=$(abspath $(OUT)/bin) PYTHONDONTWRITEBYTECODE=1 tests/x11/displays.py $(ARGS)

stability: packages-stability ## cases made to break it, random ones, polygons and curves; goes on where it was stopped; REAL=double as well
	+@$(again) $(STABILITY)
	@mkdir -p docs/report
	$(STABILITY) --folder docs/report $(ARGS)
	tests/stability/stability_pages.py docs/report

matrix: packages-test packages-matrix ## every test: each scalar, plain and sanitized, both compilers
	+@$(if $(dry_run),:,MAKE="$(again)" tests/lint/matrix.sh $(BUILD)/matrix)

lint: packages-lint packages-test packages-tidy ## the documents' commands, clang-tidy, and:
	+@$(call judge,$(LINT_LOGS))

$(CHECKS): packages-lint packages-test ## one check alone
	+@$(call judge,$(OUT)/log/$@.log)

tidy: packages-tidy ## clang-tidy, warnings are errors
	+@$(again) -k $(patsubst %.o,%.tidy,$(OBJECTS))

format: packages-lint ## clang-format every file in place
	$(Q)$(CLANG_FORMAT) -i $(FORMATTED)

golden: packages-test $(APPS) $(PLUGINS) $(DATA) ## store the pictures' hashes that tests/x11/programs_test.py compares with
	L3D_BIN=$(abspath $(OUT)/bin) tests/x11/programs_test.py --write

pictures: packages-report packages-bench $(APPS) $(PLUGINS) $(DATA) $(OUT)/tests/bench/fixed_failure_bench $(OUT)/tests/bench/depth_bits_bench ## the documents' pictures that are no report's
	L3D_BIN=$(abspath $(OUT)/bin) tests/x11/contact_sheet.py docs/pictures
	$(OUT)/bin/teapot_afd --no-input --backend memory --size 640x480 --output docs/pictures/teapot.png
	$(OUT)/bin/teapot_afd --no-input --backend memory --size 640x480 --wireframe --net --output docs/pictures/steps.png
	for shade in zebra gaussian; do \
	    $(OUT)/bin/teapot_afd --no-input --backend memory --size 640x480 --shade $$shade --output docs/pictures/$$shade.png; done
	$(OUT)/bin/teapot_afd --no-input --backend memory --size 1000x420 --compare tessellation:6 --output docs/pictures/comparison.png
	$(OUT)/bin/gallery --no-input --backend memory --size 1024x560 --glossy --output docs/pictures/gallery.png
	$(OUT)/tests/bench/fixed_failure_bench docs/pictures/fixed_16_16.png
	$(OUT)/tests/bench/depth_bits_bench docs/pictures/depth_16.png
	gnuplot docs/report/peers.gp
	gnuplot docs/report/antialias_peers.gp
	gnuplot docs/report/leaving_out.gp
	for drawing in docs/pictures/*.dot; do dot -Tpng -Gdpi=90 $$drawing -o $${drawing%.dot}.png; done

docs: packages-docs $(DOOR) ## the reference of all public headers; a public thing without a comment is an error
	@rm -rf $(BUILD)/docs; mkdir -p $(BUILD)/docs
	@L3D_VERSION_TEXT=$(VERSION) L3D_HEADERS=$(OUT)/include L3D_REFERENCE=$(BUILD)/docs doxygen docs/Doxyfile
	@echo $(BUILD)/docs/html/index.html

# The document as it is up to its first table, and the tables as they should be.
reference_text = { sed '/^\#\# Layer /,$$d' docs/REFERENCE.md; awk -f packaging/reference.awk $(PUBLIC:%=lib/%); }
reference: ## write the tables of classes in docs/REFERENCE.md, from the comments of the public headers
	@mkdir -p $(OUT); $(reference_text) > $(OUT)/REFERENCE.md && mv $(OUT)/REFERENCE.md docs/REFERENCE.md

bench: packages-bench ## build and run the benchmarks
	+@$(again) $(BENCHES) $(APPS)
	@set -e; for bench in $(BENCHES); do $$bench $(ARGS); done
	@L3D_BIN=$(abspath $(OUT)/bin) tests/bench/start_up.py

report: packages-report $(OUT)/bin/teapot_afd $(DATA) ## error against time, into docs/report; goes on where it was stopped; QUICK=1: a small one
	@$(OUT)/bin/teapot_afd --no-input --error-report $(if $(QUICK),$(OUT)/report --quick,docs/report)
	@python3 $(OUT)/share/l3d/report/report_pages.py $(if $(QUICK),$(OUT)/report,docs/report)

report-pages: packages-report ## the pages and diagrams of the report's numbers that are there
	@PYTHONDONTWRITEBYTECODE=1 python3 apps/teapot_afd/report_pages.py docs/report

fuzz: packages-fuzz ## fuzz every reader of model files: make fuzz FUZZ_SECONDS=600
	+@$(again) MODE=fuzz CXX="$(FUZZ_CXX)" fuzz-each

fuzz-each: $(FUZZERS)
	@set -e; for fuzzer in $(FUZZERS); do mkdir -p $$fuzzer.corpus; \
	    $$fuzzer -max_total_time=$(FUZZ_SECONDS) $(FUZZ_LIMITS) -artifact_prefix=$$fuzzer.found- \
	    $$fuzzer.corpus tests/fuzz/corpus/$${fuzzer##*/}; done

packages: packages-build packages-run packages-test packages-lint ## install the Debian packages that are missing
packages-%:
	@CXX="$(CXX)" tests/lint/packages.sh $(PACKAGES_$*)

# Compilers' commands for clangd and other tools, which look for them at the top.
comma   := ,
quoted   = "$(subst ",\",$(subst \,\\,$(strip $(1))))"
compiled = {"directory": $(call quoted,$(CURDIR)), "file": $(call quoted,$(1)), "command": $(call quoted,$(CXX) $(FLAGS) \
           $(FLAGS_$(call kind,$(1))) $(call include_paths,$(1)) -c $(1))}
compile_commands.json: $(DOOR) FORCE ## how each source is compiled, for clangd and editors; of the variant that is named
	$(file >$@,[$(subst } {,}$(comma) {,$(foreach s,$(SOURCES),$(call compiled,$(s))))])
	@echo $@

hooks: ## run the quicker of these checks before every commit
	git config core.hooksPath .githooks

clean: ## remove everything made
	rm -rf $(BUILD) compile_commands.json

help: ## this list
	@awk -F':.*## ' '/^[a-z$$].*:.*## /{sub(/^\$$\(CHECKS\)/, "$(CHECKS)", $$1); \
	    printf "  %-14s %s\n", $$1, $$2}' $(filter-out %.d,$(MAKEFILE_LIST))
	@echo "  REAL=float|double|fixed MODE=release|debug|asan|tsan|cov|fuzz CXX=g++|clang++ V=1"

# ---- rules --------------------------------------------------------------------------------------

# A file whose text changed is written while make reads: what depends on it is remade when flags or
# lists do. A dry run leaves it as it is, so that what is built stays built. Neither a compiler's cache nor
# -Werror changes what is made.
dry_run  = $(findstring n,$(firstword -$(MAKEFLAGS)))
is_new   = $(subst x$(strip $(2))x,,x$(if $(wildcard $(1)),$(file <$(1)),none)x)
remember = $(if $(and $(dry_run),$(wildcard $(1))),,$(if $(is_new),$(shell mkdir -p $(dir $(1)))$(file >$(1),$(strip $(2)))))
$(call remember,$(OUT)/flags,$(filter-out ccache $(WERROR),$(LINK) $(FLAGS_lib) $(FLAGS_test)))

$(OUT)/%.o: %.cpp $(OUT)/flags $$(call precompiled,$$*.cpp).gch | packages-build
	$(call say,C++,$@)
	$(Q)mkdir -p $(@D); $(CXX) $(FLAGS) $(FLAGS_$(call kind,$<)) $(call include_paths,$<) \
	    -include $(call precompiled,$<) -MD -MP -c $< -o $@

# Compilers find NAME.gch beside NAME.
$(OUT)/precompiled/%.h.gch: $$(headers_$$*) $(OUT)/flags | packages-build
	$(call say,C++,$@)
	$(Q)mkdir -p $(@D); cp $< $(@:.gch=); $(CXX) $(FLAGS) $(FLAGS_$*) -Ilib -x c++-header $(@:.gch=) -o $@
$(OUT)/precompiled/test.h.gch: | packages-test

$(foreach h,$(PUBLIC),$(eval $(OUT)/include/l3d/$(notdir $(h)): lib/$(h)))
$(filter-out %/l3d.h,$(DOOR)):
	$(Q)mkdir -p $(@D); sed 's|^#include "\(.*/\)*\(.*\)"|#include <l3d/\2>|' $< > $@
$(OUT)/include/l3d/l3d.h: packaging/public_headers packaging/umbrella.awk
	$(Q)mkdir -p $(@D); awk -f packaging/umbrella.awk $< > $@
$(foreach a,$(apps),$(eval $(objects_apps/$(a)): | $(DOOR)))
$(PLUGINS): | $(DOOR)

# A text file as a C++ string literal, to be included.
$(OUT)/%.inc: %
	$(Q)mkdir -p $(@D); { printf 'R"text('; cat $<; printf ')text"\n'; } > $@
$(OUT)/lib/geom/teapot.o: $(OUT)/data/teapot.bpt.inc

# Any file as the numbers of its bytes, to be included between braces.
$(OUT)/%.bytes: %
	$(Q)mkdir -p $(@D); od -An -v -tu1 $< | sed 's/[0-9]\+/&,/g' > $@
$(OUT)/lib/tool_2d/x11_window/x11_icon.o: $(OUT)/packaging/desktop/icon.png.bytes

# A layer of headers alone has no object that the packages come before.
$(OUT)/libl3d_%.a: $$(objects_$$*) $(OUT)/list/% | packages-build
	$(call say,AR,$@)
	$(Q)rm -f $@; ar rcs $@ $(filter %.o,$^)

# What a program links beside the library.
beside = $(foreach layer,compare reference,$(if $(filter $(1),$(apps_with_$(layer))),$(layer)))
# A linker writes for a second what nobody may execute: whoever starts the program meanwhile gets the old one.
$(APPS): $(OUT)/bin/%: $$(objects_apps/$$*) \
        $$(call archives,$(LAYERS) $$(call beside,$$*)) \
        $(OUT)/list/apps/%
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D); $(LINK) $(pie_$(MODE)) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(LAYERS)) -o $@.new
	$(Q)mv $@.new $@

# A plug-in is loaded, not linked: it may be built otherwise than the library, here by itself.
$(foreach p,$(plugins),$(eval $(call plugged,$(p)): $(p)))
$(PLUGINS): $(OUT)/flags | packages-build
	$(call say,PLUG,$@)
	$(Q)mkdir -p $(@D); $(CXX) $(FLAGS) $(link_$(MODE)) -I$(OUT)/include -fPIC -shared -MD -MP $(filter %.cpp,$^) -o $@

$(foreach d,$(data),$(eval $(OUT)/share/l3d/$(notdir $(d)): $(d)))
$(foreach r,$(reports),$(eval $(OUT)/share/l3d/report/$(notdir $(r)): $(r)))
$(DATA):
	$(Q)mkdir -p $(@D); cp $< $@

$(TESTERS): $(OUT)/tests/%_tests: $$(objects_tests/$$*) $$(call archives,$$(call may_use,$$*)) \
        $(OUT)/list/tests/%
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(call may_use,$*)) \
	    -lgtest -lgtest_main -o $@

$(STABILITY): $(objects_stability) $(call archives,reference $(uses_stability)) \
        $(OUT)/list/stability
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(uses_stability)) -o $@

$(OUT)/tests/models/model_polygons: %: %.o $(call archives,$(uses_models))
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(LAYERS)) -o $@

$(BENCHES): %: %.o $(objects_bench) $(call archives,reference compare $(LAYERS))
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(LAYERS)) \
	    -lembree3 -lbenchmark -lcairo -lagg -o $@

$(OUT)/fuzz/%: tests/fuzz/model_fuzz.cpp $(wildcard tests/fuzz/*.h) $(OUT)/libl3d_geom.a
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D); $(LINK) $(call include_paths,$<) -fsanitize=fuzzer -DL3D_FUZZED='"$*"' $(filter-out %.h,$^) -o $@

# ---- logs: each ends with the exit status of what it ran ----------------------------------------

logged = $(Q)mkdir -p $(@D); { $(1); } > $@ 2>&1; echo "exit status $$?" >> $@

$(tested:%=$(OUT)/log/%.log): $(OUT)/log/%.log: $(OUT)/tests/%_tests FORCE
	$(call say,TEST,$*)
	$(call logged,timeout --foreground $(TEST_TIMEOUT) $< --gtest_color=no)

# A part of what `make stability` runs, a few seconds.
$(OUT)/log/stability.log: $(STABILITY) FORCE
	$(call say,TEST,stability)
	$(call logged,timeout --foreground $(TEST_TIMEOUT) $< --sample)

# What takes minutes is disabled in its test program.
$(OUT)/log/%-stress.log: $(OUT)/tests/%_tests FORCE
	$(call say,TEST,$* stress)
	$(call logged,timeout --foreground $(STRESS_TIMEOUT) $< --gtest_color=no \
	    --gtest_also_run_disabled_tests --gtest_filter='*DISABLED_*')

$(OUT)/log/system.log: $(PLUGINS) $(DATA)

$(OUT)/log/x11/%.log: tests/x11/% $(APPS) $(PLUGINS) $(DATA) FORCE
	$(call say,TEST,$<)
	$(call logged,PYTHONDONTWRITEBYTECODE=1 L3D_BIN=$(abspath $(OUT)/bin) \
	    timeout --foreground $(TEST_TIMEOUT) $<)

$(OUT)/log/format-check.log: FORCE
	$(call logged,$(CLANG_FORMAT) --dry-run -Werror $(FORMATTED) && echo ok format-check)

$(OUT)/log/headers.log: FORCE
	$(call logged,$(MAKE) -k $(LONE) && echo ok headers)

$(OUT)/log/front-door.log: $(DOOR) FORCE
	$(call logged,awk -f tests/lint/front_door.awk packaging/public_headers $(PUBLIC:%=lib/%) && \
	    if $(reference_text) | diff docs/REFERENCE.md -; then echo ok reference; \
	    else echo "not ok reference: make reference writes the tables of docs/REFERENCE.md anew"; (exit 1); fi)

$(OUT)/%.h.ok: %.h $(OUT)/flags | packages-build
	$(Q)mkdir -p $(@D); echo '#include "$(<:lib/%=%)"' | \
	    $(CXX) $(FLAGS) $(call include_paths,$<) -MD -MP -MF $@.d -MT $@ -fsyntax-only -x c++ - && touch $@

include_law = awk -f tests/lint/layers.awk -v out=$(OUT)/ \
    -v law="$(foreach l,$(LAYERS) compare reference stability models apps,$(l): $(uses_$(l));)" \
    -v with_compare="$(tests_with_compare:%=tests/%) $(apps_with_compare:%=apps/%)" \
    -v with_reference="$(tests_with_reference:%=tests/%) $(apps_with_reference:%=apps/%)" $(HEADERS) $(OBJECTS:.o=.d)
# Archives are lazy, so a whole one is linked: a call that climbs is an undefined symbol.
link_law = echo 'int main() {}' | $(LINK) -x c++ - -x none -o $(OUT)/link_law \
    -Wl,--whole-archive $(OUT)/libl3d_$(1).a -Wl,--no-whole-archive \
    $(call archives,$(uses_$(1))) $(call links,$(1) $(uses_$(1))) && \
    echo ok link $(1) || { echo not ok link $(1); worst=1; }
$(OUT)/log/layers.log: $(OBJECTS) $(call archives,$(TOP_DOWN)) FORCE
	$(call say,LAW,layers)
	$(call logged,worst=0; $(include_law) || worst=1; \
	    $(foreach l,$(LAYERS) compare reference,$(call link_law,$(l));) (exit $$worst))

$(OUT)/log/errors-doc.log: FORCE
	$(call logged,awk -f tests/lint/errors_doc.awk $(HEADERS) && echo ok errors-doc)

# Of documents and comments: nobody should have to read a sentence twice.
longest_sentence := 35
$(OUT)/log/sentences.log: FORCE
	$(call logged,tests/lint/sentences.py --self-test --longest $(longest_sentence) && echo ok sentences)

$(OUT)/log/tidy.log: FORCE
	$(call logged,$(MAKE) tidy && echo ok tidy)

$(OUT)/log/fail.log: FORCE | packages-build
	$(call say,CHECK,tests/fail)
	$(call logged,tests/lint/must_fail.sh '$(CXX) $(FLAGS) -Ilib' $(wildcard tests/fail/*.cpp))

$(OUT)/%.tidy: %.cpp .clang-tidy $(OUT)/%.o
	$(call say,TIDY,$<)
	$(Q)$(CLANG_TIDY) --quiet $< -- -xc++ -Wno-unknown-warning-option $(FLAGS) $(call include_paths,$<) && touch $@

include packaging/install.mk

$(foreach list,$(filter objects_%,$(.VARIABLES)),$(call remember,$(OUT)/list/$(list:objects_%=%),$($(list))))

-include $(wildcard $(OBJECTS:.o=.d) $(PLUGINS:.so=.d) $(BENCHES:=.d) $(objects_bench:.o=.d) $(LONE:=.d))
