#!/usr/bin/env python3
"""Runs one check over the sources. Usage: run_check.py NAME ROOT"""

import pathlib
import sys

from checks import CHECKS

found = list(CHECKS[sys.argv[1]](pathlib.Path(sys.argv[2]).resolve()))
print("\n".join(found) or f"{sys.argv[1]}: nothing found")
sys.exit(1 if found else 0)
