# SPDX-License-Identifier: MIT
# The lab measures the product: benchmarks, reports, hard cases, other programs, servers, random input.

.PHONY: lab faults models displays stability pictures bench report report-pages fuzz fuzz-each

# Open CASCADE meshes for peers_bench --cad, where it is installed.
bench_cad     := $(filter cad,$(library_plugins))
objects_bench := $(call objects,$(filter-out %_bench.cpp,$(wildcard tests/bench/*.cpp)) \
                     tests/scene/bodies.cpp tests/dice/scene.cpp $(if $(bench_cad),tests/cad/shapes.cpp))
STABILITY := $(OUT)/tests/stability/stability
BENCHES   := $(patsubst %.cpp,$(OUT)/%,$(wildcard tests/bench/*_bench.cpp))
FUZZERS   := $(patsubst tests/fuzz/corpus/%,$(OUT)/fuzz/%,$(wildcard tests/fuzz/corpus/*))

lab: packages-stability ## a sample of `make stability` as a test, seconds long (make test WITH=lab adds it)
	+@$(call judge,$(OUT)/log/stability.log)

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

pictures: packages-report packages-bench $(APPS) $(PLUGINS) $(DATA) $(OUT)/tests/bench/fixed_failure_bench $(OUT)/tests/bench/depth_bits_bench ## the documents' pictures that are no report's
	L3D_BIN=$(abspath $(OUT)/bin) tests/x11/contact_sheet.py docs/pictures
	$(OUT)/bin/teapot_afd --no-input --backend memory --size 640x480 --output docs/pictures/teapot.png
	$(OUT)/bin/teapot_afd --no-input --backend memory --size 640x480 --wireframe --net --output docs/pictures/steps.png
	for shade in zebra gaussian; do \
	    $(OUT)/bin/teapot_afd --no-input --backend memory --size 640x480 --shade $$shade --output docs/pictures/$$shade.png; done
	$(OUT)/bin/teapot_afd --no-input --backend memory --size 1000x420 --compare tessellation:6 --output docs/pictures/comparison.png
	$(OUT)/bin/surfview --no-input --backend memory --size 480x320 plate --edges --output docs/pictures/plate.png
	$(OUT)/bin/surfview --no-input --backend memory --size 480x320 plate --drawing --output docs/pictures/drawing.png
	$(OUT)/bin/surfview --no-input --backend memory --size 480x320 data/head.obj --subdivide --output docs/pictures/head.png
	$(OUT)/bin/gallery --no-input --backend memory --size 1024x560 --glossy --output docs/pictures/gallery.png
	$(OUT)/tests/bench/fixed_failure_bench docs/pictures/fixed_16_16.png
	$(OUT)/tests/bench/depth_bits_bench docs/pictures/depth_16.png
	gnuplot docs/report/peers.gp
	gnuplot docs/report/antialias_peers.gp
	gnuplot docs/report/leaving_out.gp
	for drawing in docs/pictures/*.dot; do dot -Tpng -Gdpi=90 $$drawing -o $${drawing%.dot}.png; done

bench: packages-bench ## build and run the benchmarks
	+@$(again) $(BENCHES) $(APPS)
	@set -e; for bench in $(BENCHES); do $$bench $(ARGS); done
	@L3D_BIN=$(abspath $(OUT)/bin) tests/bench/start_up.py
	@L3D_BIN=$(abspath $(OUT)/bin) tests/bench/world_rates.py

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

# ---- rules --------------------------------------------------------------------------------------

$(STABILITY): $(objects_stability) $(call archives,reference $(uses_stability)) \
        $(OUT)/list/stability
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(uses_stability)) -o $@

# A part of what `make stability` runs, a few seconds.
$(OUT)/log/stability.log: $(STABILITY) FORCE
	$(call say,TEST,stability)
	$(call logged,timeout --foreground $(TEST_TIMEOUT) $< --sample)

$(OUT)/tests/models/model_polygons: $(objects_models) $(call archives,$(uses_models))
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(LAYERS)) -o $@

$(BENCHES): %: %.o $(objects_bench) $(call archives,reference compare $(LAYERS))
	$(call say,LINK,$@)
	$(Q)$(LINK) $(filter %.o,$^) $(filter %.a,$^) $(call links,$(LAYERS)) \
	    -lembree3 -lbenchmark -lcairo -lagg $(if $(bench_cad),-lTKMesh $(links_cad)) -o $@

$(OUT)/fuzz/%: tests/fuzz/model_fuzz.cpp $(wildcard tests/fuzz/*.h) $(OUT)/libl3d_geom.a
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D); $(LINK) $(call include_paths,$<) -fsanitize=fuzzer -DL3D_FUZZED='"$*"' $(filter-out %.h,$^) -o $@

-include $(wildcard $(BENCHES:=.d) $(objects_bench:.o=.d))
