# SPDX-License-Identifier: MIT
# What others get of l3d: libraries, headers, programs, pages, data; and how it is packed.

# The number type is part of the library's name: what is built for another must not find this one.
NAME_float  := l3d
NAME_double := l3d-double
NAME_fixed  := l3d-fixed
NAME        := $(NAME_$(REAL))
STATIC      := $(OUT)/lib$(NAME).a
SHARED      := $(OUT)/lib$(NAME).so.$(VERSION)
SONAME      := lib$(NAME).so.$(ABI)
# The book's programs have names that others have, too: objcopy is binutils', hello GNU's.
PLAIN       := teapot_afd modelview surfview drawdot
installed    = $(strip $(patsubst %,l3d-%,$(filter-out $(PLAIN),$(1))) $(filter $(PLAIN),$(1)))
# Installed programs share one copy of the library, found from their own place. Those that look
# inside have theirs: the shared library exports nothing private.
SHARING     := $(filter-out $(apps_with_compare),$(apps))
installable  = $(if $(filter $(1),$(SHARING)),$(OUT)/sharing/$(1),$(OUT)/bin/$(1))
PAGES       := $(patsubst %,$(OUT)/man/%.1,$(call installed,$(apps)))
# What shells and desktops want to know of the programs.
BASH_WORDS  := $(patsubst %,$(OUT)/completion/bash/%,$(call installed,$(apps)))
ZSH_WORDS   := $(patsubst %,$(OUT)/completion/zsh/_%,$(call installed,$(apps)))
ICON        := $(OUT)/icon/l3d.png

BINDIR     ?= $(PREFIX)/bin
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
SHAREDIR   ?= $(PREFIX)/share
DOCDIR     ?= $(SHAREDIR)/doc/l3d
# Where programs look, from their own place: ../lib/l3d, whatever LIBDIR is.
PLUGINDIR  := $(PREFIX)/lib/l3d

.PHONY: install install-programs install-library install-library-told uninstall installcheck bare exported export-list dist package

libraries: $(STATIC) $(SHARED)

install: ## PREFIX=/usr/local DESTDIR=: libraries (REALS="float fixed"), headers, programs, pages, documents
	+@$(call build,install-programs)
	+@set -e; for real in $(REALS); do $(MAKE) REAL=$$real install-library-told; done
	@DESTDIR="$(DESTDIR)" packaging/installed.sh "$(BINDIR)" "$(LIBDIR)" "$(INCLUDEDIR)" "$(SHAREDIR)" "$(DOCDIR)"

# A number type that nothing was built for takes as long as the first build.
install-library-told:
	+@$(call count,install-library); [ "$$steps" = 0 ] || \
	    echo "The library whose numbers are $(REAL) takes $$steps steps first; REALS names the libraries, now: $(REALS)"; \
	    $(again) STEPS=$$steps install-library

put = install -d $(DESTDIR)$(2) && install -m $(1) $(3) $(DESTDIR)$(2)

