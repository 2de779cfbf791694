# SPDX-License-Identifier: MIT
"""The wheel of the package that `make python` has built: one file for Python 3.11 and all later versions."""

from setuptools import Distribution, setup


class BuiltDistribution(Distribution):
    """It holds a compiled module, although setuptools compiles none."""

    def has_ext_modules(self):
        return True


setup(distclass=BuiltDistribution, options={"bdist_wheel": {"py_limited_api": "cp311"}})
