#!/usr/bin/env python3
"""The strategy that common/hulls/README.md takes as its example is added by its own files alone, in less
than 100 lines, and the tests and the probe find its function. Usage: test_added_strategy.py ROOT"""

import pathlib
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(ROOT / "experiments/probe"))

import shader_text  # noqa: E402

FILES = ["common/hulls/strategies/aabbSphere.cpp", "shaders/hulls/volumes/aabbSphere.glsl",
         "cpu/kernel/hulls/volumes/aabbSphere.h"]
FOLDERS = ["common", "cpu", "gpu", "shaders", "experiments", "tests"]
SOURCES = {".cpp", ".h", ".glsl", ".py", ".txt", ".cmake"}


class AddedStrategy(unittest.TestCase):
    def test_is_short(self):
        lines = sum(len((ROOT / name).read_text().splitlines()) for name in FILES)
        self.assertLess(lines, 100)

    def test_is_named_nowhere_else(self):
        own = {ROOT / name for name in FILES} | {pathlib.Path(__file__).resolve()}
        naming = [str(path.relative_to(ROOT)) for folder in FOLDERS
                  for path in (ROOT / folder).rglob("*")
                  if path.suffix in SOURCES and path not in own
                  and "aabbsphere" in path.read_text(errors="replace").lower()]
        self.assertEqual(naming, [])

    def test_its_function_is_among_the_twins(self):
        sources = shader_text.Sources(ROOT)
        self.assertIn("enterAabbSphere", [f.name for f in sources.functions])
        twins = sources.twins[shader_text.twin_name("hulls/volumes/aabbSphere.glsl")]
        self.assertIn("enterAabbSphere", [f.name for f in twins])

    def test_readme_names_its_files(self):
        page = (ROOT / "common/hulls/README.md").read_text()
        for name in FILES:
            self.assertIn(f"`{name}`", page)


if __name__ == "__main__":
    unittest.main()
