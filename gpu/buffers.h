#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

namespace twintrace {

class Context;
class Program;

/// Read-only 128-bit texels for `usamplerBuffer` and texelFetch: the fastest general storage that
/// was measured on llvmpipe, and one that keeps every bit pattern.
class BufferTexture {
 public:
  /// Copies the texels; none at all become one zero texel, since GL has no empty buffers.
  /// @throws DeviceError with the figures if there are more than GL_MAX_TEXTURE_BUFFER_SIZE.
  BufferTexture(Context& context, std::span<const glm::uvec4> texels);
  ~BufferTexture();
  BufferTexture(const BufferTexture&) = delete;
  BufferTexture& operator=(const BufferTexture&) = delete;

  /// Makes it what a sampler uniform of that value reads.
  void bind(std::uint32_t unit) const;

 private:
  Context& context_;
  std::uint32_t buffer_ = 0;
  std::uint32_t texture_ = 0;
};

/// A float RGBA picture that fragment programs render to.
class FloatTarget {
 public:
  /// @param width, height in pixels, 1 .. maxSize().
  /// @param attachments outputs of the program, at layout locations 0 .. attachments - 1.
  /// @throws DeviceError with the figures if it is larger than the device allows.
  FloatTarget(Context& context, int width, int height, int attachments = 1);
  ~FloatTarget();
  FloatTarget(const FloatTarget&) = delete;
  FloatTarget& operator=(const FloatTarget&) = delete;

  /// The longest side that the device allows.
  static int maxSize(Context& context);

  /// Runs the fragment program once per pixel, without waiting for the end.
  /// @throws DeviceError if the device fails.
  void draw(const Program& program);

  /// Copies one output to the host, rows in the order of gl_FragCoord.y, and waits for it.
  /// @param rgba width * height * 4 floats; overwritten.
  /// @throws DeviceError if the device fails.
  void read(std::span<float> rgba, int attachment = 0) const;

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  static constexpr int kMaxAttachments = 8;  // GL guarantees as many draw buffers

  Context& context_;
  int width_;
  int height_;
  int attachments_;
  std::uint32_t framebuffer_ = 0;
  std::uint32_t textures_[kMaxAttachments] = {};
};

/// A buffer that compute programs read and write.
class StorageBuffer {
 public:
  /// @param byteCount at least 1; the content is undefined.
  /// @throws DeviceError with the figures if it is larger than the device allows.
  StorageBuffer(Context& context, std::size_t byteCount);

  /// @param content copied to the device; must not be empty.
  StorageBuffer(Context& context, std::span<const std::byte> content);

  ~StorageBuffer();
  StorageBuffer(const StorageBuffer&) = delete;
  StorageBuffer& operator=(const StorageBuffer&) = delete;

  /// Makes it the buffer block with that `binding`.
  void bind(std::uint32_t binding) const;

  /// Replaces the first bytes.
  void write(std::span<const std::byte> content);

  /// Copies the first bytes to the host, and waits for them.
  /// @throws DeviceError if the device fails.
  void read(std::span<std::byte> content) const;

  std::size_t byteCount() const { return byteCount_; }

 private:
  Context& context_;
  std::uint32_t buffer_ = 0;
  std::size_t byteCount_;
};

}  // namespace twintrace
