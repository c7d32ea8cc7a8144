#include "experiments/probe/user_shader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "common/base/error.h"
#include "common/base/wording.h"

namespace twintrace::probe {
namespace {

struct Shape {
  Kind kind;
  int size;
};

const std::map<std::string, Shape>& shapes() {
  static const std::map<std::string, Shape> known = {
      {"float", {Kind::real, 1}},    {"vec2", {Kind::real, 2}},     {"vec3", {Kind::real, 3}},
      {"vec4", {Kind::real, 4}},     {"int", {Kind::integer, 1}},   {"ivec2", {Kind::integer, 2}},
      {"ivec3", {Kind::integer, 3}}, {"ivec4", {Kind::integer, 4}}, {"uint", {Kind::natural, 1}},
      {"uvec2", {Kind::natural, 2}}, {"uvec3", {Kind::natural, 3}}, {"uvec4", {Kind::natural, 4}},
      {"bool", {Kind::truth, 1}}};
  return known;
}

std::string blankVersion(std::string text) {
  const std::size_t at = withoutGlslComments(text).find("#version");
  if (at != std::string::npos) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    text.replace(at, end - at, end - at, ' ');
  }
  return text;
}

class Reader {
 public:
  Reader(const std::string& text, const std::string& path) : parsed_(parseGlsl(text, path)) {
    comments_ = text;
    shader_.path = path;
    shader_.text = text;
  }

  UserShader read(const std::vector<std::string>& names) {
    checkNames(names);
    std::size_t begin = 0;
    for (const GlslFunction& function : parsed_.functions) {
      const bool asked = names.empty() || std::ranges::find(names, function.name) != names.end();
      if (asked) add(function, begin);
      begin = function.body.end;
    }
    if (!faults_.empty()) throw FileError(std::move(faults_));
    return std::move(shader_);
  }

 private:
  void checkNames(const std::vector<std::string>& names) const {
    std::vector<std::string> known;
    for (const GlslFunction& function : parsed_.functions) known.push_back(function.name);
    if (known.empty()) {
      const SourceLocation whole{parsed_.path, 0, 0};
      throw FileError({{whole, "found no function, expected one"}});
    }
    for (const std::string& name : names) {
      if (std::ranges::find(known, name) != known.end()) continue;
      throw UsageError("found function " + quote(name) + ", expected one of " + parsed_.path +
                       ": " + oneOf(known) + didYouMean(name, known));
    }
  }

  void complain(std::size_t place, const std::string& message) {
    faults_.push_back({parsed_.location(place), message});
  }

  std::optional<UserValue> value(const GlslVariable& variable) {
    const auto shape = shapes().find(variable.type);
    if (shape == shapes().end()) {
      complain(variable.place, "found type " + quote(variable.type) +
                                   ", expected float, int, uint, bool, vec2-4, ivec2-4 or uvec2-4");
      return std::nullopt;
    }
    return UserValue{variable.type,      variable.name,      shape->second.kind,
                     shape->second.size, variable.direction, std::nullopt};
  }

  void add(const GlslFunction& function, std::size_t begin) {
    UserFunction found;
    found.name = function.name;
    found.signature = function.signature();
    found.place = parsed_.location(function.place);
    if (function.name == "main") {
      complain(function.place, "found main, expected functions only: it is written here");
      return;
    }
    const std::size_t before = faults_.size();
    for (const GlslVariable& parameter : function.parameters) {
      if (const auto packed = value(parameter)) found.parameters.push_back(*packed);
    }
    if (function.result != "void") {
      found.result = value({function.result, "result", GlslDirection::in, function.whole.begin});
    }
    if (faults_.size() != before) return;
    if (found.outputs().empty()) {
      complain(function.place, "found a function without a result, expected a result or out");
    }
    readRanges(found, begin, function.body.end);
    shader_.functions.push_back(std::move(found));
  }

  void readRanges(UserFunction& function, std::size_t begin, std::size_t end) {
    static const std::regex comment(R"(//\s*twintrace:([^\n\r]*))");
    const std::string part = comments_.substr(begin, end - begin);
    for (std::sregex_iterator at(part.begin(), part.end(), comment), last; at != last; ++at) {
      readRange(function, (*at)[1].str(), begin + static_cast<std::size_t>(at->position()));
    }
  }

