#include "experiments/probe/user_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "common/base/error.h"
#include "common/base/word_char.h"
#include "experiments/probe/trial.h"
#include "experiments/probe/user_compiler.h"
#include "experiments/probe/user_prelude.h"
#include "experiments/probe/worlds.h"

namespace twintrace::probe {
namespace {

using RunFunction = void(const std::uint32_t*, double*);

struct Edit {
  std::size_t at;
  std::size_t length;
  std::string text;
};

/// Blanks in, out and inout before parameters, and makes the latter two references.
void editParameters(const GlslText& parsed, std::vector<Edit>& edits) {
  for (const GlslFunction& function : parsed.functions) {
    for (std::size_t at = function.place; at < function.body.begin;) {
      std::size_t end = at + 1;
      if (isWordChar(parsed.text[at])) {
        while (isWordChar(parsed.text[end])) ++end;
      }
      const std::string word = parsed.text.substr(at, end - at);
      if (word == "in" || word == "out" || word == "inout") edits.push_back({at, word.size(), ""});
      at = end;
    }
    for (const GlslVariable& parameter : function.parameters) {
      if (parameter.direction == GlslDirection::in) continue;
      edits.push_back({parameter.place + parameter.type.size(), 0, "&"});
    }
  }
}

/// Takes the f or lf off literals, so that `0.1f` is a tenth in double too.
void editLiterals(const std::string& text, std::vector<Edit>& edits) {
  for (std::size_t at = 0; at < text.size();) {
    if (!isWordChar(text[at]) && text[at] != '.') {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    const bool number = std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.';
    const bool hex = text.compare(at, 2, "0x") == 0 || text.compare(at, 2, "0X") == 0;
    while (end < text.size() && (isWordChar(text[end]) || (number && text[end] == '.') ||
                                 (number && !hex && (text[end] == '-' || text[end] == '+') &&
                                  (text[end - 1] == 'e' || text[end - 1] == 'E')))) {
      ++end;
    }
    const bool suffixed = text[end - 1] == 'f' || text[end - 1] == 'F';
    const bool digits = end - at > 1 && std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0;
    if (number && !hex && suffixed && (text[at] != '.' || digits)) {
      const bool wide = text[end - 2] == 'l' || text[end - 2] == 'L';
      const std::size_t length = wide ? 2 : 1;
      edits.push_back({end - length, length, ""});
    }
    at = end;
  }
}

/// The place of each component if all are of one set of names, such as rgb; else nothing.
std::vector<std::size_t> swizzle(std::string_view word) {
  for (const std::string_view names : {"xyzw", "rgba", "stpq"}) {
    if (word.find_first_not_of(names) != std::string_view::npos) continue;
    std::vector<std::size_t> places;
    for (const char c : word) places.push_back(names.find(c));
    return places;
  }
  return {};
}

/// `.xyz` becomes `.swizzle<0, 1, 2>()`; a single component is a member.
void editSwizzles(const std::string& text, std::vector<Edit>& edits) {
  for (std::size_t at = 0; (at = text.find('.', at)) != std::string::npos; ++at) {
    std::size_t end = at + 1;
    while (end < text.size() && isWordChar(text[end])) ++end;
    const std::vector<std::size_t> places = swizzle({&text[at + 1], end - at - 1});
    if (places.size() < 2 || places.size() > 4) continue;
    edits.push_back({at, end - at, fmt::format(".swizzle<{}>()", fmt::join(places, ", "))});
  }
}

std::string asCpp(std::string text, const std::string& path) {
  const GlslText parsed = parseGlsl(text, path);
  std::vector<Edit> edits;
  editParameters(parsed, edits);
  editLiterals(parsed.text, edits);
  editSwizzles(parsed.text, edits);
  std::ranges::sort(edits, std::ranges::greater{}, &Edit::at);
  for (const Edit& edit : edits) text.replace(edit.at, edit.length, edit.text);
  return text;
}

/// The text with #line where the next line is of another place.
std::string withPlaces(const ShaderSource& source, const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  std::size_t index = 0;
  ShaderSource::Line last{source.files.size(), 0};
  for (std::string line; std::getline(lines, line); ++index) {
    const ShaderSource::Line place = source.lines.at(index);
    if (line.starts_with("#version")) continue;
    if (place.file != last.file || place.number != last.number + 1) {
      result += fmt::format("#line {} \"{}\"\n", place.number, source.files[place.file]);
    }
    result += line + "\n";
    last = place;
  }
  return result;
}

std::string scalarFrom(const UserValue& value, int word) {
  switch (value.kind) {
    case Kind::real:
      return fmt::format("std::bit_cast<float>(in[{}])", word);
    case Kind::integer:
      return fmt::format("static_cast<int>(in[{}])", word);
    case Kind::natural:
      return fmt::format("in[{}]", word);
    case Kind::truth:
      return fmt::format("((in[{}] & 1u) != 0u)", word);
  }
  return "";
}

/// `scalar, scalar, ...` of a value's words.
std::string scalarsFrom(const UserValue& value, int at) {
  std::string text;
  for (int i = 0; i < value.size; ++i) text += (i == 0 ? "" : ", ") + scalarFrom(value, at + i);
  return text;
}

std::string toDoubles(const UserValue& value, const std::string& name, int& to) {
  std::string text;
  for (int i = 0; i < value.size; ++i) {
    const std::string part = value.size == 1 ? name : fmt::format("{}[{}]", name, i);
    text += fmt::format("  out[{}] = static_cast<double>({});\n", to++, part);
  }
  return text;
}

std::string textCaller(const UserFunction& function) {
  std::string text = "#line 1 \"<call>\"\n}\n#undef float\n";
  text +=
      "extern \"C\" void twintraceRun(const std::uint32_t* in, double* out) {\n"
      "  using namespace shader;\n  static_cast<void>(in);\n";
  std::string arguments;
  int at = 0;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const UserValue& value = function.parameters[i];
    const std::string type = value.type == "float" ? "double" : value.type;
    text += fmt::format("  {} given{}", type, i);
    text += value.isInput() ? fmt::format("({});\n", scalarsFrom(value, at)) : "{};\n";
    if (value.isInput()) at += value.size;
    arguments += fmt::format("{}given{}", i == 0 ? "" : ", ", i);
  }
  text += fmt::format("  {}shader::{}({});\n", function.result ? "const auto result = " : "",
                      function.name, arguments);
  int to = 0;
  if (function.result) text += toDoubles(*function.result, "result", to);
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const UserValue& value = function.parameters[i];
    if (value.direction != GlslDirection::in)
      text += toDoubles(value, fmt::format("given{}", i), to);
  }
  return text + "}\n";
}

constexpr std::string_view kHeaderHelpers = R"(
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
template <class T, std::size_t N> struct TwintraceVector {
  std::array<T, N> parts;
  template <class V> operator V() const {
    return [this]<std::size_t... I>(std::index_sequence<I...>) { return V{parts[I]...}; }
      (std::make_index_sequence<N>{});
  }
};
template <class V> double twintracePart(const V& v, int i) {
  if constexpr (requires { v.w; }) return static_cast<double>(i == 0 ? v.x : i == 1 ? v.y : i == 2 ? v.z : v.w);
  else if constexpr (requires { v.z; }) return static_cast<double>(i == 0 ? v.x : i == 1 ? v.y : v.z);
  else if constexpr (requires { v.y; }) return static_cast<double>(i == 0 ? v.x : v.y);
  else if constexpr (requires { v[0]; }) return static_cast<double>(v[i]);
  else return static_cast<double>(v);
}
)";

