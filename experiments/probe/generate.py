#!/usr/bin/env python3
"""Writes what is needed to run every shader function alone.

For each function of shaders/*.glsl: a compute main that runs it over packed inputs, and calls of its
C++ twin in float and in double. Nothing is listed by hand: a new function is found by its signature,
and one without a twin of the same signature is an error. A twin that cannot be called with doubles is
constrained (StrictNumber), or its template fails to compile here.

Usage: generate.py ROOT OUTPUT_DIRECTORY
"""

import pathlib
import re
import sys

import shader_text
from shader_text import WITHOUT_TWIN, Sources, identifier, twin_name

KINDS = {"float": "real", "int": "integer", "uint": "natural", "bool": "truth"}
VECTORS = {"vec3": ("float", "xyz"), "uvec4": ("uint", "xyzw")}
TWIN_TYPES = {
    "float": ["R", "float", "WideFloat"],
    "int": ["IntOf<R>", "int", "std::int32_t", "Int", "Index", "WideInt"],
    "uint": ["UintOf<R>", "std::uint32_t", "Uint", "WideUint"],
    "bool": ["MaskOf<R>", "bool", "WideMask"],
    "vec3": ["Vec3<R>"],
}
CANONICAL = {cpp: glsl for glsl, spellings in TWIN_TYPES.items() for cpp in spellings}


def canonical(twin_type):
    return CANONICAL.get(twin_type, re.sub(r"<R>$", "", twin_type))


def own_parameters(twin):
    return [p for p in twin.parameters if p.type != "SceneView"]


