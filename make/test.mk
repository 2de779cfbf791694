# SPDX-License-Identifier: MIT
# Tests: each writes a log, and tests/lint/summary.awk judges any set of logs.

.PHONY: test stress matrix golden

TESTERS   := $(tested:%=$(OUT)/tests/%_tests)
SCRIPTS   := $(wildcard tests/x11/*_test.sh tests/x11/*_test.py)
STRESS    := $(wildcard tests/x11/stress/*_test.py)
SERVER_LOGS := $(STRESS:tests/%=$(OUT)/log/%.log)
STRESS_LOGS := $(SERVER_LOGS) $(OUT)/log/raster-stress.log $(OUT)/log/pipeline-stress.log
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
judge = $(if $(dry_run),: $(1),\
        rm -f $(1); $(MAKE) $(call jobs,2) -k $(1) || true; awk -f tests/lint/summary.awk $(1))

test: packages-test $(if $(filter install,$(WITH)),packages-install) ## build and run every test; ends with "N passed, N failed"
	+@$(call build,-k $(SLOW_FIRST) $(MADE_FIRST)) || true
	+@$(if $(filter install,$(WITH)),$(build_other) || true)
	+@$(call judge,$(TEST_LOGS))

stress: packages-test ## what takes minutes: servers that die, a million shapes (make test WITH=stress adds all)
	+@$(call judge,$(STRESS_LOGS))

test-%: packages-test ## the tests of one layer: make test-geom
	+@$(call judge,$(OUT)/log/$*.log)

matrix: packages-test packages-matrix ## every test: each scalar, plain and sanitized, both compilers
	+@$(if $(dry_run),:,MAKE="$(again)" tests/lint/matrix.sh $(BUILD)/matrix)

golden: packages-test $(APPS) $(PLUGINS) $(DATA) ## store the pictures' hashes that tests/x11/programs_test.py compares with
	L3D_BIN=$(abspath $(OUT)/bin) tests/x11/programs_test.py --write

# ---- rules --------------------------------------------------------------------------------------

$(TESTERS): $(OUT)/tests/%_tests: $$(objects_tests/$$*) $$(call archives,$$(call may_use,$$*)) \
        $(OUT)/list/tests/%
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(call may_use,$*)) \
	    -lgtest -lgtest_main -o $@

# A log ends with an exit status.
logged = $(Q)mkdir -p $(@D); { $(1); } > $@ 2>&1; echo "exit status $$?" >> $@

$(tested:%=$(OUT)/log/%.log): $(OUT)/log/%.log: $(OUT)/tests/%_tests FORCE
	$(call say,TEST,$*)
	$(call logged,timeout --foreground $(TEST_TIMEOUT) $< --gtest_color=no)

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
