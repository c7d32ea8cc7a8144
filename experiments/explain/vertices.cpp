#include "experiments/explain/vertices.h"

#include <algorithm>
#include <limits>

#include "common/scene/layout.h"

namespace twintrace {
namespace {

const Call& callAt(const CallTree& tree, int call) {
  return tree.calls[static_cast<std::size_t>(call)];
}

std::vector<std::pair<int, float>> noiseBelow(const CallTree& tree, int from) {
  std::vector<std::pair<int, float>> drawn;
  for (const int call : tree.find(from, "noise")) {
    const auto dimension = wordOf(callAt(tree, call).inputs, "dimension");
    if (dimension) {
      drawn.emplace_back(static_cast<int>(*dimension), realOf(callAt(tree, call).output, "result"));
    }
  }
  std::sort(drawn.begin(), drawn.end());
  return drawn;
}

bool truthOf(const TracedValues& values, std::string_view path) {
  return wordOf(values, path).value_or(0) != 0;
}

/// The lobe is told by the sampler that was called.
std::string lobeBelow(const CallTree& tree, int step) {
  const auto scattering = tree.find(step, "sampleScattering");
  if (scattering.empty()) return "";
  for (const auto& [sampler, lobe] :
       {std::pair{"sampleCosineHemisphere", "diffuse"}, std::pair{"sampleGgx", "ggx"},
        std::pair{"samplePhong", "phong"}, std::pair{"reflect3", "mirror"}}) {
    if (!tree.find(scattering.front(), sampler).empty()) return lobe;
  }
  return "none";
}

PathVertex vertexOf(const CallTree& tree, int step) {
  PathVertex vertex;
  const Call& call = callAt(tree, step);
  vertex.origin = vectorOf(call.inputs, "state.ray.origin");
  vertex.direction = vectorOf(call.inputs, "state.ray.direction");
  if (const auto arrivals = tree.find(step, "arrive"); !arrivals.empty()) {
    if (const auto hits = tree.find(arrivals.front(), "closestHit"); !hits.empty()) {
      const TracedValues& hit = callAt(tree, hits.front()).output;
      const auto primitive = static_cast<int>(wordOf(hit, "result.primitive").value_or(0));
      vertex.primitive = primitive == layout::kNoPrimitive ? -1 : primitive;
      vertex.t = realOf(hit, "result.t");
    }
    vertex.normal = vectorOf(callAt(tree, arrivals.front()).output, "result.normal");
  }
  vertex.noise = noiseBelow(tree, step);
  for (const int shadow : tree.find(step, "occluded")) {
    vertex.blocked.push_back(truthOf(callAt(tree, shadow).output, "result"));
  }
  vertex.lobe = lobeBelow(tree, step);
  vertex.throughput = vectorOf(call.output, "result.throughput");
  vertex.radiance = vectorOf(call.output, "result.radiance");
  vertex.alive = truthOf(call.output, "result.alive");
  return vertex;
}

}  // namespace

std::vector<PathVertex> pathVertices(const CallTree& tree) {
  std::vector<PathVertex> vertices;
  for (const int step : tree.find(0, "stepSample")) vertices.push_back(vertexOf(tree, step));
  return vertices;
}

std::vector<std::pair<int, float>> cameraNoise(const CallTree& tree) {
  const auto begin = tree.find(0, "beginSample");
  return begin.empty() ? std::vector<std::pair<int, float>>() : noiseBelow(tree, begin.front());
}

}  // namespace twintrace
