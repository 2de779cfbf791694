#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What display_test.py looks at for a moment, for as long as the requirements ask."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

import display_test
import harness
from harness import Checks

if __name__ == "__main__":
    print("seed", display_test.SEED)
    checks = Checks()
    for program in harness.PROGRAMS:
        for backend in display_test.BACKENDS:
            for check, amount in (
                (display_test.rests_when_paused, 10),  # seconds
                (display_test.waits_for_a_stopped_server, 3),  # seconds
            ):
                name = "displays.%s.%s.%s" % (program.name, backend, check.__name__)
                checks.run(name, check, program, backend, amount)
        if "xshm" in display_test.BACKENDS:
            name = "displays.%s.leaves_no_segment" % program.name
            checks.run(name, display_test.leaves_no_segment, program, 200)  # runs
    checks.finish()
