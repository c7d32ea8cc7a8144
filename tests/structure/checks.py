"""Rules about the text of the sources that no compiler knows. Each check yields messages."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "experiments/probe"))

import shader_text  # noqa: E402
from shader_text import NATIVE, WITHOUT_TWIN, cpp_functions, glsl_functions, without_comments

# Builtins whose order of operations, precision or treatment of NaN is the driver's own affair.
FORBIDDEN = ("acos acosh all any asin asinh atan atanh ceil clamp cos cosh cross degrees determinant "
             "distance dot equal exp exp2 faceforward fma fract greaterThan inverse inversesqrt "
             "isinf isnan ldexp length lessThan log log2 max min mix mod modf normalize "
             "outerProduct pow radians reflect refract round roundEven sign sin sinh smoothstep "
             "step tan tanh texture textureLod transpose trunc dFdx dFdy fwidth interpolateAtCentroid"
             ).split()
EXACT_TYPES = {"int", "uint", "uvec4", "void", "ivec2"}
FLOAT_TYPES = {"float", "vec2", "vec3", "vec4", "double", "dvec3"}
INTEGER_BUILTINS = {"floatBitsToInt", "floatBitsToUint"}


def shader_paths(root):
    return sorted(p for p in (root / "shaders").rglob("*.glsl") if p.name != NATIVE)


def located(root, path, text, at, message):
    return f"{path.relative_to(root)}:{text.count(chr(10), 0, at) + 1}: {message}"


def shader_structs(root):
    found = {}
    for path in shader_paths(root):
        found.update({s.name: s for s in shader_text.structs(path.read_text(), path.name)})
    return found


def integer_structs(root):
    """Structures without a float, at any depth."""
    found = shader_structs(root)
    exact = set()
    grown = True
    while grown:
        new = {n for n, s in found.items() if all(f.type in EXACT_TYPES | exact for f in s.fields)}
        grown = new != exact
        exact = new
    return exact


def check_precise(root):
    """Every local that holds, or was decided by, a float is precise; returns, conditions and the
    arguments of functions name such locals instead of computing."""
    exact = EXACT_TYPES | integer_structs(root)
    integers = integer_names(root, exact)
    constructors = EXACT_TYPES | FLOAT_TYPES | set(shader_structs(root))
    local = re.compile(r"^[ ]+((?:const |precise )*)(\w+) (\w+)( =|;)", re.M)
    for path in shader_paths(root):
        text = without_comments(path.read_text())
        for function in glsl_functions(text, path.name):
            start = text.index(function.body)
            floats = {p.name for p in function.parameters if p.type not in exact | {"bool"}}
            for match in local.finditer(function.body):
                qualifiers, kind, name, _ = match.groups()
                if kind in ("return", "else"):
                    continue
                if kind not in exact | {"bool"}:
                    floats.add(name)
                if kind not in exact and "precise" not in qualifiers:
                    yield located(root, path, text, start + match.start(2),
                                  f"{kind} {name} in {function.name} is not precise")
            yield from check_computed(root, path, text, start, function, floats, exact)
            yield from check_arguments(root, path, text, start, function, integers, constructors)
            yield from check_branches(root, path, text, start, function, exact)


def check_branches(root, path, text, start, function, exact):
    """At most one branch that is chosen at run time returns a call. Mesa drops `precise`
    from several; it keeps that of one result which all branches assign."""
    branch = re.compile(r"^ +(?:\} else )?if \(([^{]*)\) \{\n +return \w+\(", re.M)
    returning = [match for match in branch.finditer(function.body)
                 if not all(re.fullmatch(r"k[A-Z]\w*", n) for n in re.findall(r"[A-Za-z]\w*", match.group(1)))]
    for match in returning[1:] if function.result not in exact else []:
        yield located(root, path, text, start + match.start(),
                      f"another branch of {function.name} returns a call, "
                      "expected one precise result for all branches")


def check_computed(root, path, text, start, function, floats, exact):
    arithmetic = re.compile(r" [-+*/] |[(\[,] ?-\w|^-\w")
    computed = re.compile(r"\b(return|if|while) ?(.*?)(;|\{)", re.S)
    for match in computed.finditer(function.body):
        word, expression, _ = match.groups()
        if word == "return" and function.result in exact:
            continue
        names = set(re.findall(r"(?<![.\w])\w+", expression))
        literal = re.search(r"\d\.\d*f", expression)
        if arithmetic.search(expression) and (names & floats or literal):
            yield located(root, path, text, start + match.start(),
                          f"{word} in {function.name} computes with floats outside a precise local")


def integer_names(root, exact):
    """Functions, members and globals that hold no float wherever the name is used."""
    kinds = {}
    for path in shader_paths(root):
        text = path.read_text()
        for kind, name in re.findall(r"^(?:const|uniform) (\w+) (\w+)", text, re.M):
            kinds.setdefault(name, set()).add(kind)
        for function in glsl_functions(text, path.name):
            kinds.setdefault(function.name, set()).add(function.result)
    for structure in shader_structs(root).values():
        for field in structure.fields:
            kinds.setdefault("." + field.name, set()).add(field.type)
    found = {name for name, types in kinds.items() if types <= exact}
    return found | INTEGER_BUILTINS | EXACT_TYPES


def enclosing_calls(body):
    """For each place of the body the names before the brackets that enclose it; a bracket of
    grouping has an empty name."""
    open_calls, found = [], []
    for at, char in enumerate(body):
        if char == ")":
            open_calls.pop()
        found.append(tuple(open_calls))
        if char == "(":
            open_calls.append(re.search(r"\w*$", body[:at]).group(0))
    return found


def check_arguments(root, path, text, start, function, integers, constructors):
    """Arithmetic with floats within the brackets of a call. An operator works on integers where the
    operand on either side of it is one, since the shaders convert no numbers silently."""
    body = function.body
    own = {p.name for p in function.parameters if p.type in EXACT_TYPES}
    own |= set(re.findall(r"\b(?:int|uint) (\w+)", body))
    calls = enclosing_calls(body)
    no_calls = {"", "if", "for", "while", "return"} | constructors

    def is_integer(operand):
        name = operand.rsplit(".", 1)
        return (re.fullmatch(r"\d+u?", operand) or operand in own | integers
                or (len(name) == 2 and "." + name[1] in integers))

    for operator in re.finditer(r"(?<=\s)[-+*/](?=\s)", body):
        at = operator.start()
        called = [name for name in calls[at] if name not in no_calls]
        if not called:
            continue
        left = body[:at].rstrip()
        if left.endswith(")"):
            opening = max(i for i in range(len(left) - 1)
                          if body[i] == "(" and calls[i] == calls[len(left) - 1])
            left = left[:opening]
        operands = (re.search(r"[\w.]*$", left), re.match(r"[\w.]*", body[at + 1:].lstrip()))
        if not any(is_integer(operand.group(0)) for operand in operands):
            yield located(root, path, text, start + at,
                          f"an argument of {called[-1]} in {function.name} computes with floats "
                          "outside a precise local")


def check_builtins(root):
    pattern = re.compile(r"(?<![\w.])(" + "|".join(FORBIDDEN) + r")\s*\(")
    for path in shader_paths(root):
        text = without_comments(path.read_text())
        for match in pattern.finditer(text):
            yield located(root, path, text, match.start(), f"forbidden builtin {match.group(1)}")


def check_twins(root):
    """Each shader file has a twin with the same functions in the same order. A twin may hold more:
    overloads for other number types, and what C++ needs to stand in for GLSL."""
    anywhere = {f.name for n in shader_text.twin_headers(root)
                for f in cpp_functions((root / "cpu/kernel" / n).read_text(), n)}
    for name in shader_text.shader_files(root):
        twin = root / "cpu/kernel" / shader_text.twin_name(name)
        if not twin.exists():
            yield f"shaders/{name}: no twin {twin.relative_to(root)}"
            continue
        ours = [f.name for f in glsl_functions((root / "shaders" / name).read_text(), name)]
        ours = [n for n in dict.fromkeys(ours) if n not in WITHOUT_TWIN]
        theirs = list(dict.fromkeys(f.name for f in cpp_functions(twin.read_text(), twin.name)))
        for missing in (n for n in ours if n not in theirs):
            if missing not in anywhere:
                yield f"{twin.relative_to(root)}: {missing} of shaders/{name} is missing"
        common = [n for n in ours if n in theirs]
        order = [n for n in theirs if n in common]
        if common != order:
            first = next(a for a, b in zip(order, common) if a != b)
            yield f"{twin.relative_to(root)}: {first} stands elsewhere than in shaders/{name}"


# What the files of a folder may include of the project.
MAY_INCLUDE = {
    "common/base": ("common/base",),
    "common/stats": ("common/base", "common/film", "common/stats"),
    "common": ("common", "shaders/shared"),
    "cpu": ("common", "cpu"),
    "gpu": ("common", "gpu"),
    "experiments": ("common", "cpu", "gpu", "experiments"),
}
PROJECT = ("common/", "cpu/", "gpu/", "experiments/", "shaders/", "tests/")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def sources(root):
    for folder in ("common", "cpu", "gpu", "experiments"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                yield path


def check_layers(root):
    for path in sources(root):
        relative = str(path.relative_to(root))
        rule = max((r for r in MAY_INCLUDE if relative.startswith(r + "/")), key=len)
        text = path.read_text()
        for match in INCLUDE.finditer(text):
            name = match.group(1)
            allowed = any(name.startswith(prefix + "/") for prefix in MAY_INCLUDE[rule])
            if name.startswith(PROJECT) and not allowed:
                yield located(root, path, text, match.start(), f"{rule} must not include {name}")
            if "rtcore" in name and not re.fullmatch(r"cpu/embree_\w+\.(cpp|h)", relative):
                yield located(root, path, text, match.start(), "only cpu/embree_* may include Embree")
            if name.startswith(("GL/", "EGL/", "GLES")) and not relative.startswith("gpu/"):
                yield located(root, path, text, match.start(), "only gpu may include GL headers")
        if path.suffix == ".h" and not re.search(r"^#pragma once$", text, re.M):
            yield f"{relative}:1: no #pragma once"


CHECKS = {"precise": check_precise, "builtins": check_builtins, "twins": check_twins,
          "layers": check_layers}
