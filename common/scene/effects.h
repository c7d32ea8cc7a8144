#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace twintrace {

/// Parts of light transport that can be compiled in or left out.
enum class Effect : std::uint32_t {
  sphere,
  box,
  orientedBox,
  triangle,
  smooth,
  plane,
  emission,
  diffuse,
  mirror,
  ggx,
  phong,
  environmentImage,
  pointLight,
  sphereLight,
  sunLight,
  lens,
  indirect,
};
inline constexpr int kEffectCount = 17;

/// Names as written in [effects], in --effects and, with a leading kEffect, in the shaders.
inline constexpr std::array<std::string_view, kEffectCount> kEffectNames = {
    "sphere", "box",    "orientedBox", "triangle", "smooth",           "plane",
    "emission", "diffuse", "mirror",  "ggx",      "phong",            "environmentImage",
    "pointLight", "sphereLight", "sunLight", "lens", "indirect"};

/// The effect of that name, or nothing.
std::optional<Effect> effectFromName(std::string_view name);

/// A set of effects.
class EffectSet {
 public:
  static EffectSet all() { return EffectSet((1u << kEffectCount) - 1u); }
  EffectSet() = default;

  bool has(Effect effect) const { return (bits_ & bit(effect)) != 0; }
  void set(Effect effect, bool on) { bits_ = on ? bits_ | bit(effect) : bits_ & ~bit(effect); }
  void add(const EffectSet& others) { bits_ |= others.bits_; }
  std::uint32_t bits() const { return bits_; }
  bool operator==(const EffectSet&) const = default;

 private:
  explicit EffectSet(std::uint32_t bits) : bits_(bits) {}
  static std::uint32_t bit(Effect effect) { return 1u << static_cast<std::uint32_t>(effect); }

  std::uint32_t bits_ = 0;
};

/// The effects of a comma-separated list of names, without blanks.
/// @throws UsageError for a name that is no effect, an empty list included.
EffectSet effectsFromList(std::string_view list);

struct Scene;
struct RenderOptions;

/// The scene without what these effects leave out: colours become black, lights and objects go, the
/// lens shrinks to a pinhole. So an effect that is off is off in every integrator.
Scene withoutEffects(Scene scene, const EffectSet& effects);

/// The effects that this scene's content can show under these options, with [effects] applied.
EffectSet neededEffects(const Scene& scene, const RenderOptions& options);

/// The effects to compile in: `options.effects` (auto, all or a list) applied to the scene.
/// @throws UsageError for a name that is no effect.
EffectSet chosenEffects(const Scene& scene, const RenderOptions& options);

}  // namespace twintrace
