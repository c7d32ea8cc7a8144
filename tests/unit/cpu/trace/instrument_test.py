#!/usr/bin/env python3
"""Instruments a small kernel, compiles and runs it, and looks at what it recorded.

Usage: instrument_test.py ROOT COMPILER
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

COMPILER = sys.argv.pop(2)
ROOT = pathlib.Path(sys.argv.pop(1)).resolve()

SHADER = """
struct Pair {
  float first;
  int second;
};
float added(float x, float y) { return x + y; }
Pair paired(float x, int n) { return Pair(x, n); }
float chosen(float x) { return x; }
float widened(float x) { return x; }
float renderPixel(float x) { return x; }
"""

KERNEL = """#pragma once
#include "cpu/kernel/namespace.h"

namespace twintrace::kernel {

template <class R>
struct Pair {
  R first;
  int second;
};

template <class R>
R added(R x, R y) {
  return x + y;
}

template <class R>
Pair<R> paired(R x, int n) {
  Pair<R> made{x, n};
  made.second = n + 1;
  return {made.first, made.second};
}

// Not a function of the shaders.
template <class R>
R own(R x) {
  return x;
}

template <class R>
R chosen(R x) {
  const R lists[2] = {x, x};
  R y = lists[0];
  if (x < R(0)) y = added<R>(x,
                             R(1));
  if (x == R(5)) {
    y = R(6);
  } else if (x > R(7)) return R(8);
  for (int i = 0; i < 2; ++i) {
    y += x;
  }
  return y;
}

template <class R>
R widened(R x) {
  using Wider = double;
  const Wider square = Wider(x) * x;
  return R(square);
}

inline float renderPixel(float x) {
  return x;
}

}  // namespace twintrace::kernel
"""

MAIN = """#include <cstdio>
#include <cstdlib>
#include "cpu/kernel/toy.h"
#include "traced_tables.h"
using namespace twintrace;
using namespace twintrace::kernel;

template <class Words>
void print(const Words& words) {
  for (std::size_t at = 0; at < words.size();) {
    const TraceSiteRow& site = kTraceSites[words[at++]];
    const char* name = kTracedFunctions[site.function].name;
    std::printf("%s %s", name, site.kind == TraceSite::Kind::enter ? "(" : site.text);
    for (const char* slot = site.slots; slot != nullptr && *slot != 0;) {
      if (*slot == 'r') std::printf(" %g", std::bit_cast<float>(words[at++]));
      else std::printf(" %d", static_cast<int>(words[at++]));
      slot = __builtin_strchr(slot, ';');
      if (slot != nullptr) ++slot;
    }
    std::printf("\\n");
  }
}

int main(int, char** argv) {
  TraceRecorder recorder;
  const TraceScope scope(recorder);
  const float x = std::strtof(argv[2], nullptr);
  if (argv[1][0] == 'c') chosen(x);
  if (argv[1][0] == 'p') paired(x, 3);
  if (argv[1][0] == 'w') widened(x);
  if (argv[1][0] == 'd') added(0.1, 0.2);
  if (argv[1][0] == 'o') own(x), renderPixel(x);
  print(recorder.words);
}
"""


class Instrumented(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        root = pathlib.Path(cls.directory.name)
        for folder in ("shaders", "cpu/kernel", "experiments/probe"):
            (root / folder).mkdir(parents=True)
        shutil.copy(ROOT / "experiments/probe/shader_text.py", root / "experiments/probe")
        (root / "shaders/toy.glsl").write_text(SHADER)
        (root / "shaders/math_native.glsl").write_text("")
        (root / "cpu/kernel/toy.h").write_text(KERNEL)
        (root / "cpu/kernel/namespace.h").write_text("#pragma once\n")
        out = root / "traced"
        subprocess.run([sys.executable, "-B", ROOT / "cpu/trace/instrument.py", root, out],
                       check=True)
        cls.tables = (out / "traced_tables.h").read_text()
        (out / "main.cpp").write_text(MAIN)
        cls.program = root / "toy"
        subprocess.run([COMPILER, "-std=c++20", "-O0", "-I", out, "-I", ROOT, out / "main.cpp",
                        "-o", cls.program], check=True)

    def events(self, *arguments):
        run = subprocess.run([self.program, *arguments], check=True, capture_output=True, text=True)
        return run.stdout.splitlines()

    def test_arguments_and_result_are_recorded(self):
        self.assertEqual(self.events("double", "0"),
                         ["added ( 0.1 0.2", "added return x + y; 0.3"])

    def test_structures_are_taken_apart_and_members_set(self):
        self.assertEqual(self.events("paired", "2"),
                         ["paired ( 2 3", "paired Pair<R> made{x, n}; 2 3",
                          "paired made.second = n + 1; 2 4",
                          "paired return {made.first, made.second}; 2 4"])

    def test_statements_are_recorded_in_the_order_of_time(self):
        self.assertEqual(self.events("chosen", "1"),
                         ["chosen ( 1", "chosen R y = lists[0]; 1", "chosen y += x; 2",
                          "chosen y += x; 3", "chosen return y; 3"])

    def test_what_hangs_on_a_condition_is_recorded_only_where_it_holds(self):
        self.assertEqual(self.events("chosen", "-1")[2:5],
                         ["added ( -1 1", "added return x + y; 0",
                          "chosen y = added<R>(x, R(1)); 0"])

    def test_branches_are_followed(self):
        self.assertIn("chosen y = R(6); 6", self.events("chosen", "5"))
        self.assertEqual(self.events("chosen", "9")[-1], "chosen return R(8); 8")

    def test_wider_numbers_are_rounded(self):
        self.assertEqual(self.events("widened", "3")[1],
                         "widened const Wider square = Wider(x) * x; 9")

    def test_functions_without_a_shader_and_sample_loops_are_left(self):
        self.assertEqual(self.events("other", "1"), [])

    def test_places_are_those_of_the_original(self):
        line = KERNEL[:KERNEL.index("y = added")].count("\n") + 1
        self.assertTrue(re.search(f'cpu/kernel/toy.h:{line}", "r y", R"cpp\\(y = added',
                                  self.tables))


if __name__ == "__main__":
    unittest.main()
