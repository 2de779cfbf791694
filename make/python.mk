# SPDX-License-Identifier: MIT
# The Python module: it comes in by the front door, as programs do, and links the shared library.

.PHONY: python python-package wheel test-python install-python

# A package of Python: the module, the library beside it, and what editors and type checkers read.
PYTHON_PACKAGE  := $(OUT)/python/l3d
PYTHON_TEXTS    := $(addprefix $(PYTHON_PACKAGE)/,__init__.py __init__.pyi py.typed)
PYTHON_MODULE   := $(PYTHON_PACKAGE)/_l3d.abi3.so
PYTHON_HEADERS   = $(shell $(PYTHON) -c 'import sysconfig; print(sysconfig.get_path("include"))')

python: packages-python ## the Python module, in a folder to be put into PYTHONPATH
	+@$(call build,python-package)
	@echo $(OUT)/python

wheel: packages-python packages-wheel ## a file for `pip install`, with the library inside, into build/.../python/dist
	+@$(call build,python-package)
	+@$(again) $(OUT)/python/pyproject.toml $(OUT)/python/setup.py
	$(Q)cd $(OUT)/python && rm -rf dist build && $(PYTHON) -m build --no-isolation --wheel > wheel.log 2>&1 || \
	    { cat wheel.log; exit 1; }
	@ls $(OUT)/python/dist/*.whl

test-python: packages-python packages-test packages-wheel ## the tests of the Python module
	+@$(call judge,$(PYTHON_LOGS))

# Beside the module lies the library; packages that have it elsewhere give an empty python_run_path.
PYTHONDIR ?= $(PREFIX)/lib/python3/dist-packages
install-python: python-package
	$(Q)$(call put,644,$(PYTHONDIR)/l3d,$(PYTHON_MODULE) $(PYTHON_PACKAGE)/$(SONAME) $(PYTHON_TEXTS))

python-package: $(PYTHON_MODULE) $(PYTHON_PACKAGE)/$(SONAME) $(PYTHON_TEXTS)

# ---- rules --------------------------------------------------------------------------------------

$(objects_python): private CPPFLAGS += -isystem $(PYTHON_HEADERS)
$(objects_python): $(OUT)/python/docs.inc | $(DOOR)

$(OUT)/python/docs.inc: python/docs.py python/l3d/__init__.pyi
	$(Q)mkdir -p $(@D); $(PYTHON) $^ > $@

# Its one exported name is the one that Python looks for.
$(PYTHON_MODULE): $(objects_python) $(SHARED) $(OUT)/list/python
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D); $(LINK) -shared $(filter %.o,$^) $(SHARED) $(python_run_path) -o $@
python_run_path ?= -Wl,-rpath,'$$ORIGIN'

$(PYTHON_PACKAGE)/$(SONAME): $(SHARED)
	$(Q)mkdir -p $(@D); cp $< $@

$(PYTHON_TEXTS): $(PYTHON_PACKAGE)/%: python/l3d/%
	$(Q)mkdir -p $(@D); cp $< $@

$(OUT)/python/pyproject.toml: python/pyproject.toml.in $(OUT)/flags
	$(Q)sed 's|@version@|$(VERSION)|' $< > $@
$(OUT)/python/setup.py: python/setup.py
	$(Q)cp $< $@

$(OUT)/log/python/%.log: tests/python/% python-package FORCE
	$(call say,TEST,$<)
	$(call logged,PYTHONDONTWRITEBYTECODE=1 L3D_PYTHON=$(abspath $(OUT)/python) \
	    timeout --foreground $(TEST_TIMEOUT) $(PYTHON) $<)
# It builds in the folder of the package, of which others take copies.
$(OUT)/log/python/wheel_test.py.log: $(OUT)/python/pyproject.toml $(OUT)/python/setup.py

-include $(wildcard $(objects_python:.o=.d))
