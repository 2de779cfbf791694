# SPDX-License-Identifier: MIT
# Tests: each writes a log, and tests/lint/summary.awk judges any set of logs.

.PHONY: test test-farm stress matrix golden

# What the law is read from: all objects of the library, of programs and of tests.
lists     := $(LAYERS) compare reference $(apps:%=apps/%) $(library_plugins:%=plugins/%) $(tested:%=tests/%) \
             $(if $(filter lab,$(WITH)),stability models) $(filter python,$(WITH))
OBJECTS   := $(sort $(foreach l,$(lists),$(objects_$(l))))
TESTERS   := $(tested:%=$(OUT)/tests/%_tests)
SCRIPTS   := $(wildcard tests/x11/*_test.sh tests/x11/*_test.py)
STRESS    := $(wildcard tests/x11/stress/*_test.py)
SERVER_LOGS := $(STRESS:tests/%=$(OUT)/log/%.log)
PYTHON_LOGS := $(patsubst tests/%,$(OUT)/log/%.log,$(wildcard tests/python/*_test.py))
FARM_LOGS   := $(OUT)/log/farm/farm_test.py.log
STRESS_LOGS := $(SERVER_LOGS) $(patsubst %,$(OUT)/log/%-stress.log,raster dice pipeline)
# What is tested is made before anything is run, and what runs longest is begun first.
MADE_FIRST = $(TESTERS) $(APPS) $(PLUGINS) $(LIBRARY_PLUGINS) $(DATA) \
             $(if $(filter lab,$(WITH)),$(STABILITY)) \
             $(if $(filter python,$(WITH)),python-package) \
             $(if $(filter install,$(WITH)),$(PAGES) $(STATIC) $(SHARED) $(OUT)/$(NAME).pc)
LONGEST   := pipeline dice
TEST_LOGS := $(LONGEST:%=$(OUT)/log/%.log) \
             $(if $(filter install,$(WITH)),$(OUT)/log/installcheck.log) \
             $(if $(filter stress,$(WITH)),$(STRESS_LOGS)) \
             $(if $(filter servers,$(WITH)),$(SERVER_LOGS)) \
             $(if $(filter python,$(WITH)),$(PYTHON_LOGS)) \
             $(if $(filter farm,$(WITH)),$(FARM_LOGS)) \
             $(patsubst %,$(OUT)/log/%.log,$(filter-out $(LONGEST),$(tested))) \
             $(if $(filter lab,$(WITH)),$(OUT)/log/stability.log) \
             $(SCRIPTS:tests/%=$(OUT)/log/%.log) $(OUT)/log/layers.log \
             $(OUT)/log/fail.log $(OUT)/log/front-door.log $(OUT)/log/sentences.log
# Further pictures of what a shorter test judges already: WITH=thorough, `make test-LAYER` and `make matrix` run them.
# Then tests find L3D_THOROUGH in their environment, and judge many cases in place of a few.
longest_pipeline := lit_doubts.hold_for_highlights_of_two_lights_on_four_models:lit_doubts.hold_for_fog:$\
    lit_doubts.hold_for_transparent_instances:error_map.holds_for_patches_of_every_kind:$\
    error_map.holds_for_tiny_patches_and_tilings:error_map.holds_for_bodies:$\
    fog.adds_to_the_bound_of_shades_and_has_bounds_of_colors:background.is_known_to_the_map_of_errors:$\
    leaving_out.of_dicing_of_thousands_of_tiny_patches_covers_the_exact_picture_within_the_bound:$\
    leaving_out.of_random_bodies_backs_loses_nothing_of_the_exact_picture:$\
    shapes/exact_shapes.are_drawn_within_their_bounds_at_any_zoom/0:$\
    shapes/exact_shapes.are_drawn_within_their_bounds_at_any_zoom/3:$\
    lit_picture.by_a_headlight_is_that_of_a_light_of_the_world
longest_dice := pictures.large_ones_are_exact_within_the_bound_too:$\
    watertight/fixed.tilings_cut_again_and_again_cover_every_pixel
longest_raster := draw_path.has_exact_areas_where_a_row_has_hundreds_of_edges:MesaLife.AHundredCyclesEndClean
longest_compare := method_picture.a_tessellations_outline_is_within_its_bound
longest_reference := box_image.of_the_teapot_is_what_many_samples_say
longest_geom := nurbs.places_and_derivatives_are_those_of_exact_rationals_at_100000_places
longest_tool_2d := screen_x11_loss.a_server_may_die_at_any_byte
judge = $(if $(dry_run),: $(1),\
        rm -f $(1); $(MAKE) $(call jobs,2) -k $(2) $(1) || true; awk -f tests/lint/summary.awk $(1))

test: packages-test $(if $(filter install,$(WITH)),packages-install) $(if $(filter python,$(WITH)),packages-python packages-wheel) $(if $(filter farm,$(WITH)),packages-farm) ## build and run the tests; ends with "N passed, N failed"
	+@$(call build,-k $(SLOW_FIRST) $(MADE_FIRST)) || true
	+@$(if $(filter install,$(WITH)),$(build_other) || true)
	+@$(call judge,$(TEST_LOGS))

stress: packages-test ## what takes minutes: servers that die, a million shapes (make test WITH="stress lab thorough" adds all)
	+@$(call judge,$(STRESS_LOGS))

test-farm: packages-test packages-farm ## docs/FARM.md on two nodes with Slurm and ssh, which die and have full disks; as root
	+@$(call judge,$(FARM_LOGS))

test-%: packages-test ## the tests of one layer: make test-geom
	+@$(call judge,$(OUT)/log/$*.log,WITH=thorough)

matrix: packages-test packages-matrix ## every test, the thorough and the lab's as well: each scalar, plain and sanitized, both compilers
	+@$(if $(dry_run),:,MAKE="$(again)" tests/lint/matrix.sh $(BUILD)/matrix)

golden: packages-test $(APPS) $(PLUGINS) $(DATA) ## store the pictures' hashes that tests/x11/programs_test.py compares with
	L3D_BIN=$(abspath $(OUT)/bin) tests/x11/programs_test.py --write

# ---- rules --------------------------------------------------------------------------------------

# Tests of a plug-in look into it, too.
$(TESTERS): $(OUT)/tests/%_tests: $$(objects_tests/$$*) $$(objects_plugins/$$*) $$(call archives,$$(call may_use,$$*)) \
        $(OUT)/list/tests/%
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(call may_use,$*)) \
	    -lgtest -lgtest_main -o $@

# A log ends with an exit status.
logged = $(Q)mkdir -p $(@D); { $(1); } > $@ 2>&1; echo "exit status $$?" >> $@

$(tested:%=$(OUT)/log/%.log): $(OUT)/log/%.log: $(OUT)/tests/%_tests FORCE
	$(call say,TEST,$*)
	$(call logged,$(if $(filter thorough,$(WITH)),L3D_THOROUGH=1) timeout --foreground $(TEST_TIMEOUT) $< --gtest_color=no \
	    $(if $(filter thorough,$(WITH)),,--gtest_filter='-$(longest_$*)'))

# What takes minutes is disabled in its test program.
$(OUT)/log/%-stress.log: $(OUT)/tests/%_tests FORCE
	$(call say,TEST,$* stress)
	$(call logged,timeout --foreground $(STRESS_TIMEOUT) $< --gtest_color=no \
	    --gtest_also_run_disabled_tests --gtest_filter='*DISABLED_*')

$(OUT)/log/system.log $(OUT)/log/geom.log: $(PLUGINS) $(DATA)
$(library_plugins:%=$(OUT)/log/%.log): $(LIBRARY_PLUGINS)

$(OUT)/log/x11/%.log: tests/x11/% $(APPS) $(PLUGINS) $(LIBRARY_PLUGINS) $(DATA) FORCE
	$(call say,TEST,$<)
	$(call logged,PYTHONDONTWRITEBYTECODE=1 L3D_BIN=$(abspath $(OUT)/bin) \
	    timeout --foreground $(TEST_TIMEOUT) $<)

# It is the first process of its namespaces, which SIGTERM does not end.
$(OUT)/log/farm/%.log: tests/farm/% $(OUT)/bin/teapot_afd FORCE
	$(call say,TEST,$<)
	$(call logged,PYTHONDONTWRITEBYTECODE=1 L3D_BIN=$(abspath $(OUT)/bin) \
	    timeout --foreground --signal=KILL $(TEST_TIMEOUT) $<)