install-programs: $(foreach a,$(apps),$(call installable,$(a))) $(PLUGINS) $(LIBRARY_PLUGINS) $(DATA) $(PAGES) $(BASH_WORDS) $(ZSH_WORDS) $(ICON)
	$(Q)install -d $(DESTDIR)$(BINDIR)
	$(Q)$(foreach a,$(apps),install -m 755 $(call installable,$(a)) \
	    $(DESTDIR)$(BINDIR)/$(call installed,$(a)) &&) true
	$(Q)$(call put,644,$(PLUGINDIR),$(filter-out $(TEST_PLUGINS),$(PLUGINS)))
	$(Q)$(if $(LIBRARY_PLUGINS),$(call put,644,$(LIBDIR)/l3d,$(LIBRARY_PLUGINS)))
	$(Q)$(call put,644,$(SHAREDIR)/l3d,$(filter-out $(REPORTS),$(DATA)))
	$(Q)$(call put,644,$(SHAREDIR)/l3d/report,$(REPORTS))
	$(Q)$(call put,644,$(SHAREDIR)/man/man1,$(PAGES))
	$(Q)$(call put,644,$(SHAREDIR)/man/man7,docs/l3d.7)
	$(Q)$(call put,644,$(DOCDIR),README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md LICENSE)
	$(Q)$(foreach d,docs docs/farm docs/pictures docs/report,$(call put,644,$(DOCDIR)/$(d),\
	    $(wildcard $(addprefix $(d)/*.,md mk png sh))) &&) true
	$(Q)$(call put,644,$(SHAREDIR)/bash-completion/completions,$(BASH_WORDS))
	$(Q)$(call put,644,$(SHAREDIR)/zsh/site-functions,$(ZSH_WORDS))
	$(Q)$(call put,644,$(SHAREDIR)/applications,packaging/desktop/*.desktop)
	$(Q)$(call put,644,$(SHAREDIR)/thumbnailers,packaging/desktop/*.thumbnailer)
	$(Q)$(call put,644,$(SHAREDIR)/mime/packages,packaging/desktop/l3d.xml)
	$(Q)$(call put,644,$(SHAREDIR)/icons/hicolor/128x128/apps,$(ICON))

install-library: $(STATIC) $(SHARED) $(OUT)/$(NAME).pc $(DOOR) \
        $(OUT)/l3d-$(REAL).cmake $(OUT)/l3d-config.cmake $(OUT)/l3d-config-version.cmake
	$(Q)$(call put,644,$(LIBDIR),$(STATIC) $(SHARED))
	$(Q)ln -sf $(notdir $(SHARED)) $(DESTDIR)$(LIBDIR)/$(SONAME)
	$(Q)ln -sf $(SONAME) $(DESTDIR)$(LIBDIR)/lib$(NAME).so
	$(Q)$(call put,644,$(LIBDIR)/pkgconfig,$(OUT)/$(NAME).pc)
	$(Q)$(call put,644,$(INCLUDEDIR)/l3d,$(DOOR))
	$(Q)$(call put,644,$(LIBDIR)/cmake/l3d,$(OUT)/l3d-$(REAL).cmake $(OUT)/l3d-config.cmake \
	    $(OUT)/l3d-config-version.cmake)

uninstall: ## remove what install has put there, given the same PREFIX and DESTDIR
	rm -rf $(addprefix $(DESTDIR),$(INCLUDEDIR)/l3d $(PLUGINDIR) $(LIBDIR)/l3d $(SHAREDIR)/l3d $(DOCDIR) \
	    $(LIBDIR)/cmake/l3d)
	rm -f $(patsubst %,$(DESTDIR)$(BINDIR)/%,$(call installed,$(apps))) \
	    $(patsubst $(OUT)/man/%,$(DESTDIR)$(SHAREDIR)/man/man1/%,$(PAGES)) \
	    $(patsubst $(OUT)/completion/bash/%,$(DESTDIR)$(SHAREDIR)/bash-completion/completions/%,$(BASH_WORDS)) \
	    $(patsubst $(OUT)/completion/zsh/%,$(DESTDIR)$(SHAREDIR)/zsh/site-functions/%,$(ZSH_WORDS)) \
	    $(addprefix $(DESTDIR)$(SHAREDIR)/,man/man7/l3d.7 mime/packages/l3d.xml icons/hicolor/128x128/apps/l3d.png \
	    $(patsubst packaging/desktop/%,applications/%,$(wildcard packaging/desktop/*.desktop)) \
    $(patsubst packaging/desktop/%,thumbnailers/%,$(wildcard packaging/desktop/*.thumbnailer)))
	rm -f $(foreach r,float double fixed,$(addprefix $(DESTDIR)$(LIBDIR)/,lib$(NAME_$(r)).a \
	    lib$(NAME_$(r)).so lib$(NAME_$(r)).so.* pkgconfig/$(NAME_$(r)).pc))

installcheck: packages-test packages-install ## install into an empty place; build and run the examples with nothing else
	@$(call judge,$(OUT)/log/installcheck.log)

bare: packages-bare ## what a new machine lacks: make run and make test on a bare Debian in build/bare, as root; ARGS="run" for one
	@tests/install/bare.sh $(BUILD)/bare $(ARGS)

exported: ## list the names that the shared libraries export, as make installcheck compares them, in packaging/exported
	+@set -e; for real in $(REALS); do $(again) REAL=$$real export-list; done

export-list: $(SHARED)
	$(Q)packaging/exported_names.sh $(SHARED) > packaging/exported/$(NAME)

dist: ## build/l3d-VERSION.tar.gz: what git holds, the same bytes every time
	@packaging/dist.sh $(VERSION) $(BUILD)

package: packages-package dist ## Debian packages into build/debian, judged by lintian
	@packaging/debian.sh $(VERSION) $(BUILD)

# ---- rules --------------------------------------------------------------------------------------

objects_library := $(foreach l,$(LAYERS),$(objects_$(l)))

$(STATIC): $(objects_library) $(OUT)/list/library
	$(call say,AR,$@)
	$(Q)rm -f $@; ar rcs $@ $(filter %.o,$^)

$(SHARED): $(objects_library) $(OUT)/list/library packaging/l3d.map
	$(call say,LINK,$@)
	$(Q)$(LINK) -shared -Wl,-soname,$(SONAME) -Wl,--version-script=packaging/l3d.map \
	    -Wl,-z,defs -Wl,-Bsymbolic-functions \
	    $(filter %.o,$^) $(call links,$(LAYERS)) -o $@

# Where the loader looks anyway nothing needs to be said.
run_path = $(if $(filter /usr/lib%,$(LIBDIR)),,-Wl,-rpath,'$$ORIGIN/$(shell realpath -ms --relative-to=$(BINDIR) $(LIBDIR))')
$(SHARING:%=$(OUT)/sharing/%): $(OUT)/sharing/%: $$(objects_apps/$$*) $(SHARED) $(OUT)/list/apps/% $(OUT)/place
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D); $(LINK) $(pie_$(MODE)) $(filter %.o,$^) $(SHARED) $(run_path) -o $@

$(call remember,$(OUT)/place,$(PREFIX) $(LIBDIR) $(INCLUDEDIR))

# pkg-config moves what lies in the prefix with it, if it is named so.
below_prefix = $(patsubst $(PREFIX)/%,$${prefix}/%,$(1))
$(OUT)/$(NAME).pc: packaging/l3d.pc.in $(OUT)/place $(OUT)/flags
	$(Q)sed -e 's|@prefix@|$(PREFIX)|; s|@libdir@|$(call below_prefix,$(LIBDIR))|' \
	    -e 's|@includedir@|$(call below_prefix,$(INCLUDEDIR))|' \
	    $(named) -e 's|@define@|$(flags_$(REAL))|; s|@links@|$(call links,$(LAYERS))|' $< > $@

# CMake finds headers from the library's own place, wherever both were moved to.
named = -e 's|@name@|$(NAME)|; s|@real@|$(REAL)|; s|@version@|$(VERSION)|; s|@soname@|$(SONAME)|' \
        -e 's|@real_macro@|$(flags_$(REAL):-D%=%)|' \
        -e "s|@to_include@|$$(realpath -ms --relative-to=$(LIBDIR) $(INCLUDEDIR))|"
$(OUT)/l3d-$(REAL).cmake: packaging/l3d-real.cmake.in $(OUT)/place $(OUT)/flags
	$(Q)sed $(named) $< > $@
$(OUT)/%.cmake: packaging/%.cmake.in $(OUT)/flags
	$(Q)sed $(named) $< > $@

page = $(Q)mkdir -p $(@D); $< --help | \
    awk -f packaging/man_page.awk -v program=$(basename $(@F)) -v date='$(RELEASED)' > $@
$(OUT)/man/l3d-%.1: $(OUT)/bin/% packaging/man_page.awk
	$(page)
$(OUT)/man/%.1: $(OUT)/bin/% packaging/man_page.awk
	$(page)

completion = $(Q)mkdir -p $(@D); $< --help | \
    awk -f packaging/completion.awk -v shell=$(1) -v program=$(patsubst _%,%,$(@F)) > $@
$(OUT)/completion/bash/l3d-%: $(OUT)/bin/% packaging/completion.awk
	$(call completion,bash)
$(OUT)/completion/bash/%: $(OUT)/bin/% packaging/completion.awk
	$(call completion,bash)
$(OUT)/completion/zsh/_l3d-%: $(OUT)/bin/% packaging/completion.awk
	$(call completion,zsh)
$(OUT)/completion/zsh/_%: $(OUT)/bin/% packaging/completion.awk
	$(call completion,zsh)

$(ICON): $(OUT)/bin/teapot_afd
	$(Q)mkdir -p $(@D); $< --no-input --backend memory --size 128x128 --fov 30 --target 0.25,1.5,0 --background none --output $@

# Where installed programs and the shared library look for data, if not beside themselves.
$(OUT)/lib/system/plugin_loader.o $(OUT)/lib/geom/files/plugin.o: $(OUT)/place
$(OUT)/lib/system/plugin_loader.o $(OUT)/lib/geom/files/plugin.o: private CPPFLAGS += -DL3D_PREFIX='"$(PREFIX)"' -DL3D_LIBDIR='"$(LIBDIR)"'

# The library of the other numbers is only looked at for its place and its names, so it is compiled in
# a hurry, for one set of instructions. `make test` builds it before anything is run: the check of what
# is installed takes minutes of one process, and has to begin with the others.
STAGE := $(OUT)/stage
OTHER := $(if $(filter fixed,$(REAL)),float,fixed)
hurry := BUILD=$(BUILD)/hurry REAL=$(OTHER) CXXFLAGS="-O1 -DHWY_COMPILE_ONLY_STATIC"
build_other = $(if $(dry_run),:,$(again) -k $(hurry) libraries)
$(OUT)/log/installcheck.log: $(APPS) $(PLUGINS) $(DATA) $(PAGES) $(STATIC) $(SHARED) $(OUT)/$(NAME).pc FORCE
	$(call say,TEST,installcheck)
	$(Q)rm -rf $(STAGE)
	+$(call logged,(set -e; $(again) install DESTDIR=$(abspath $(STAGE)) REALS=$(REAL); \
	    $(again) install-library DESTDIR=$(abspath $(STAGE)) $(hurry); \
	    CXX="$(CXX)" PYTHONDONTWRITEBYTECODE=1 tests/install/installed_test.py $(STAGE)$(PREFIX); \
	    $(MAKE) uninstall DESTDIR=$(abspath $(STAGE)); \
	    test -z "$$(find $(STAGE) ! -type d)"; echo ok install.uninstall))
