"""What probes and tests know about the text of shaders and of their C++ twins.

The sources are laid out by clang-format, so a definition begins in column 0; that is all the parsing
that structures and signatures need.
"""

import dataclasses
import pathlib
import re

NATIVE = "math_native.glsl"
TWIN_FOLDERS = ("", "hulls", "hulls/volumes")


@dataclasses.dataclass(frozen=True)
class Parameter:
    type: str
    name: str


@dataclasses.dataclass(frozen=True)
class Function:
    name: str
    result: str
    parameters: tuple
    file: str
    line: int
    body: str
    template: str = ""  # C++ only: the template's parameter list


@dataclasses.dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple
    file: str
    template: str = ""


def without_comments(text):
    """The text with comments blanked out; places stay where they are."""
    blank = lambda match: re.sub(r"[^\n]", " ", match.group(0))
    return re.sub(r"//[^\n]*|/\*.*?\*/", blank, text, flags=re.S)


def shader_files(root):
    """The shader files that hold functions with twins, as names below shaders/. Walks through hulls are
    loops over those, and what the host replaces calls them."""
    shaders = pathlib.Path(root) / "shaders"
    paths = [path for folder in TWIN_FOLDERS for path in (shaders / folder).glob("*.glsl")]
    return sorted(str(path.relative_to(shaders)) for path in paths
                  if not path.name.startswith("chosen_"))


def twin_headers(root):
    """The kernel's headers, as names below cpu/kernel/."""
    kernel = pathlib.Path(root) / "cpu/kernel"
    return sorted(str(path.relative_to(kernel)) for path in kernel.rglob("*.h"))


def twin_name(shader):
    """The header that holds the twins of a shader file's functions."""
    return str(pathlib.PurePath(shader).with_suffix(".h"))


def identifier(file):
    """A file's name as part of an identifier."""
    return re.sub(r"\W", "_", str(pathlib.PurePath(file).with_suffix("")))


def block_end(text, opening):
    """Index behind the brace that closes the one at `opening`."""
    depth = 0
    for at in range(opening, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at + 1
    raise ValueError("unbalanced braces")


def split_arguments(text):
    """Splits at commas that lie in no brackets."""
    parts, depth, part = [], 0, ""
    for char in text:
        depth += {"<": 1, "(": 1, "{": 1, ">": -1, ")": -1, "}": -1}.get(char, 0)
        if char == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += char
    return [" ".join(p.split()) for p in parts + [part] if p.strip()]


def parameter(text):
    """A parameter's type, without qualifiers and reference, and its name."""
    match = re.fullmatch(r"(?:const |precise )?(.+?)\s*&?\s*(\w+)", text)
    return Parameter(match.group(1), match.group(2))


_GLSL_FUNCTION = re.compile(r"^(\w+)\s+(\w+)\(([^()]*)\)\s*(\{)", re.M)
_CPP_FUNCTION = re.compile(
    r"^(?:template <([^{}]*?)>\s+)?(?:__attribute__\(\(\w+\)\)\s+)?(?:inline |TWINTRACE_\w+ )?"
    r"([\w:<>]+)\s+(\w+)\(([^()]*)\)\s*(\{)", re.M)
_STRUCT = re.compile(r"^(?:template <([^{}]*?)>\s+)?struct (\w+)\s*(\{)", re.M)


def functions_of(text, file, pattern):
    text = without_comments(text)
    for match in pattern.finditer(text):
        groups = match.groups()
        template = groups[0] if len(groups) == 5 else ""
        result, name, parameters = groups[-4], groups[-3], groups[-2]
        opening = match.start(len(groups))
        yield Function(name, result, tuple(parameter(p) for p in split_arguments(parameters)), file,
                       text.count("\n", 0, match.start()) + 1, text[opening:block_end(text, opening)],
                       template or "")


def glsl_functions(text, file):
    return list(functions_of(text, file, _GLSL_FUNCTION))


def cpp_functions(text, file):
    return list(functions_of(text, file, _CPP_FUNCTION))


def structs(text, file):
    """Structures that hold nothing but data."""
    text = without_comments(text)
    found = []
    for match in _STRUCT.finditer(text):
        opening = match.start(3)
        body = text[opening + 1:block_end(text, opening) - 1]
        if "(" in body or "=" in body or "using" in body:
            continue
        fields = []
        for declaration in body.split(";"):
            if declaration.strip():
                kind, names = declaration.split(None, 1)
                fields += [Parameter(kind, name.strip()) for name in names.split(",")]
        found.append(Struct(match.group(2), tuple(fields), file, match.group(1) or ""))
    return found


class Sources:
    """All shaders and twins below a repository root."""

    def __init__(self, root):
        root = pathlib.Path(root)
        self.files = [name for name in shader_files(root) if name != NATIVE]
        self.texts = {name: (root / "shaders" / name).read_text() for name in self.files}
        self.functions = [f for n in self.files for f in glsl_functions(self.texts[n], n)]
        self.structs = {s.name: s for n in self.files for s in structs(self.texts[n], n)}
        self.twin_files = twin_headers(root)
        self.twin_texts = {n: (root / "cpu/kernel" / n).read_text() for n in self.twin_files}
        self.twins = {n: cpp_functions(t, n) for n, t in self.twin_texts.items()}
        self.native = {(f.name, tuple(p.type for p in f.parameters))
                       for f in glsl_functions((root / "shaders" / NATIVE).read_text(), NATIVE)}
        self.twin_structs = {s.name: s for n, t in self.twin_texts.items() for s in structs(t, n)}

    def in_native(self, function):
        """Whether native maths, which takes NATIVE for math.glsl, has the function."""
        parameters = tuple(p.type for p in function.parameters)
        return function.file != "math.glsl" or (function.name, parameters) in self.native


# Shader functions without a twin of the same signature, and why. They are reached through their
# callers, and the third witness checks them alone.
WITHOUT_TWIN = {
    "fetchTexel": "the kernel reads words, by fetchNumber and fetchInteger",
    "fetchHullTexel": "the kernel's texel is GLM's, which traces do not know",
    "floats3": "the kernel reads words, not texels",
    "float4th": "the kernel reads words, not texels",
}
