#include "tests/audit/damage.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <regex>

#include "common/base/error.h"
#include "common/base/wording.h"
#include "common/base/word_char.h"
#include "gpu/glsl_text.h"
#include "gpu/shader_source.h"

namespace twintrace::test {
namespace {

std::set<std::string> namesIn(const std::string& text) {
  std::set<std::string> names;
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = std::find_if(at, text.end(), isWordChar);
    at = std::find_if_not(begin, text.end(), isWordChar);
    if (begin != at) names.emplace(begin, at);
  }
  return names;
}

std::vector<FunctionText> functionsIn(const std::string& text, const std::string& file) {
  const GlslText parsed = parseGlsl(text, file);
  std::vector<FunctionText> functions;
  for (const GlslFunction& f : parsed.functions) {
    const std::string whole = parsed.text.substr(f.whole.begin, f.whole.end - f.whole.begin);
    const std::string body = parsed.text.substr(f.body.begin, f.body.end - f.body.begin);
    functions.push_back(
        {f.name == "main" ? "main of " + file : f.name, f.signature(), file, whole, namesIn(body)});
  }
  return functions;
}

/// The constants of a shader with their values as text.
std::map<std::string, std::string> constantsIn(const std::string& text) {
  static const std::regex kConstant(R"(const\s+\w+\s+(\w+)\s*=([^;]*);)");
  const std::string bare = withoutGlslComments(text);
  std::map<std::string, std::string> constants;
  for (std::sregex_iterator at(bare.begin(), bare.end(), kConstant), end; at != end; ++at) {
    constants[(*at)[1]] = (*at)[2];
  }
  return constants;
}

std::string replacedOnce(const LogicFault& fault, const std::string& text) {
  const std::size_t at = text.find(fault.from);
  const bool once = !fault.from.empty() && at != std::string::npos &&
                    text.find(fault.from, at + 1) == std::string::npos;
  if (!once) {
    throw UsageError("fault " + quote(fault.name) + ": found " +
                     (at == std::string::npos ? "no " : "more than one ") + quote(fault.from) +
                     " in shaders/" + fault.shader + ", expected exactly one");
  }
  return std::string(text).replace(at, fault.from.size(), fault.to);
}

/// What a change of one file's text changes.
std::vector<FunctionText> changedFunctions(const LogicFault& fault, const std::string& before,
                                           const std::string& after, const ShaderTexts& texts) {
  const std::vector<FunctionText> sound = functionsIn(before, fault.shader);
  const std::vector<FunctionText> faulty = functionsIn(after, fault.shader);
  std::vector<FunctionText> changed;
  for (std::size_t i = 0; i < std::min(sound.size(), faulty.size()); ++i) {
    if (sound[i].text != faulty[i].text) changed.push_back(sound[i]);
  }
  const auto constants = constantsIn(after);
  for (const auto& [name, value] : constantsIn(before)) {
    const auto now = constants.find(name);
    if (now != constants.end() && now->second == value) continue;
    for (const FunctionText& function : texts.functions()) {
      if (function.mentions.contains(name)) changed.push_back(function);
    }
  }
  if (changed.empty() || sound.size() != faulty.size()) {
    throw UsageError("fault " + quote(fault.name) +
                     ": found no change of a function or of a constant that functions use");
  }
  return changed;
}

std::vector<FunctionText> callersOf(const std::vector<FunctionText>& changed,
                                    const std::string& file, const ShaderTexts& texts) {
  std::vector<FunctionText> callers;
  for (const FunctionText& function : texts.functions()) {
    if (function.file != file) continue;
    const std::set<std::string> reached = texts.reachableFrom(function.name);
    const auto concerns = [&](const FunctionText& f) { return reached.contains(f.name); };
    const auto isSame = [&](const FunctionText& f) { return f.signature == function.signature; };
    if (std::ranges::any_of(changed, concerns) && std::ranges::none_of(changed, isSame)) {
      callers.push_back(function);
    }
  }
  return callers;
}

Damage plant(const LogicFault& fault, const ShaderTexts& texts) {
  const auto file = ShaderLibrary().find(fault.shader);
  if (!file) {
    throw UsageError("fault " + quote(fault.name) + ": found shader " + quote(fault.shader) +
                     ", expected a file of the shader library");
  }
  const std::string text = replacedOnce(fault, file->text);
  Damage damage;
  damage.shader = {fault.shader, "faulty/" + fault.shader, text};
  damage.functions = changedFunctions(fault, file->text, text, texts);
  damage.callers = callersOf(damage.functions, fault.shader, texts);
  return damage;
}

}  // namespace

ShaderTexts::ShaderTexts() {
  const ShaderLibrary library;
  for (const std::string& path : library.paths()) {
    if (path == "math_native.glsl") continue;
    for (FunctionText& function : functionsIn(library.find(path).value().text, path)) {
      functions_.push_back(std::move(function));
    }
  }
  std::set<std::string> known;
  for (const FunctionText& function : functions_) known.insert(function.name);
  for (const FunctionText& function : functions_) {
    std::ranges::set_intersection(
        function.mentions, known,
        std::inserter(calls_[function.name], calls_[function.name].end()));
  }
}

std::set<std::string> ShaderTexts::reachableFrom(const std::string& name) const {
  std::set<std::string> reached = {name};
  std::deque<std::string> waiting = {name};
  while (!waiting.empty()) {
    const auto calls = calls_.find(waiting.front());
    waiting.pop_front();
    if (calls == calls_.end()) continue;
    for (const std::string& callee : calls->second) {
      if (reached.insert(callee).second) waiting.push_back(callee);
    }
  }
  return reached;
}

bool Damage::damages(const std::string& function) const {
  return std::ranges::any_of(functions, [&](const FunctionText& f) { return f.name == function; });
}

std::string Damage::where() const {
  std::set<std::string> names;
  for (const FunctionText& f : functions) names.insert(f.name);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<Damage> plantAll(const std::vector<LogicFault>& faults, const ShaderTexts& texts) {
  std::vector<Damage> damages;
  std::string wrong;
  for (const LogicFault& fault : faults) {
    try {
      damages.push_back(plant(fault, texts));
    } catch (const UsageError& error) {
      wrong += std::string(wrong.empty() ? "" : "\n") + error.what();
    }
  }
  if (!wrong.empty()) throw UsageError(wrong);
  return damages;
}

}  // namespace twintrace::test
