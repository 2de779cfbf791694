# SPDX-License-Identifier: MIT
# The Python module: it comes in by the front door, as programs do, and links the shared library.

.PHONY: python python-package python-wheel

# A package of Python: the module, the library beside it, and what editors and type checkers read.
PYTHON_PACKAGE  := $(OUT)/python/l3d
PYTHON_TEXTS    := $(addprefix $(PYTHON_PACKAGE)/,__init__.py __init__.pyi py.typed)
PYTHON_MODULE   := $(PYTHON_PACKAGE)/_l3d.abi3.so
PYTHON_HEADERS   = $(shell $(PYTHON) -c 'import sysconfig; print(sysconfig.get_path("include"))')
objects_python  := $(call objects,$(wildcard python/*.cpp))

python: packages-python ## the Python module, in a folder to be put into PYTHONPATH
	+@$(call build,python-package)
	@echo $(OUT)/python

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

-include $(wildcard $(objects_python:.o=.d))
