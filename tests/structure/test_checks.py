#!/usr/bin/env python3
"""Plants violations in a copy of the sources and sees each check report them.

Usage: test_checks.py ROOT COMPILER
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

from checks import CHECKS
from run_headers import complaint, unshown
from run_symbols import foreign_symbols

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
COMPILER = [sys.argv.pop(1), "-std=c++20"]
FOLDERS = ("common", "cpu", "gpu", "experiments", "shaders")


class Planted(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.copy = pathlib.Path(self.directory.name)
        for folder in FOLDERS:
            shutil.copytree(ROOT / folder, self.copy / folder)

    def plant(self, name, old, new):
        """Replaces the first `old`; returns the number of its line."""
        path = self.copy / name
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1))
        return text.count("\n", 0, text.index(old)) + 1

    def assert_found(self, check, *parts):
        found = list(CHECKS[check](self.copy))
        self.assertTrue(any(all(p in m for p in parts) for m in found), f"{parts} not in {found}")

    def test_nothing_is_found_in_the_sources(self):
        for name, check in CHECKS.items():
            self.assertEqual(list(check(self.copy)), [], name)

    def test_float_local_without_precise(self):
        line = self.plant("shaders/math.glsl", "  precise float twice", "  float twice")
        self.assert_found("precise", f"shaders/math.glsl:{line}: float twice in reflect3")

    def test_vector_local_without_precise(self):
        self.plant("shaders/sampling.glsl", "  precise vec3 tangent ", "  vec3 tangent ")
        self.assert_found("precise", "vec3 tangent in tangentToWorld")

    def test_structure_with_floats_without_precise(self):
        self.plant("shaders/traverse.glsl", "  precise Hit result", "  Hit result")
        self.assert_found("precise", "Hit result in closestHit")

    def test_condition_without_precise(self):
        self.plant("shaders/math.glsl", "  precise bool steep", "  bool steep")
        self.assert_found("precise", "bool steep in arcTangent2")

    def test_branches_that_return_calls(self):
        self.plant("shaders/cases.glsl", "    result = chosenSphereSurface(", "    return chosenSphereSurface(")
        self.plant("shaders/cases.glsl", "    result = chosenPlaneSurface(", "    return chosenPlaneSurface(")
        self.assert_found("precise", "another branch of caseSurface returns a call")

    def test_return_that_computes(self):
        self.plant("shaders/ray.glsl",
                   "  precise vec3 result = ray.origin + ray.direction * t;\n  return result;",
                   "  return ray.origin + ray.direction * t;")
        self.assert_found("precise", "return in pointAt computes")

    def test_condition_that_computes(self):
        self.plant("shaders/corrected.glsl", "  precise float result = sqrt(x);",
                   "  precise float result = x;\n  if (x * x > 1.0f) {\n    return x;\n  }")
        self.assert_found("precise", "if in approximateRoot computes")

    def test_double_without_precise(self):
        name = "shaders/surface.glsl"
        for kind, local in (("double", "height"), ("dvec3", "moved")):
            line = self.plant(name, f"  precise {kind} {local} =", f"  {kind} {local} =")
            self.assert_found("precise", f"{name}:{line}: {kind} {local} in broughtToPlane")

    def test_doubles_that_compute_outside_a_local(self):
        name = "shaders/surface.glsl"
        line = self.plant(name, "  precise vec3 result = vec3(float(moved.x)",
                          "  while (0.0f > height * height) {\n  }\n"
                          "  precise vec3 result = vec3(float(moved.x)")
        self.assert_found("precise", f"{name}:{line}: while in broughtToPlane computes")
        line = self.plant(name, "  precise dvec3 moved =",
                          "  if (0.0f > height * height) {\n  }\n  precise dvec3 moved =")
        self.assert_found("precise", f"{name}:{line}: if in broughtToPlane computes")
        line = self.plant(name, "sqrt(squared)", "sqrt(x * x + y * y)")
        self.assert_found("precise", f"{name}:{line}: an argument of sqrt in triangleNormal")

    def test_constructor_of_doubles_may_compute(self):
        self.plant("shaders/intersect_robust.glsl", "dvec3(ray.direction)",
                   "dvec3(ray.direction * ray.direction)")
        self.plant("shaders/intersect_robust.glsl", "double(t)", "double(t + t)")
        self.assertEqual(list(CHECKS["precise"](self.copy)), [])

    def test_argument_that_computes(self):
        for name, old, new, message in (
                ("math", "floor(raised)", "floor(quarters + 0.5f)", "floor in sinCosTurns"),
                ("math", "exp2Of(exponent)", "exp2Of(y * log2Of(x))", "exp2Of in power"),
                ("math", "dot3(v, v)", "dot3(v, (v + v) * (v - v))", "dot3 in length3"),
                ("material", "normalize3(bisector)", "normalize3(i - d)",
                 "normalize3 in evaluateGgx"),
                ("surface", "vec3(x, y, z)", "vec3(x * y, y, z)", "normalize3 in reportBoxNormal"),
                ("light", "divide(r2, squared)", "divide(r2,\n light.radius * r2)",
                 "divide in sampleSphereLight")):
            line = self.plant(f"shaders/{name}.glsl", old, new) + new.count("\n")
            self.assert_found("precise", f"shaders/{name}.glsl:{line}: an argument of {message}")
            shutil.copy(ROOT / f"shaders/{name}.glsl", self.copy / f"shaders/{name}.glsl")

    def test_argument_that_computes_with_integers(self):
        self.plant("shaders/path_state.glsl", "noise(key, 0, kDimensionPixelX)",
                   "noise(key, int(column) + x, (x + 1) * kDimensionPixelX)")
        self.assertEqual(list(CHECKS["precise"](self.copy)), [])

    def test_forbidden_builtins(self):
        for call in ("dot(a, b)", "mix(a, b, c)", "max(a, b)", "inversesqrt(a)", "fract(a)"):
            name = "shaders/corrected.glsl"
            line = self.plant(name, "  precise float result = a / b;",
                              f"  precise float result = a / b + {call};")
            self.assert_found("builtins",
                              f"{name}:{line}: forbidden builtin {call.split('(')[0]}")
            shutil.copy(ROOT / name, self.copy / name)

    def test_native_maths_may_use_builtins(self):
        self.plant("shaders/math_native.glsl", "return sqrt(x);", "return pow(x, 0.5f);")
        self.assertEqual(list(CHECKS["builtins"](self.copy)), [])

    def test_missing_twin_file(self):
        (self.copy / "cpu/kernel/light.h").unlink()
        self.assert_found("twins", "shaders/light.glsl: no twin cpu/kernel/light.h")

    def test_missing_twin_function(self):
        self.plant("cpu/kernel/ray.h", "pointAt(", "placeAt(")
        self.assert_found("twins", "cpu/kernel/ray.h: pointAt of shaders/ray.glsl is missing")

    def test_order_of_twin_functions(self):
        self.plant("cpu/kernel/ray.h", "inverseOrInfinity(R x)", "swapped(R x)")
        self.plant("cpu/kernel/ray.h", "Vec3<R> pointAt(", "Vec3<R> inverseOrInfinity(")
        self.plant("cpu/kernel/ray.h", "R swapped(R x)", "R pointAt(R x)")
        self.assert_found("twins", "cpu/kernel/ray.h", "stands elsewhere")

    def test_layers(self):
        for name, include in (("cpu/tracer.cpp", "gpu/context.h"), ("gpu/context.cpp", "cpu/tracer.h"),
                              ("common/film/film.cpp", "cpu/tracer.h"),
                              ("common/stats/welch.cpp", "common/scene/scene.h"),
                              ("common/base/error.cpp", "common/scene/scene.h")):
            self.plant(name, "#include", f'#include "{include}"\n#include')
            self.assert_found("layers", name, f"must not include {include}")

    def test_embree_and_gl_in_their_places_only(self):
        self.plant("cpu/tracer.cpp", "#include", "#include <embree3/rtcore.h>\n#include")
        self.assert_found("layers", "cpu/tracer.cpp", "Embree")
        self.plant("common/base/error.cpp", "#include", "#include <GL/glcorearb.h>\n#include")
        self.assert_found("layers", "common/base/error.cpp", "GL headers")

    def test_header_without_pragma_once(self):
        self.plant("common/base/error.h", "#pragma once", "")
        self.assert_found("layers", "common/base/error.h:1: no #pragma once")

    def test_header_that_needs_another_before_it(self):
        self.plant("cpu/kernel_entry.h", "#include \"common/scene/flat_scene.h\"", "")
        self.assertNotEqual(complaint(self.copy, COMPILER, "cpu/kernel_entry.h"), "")
        self.assertEqual(complaint(ROOT, COMPILER, "cpu/kernel_entry.h"), "")

    def test_header_that_no_file_includes_first(self):
        self.assertNotIn("common/base/error.h", unshown(self.copy))
        self.plant("common/base/error.cpp", "#include", "#include <string>\n#include")
        self.assertIn("common/base/error.h", unshown(self.copy))

    def test_symbols_without_namespace(self):
        listing = ("0000 W twintrace::kernel::avx2::noise(int)\n0000 V DW.ref.__gxx_personality_v0\n"
                   "0000 W std::vector<int>::size() const\n0000 T renderTileAvx2(int)\n")
        self.assertEqual(list(foreign_symbols("avx2", listing)), ["std::vector<int>::size() const"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
