# SPDX-License-Identifier: MIT
# Library and programs: how they are made, and the targets that make them.

MAKEFLAGS += -rR --no-print-directory
.SUFFIXES:
.SECONDEXPANSION:
.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: FORCE all run packages hooks clean help

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
# What takes longest to compile is begun first, so that no processor waits for it in the end.
SLOW_FIRST := $(patsubst %,$(OUT)/lib/%.o,raster/surfaces/fill_kernel scene/bends/surface_bends_lanes)

all: ## build the library and the programs (the default)
	+@$(call build,$(SLOW_FIRST) $(APPS) $(PLUGINS) $(LIBRARY_PLUGINS) $(DATA) $(ARCHIVES))

run: packages-run ## build, then show the teapot: in a window, or as a PNG where there is no display
	+@$(call build,$(SLOW_FIRST) $(OUT)/bin/teapot_afd)
	@if [ -n "$$DISPLAY" ]; then $(OUT)/bin/teapot_afd --no-input --backend auto; else \
	    $(OUT)/bin/teapot_afd --no-input --backend memory --output $(OUT)/teapot.png && \
	    echo $(OUT)/teapot.png; fi

packages: packages-build packages-run packages-test packages-lint ## install the Debian packages that are missing
packages-%: FORCE
	@CXX="$(CXX)" tests/lint/packages.sh $(PACKAGES_$*)

# Compilers' commands for clangd and other tools, which look for them at the top.
comma   := ,
quoted   = "$(subst ",\",$(subst \,\\,$(strip $(1))))"
compiled = {"directory": $(call quoted,$(CURDIR)), "file": $(call quoted,$(1)), "command": $(call quoted,$(CXX) $(FLAGS) \
           $(FLAGS_$(call kind,$(1))) $(call less_optimised,$(1)) $(call include_paths,$(1)) -c $(1))}
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
# -Werror changes what is made. Make 4.3 leaves the last newline of some files.
dry_run  = $(findstring n,$(firstword -$(MAKEFLAGS)))
is_new   = $(subst x$(strip $(2))x,,x$(if $(wildcard $(1)),$(strip $(file <$(1))),none)x)
remember = $(if $(and $(dry_run),$(wildcard $(1))),,$(if $(is_new),$(shell mkdir -p $(dir $(1)))$(file >$(1),$(strip $(2)))))
$(call remember,$(OUT)/flags,$(filter-out ccache $(WERROR),$(LINK) $(FLAGS_lib) $(FLAGS_test)))

$(OUT)/%.o: %.cpp $(OUT)/flags $$(call precompiled,$$*.cpp).gch | packages-build
	$(call say,C++,$@)
	$(call compile)
compile = $(Q)mkdir -p $(@D); $(CXX) $(FLAGS) $(FLAGS_$(call kind,$*.cpp)) $(call less_optimised,$*.cpp) $(call include_paths,$*.cpp) \
    -include $(call precompiled,$*.cpp) $(1) -MD -MP -c $< -o $@

# In a unit, one source's own names are known to the next, but for those of tests; AT_ONCE=1 warns of shadows. g++
# takes all names for those of a main file.
in_unit = $(if $(filter tests/%,$*),,-Wno-shadow) $(if $(findstring clang,$(compiler)),,-Wno-subobject-linkage)
$(foreach u,$(UNITS:$(OUT)/%.cpp=%),$(call remember,$(OUT)/list/units/$(u),$(unit_$(u))))
$(UNITS): $(OUT)/%.cpp: $$(unit_$$*) $(OUT)/list/units/% make/unit.awk
	$(Q)mkdir -p $(@D); awk -f make/unit.awk $(unit_$*) > $@
$(UNITS:.cpp=.o): $(OUT)/%.o: $(OUT)/%.cpp $(OUT)/flags $$(call precompiled,$$*.cpp).gch | packages-build
	$(call say,C++,$@)
	$(call compile,-iquote $(*D) $(in_unit))

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
$(OUT)/lib/tool_2d/x11/x11_window.o: $(OUT)/packaging/desktop/icon.png.bytes

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

# A plug-in of the library shares headers with it, and links nothing of it.
$(LIBRARY_PLUGINS): $(OUT)/lib/l3d/libl3d_%.so: $$(objects_plugins/$$*) $(OUT)/list/plugins/%
	$(call say,PLUG,$@)
	$(Q)mkdir -p $(@D); $(LINK) -shared -Wl,-z,defs $(filter %.o,$^) $(links_$*) -o $@

$(foreach d,$(data),$(eval $(OUT)/share/l3d/$(notdir $(d)): $(d)))
$(foreach r,$(reports),$(eval $(OUT)/share/l3d/report/$(notdir $(r)): $(r)))
$(DATA):
	$(Q)mkdir -p $(@D); cp $< $@

-include $(wildcard $(LINTED:%.cpp=$(OUT)/%.d) $(UNITS:.cpp=.d) $(PLUGINS:.so=.d))
