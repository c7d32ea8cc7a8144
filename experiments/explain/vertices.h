#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "experiments/explain/call_tree.h"

namespace twintrace {

/// What a path did at one of its vertices.
struct PathVertex {
  std::array<float, 3> origin{};  ///< of the ray that arrived
  std::array<float, 3> direction{};
  int primitive = -1;  ///< -1 = the ray left the scene
  float t = 0;
  std::array<float, 3> normal{};                ///< facing the ray; zero without a surface
  std::vector<std::pair<int, float>> noise;     ///< dimension and random number
  std::vector<bool> blocked;                    ///< answers of the shadow rays
  std::string lobe;                             ///< empty if none was sampled
  std::array<float, 3> throughput{};            ///< after the vertex
  std::array<float, 3> radiance{};              ///< so far
  bool alive = false;                           ///< whether the path goes on
};

/// The vertices of a traced sample, in order.
std::vector<PathVertex> pathVertices(const CallTree& tree);

/// Random numbers that the camera ray took.
std::vector<std::pair<int, float>> cameraNoise(const CallTree& tree);

}  // namespace twintrace
