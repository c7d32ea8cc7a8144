#!/usr/bin/env python3
"""Every header compiles alone. Of one that some file includes before all else, compiling that file
shows it, in the build or here; this compiles the others.

Usage: run_headers.py ROOT COMPILER FLAG...
"""

import concurrent.futures
import os
import pathlib
import subprocess
import sys

from checks import INCLUDE, sources


def unshown(root):
    """Headers, relative to the root, that no file includes before all else."""
    paths = list(sources(root))
    first = {match.group(1) for path in paths if (match := INCLUDE.search(path.read_text()))}
    headers = [str(path.relative_to(root)) for path in paths if path.suffix == ".h"]
    return [header for header in headers if header not in first]


def complaint(root, command, header):
    """What the compiler says of a header alone; empty if nothing."""
    run = subprocess.run([*command, "-I.", "-fsyntax-only", "-x", "c++", "-"], cwd=root, text=True,
                         input=f'#include "{header}"\n', stderr=subprocess.PIPE)
    return run.stderr or ("" if run.returncode == 0 else f"{header}: {command[0]} failed")


def complaints(root, command):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(filter(None, pool.map(lambda h: complaint(root, command, h), unshown(root))))


if __name__ == "__main__":
    found = complaints(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:])
    print("\n".join(found) or "headers: nothing found")
    sys.exit(1 if found else 0)
