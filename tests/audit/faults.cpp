#include "tests/audit/faults.h"

#include <algorithm>
#include <map>

#include "gpu/glsl_text.h"

namespace twintrace::test {
namespace {

using Structs = std::map<std::string, GlslStruct>;

/// The floats of a value of that type, as in `.normal.x`.
std::vector<std::string> floatWords(const Structs& structs, const std::string& type,
                                    const std::string& path) {
  if (type == "float") return {path};
  if (type == "vec3") return {path + ".x", path + ".y", path + ".z"};
  std::vector<std::string> words;
  const auto found = structs.find(type);
  if (found == structs.end()) return words;
  for (const GlslVariable& field : found->second.fields) {
    for (const std::string& word : floatWords(structs, field.type, path + "." + field.name)) {
      words.push_back(word);
    }
  }
  return words;
}

/// `value` one ulp farther from zero.
std::string moved(const std::string& value) {
  return value + " = " + value + " != 0.0f && abs(" + value +
         ") < 3.0e38f ? intBitsToFloat(floatBitsToInt(" + value + ") + 1) : " + value + ";";
}

FunctionFaults faultsOf(const GlslText& parsed, const std::string& text, const GlslFunction& f,
                        const Structs& structs) {
  FunctionFaults faults;
  const std::size_t at = parsed.text.rfind("return ", f.body.end);
  if (at == std::string::npos || at < f.body.begin) return faults;
  const std::size_t end = parsed.text.find(';', at);
  const std::string value = text.substr(at + 7, end - at - 7);
  for (const std::string& word : floatWords(structs, f.result, "")) {
    const std::string file = "faulty/" + parsed.path;
    const std::string before =
        text.substr(0, at) + "precise " + f.result + " faulty = " + value + ";\n  ";
    const std::string changed =
        before + moved("faulty" + word) + "\n  return faulty;" + text.substr(end + 1);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    faults.push_back({f.name, parsed.path, word, {parsed.path, file, changed},
                      file + ":" + std::to_string(line)});
  }
  return faults;
}

}  // namespace

std::vector<FunctionFaults> possibleFaults(const std::set<std::string>& functions) {
  const ShaderLibrary library;
  std::map<std::string, std::string> texts;
  Structs structs;
  for (const std::string& path : library.paths()) {
    // Native maths has the names of math.glsl but is not in a strict program.
    if (path == "math_native.glsl" || path.find('/') != std::string::npos) continue;
    texts[path] = library.find(path).value().text;
    for (const GlslStruct& s : parseGlsl(texts[path], path).structs) structs[s.name] = s;
  }
  std::vector<FunctionFaults> all;
  for (const auto& [path, text] : texts) {
    const GlslText parsed = parseGlsl(text, path);
    for (const GlslFunction& f : parsed.functions) {
      if (!functions.contains(f.name)) continue;
      FunctionFaults faults = faultsOf(parsed, text, f, structs);
      if (!faults.empty()) all.push_back(std::move(faults));
    }
  }
  return all;
}

}  // namespace twintrace::test
