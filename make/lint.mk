# SPDX-License-Identifier: MIT
# Checks of the sources (format, includes, names, sentences, clang-tidy), and the reference made of them.

CHECKS    := format-check headers front-door layers errors-doc sentences fail
.PHONY: lint $(CHECKS) tidy format docs reference

LINT_LOGS := $(CHECKS:%=$(OUT)/log/%.log) $(OUT)/log/x11/docs_test.py.log $(OUT)/log/tidy.log
LONE      := $(HEADERS:%=$(OUT)/%.ok)

lint: packages-lint packages-test packages-tidy ## the documents' commands, clang-tidy, and:
	+@$(call judge,$(LINT_LOGS),WITH=lab)

$(CHECKS): packages-lint packages-test ## one check alone
	+@$(call judge,$(OUT)/log/$@.log,WITH=lab)

tidy: packages-tidy ## clang-tidy, warnings are errors
	+@$(again) -k $(LINTED:%.cpp=$(OUT)/%.tidy)

format: packages-lint ## clang-format every file in place
	$(Q)$(CLANG_FORMAT) -i $(FORMATTED)

docs: packages-docs $(DOOR) ## the reference of all public headers; a public thing without a comment is an error
	@rm -rf $(BUILD)/docs; mkdir -p $(BUILD)/docs
	@L3D_VERSION_TEXT=$(VERSION) L3D_HEADERS=$(OUT)/include L3D_REFERENCE=$(BUILD)/docs doxygen docs/Doxyfile
	@echo $(BUILD)/docs/html/index.html

# The document as it is up to its first table, and the tables as they should be.
reference_text = { sed '/^\#\# Layer /,$$d' docs/REFERENCE.md; awk -f packaging/reference.awk $(PUBLIC:%=lib/%); }
reference: ## write the tables of classes in docs/REFERENCE.md, from the comments of the public headers
	@mkdir -p $(OUT); $(reference_text) > $(OUT)/REFERENCE.md && mv $(OUT)/REFERENCE.md docs/REFERENCE.md

# ---- rules --------------------------------------------------------------------------------------

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
    -v law="$(foreach l,$(LAYERS) compare reference stability models apps python $(library_plugins),$(l): $(uses_$(l));)" \
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
	$(call logged,tests/lint/sentences.py --self-test --riddles --longest $(longest_sentence) && echo ok sentences)

$(OUT)/log/tidy.log: FORCE
	$(call logged,$(MAKE) tidy && echo ok tidy)

$(OUT)/log/fail.log: FORCE | packages-build
	$(call say,CHECK,tests/fail)
	$(call logged,tests/lint/must_fail.sh '$(CXX) $(FLAGS) -Ilib' $(wildcard tests/fail/*.cpp))

$(OUT)/%.tidy: %.cpp .clang-tidy $(OUT)/flags
	$(call say,TIDY,$<)
	$(Q)$(CLANG_TIDY) --quiet $< -- -xc++ -Wno-unknown-warning-option $(FLAGS) $(call include_paths,$<) && touch $@

-include $(wildcard $(LONE:=.d))
