#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "common/scene/scene.h"
#include "experiments/compare_arms.h"
#include "experiments/explain/path_tracer.h"
#include "tests/audit/damage.h"
#include "tests/audit/finding.h"

namespace twintrace::test {

/// What explain makes of a picture that a fault has changed.
struct Explained {
  std::set<std::string> functions;  ///< the culprits that it names; `no sample` if none differs
  std::string kind;                 ///< class of the first difference
  int pixels = 0;                   ///< that were explained
};

/// A small picture as `compare` renders it, and `explain` on what differs in it.
class Picture {
 public:
  /// @param root folder that the scenes' paths begin at.
  /// @throws FileError and UsageError for an invalid scene or invalid options.
  Picture(const PictureChoice& choice, const std::string& root);

  const std::string& name() const { return name_; }

  /// Whether rendering this picture calls a damaged function.
  bool calls(const Damage& damage) const;

  /// Compares the CPU with the damaged GPU.
  /// @throws std::logic_error if the arms differ without the fault too.
  ArmsComparison compare(const Damage& damage);

  /// Explains some of the pixels that differ.
  Explained explain(const Damage& damage, const ArmsComparison& comparison) const;

 private:
  Arm openGpu(const std::vector<ShaderReplacement>& shaders) const;
  void requireSound();
  std::string culprit(PathTracer& gpu, const PixelPosition& pixel, std::uint32_t frame,
                      std::string& kind) const;

  std::string name_;
  Scene scene_;
  RenderOptions options_;
  std::shared_ptr<const FlatScene> flat_;
  Arm cpu_;
  std::unique_ptr<PathTracer> traced_;
  std::set<std::string> called_;
  bool sound_ = false;
};

struct PictureFinding {
  Finding compare;
  Explained explained;  ///< of the picture that differs
};

/// `compare` and `explain` against damaged shaders.
class PictureCheck {
 public:
  /// @param choices pictures, tried in this order; opened when they are first needed.
  /// @param root folder that the scenes' paths begin at.
  PictureCheck(std::vector<PictureChoice> choices, std::string root);

  /// Tries the pictures that call a damaged function, until one differs.
  /// @throws FileError and UsageError for an invalid scene or invalid options; as Picture::compare.
  PictureFinding find(const Damage& damage);

 private:
  Picture& picture(std::size_t index);

  std::vector<PictureChoice> choices_;
  std::string root_;
  std::vector<std::unique_ptr<Picture>> pictures_;
};

}  // namespace twintrace::test
