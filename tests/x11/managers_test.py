#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The quickest rows of `make displays`: one manager that stacks windows and one that tiles them."""

import sys

from displays import run_cell

QUICK = ("openbox", "i3")


def main():
    failed = False
    for manager in QUICK:
        for title, word in run_cell("Xvfb", manager).items():
            # What the manager has not is in brackets; that there is no manager is a failure.
            is_well = word == "ok" or (title != "starts" and word.startswith("("))
            failed = failed or not is_well
            print("ok" if is_well else "not ok", "managers.%s.%s" % (manager, title),
                  "" if is_well else word, flush=True)
    sys.exit(failed)


if __name__ == "__main__":
    main()
