#include "gpu/buffers.h"

#include <array>
#include <cassert>
#include <string>

#include "common/base/error.h"
#include "gpu/context.h"
#include "gpu/gl_api.h"
#include "gpu/program.h"

namespace twintrace {

namespace {

/// @throws DeviceError if more is asked for than the device allows.
void requireLimit(const std::string& what, std::int64_t asked, std::int64_t limit) {
  if (asked <= limit) return;
  throw DeviceError(what + ": found " + std::to_string(asked) + ", the device allows " +
                    std::to_string(limit));
}

}  // namespace

BufferTexture::BufferTexture(Context& context, std::span<const glm::uvec4> texels)
    : context_(context) {
  static constexpr glm::uvec4 kZero(0u);
  if (texels.empty()) texels = {&kZero, 1};
  requireLimit("scene texels", static_cast<std::int64_t>(texels.size()),
               context_.integer(GL_MAX_TEXTURE_BUFFER_SIZE));
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  gl.CreateBuffers(1, &buffer_);
  gl.NamedBufferStorage(buffer_, static_cast<GLsizeiptr>(texels.size_bytes()), texels.data(), 0);
  gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &texture_);
  gl.TextureBuffer(texture_, GL_RGBA32UI, buffer_);
  context_.check("making a buffer texture of " + std::to_string(texels.size_bytes()) + " bytes");
}

BufferTexture::~BufferTexture() {
  const auto current = context_.use();
  context_.gl().DeleteTextures(1, &texture_);
  context_.gl().DeleteBuffers(1, &buffer_);
}

void BufferTexture::bind(std::uint32_t unit) const {
  const auto current = context_.use();
  context_.gl().BindTextureUnit(unit, texture_);
}

FloatTarget::FloatTarget(Context& context, int width, int height, int attachments)
    : context_(context), width_(width), height_(height), attachments_(attachments) {
  assert(width > 0 && height > 0 && attachments > 0 && attachments <= kMaxAttachments);
  requireLimit("picture width", width, maxSize(context_));
  requireLimit("picture height", height, maxSize(context_));
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  gl.CreateFramebuffers(1, &framebuffer_);
  gl.CreateTextures(GL_TEXTURE_2D, attachments, textures_);
  std::array<GLenum, kMaxAttachments> outputs{};
  for (int i = 0; i < attachments; ++i) {
    outputs[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    gl.TextureStorage2D(textures_[i], 1, GL_RGBA32F, width, height);
    gl.NamedFramebufferTexture(framebuffer_, outputs[i], textures_[i], 0);
  }
  gl.NamedFramebufferDrawBuffers(framebuffer_, attachments, outputs.data());
  context_.check("making a picture of " + std::to_string(width) + " x " + std::to_string(height));
  if (gl.CheckNamedFramebufferStatus(framebuffer_, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw DeviceError("the device can't render to float pictures");
  }
}

FloatTarget::~FloatTarget() {
  const auto current = context_.use();
  context_.gl().DeleteFramebuffers(1, &framebuffer_);
  context_.gl().DeleteTextures(attachments_, textures_);
}

int FloatTarget::maxSize(Context& context) {
  return static_cast<int>(context.integer(GL_MAX_TEXTURE_SIZE));
}

void FloatTarget::draw(const Program& program) {
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.Viewport(0, 0, width_, height_);
  gl.UseProgram(program.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  context_.check("drawing");
}

void FloatTarget::read(std::span<float> rgba, int attachment) const {
  assert(rgba.size() == std::size_t{4} * width_ * height_ && attachment < attachments_);
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.NamedFramebufferReadBuffer(framebuffer_,
                                GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment));
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, rgba.data());
  context_.check("reading a picture back");
}

StorageBuffer::StorageBuffer(Context& context, std::size_t byteCount)
    : context_(context), byteCount_(byteCount) {
  requireLimit("bytes of a storage buffer", static_cast<std::int64_t>(byteCount),
               context_.integer(GL_MAX_SHADER_STORAGE_BLOCK_SIZE));
  const auto current = context_.use();
  const GlApi& gl = context_.gl();
  gl.CreateBuffers(1, &buffer_);
  gl.NamedBufferStorage(buffer_, static_cast<GLsizeiptr>(byteCount), nullptr,
                        GL_DYNAMIC_STORAGE_BIT);
  context_.check("making a storage buffer of " + std::to_string(byteCount) + " bytes");
}

StorageBuffer::StorageBuffer(Context& context, std::span<const std::byte> content)
    : StorageBuffer(context, content.size()) {
  write(content);
}

StorageBuffer::~StorageBuffer() {
  const auto current = context_.use();
  context_.gl().DeleteBuffers(1, &buffer_);
}

void StorageBuffer::bind(std::uint32_t binding) const {
  const auto current = context_.use();
  context_.gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_);
}

void StorageBuffer::write(std::span<const std::byte> content) {
  assert(content.size() <= byteCount_);
  const auto current = context_.use();
  context_.gl().NamedBufferSubData(buffer_, 0, static_cast<GLsizeiptr>(content.size()),
                                   content.data());
  context_.check("writing a storage buffer");
}

void StorageBuffer::read(std::span<std::byte> content) const {
  assert(content.size() <= byteCount_);
  const auto current = context_.use();
  context_.gl().GetNamedBufferSubData(buffer_, 0, static_cast<GLsizeiptr>(content.size()),
                                      content.data());
  context_.check("reading a storage buffer");
}

}  // namespace twintrace
