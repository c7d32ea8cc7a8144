#include "experiments/explain/explain_text.h"

#include <fmt/format.h>

#include "experiments/explain/statement_text.h"

namespace twintrace {
namespace {

const SideNames kSides = {"a", "b"};

std::string objectOf(const FlatScene& scene, int primitive) {
  const auto index = static_cast<std::size_t>(primitive);
  if (primitive < 0 || index >= scene.primitiveObject.size()) return "nothing";
  const auto object = static_cast<std::size_t>(scene.primitiveObject[index]);
  return fmt::format("{} (primitive {})", scene.objectNames[object], primitive);
}

std::string vectorText(const std::array<float, 3>& v) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", v[0], v[1], v[2]);
}

/// Name and value of what a vertex's record holds.
std::vector<std::pair<std::string, std::string>> lines(const FlatScene& scene,
                                                       const PathVertex& v) {
  std::string noise;
  for (const auto& [dimension, value] : v.noise) {
    noise += fmt::format("{}[{}] {:.9g}", noise.empty() ? "" : ", ", dimension, value);
  }
  std::string shadows;
  for (const bool blocked : v.blocked) shadows += blocked ? "blocked " : "free ";
  return {{"origin", vectorText(v.origin)},
          {"direction", vectorText(v.direction)},
          {"hit", objectOf(scene, v.primitive)},
          {"t", fmt::format("{:.9g}", v.t)},
          {"normal", vectorText(v.normal)},
          {"noise", noise},
          {"shadow rays", shadows},
          {"lobe", v.lobe},
          {"throughput", vectorText(v.throughput)},
          {"radiance", vectorText(v.radiance)}};
}

std::string vertexText(const FlatScene& scene, const PathVertex* a, const PathVertex* b) {
  std::string text;
  const auto ofA = a != nullptr ? lines(scene, *a) : lines(scene, *b);
  const auto ofB = b != nullptr ? lines(scene, *b) : lines(scene, *a);
  for (std::size_t i = 0; i < ofA.size(); ++i) {
    const auto& [name, valueA] = ofA[i];
    const std::string& valueB = ofB[i].second;
    if (valueA.empty() && valueB.empty()) continue;
    if (a != nullptr && b != nullptr && valueA == valueB) {
      text += fmt::format("    {:<12} {}\n", name, valueA);
    } else {
      if (a != nullptr) text += fmt::format("  * {:<12} a {}\n", name, valueA);
      if (b != nullptr) text += fmt::format("  * {:<12} b {}\n", name, valueB);
    }
  }
  return text;
}

std::string pathText(const FlatScene& scene, const SampleExplanation& e) {
  std::string text;
  const std::size_t count = std::max(e.verticesA.size(), e.verticesB.size());
  for (std::size_t i = 0; i < count; ++i) {
    const PathVertex* a = i < e.verticesA.size() ? &e.verticesA[i] : nullptr;
    const PathVertex* b = i < e.verticesB.size() ? &e.verticesB[i] : nullptr;
    text +=
        fmt::format("vertex {}{}{}\n", i, static_cast<int>(i) == e.parted ? ": here they part" : "",
                    a == nullptr   ? ": only b gets here"
                    : b == nullptr ? ": only a gets here"
                                   : "");
    text += vertexText(scene, a, b);
  }
  return text;
}

const TraceFunction& functionOf(const CallTree& tree, int call) {
  const auto function = tree.calls[static_cast<std::size_t>(call)].function;
  return tree.program->functions[static_cast<std::size_t>(function)];
}

std::string divergenceText(const ExplainedSample& about, const SampleExplanation& e) {
  if (!e.divergence) return "no call has equal inputs and another output: unexplained\n";
  const Divergence& d = *e.divergence;
  std::string text = fmt::format(
      "first differing operation: {}, called on {}\n  a {}\n  b {}\n", e.treeA.name(d.a),
      d.step < 0 ? "the camera ray" : fmt::format("the way to and at vertex {}", d.step),
      functionOf(e.treeA, d.a).place, functionOf(e.treeB, d.b).place);
  text += "  inputs, the same on both sides\n";
  const TracedValues& inputs = e.treeA.calls[static_cast<std::size_t>(d.a)].inputs;
  for (std::size_t i = 0; i < inputs.words.size(); ++i) {
    const TraceSlot& slot = inputs.site->slots[i];
    text += fmt::format("    {:<24} {}\n", slot.path, wordText(slot.kind, inputs.words[i]));
  }
  text += statementText(d.statement, kSides);
  if (!about.replay.empty()) text += "  to replay it alone\n    " + about.replay + "\n";
  return text;
}

Json divergenceJson(const ExplainedSample& about, const SampleExplanation& e) {
  if (!e.divergence) return nullptr;
  const Divergence& d = *e.divergence;
  Json inputs = Json::object();
  const TracedValues& given = e.treeA.calls[static_cast<std::size_t>(d.a)].inputs;
  for (std::size_t i = 0; i < given.words.size(); ++i) {
    inputs[given.site->slots[i].path] = wordJson(given.site->slots[i].kind, given.words[i]);
  }
  return {{"function", e.treeA.name(d.a)},
          {"vertex", d.step},
          {"place_a", functionOf(e.treeA, d.a).place},
          {"place_b", functionOf(e.treeB, d.b).place},
          {"statement", statementJson(d.statement, kSides)},
          {"inputs", inputs},
          {"differing", differingJson(d.statement, kSides)},
          {"replay", about.replay}};
}

Json verticesJson(const FlatScene& scene, const std::vector<PathVertex>& vertices) {
  Json list = Json::array();
  for (const PathVertex& v : vertices) {
    Json noise = Json::object();
    for (const auto& [dimension, value] : v.noise) noise[std::to_string(dimension)] = value;
    list.push_back({{"origin", v.origin},
                    {"direction", v.direction},
                    {"primitive", v.primitive},
                    {"object", objectOf(scene, v.primitive)},
                    {"t", v.t},
                    {"normal", v.normal},
                    {"noise", noise},
                    {"blocked", v.blocked},
                    {"lobe", v.lobe},
                    {"throughput", v.throughput},
                    {"radiance", v.radiance},
                    {"alive", v.alive}});
  }
  return list;
}

}  // namespace

