#!/usr/bin/env python3
"""Weak symbols of code built for one instruction set must carry its namespace: the linker keeps one
copy of those of the same name, and the baseline must not get the one for AVX-512.

Usage: run_symbols.py NAMESPACE OBJECT...
"""

import subprocess
import sys


def foreign_symbols(namespace, nm_output):
    """Weak and unique symbols, demangled, that are not of the namespace. DW.ref are pointers to the
    personality routine: data, the same in every build."""
    for line in nm_output.splitlines():
        fields = line.split(None, 2)
        if len(fields) == 3 and fields[1] in "WVu" and not fields[2].startswith("DW.ref."):
            if f"::{namespace}::" not in fields[2]:
                yield fields[2]


if __name__ == "__main__":
    found = []
    for path in sys.argv[2:]:
        output = subprocess.run(["nm", "-C", "--defined-only", path], check=True, text=True,
                                stdout=subprocess.PIPE).stdout
        found += [f"{path}: {name}" for name in foreign_symbols(sys.argv[1], output)]
    print("\n".join(found) or f"{sys.argv[1]}: nothing found")
    sys.exit(1 if found else 0)
