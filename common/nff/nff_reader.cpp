#include "common/nff/nff_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <type_traits>

#include "common/base/wording.h"
#include "common/generate/generators.h"

namespace twintrace {
namespace {

constexpr std::array<std::string_view, 8> kEntities = {"v", "b", "l", "f", "s", "c", "p", "pp"};
constexpr std::string_view kExpectedEntity = "v, b, l, f, s, c, p, pp or a comment (#)";
constexpr int kMaxSide = 1 << 28;  // of a film
/// As in scenes: squares of lengths stay within floats.
constexpr double kMaxMagnitude = 1e18;
/// Of the angle between `up` and the view: 16 times the rounding unit of a float, as in scenes.
constexpr double kParallelSine = 16.0 / (1 << 24);
/// A file of another format may have one in each line.
constexpr std::size_t kMaxFaults = 100;

bool isEntity(const NffToken& token) {
  return std::ranges::find(kEntities, token.text) != kEntities.end();
}

std::string describe(const NffToken& token) {
  return token.isEnd() ? "the end of the file" : quote(token.text);
}

/// The float that the tracers see: they flush denormals to zero.
float toFloat(double value) {
  const auto rounded = static_cast<float>(value);
  return std::abs(rounded) < std::numeric_limits<float>::min() ? 0.0f : rounded;
}

glm::vec3 toVec3(const double* values) {
  return {toFloat(values[0]), toFloat(values[1]), toFloat(values[2])};
}

glm::dvec3 toDvec3(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

template <std::size_t kCount, class Expected>
std::optional<std::array<double, kCount>> NffReader::numbers(const Expected& expected) {
  std::array<double, kCount> values;
  for (double& value : values) {
    const std::optional<double> next = number(expected);
    if (!next) return std::nullopt;
    value = *next;
  }
  return values;
}

template <class Expected>
std::optional<double> NffReader::number(const Expected& expected) {
  const std::optional<double> value = parseNffNumber(tokens_.current().text);
  if (!value) {
    if constexpr (std::is_invocable_v<Expected>)
      faultHere(expected());
    else
      faultHere(expected);
    return std::nullopt;
  }
  if (!(std::abs(*value) <= kMaxMagnitude)) {
    faultHere("a number of at most 1e18 in size, whose square fits in a float");
    return std::nullopt;
  }
  tokens_.advance();
  return value;
}

NffFile NffReader::read() {
  while (!tokens_.current().isEnd()) {
    readEntity();
    if (broken_) recover();
    if (surfaces_.primitiveCount() > kMaxGenerated) {
      fault(tokens_.current(), "more than 1e7 spheres and triangles", "fewer");
      break;
    }
  }
  throwFaults();
  surfaces_.moveInto(file_);
  return std::move(file_);
}

void NffReader::readEntity() {
  const NffToken token = tokens_.current();
  if (!isEntity(token)) return faultHere(kExpectedEntity);
  tokens_.advance();
  if (token.text == "v") return readView(token);
  if (token.text == "b") return readBackground();
  if (token.text == "l") return readLight();
  if (token.text == "f") return readFill();
  checkFill(token);
  if (token.text == "s") return readSphere();
  if (token.text == "c") return readCone();
  readPolygon(token.text == "pp");
}

/// What comes before the next entity can't be understood any more.
void NffReader::recover() {
  while (!tokens_.current().isEnd() &&
         !(tokens_.current().beginsLine && isEntity(tokens_.current()))) {
    tokens_.advance();
  }
  broken_ = false;
}

void NffReader::readView(const NffToken& at) {
  if (file_.view) {
    broken_ = true;
    return fault(at, "a second view", "only one");
  }
  NffView view;
  std::vector<std::string> missing = {"from", "at", "up", "angle"};
  while (readViewLine(tokens_.current(), view, missing)) {
  }
  if (broken_) return;
  if (!missing.empty()) {
    return fault(at, "a view without " + oneOf(missing), "all of from, at, up and angle");
  }
  file_.view = view;
  checkView(at, view);
}

/// False where no line of a view is next, or a faulty one.
bool NffReader::readViewLine(const NffToken& word, NffView& view,
                             std::vector<std::string>& missing) {
  const std::string key(word.text);
  const auto vector = [&](glm::dvec3& into) {
    const auto values = numbers<3>("the 3 numbers of " + quote(key));
    if (values) into = toDvec3(*values);
  };
  constexpr std::array<std::string_view, 6> kKeys = {"from",  "at",     "up",
                                                     "angle", "hither", "resolution"};
  if (std::ranges::find(kKeys, key) == kKeys.end()) return false;
  tokens_.advance();
  if (key == "from") vector(view.from);
  if (key == "at") vector(view.at);
  if (key == "up") vector(view.up);
  if (key == "angle") view.angle = number("an angle in degrees").value_or(0.0);
  // Nothing is clipped.
  if (key == "hither") number("a distance");
  if (key == "resolution") {
    constexpr std::string_view kExpected = "2 whole numbers from 2 to 2^28";
    view.width = integer(2, kMaxSide, kExpected).value_or(2);
    if (!broken_) view.height = integer(2, kMaxSide, kExpected).value_or(2);
  }
  std::erase(missing, key);
  return !broken_;
}

void NffReader::checkView(const NffToken& at, const NffView& view) {
  const glm::dvec3 direction = view.at - view.from;
  const double distance = glm::length(direction);
  const double length = glm::length(view.up);
  if (!(view.angle > 0.0 && view.angle < 180.0)) {
    fault(at, fmt::format("angle {}", view.angle), "an angle above 0 and below 180 degrees");
  }
  if (double(view.width) * view.height > kMaxSide) {
    fault(at, fmt::format("resolution {} {}", view.width, view.height), "at most 2^28 pixels");
  }
  if (distance < 1.0 / kMaxMagnitude) {
    fault(at, "'from' and 'at' in the same place", "two places (at least 1e-18 apart)");
  } else if (length < 1.0 / kMaxMagnitude ||
             glm::length(glm::cross(direction / distance, view.up / length)) < kParallelSine) {
    fault(at, "an 'up' that is zero or along the view", "one that is not");
  }
}

void NffReader::readBackground() {
  if (const auto value = color("a background's 3 numbers >= 0 (r g b)")) file_.background = *value;
}

void NffReader::readLight() {
  const auto position = numbers<3>("a light's 3 numbers (x y z) or 6 (x y z r g b)");
  if (!position) return;
  NffLight light{toVec3(position->data()), std::nullopt};
  const NffToken& next = tokens_.current();
  if (!next.isEnd() && !next.beginsLine) {
    light.color = color("a light's colour (3 numbers >= 0) or the end of the line");
    if (!light.color) return;
  }
  file_.lights.push_back(light);
}

void NffReader::readFill() {
  const NffToken at = tokens_.current();
  const auto values = numbers<8>("a fill's 8 numbers (r g b Kd Ks Shine T ior)");
  // One fault is enough for all surfaces that follow.
  if (!values) return surfaces_.setFill({});
  if (*std::ranges::min_element(*values) < 0.0) {
    fault(at, fmt::format("{:g} in a fill", *std::ranges::min_element(*values)),
          "8 numbers >= 0 (r g b Kd Ks Shine T ior)");
  }
  const auto& v = *values;
  surfaces_.setFill({toVec3(v.data()), toFloat(v[3]), toFloat(v[4]), toFloat(v[5]), toFloat(v[6]),
                     toFloat(v[7])});
}

void NffReader::readSphere() {
  const auto values = numbers<4>("a sphere's 4 numbers (x y z radius)");
  if (values) surfaces_.addSphere(toVec3(values->data()), toFloat((*values)[3]));
}

void NffReader::readCone() {
  const auto values = numbers<8>("a cone's 8 numbers (base, its radius, apex, its radius)");
  if (!values) return;
  const auto& v = *values;
  surfaces_.addCone(toVec3(v.data()), toFloat(v[3]), toVec3(v.data() + 4), toFloat(v[7]));
}

void NffReader::readPolygon(bool hasNormals) {
  const std::optional<int> count =
      integer(3, kMaxCorners, fmt::format("a number of vertices from 3 to {}", kMaxCorners));
  if (!count) return;
  corners_.clear();
  normals_.clear();
  const auto part = [&](const char* what, int i) {
    return numbers<3>(
        [&] { return fmt::format("the {} of vertex {} of {} (x y z)", what, i + 1, *count); });
  };
  for (int i = 0; i < *count; ++i) {
    const auto place = part("place", i);
    if (!place) return;
    corners_.push_back(toVec3(place->data()));
    if (!hasNormals) continue;
    const auto normal = part("normal", i);
    if (!normal) return;
    normals_.push_back(toVec3(normal->data()));
  }
  surfaces_.addPolygon(corners_, normals_);
}

std::optional<int> NffReader::integer(int least, int most, std::string_view expected) {
  const std::optional<double> value = parseNffNumber(tokens_.current().text);
  if (!value || *value != std::floor(*value) || *value < least || *value > most) {
    faultHere(expected);
    return std::nullopt;
  }
  tokens_.advance();
  return static_cast<int>(*value);
}

std::optional<glm::vec3> NffReader::color(std::string_view expected) {
  const NffToken at = tokens_.current();
  const auto values = numbers<3>(expected);
  if (!values) return std::nullopt;
  if (*std::ranges::min_element(*values) >= 0.0) return toVec3(values->data());
  fault(at, fmt::format("{:g}", *std::ranges::min_element(*values)), expected);
  return std::nullopt;
}

void NffReader::checkFill(const NffToken& at) {
  if (surfaces_.hasFill()) return;
  fault(at, quote(at.text) + " before the first fill", "a fill (f) before all surfaces");
  surfaces_.setFill({});
}

void NffReader::fault(const NffToken& at, std::string_view found, std::string_view expected) {
  if (++faultCount_ > kMaxFaults) return;
  faults_.push_back(
      {{path_, at.line, at.column}, fmt::format("found {}, expected {}", found, expected)});
}

void NffReader::faultHere(std::string_view expected) {
  fault(tokens_.current(), describe(tokens_.current()), expected);
  broken_ = true;
}

void NffReader::throwFaults() {
  if (faults_.empty()) return;
  if (faultCount_ > kMaxFaults) {
    const auto more = static_cast<std::int64_t>(faultCount_ - kMaxFaults);
    std::string message = counted(more, "further fault", "further faults");
    const SourceLocation location{path_, 0, 0};
    faults_.push_back({location, std::move(message)});
  }
  throw FileError(std::move(faults_));
}

}  // namespace twintrace