std::string explanationText(const FlatScene& scene, const ExplainedSample& about,
                            const SampleExplanation& e) {
  std::string text =
      fmt::format("pixel {},{}, sample {}\n", about.pixel.x, about.pixel.y, about.sample);
  for (const std::string& note : about.notes) text += "note: " + note + "\n";
  text += pathText(scene, e);
  text += fmt::format("radiance a {}\nradiance b {}\n", vectorText(e.traceA.radiance),
                      vectorText(e.traceB.radiance));
  if (!e.sameRadiance) {
    text += divergenceText(about, e) + fmt::format("class: {}\n", className(e.kind));
    for (const std::string& event : consequences(e)) text += "then " + event + "\n";
    return text;
  }
  text += about.renderedAlike
              ? "identical: the sample is the same on both arms\n"
              : "different: the sample is the same only on the traced programs\n";
  if (e.divergence) {
    text += "calls differ, but left no trace in the radiance\n" + divergenceText(about, e);
  }
  return text;
}

Json explanationJson(const FlatScene& scene, const ExplainedSample& about,
                     const SampleExplanation& e) {
  return {{"x", about.pixel.x},
          {"y", about.pixel.y},
          {"sample", about.sample},
          {"identical", e.sameRadiance && about.renderedAlike},
          {"radiance_a", e.traceA.radiance},
          {"radiance_b", e.traceB.radiance},
          {"class", e.sameRadiance ? Json(nullptr) : Json(className(e.kind))},
          {"first", divergenceJson(about, e)},
          {"parted_at_vertex", e.parted},
          {"consequences", consequences(e)},
          {"vertices_a", verticesJson(scene, e.verticesA)},
          {"vertices_b", verticesJson(scene, e.verticesB)},
          {"notes", about.notes}};
}

}  // namespace twintrace