std::string headerText(const std::string& path, const UserFunction& function) {
  std::string text = fmt::format("#include \"{}\"\n{}", path, kHeaderHelpers);
  text +=
      "extern \"C\" void twintraceRun(const std::uint32_t* in, double* out) {\n"
      "  static_cast<void>(in);\n";
  std::string arguments;
  int at = 0;
  for (const UserValue& value : function.parameters) {
    static constexpr const char* kTypes[] = {"float", "int", "std::uint32_t", "bool"};
    const std::string scalars = scalarsFrom(value, at);
    const char* type = kTypes[static_cast<std::size_t>(value.kind)];
    arguments += arguments.empty() ? "" : ", ";
    arguments += value.size == 1
                     ? scalars
                     : fmt::format("TwintraceVector<{}, {}>{{{{{}}}}}", type, value.size, scalars);
    at += value.size;
  }
  text += fmt::format("#line 1 \"<call of {}>\"\n  const auto result = {}({});\n", function.name,
                      function.name, arguments);
  for (int i = 0; i < function.result->size; ++i) {
    text += fmt::format("  out[{}] = twintracePart(result, {});\n", i, i);
  }
  return text + "}\n";
}

UserReference load(const std::string& text, const std::string& path) {
  const SharedLibrary library = compileLibrary(text, path);
  return library.function<RunFunction>("twintraceRun");
}

std::vector<Kind> kindsOf(const std::vector<UserValue>& values) {
  std::vector<Kind> kinds;
  for (const UserValue& value : values) {
    kinds.insert(kinds.end(), static_cast<std::size_t>(value.size), value.kind);
  }
  return kinds;
}

std::vector<Kind> kindsOf(std::span<const Slot> slots) {
  std::vector<Kind> kinds;
  for (const Slot& slot : slots)
    kinds.insert(kinds.end(), static_cast<std::size_t>(slot.size), slot.kind);
  return kinds;
}

}  // namespace

std::string referenceText(const ShaderSource& source, const UserFunction& function) {
  return std::string(userPrelude()) + withPlaces(source, asCpp(source.text, function.place.path)) +
         textCaller(function);
}

UserReference textReference(const ShaderSource& source, const UserFunction& function) {
  return load(referenceText(source, function), function.place.path);
}

UserReference headerReference(const std::string& path, const UserFunction& function) {
  const bool plain = std::ranges::all_of(function.parameters, [](const UserValue& value) {
    return value.direction == GlslDirection::in;
  });
  if (!plain || !function.result) {
    throw FileError({{function.place, "found out parameters of " + function.signature +
                                          ", expected a result alone for a reference by header"}});
  }
  if (!std::ifstream(path)) throw IoError(path + ": cannot be read");
  return load(headerText(std::filesystem::absolute(path).string(), function), path);
}

UserReference namedReference(const std::string& name, const UserFunction& function) {
  for (const ShaderFunction* known : chooseFunctions({name})) {
    if (known->twin64 == nullptr) continue;
    if (kindsOf(known->inputs) != kindsOf(function.inputs())) continue;
    if (kindsOf(known->outputs) != kindsOf(function.outputs())) continue;
    const auto world = std::make_shared<World>(plainWorld());
    return [known, world](const std::uint32_t* in, double* out) {
      known->twin64(world->view, in, out);
    };
  }
  throw UsageError("found reference '" + name + "', expected a function with the parameters of " +
                   function.signature + " and its result");
}

}  // namespace twintrace::probe
