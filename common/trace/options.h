#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace twintrace {

enum class BackEnd { cpu, gpu };
enum class Stage { fragment, compute };
enum class Maths { strict, native };
enum class Precision { float32, float64 };
enum class Lanes { scalar, wide };
enum class Integrator { local, whitted, report, path };
enum class Noise { sine, pcg };
enum class Intersector { report, robust };
enum class Geometry { automatic, literal, buffer };
enum class Provider { osmesa, egl };

/// A user's file in the place of one of the shader library.
struct ShaderReplacement {
  std::string shader;  ///< path below shaders/, as in "math.glsl"
  std::string file;    ///< where the text was read; its name in messages
  std::string text;
};

/// Everything that decides how a scene is rendered, with the defaults of the command line. Scene
/// files set them in [render], arms of `compare` and options of every command override them.
struct RenderOptions {
  BackEnd backend = BackEnd::cpu;
  Integrator integrator = Integrator::path;
  Noise noise = Noise::pcg;
  Maths maths = Maths::strict;
  Precision precision = Precision::float32;
  Lanes lanes = Lanes::wide;
  /// True when the user asked for these lanes, so that a mode without wide lanes is an error
  /// instead of a silent fall back to scalar.
  bool lanesGiven = false;
  Intersector intersector = Intersector::robust;
  /// True when the user asked for this intersector; else it follows the integrator, since `report`
  /// implies the report's intersector.
  bool intersectorGiven = false;
  std::string hull = "auto";     ///< "auto", "embree" or a strategy of common/hulls
  Geometry geometry = Geometry::automatic;
  Provider provider = Provider::osmesa;
  Stage stage = Stage::fragment;
  std::string effects = "auto";  ///< "auto", "all" or a comma-separated list of effect names

  int width = 512;               ///< pixels
  int height = 512;              ///< pixels
  int spp = 64;                  ///< samples per pixel in all
  int passes = 1;                ///< samples per pixel and frame, 1..4096
  int bounces = 6;               ///< scattering events, 0..1024
  std::uint32_t seed = 1;
  int firstSample = 0;           ///< index of the first sample, a multiple of passes
  double timeLimit = 0;          ///< seconds; 0 = no limit
  double targetError = 0;        ///< relative standard error of the image mean; 0 = none
  int threads = 0;               ///< 0 = all
  std::string shaderDirectory;   ///< empty = the shaders embedded in the binary
  std::vector<ShaderReplacement> shaderOverrides;  ///< of later ones of a shader the last counts

  /// Frames needed for spp samples: ceil(spp / passes).
  int frameCount() const { return (spp + passes - 1) / passes; }
};

/// Limits of design section 6: no value makes the program hang or exhaust memory.
inline constexpr int kMaxBounces = 1024;
inline constexpr int kMaxPasses = 4096;
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

}  // namespace twintrace
