#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/trace/options.h"
#include "gpu/shader_source.h"

namespace twintrace {

class Context;

/// A linked program as the driver stores it.
struct ProgramBinary {
  std::uint32_t format = 0;
  std::vector<char> bytes;
};

/// A linked program: a fragment shader under a triangle that covers the target, or a compute
/// shader.
class Program {
 public:
  /// Compiles and links.
  /// @throws DeviceError with the driver's log, its places mapped to the shader files.
  Program(Context& context, Stage stage, const ShaderSource& source);

  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Sets a uniform; one that the shader doesn't have, or that specialisation has removed, is
  /// silently left. A value of another type than the uniform's is found by the next draw.
  void set(std::string_view name, std::int32_t value);
  void set(std::string_view name, std::uint32_t value);
  void set(std::string_view name, float value);
  void set(std::string_view name, glm::vec3 value);

  /// Runs a compute program and makes its writes visible to whatever reads them later.
  /// @param groups number of work groups along each axis.
  /// @throws DeviceError if the device fails.
  void dispatch(glm::uvec3 groups);

  /// The driver's remarks on compiling and linking, mapped to files; empty when loaded from a
  /// cache.
  const std::string& log() const { return log_; }

  /// The linked program for a later load, or nothing where the driver can't give it.
  std::optional<ProgramBinary> binary() const;

  /// A program from a binary that this driver made before, or nullptr if it rejects it.
  static std::unique_ptr<Program> fromBinary(Context& context, const ProgramBinary& binary);

  std::uint32_t name() const { return name_; }  ///< the GL program object

 private:
  explicit Program(Context& context);
  std::int32_t location(std::string_view name);
  bool isLinked() const;

  Context& context_;
  std::uint32_t name_ = 0;
  std::string log_;
  std::map<std::string, std::int32_t, std::less<>> locations_;
};

}  // namespace twintrace
