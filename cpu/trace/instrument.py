"""Writes a copy of the kernel whose functions record their calls, and what the records mean.

Usage: instrument.py ROOT OUTPUT. The functions are those that the shaders have too. As in
gpu/glsl_instrumenter.cpp an event is the number of its site and the words of its values: the
arguments on entry, the result on return, and each variable that a statement gives a value to.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "experiments/probe"))
import shader_text  # noqa: E402

SCALARS = {"float": "real", "int": "integer", "uint": "natural", "bool": "truth"}
# Names that stand for a number, an integer ... in the kernel's templates.
ALIASES = {"R": "float", "N": "float", "double": "float", "NativeFloat": "float", "Int": "int",
           "Index": "int", "Uint": "uint", "Mask": "bool", "std::int32_t": "int",
           "std::uint32_t": "uint", "IntOf<R>": "int", "UintOf<R>": "uint", "MaskOf<R>": "bool",
           "Vec3<R>": "vec3", "Vec3<N>": "vec3", "Vec3<float>": "vec3",
           "Wider": "float", "Vec3<Wider>": "vec3",
           "WiderOf<R>": "float", "Vec3<WiderOf<R>>": "vec3"}  # recorded rounded to float
# The loops over samples, which a trace of one sample stands for.
UNTRACED = {"renderPixel"}
LOCAL = re.compile(r"(?:const\s+)?([\w:]+(?:<[^;=(){}]*>)?)\s*&?\s+(\w+)\s*(?=[=({])")
ASSIGNED = re.compile(r"(\w+)(?:\.\w+)*\s*(?:[-+*/|&^]?=)(?!=)")
CONDITION = re.compile(r"\s*(if|for|while|else)\b")


class Instrumenter:
    def __init__(self):
        self.sources = shader_text.Sources(ROOT)
        self.names = {f.name for f in self.sources.functions} - UNTRACED
        self.functions = []
        self.sites = []

    def glsl_type(self, kind):
        kind = ALIASES.get(kind, kind)
        bare = re.sub(r"<[RN]>$", "", kind)
        known = kind in SCALARS or kind == "vec3"
        return kind if known else bare if bare in self.sources.structs else None

    def slots(self, kind, path):
        if kind in SCALARS:
            return [(path, SCALARS[kind])]
        if kind == "vec3":
            return [(f"{path}.{c}", "real") for c in "xyz"]
        return [slot for field in self.sources.structs[kind].fields
                for slot in self.slots(field.type, f"{path}.{field.name}")]

    def record(self, kind, place, values, spelled=None, text=""):
        """Adds a site; the C++ text that records its values."""
        slots = [slot for type_, name in values for slot in self.slots(type_, name)]
        self.sites.append((kind, len(self.functions) - 1, place, slots, text))
        words = "".join(f" traceRecorder->words.push_back(traceWord({spelled or ''}"
                        f"{path[len('result'):] if spelled else path}));" for path, _ in slots)
        number = len(self.sites) - 1
        return (f" if (traceRecorder != nullptr && traceRecorder->begin({number}u, {len(slots)}u)) "
                f"{{{words} }}")

    def header(self, name, text):
        blank = shader_text.without_comments(text)
        edits = []
        for match in shader_text._CPP_FUNCTION.finditer(blank):
            template, result, function, parameters = match.group(1, 2, 3, 4)
            if function in self.names:
                body = match.start(5), shader_text.block_end(blank, match.start(5))
                edits += self.function(name, blank, result, function, parameters, body)
        for at, removed, inserted in sorted(edits, key=lambda e: e[0], reverse=True):
            text = text[:at] + inserted + text[at + removed:]
        return text

    def function(self, name, blank, result, function, parameters, body):
        given = [shader_text.parameter(p) for p in shader_text.split_arguments(parameters)
                 if p.count(" ")]
        values = [(self.glsl_type(p.type), p.name) for p in given if p.type != "SceneView"]
        if not self.glsl_type(result) or not all(kind for kind, _ in values):
            return []
        place = lambda at: f"cpu/kernel/{name}:{blank.count(chr(10), 0, at) + 1}"
        self.functions.append((function, self.glsl_type(result), values, place(body[0])))
        edits = [(body[0] + 1, 0, self.record("enter", place(body[0]), values))]
        types = {n: kind for kind, n in values}
        for begin, end, hangs in self.statements(blank, body):
            edits += self.statement(blank, begin, end, hangs, result, types, place)
        return edits

    def statements(self, blank, body):
        """First character and semicolon of each statement, and whether it hangs on a condition
        without a block of its own; braces of initialisers are no blocks."""
        depth, begin = 0, body[0] + 1
        braces = []
        for at in range(body[0] + 1, body[1] - 1):
            char = blank[at]
            if char in "([":
                depth += 1
            elif char in ")]":
                depth -= 1
            elif char == "{":
                before = blank[body[0]:at].rstrip()
                block = depth == 0 and (before[-1] in "){};" or before.endswith("else"))
                braces.append(block)
                if block:
                    begin = at + 1
                else:
                    depth += 1
            elif char == "}":
                if braces.pop():
                    begin = at + 1
                else:
                    depth -= 1
            elif char == ";" and depth == 0:
                first = self.behind_conditions(blank, begin, at)
                yield first, at, bool(blank[begin:first].strip())
                begin = at + 1

    def behind_conditions(self, blank, begin, end):
        while match := CONDITION.match(blank, begin, end):
            begin = match.end()
            if match.group(1) != "else":
                depth = 0
                for begin in range(begin, end):
                    depth += {"(": 1, ")": -1}.get(blank[begin], 0)
                    if depth == 0 and blank[begin] == ")":
                        begin += 1
                        break
        return begin + len(blank[begin:end]) - len(blank[begin:end].lstrip())

    def statement(self, blank, begin, end, hangs, result, types, place):
        text = blank[begin:end]
        spoken = " ".join(text.split()) + ";"
        if re.match(r"return\b", text):
            record = self.record("leave", place(begin), [(self.glsl_type(result), "result")],
                                 "traced_", spoken)
            return [(begin, len("return"), f"{{ const {result} traced_ ="),
                    (end + 1, 0, record + " return traced_; }")]
        match = LOCAL.match(text)
        if match and match.group(1) not in ("using", "else"):
            types[match.group(2)] = kind = self.glsl_type(match.group(1))
            variable = match.group(2)
        else:
            match = ASSIGNED.match(text)
            variable = match.group(1) if match else ""
            kind = types.get(variable)
        if not kind:
            return []
        record = self.record("local", place(begin), [(kind, variable)], text=spoken)
        if hangs:  # the record must hang on the same condition
            return [(begin, 0, "{ "), (end + 1, 0, record + " }")]
        return [(end + 1, 0, record)]

    def tables(self):
        slots = lambda found: ";".join(f"{kind[0]} {path}" for path, kind in found)
        functions = [f'    {{"{name}", "{result}", "{";".join(" ".join(v) for v in values)}", "{place}"}},'
                     for name, result, values, place in self.functions]
        sites = [f'    {{TraceSite::Kind::{kind}, {function}, "{place}", "{slots(found)}", '
                 f'R"cpp({text})cpp"}},' for kind, function, place, found, text in self.sites]
        return ("// Generated by cpu/trace/instrument.py.\n#pragma once\n\n"
                '#include "cpu/trace/tables.h"\n\nnamespace twintrace {\n\n'
                "inline constexpr TracedFunctionRow kTracedFunctions[] = {\n" +
                "\n".join(functions) + "\n};\n\ninline constexpr TraceSiteRow kTraceSites[] = {\n" +
                "\n".join(sites) + "\n};\n\n}  // namespace twintrace\n")

    def write(self, output):
        directory = output / "cpu/kernel"
        directory.mkdir(parents=True, exist_ok=True)
        for name, text in self.sources.twin_texts.items():
            text = self.header(name, text)
            if name == "namespace.h":  # which all of the kernel includes
                text += '\n#include "cpu/trace/recorder.h"\n'
            (directory / name).parent.mkdir(parents=True, exist_ok=True)
            (directory / name).write_text(text)
        (output / "traced_tables.h").write_text(self.tables())


if __name__ == "__main__":
    Instrumenter().write(pathlib.Path(sys.argv[2]))