  void readRange(UserFunction& function, const std::string& text, std::size_t place) {
    static const std::regex item(
        R"(\s*(\w+)\s+(?:(unit)|in\s*\[\s*([-+.\w]+)\s*,\s*([-+.\w]+)\s*\])\s*(?:,|$))");
    std::size_t read = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), item), last; at != last; ++at) {
      if (static_cast<std::size_t>(at->position()) != read) break;
      read += static_cast<std::size_t>(at->length());
      setRange(function, *at, place);
    }
    if (text.find_first_not_of(" \t", read) != std::string::npos || read == 0) {
      complain(place, "found " + quote(text.substr(read)) +
                          ", expected 'x in [0, 1]' or 'n unit', separated by commas");
    }
  }

  void setRange(UserFunction& function, const std::smatch& match, std::size_t place) {
    const auto parameter = std::ranges::find(function.parameters, match[1].str(), &UserValue::name);
    if (parameter == function.parameters.end()) {
      complain(place, "found " + quote(match[1].str()) + ", expected a parameter of " +
                          function.signature);
      return;
    }
    UserRange range;
    range.unit = match[2].matched;
    if (!range.unit) {
      char* lowEnd = nullptr;
      char* highEnd = nullptr;
      const std::string low = match[3].str();
      const std::string high = match[4].str();
      range.low = std::strtod(low.c_str(), &lowEnd);
      range.high = std::strtod(high.c_str(), &highEnd);
      if (*lowEnd != 0 || *highEnd != 0 || !(range.low <= range.high)) {
        complain(place, "found [" + low + ", " + high + "], expected two ascending numbers");
        return;
      }
    } else if (parameter->kind != Kind::real || parameter->size == 1) {
      complain(place, "found unit for a " + parameter->type + ", expected vec2, vec3 or vec4");
      return;
    }
    parameter->range = range;
  }

  GlslText parsed_;
  std::string comments_;
  UserShader shader_;
  std::vector<Diagnostic> faults_;
};

constexpr std::string_view kComponents = "xyzw";

std::string component(const UserValue& value, int i) {
  return value.size == 1 ? "" : fmt::format(".{}", kComponents[static_cast<std::size_t>(i)]);
}

std::string fromWords(const UserValue& value, int at) {
  std::string parts;
  for (int i = 0; i < value.size; ++i) {
    const std::string word = fmt::format("probeInputs[at + {}]", at + i);
    parts += i == 0 ? "" : ", ";
    switch (value.kind) {
      case Kind::real:
        parts += "uintBitsToFloat(" + word + ")";
        break;
      case Kind::integer:
        parts += "int(" + word + ")";
        break;
      case Kind::natural:
        parts += word;
        break;
      case Kind::truth:
        parts += "(" + word + " & 1u) != 0u";
        break;
    }
  }
  return value.type + "(" + parts + ")";
}

std::string toWord(const UserValue& value, const std::string& text) {
  switch (value.kind) {
    case Kind::real:
      return "floatBitsToUint(" + text + ")";
    case Kind::truth:
      return text + " ? 1u : 0u";
    default:
      return "uint(" + text + ")";
  }
}

}  // namespace

std::vector<UserValue> UserFunction::inputs() const {
  std::vector<UserValue> found;
  std::ranges::copy_if(parameters, std::back_inserter(found), &UserValue::isInput);
  return found;
}

std::vector<UserValue> UserFunction::outputs() const {
  std::vector<UserValue> found;
  if (result) found.push_back(*result);
  for (const UserValue& parameter : parameters) {
    if (parameter.direction != GlslDirection::in) found.push_back(parameter);
  }
  return found;
}

int wordCount(const std::vector<UserValue>& values) {
  int words = 0;
  for (const UserValue& value : values) words += value.size;
  return std::max(words, 1);
}

UserShader parseUserShader(const std::string& text, const std::string& path,
                           const std::vector<std::string>& names) {
  return Reader(blankVersion(text), path).read(names);
}

UserShader readUserShader(const std::string& path, const std::vector<std::string>& names) {
  std::error_code unknown;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path, unknown)) {
    throw IoError(path + ": cannot be read");
  }
  return parseUserShader({std::istreambuf_iterator<char>(stream), {}}, path, names);
}

Probe userProbe(const UserFunction& function) {
  const int inputWords = wordCount(function.inputs());
  const int outputWords = wordCount(function.outputs());
  std::string text = fmt::format(
      "#include \"{}\"\n\nlayout(local_size_x = {}) in;\n"
      "layout(std430, binding = 0) readonly buffer ProbeInputs {{ uint probeInputs[]; }};\n"
      "layout(std430, binding = 1) writeonly buffer ProbeOutputs {{ uint probeOutputs[]; }};\n"
      "uniform int probeCount;\n\nvoid main() {{\n"
      "  int record = int(gl_GlobalInvocationID.x);\n  if (record >= probeCount) return;\n"
      "  int at = record * {};\n  int to = record * {};\n",
      kUserPath, kProbeGroupSize, inputWords, outputWords);
  std::string arguments;
  int at = 0;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const UserValue& value = function.parameters[i];
    text += fmt::format("  {} given{}", value.type, i);
    if (value.isInput()) {
      text += " = " + fromWords(value, at);
      at += value.size;
    }
    text += ";\n";
    arguments += fmt::format("{}given{}", i == 0 ? "" : ", ", i);
  }
  const std::string call = function.name + "(" + arguments + ");\n";
  text += function.result ? "  " + function.result->type + " result = " + call : "  " + call;
  int to = 0;
  const auto write = [&](const UserValue& value, const std::string& name) {
    for (int i = 0; i < value.size; ++i) {
      text += fmt::format("  probeOutputs[to + {}] = {};\n", to++,
                          toWord(value, name + component(value, i)));
    }
  };
  if (function.result) write(*function.result, "result");
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const UserValue& value = function.parameters[i];
    if (value.direction != GlslDirection::in) write(value, fmt::format("given{}", i));
  }
  return {text + "}\n", inputWords, outputWords};
}

}  // namespace twintrace::probe