class Generator:
    def __init__(self, root):
        self.sources = Sources(root)
        self.errors = []
        self.needs = self.find_needs()

    # Which specialisation constants and scene data a function depends on, through all that it calls.
    def find_needs(self):
        marks = {"noise": "kNoiseSine", "intersector": "kIntersectorReport",
                 "integrator": "kIntegrator", "geometry": "visitGeometry"}
        words = {}
        for f in self.sources.functions:
            words.setdefault(f.name, set()).update(re.findall(r"\w+", f.body), [f.name])
        reach = {name: set(found) for name, found in words.items()}
        changed = True
        while changed:
            changed = False
            for name, found in reach.items():
                grown = found.union(*[reach[w] for w in found if w in reach])
                changed |= grown != found
                reach[name] = grown
        return {name: {mark for mark, word in marks.items() if word in found}
                for name, found in reach.items()}

    def twin(self, function, wide=False):
        """The twin with the same name and parameters; own file first."""
        own = twin_name(function.file)
        files = sorted(self.sources.twins, key=lambda n: (n != "wide.h" if wide else False, n != own))
        for name in files:
            if name == "math_native.h" or (name == "wide.h" and not wide):
                continue
            for twin in self.sources.twins[name]:
                types = [canonical(p.type) for p in own_parameters(twin)]
                if twin.name == function.name and types == [p.type for p in function.parameters]:
                    return twin
        return None

    # Slots: one per scalar or vector of a value, in order.
    def slots(self, kind, path, owner):
        if kind in KINDS:
            return [(path, owner, KINDS[kind], 1)]
        if kind in VECTORS:
            return [(path, owner, KINDS[VECTORS[kind][0]], len(VECTORS[kind][1]))]
        return [slot for field in self.sources.structs[kind].fields
                for slot in self.slots(field.type, f"{path}.{field.name}", kind)]

    def words(self, kind):
        return sum(slot[3] for slot in self.slots(kind, "", ""))

    # GLSL text that makes a value from words, and one that takes it apart.
    def glsl_value(self, kind, at):
        if kind in KINDS:
            word = f"probeInputs[at + {at}]"
            text = {"float": f"uintBitsToFloat({word})", "int": f"int({word})", "uint": word,
                    "bool": f"({word} & 1u) != 0u"}[kind]
            return text, at + 1
        fields = ([VECTORS[kind][0]] * len(VECTORS[kind][1]) if kind in VECTORS else
                  [field.type for field in self.sources.structs[kind].fields])
        parts = []
        for field in fields:
            part, at = self.glsl_value(field, at)
            parts.append(part)
        return f"{kind}({', '.join(parts)})", at

    def glsl_words(self, kind, path):
        if kind in KINDS:
            return [{"float": f"floatBitsToUint({path})", "int": f"uint({path})", "uint": path,
                     "bool": f"{path} ? 1u : 0u"}[kind]]
        if kind in VECTORS:
            element, names = VECTORS[kind]
            return [w for name in names for w in self.glsl_words(element, f"{path}.{name}")]
        return [w for field in self.sources.structs[kind].fields
                for w in self.glsl_words(field.type, f"{path}.{field.name}")]

    def glsl_main(self, function):
        total = sum(self.words(p.type) for p in function.parameters)
        results = self.glsl_words(function.result, "result")
        lines = ['#include "mains/uniforms.glsl"', "", f'#include "{function.file}"', "",
                 "layout(local_size_x = 64) in;",
                 "layout(std430, binding = 0) readonly buffer ProbeInputs { uint probeInputs[]; };",
                 "layout(std430, binding = 1) writeonly buffer ProbeOutputs { uint probeOutputs[]; };",
                 "uniform int probeCount;", "", "void main() {",
                 "  int record = int(gl_GlobalInvocationID.x);", "  if (record >= probeCount) {",
                 "    return;", "  }", f"  int at = record * {max(total, 1)};"]
        at = 0
        names = []
        for index, p in enumerate(function.parameters):
            value, at = self.glsl_value(p.type, at)
            names.append(f"given{index}")
            lines.append(f"  {p.type} {names[-1]} = {value};")
        # Not precise: the driver carries the qualifier over into all that a precise value is made of,
        # so that the function's own would make no difference.
        lines += [f"  {function.result} result = {function.name}({', '.join(names)});",
                  f"  int to = record * {len(results)};"]
        lines += [f"  probeOutputs[to + {i}] = {word};" for i, word in enumerate(results)]
        return "\n".join(lines + ["}"]) + "\n"

    # C++ text.
    def transfer(self, qualified, fields, template):
        """A function that moves a structure's members through `io.item`, one word each."""
        lines = [f"template <class Io{', class R' if template else ''}>",
                 f"void transfer(Io& io, {qualified}& v) {{"]
        for field in fields:
            kind = re.sub(r"<R>$", "", field.type)
            glsl = "vec3" if kind == "Vec3" else canonical(field.type)
            if glsl in KINDS:
                lines.append(f"  io.item(v.{field.name});")
            elif glsl in VECTORS:
                lines += [f"  io.item(v.{field.name}.{c});" for c in VECTORS[glsl][1]]
            else:
                lines.append(f"  transfer(io, v.{field.name});")
        return "\n".join(lines + ["}"])

    def move(self, io, kind, name):
        if kind in KINDS:
            return f"  {io}.item({name});"
        if kind in VECTORS:
            return "\n".join(f"  {io}.item({name}.{c});" for c in VECTORS[kind][1])
        return f"  transfer({io}, {name});"

    def twin_type(self, kind, number, uniform=False):
        if kind in ("int", "uint", "bool") and uniform:
            return {"int": "std::int32_t", "uint": "std::uint32_t", "bool": "bool"}[kind]
        plain = {"float": number, "int": f"IntOf<{number}>", "uint": f"UintOf<{number}>",
                 "bool": f"MaskOf<{number}>", "vec3": f"Vec3<{number}>"}
        if kind in plain:
            return plain[kind]
        return f"{kind}<{number}>" if self.sources.twin_structs[kind].template else kind

    def twin_call(self, function, twin, number):
        deducible = any(re.search(r"\bR\b", re.sub(r"\w+Of<R>", "", p.type)) for p in twin.parameters)
        explicit = re.search(r"\bR\b", twin.template) and not deducible
        names = [f"given{i}" for i in range(len(function.parameters))]
        if len(own_parameters(twin)) != len(twin.parameters):
            names.insert(0, "view")
        return f"{function.name}{f'<{number}>' if explicit else ''}({', '.join(names)})"

    def cpp_body(self, types, kinds, call, result, reader, writer):
        lines = []
        if types:
            lines.append(f"  {reader}")
        for i, (cpp, kind) in enumerate(zip(types, kinds)):
            lines.append(f"  {cpp} given{i}{{}};")
            lines.append(self.move("reader", kind, f"given{i}"))
        lines.append(f"  auto result = {call};")
        lines.append(f"  {writer}")
        lines.append(self.move("writer", result, "result"))
        return "\n".join(lines) + "\n}\n"

    def twin_function(self, function, index):
        twin = self.twin(function)
        view = "view" if len(own_parameters(twin)) != len(twin.parameters) else ""
        return self.call_function(function, twin, f"twin{index}", view, "float",
                                  "std::uint32_t", "WordWriter")

    def twin64_function(self, function, index):
        """The call in double, behind a question whether there is one."""
        twin = self.twin(function)
        view = "view" if len(own_parameters(twin)) != len(twin.parameters) else ""
        types = [self.twin_type(p.type, "R") for p in function.parameters]
        scene = ["const SceneView& view"] if view else []
        given = ", ".join(scene + [f"{t} given{i}" for i, t in enumerate(types)])
        call = self.twin_call(function, twin, "R")
        question = (f"template <class R>\nconcept HasTwin{index} = requires({given}) {{ {call}; }};\n"
                    if given else f"template <class R>\nconcept HasTwin{index} = requires {{ {call}; }};\n")
        body = self.call_function(function, twin, f"twin64_{index}", view, "R", "double", "DoubleWriter")
        return f"{question}template <class R>\n{body}"

    def call_function(self, function, twin, name, view, number, answer, writer):
        kinds = [p.type for p in function.parameters]
        head = f"void {name}(const SceneView& {view}, const std::uint32_t* "
        head += f"{'in' if kinds else ''}, {answer}* out) {{\n"
        types = [self.twin_type(k, number) for k in kinds]
        return head + self.cpp_body(types, kinds, self.twin_call(function, twin, number),
                                    function.result, "probe::WordReader reader{in};",
                                    f"probe::{writer} writer{{out}};")

    def slot_table(self, name, values):
        rows = [f'    {{"{path}", "{owner}", Kind::{kind}, {size}, {index}}},'
                for index, (kind_name, label) in enumerate(values)
                for path, owner, kind, size in self.slots(kind_name, label, "")]
        if not rows:
            return f"constexpr std::span<const Slot> {name};\n"
        return f"constexpr Slot {name}[] = {{\n" + "\n".join(rows) + "\n};\n"

    def signature(self, function):
        return f"{function.name}({', '.join(p.type for p in function.parameters)})"

    def functions_file(self, file):
        functions = [f for f in self.sources.functions if f.file == file]
        calls, rows, names = [], [], []
        header = twin_name(file)
        for i, f in enumerate(functions):
            has_twin = f.name not in WITHOUT_TWIN
            if has_twin and not self.twin(f):
                self.errors.append(f"shaders/{file}:{f.line}: {self.signature(f)} has no twin with "
                                   f"these parameters in cpu/kernel/{header}")
                continue
            if has_twin:
                calls += [self.twin_function(f, i), self.twin64_function(f, i),
                          f"template <class R>\nconstexpr Call64 call64_{i}() {{\n"
                          f"  if constexpr (HasTwin{i}<R>) return &twin64_{i}<R>;\n"
                          "  return nullptr;\n}\n"]
            rows.append(self.slot_table(f"inputs{i}", [(p.type, p.name) for p in f.parameters]))
            rows.append(self.slot_table(f"outputs{i}", [(f.result, "result")]))
            needs = self.needs[f.name]
            flags = ", ".join("true" if n in needs else "false"
                              for n in ("noise", "intersector", "integrator", "geometry"))
            twins = f"&kernel::twin{i}, kernel::call64_{i}<double>()" if has_twin else "nullptr, nullptr"
            rows.append(f"constexpr ShaderFunction function{i} = {{\n"
                        f'    "{f.name}", "{self.signature(f)}", "{file}",\n'
                        f'    R"glsl({self.glsl_main(f)})glsl",\n'
                        f"    inputs{i}, outputs{i}, {{{flags}}},\n"
                        f"    {'true' if self.sources.in_native(f) else 'false'}, {twins}}};\n")
            names.append(f"&function{i}")
        return "\n".join(
            [f"// Generated by experiments/probe/generate.py from shaders/{file} and "
             f"cpu/kernel/{header}.",
             '#include "experiments/probe/shader_function.h"',
             '#include "experiments/probe/words.h"', '#include "kernel_transfer.h"', "",
             "TWINTRACE_KERNEL_BEGIN", "namespace {", "",
             "using Call64 = decltype(probe::ShaderFunction::twin64);", ""] + calls +
            ["}  // namespace", "TWINTRACE_KERNEL_END", "", "namespace twintrace::probe {",
             "namespace {", ""] + rows +
            ["}  // namespace", "",
             f"std::vector<const ShaderFunction*> functionsOf_{identifier(file)}() {{ return {{{', '.join(names)}}}; }}",
             "", "}  // namespace twintrace::probe", ""])

    def kernel_includes(self):
        """Every header of twins; wide.h is its includer's choice."""
        names = [n for n in self.sources.twin_files if n != "wide.h"]
        return "\n".join(f'#include "cpu/kernel/{n}"' for n in names)

    def kernel_transfer(self):
        parts = [self.transfer(f"{s.name}<R>" if s.template else s.name, s.fields, s.template)
                 for name, s in self.ordered(self.sources.twin_structs)]
        return ("// Generated by experiments/probe/generate.py.\n#pragma once\n\n"
                f"{self.kernel_includes()}\n\nTWINTRACE_KERNEL_BEGIN\n\n" +
                "\n\n".join(parts) + "\n\nTWINTRACE_KERNEL_END\n")

    def traced_calls(self):
        """Calls of the float twins alone, for the instrumented copy of the kernel."""
        functions = [f for f in self.sources.functions if f.name not in WITHOUT_TWIN and self.twin(f)]
        calls = "\n".join(self.twin_function(f, i) for i, f in enumerate(functions))
        rows = "\n".join(f'    {{"{self.signature(f)}", &twin{i}}},' for i, f in enumerate(functions))
        return ("// Generated by experiments/probe/generate.py.\n#pragma once\n\n"
                '#include "experiments/probe/words.h"\n#include "kernel_transfer.h"\n\n'
                "TWINTRACE_KERNEL_BEGIN\n\n"
                f"{calls.replace('void twin', 'inline void twin')}\n"
                "struct TracedCall {\n  const char* signature;\n"
                "  void (*call)(const SceneView& view, const std::uint32_t* in, std::uint32_t* out);\n"
                f"}};\n\ninline constexpr TracedCall kTracedCalls[] = {{\n{rows}\n}};\n\n"
                "TWINTRACE_KERNEL_END\n")

    def ordered(self, found):
        """Structures, each behind those that it contains."""
        done = []

        def add(name):
            if name in [d[0] for d in done] or name not in self.sources.structs:
                return
            for field in found[name].fields:
                inner = re.sub(r"<R>$", "", field.type)
                if inner in found:
                    add(inner)
            done.append((name, found[name]))

        for name in sorted(found):
            add(name)
        return done

    def all_functions(self):
        stems = [identifier(f) for f in self.sources.files]
        declared = "\n".join(f"std::vector<const ShaderFunction*> functionsOf_{s}();" for s in stems)
        calls = ", ".join(f"functionsOf_{s}()" for s in stems)
        return ("// Generated by experiments/probe/generate.py.\n"
                '#include "experiments/probe/shader_function.h"\n\nnamespace twintrace::probe {\n\n'
                f"{declared}\n\nstd::vector<const ShaderFunction*> shaderFunctions() {{\n"
                "  std::vector<const ShaderFunction*> all;\n"
                f"  for (const auto& some : {{{calls}}}) {{\n"
                "    all.insert(all.end(), some.begin(), some.end());\n  }\n  return all;\n}\n\n"
                "}  // namespace twintrace::probe\n")

    def texts(self):
        """The files to write, by name."""
        texts = {f"functions_{identifier(f)}.cpp": self.functions_file(f)
                 for f in self.sources.files}
        texts["all_functions.cpp"] = self.all_functions()
        texts["kernel_transfer.h"] = self.kernel_transfer()
        texts["traced_calls.h"] = self.traced_calls()
        return texts

    def write(self, directory):
        directory.mkdir(parents=True, exist_ok=True)
        texts = self.texts()
        if self.errors:
            sys.exit("\n".join(self.errors))
        for name, text in texts.items():
            (directory / name).write_text(text)


if __name__ == "__main__":
    Generator(sys.argv[1]).write(pathlib.Path(sys.argv[2]))
