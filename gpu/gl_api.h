#pragma once

#include <GL/glcorearb.h>

namespace twintrace {

// The functions of OpenGL 4.5 core that this program calls, as X(type suffix, name). Listed once so
// that the table and its loader can't disagree.
#define TWINTRACE_GL_FUNCTIONS(X)                             \
  X(ATTACHSHADER, AttachShader)                               \
  X(BEGINQUERY, BeginQuery)                                   \
  X(BINDBUFFERBASE, BindBufferBase)                           \
  X(BINDFRAMEBUFFER, BindFramebuffer)                         \
  X(BINDTEXTUREUNIT, BindTextureUnit)                         \
  X(BINDVERTEXARRAY, BindVertexArray)                         \
  X(CHECKNAMEDFRAMEBUFFERSTATUS, CheckNamedFramebufferStatus) \
  X(COMPILESHADER, CompileShader)                             \
  X(CREATEBUFFERS, CreateBuffers)                             \
  X(CREATEFRAMEBUFFERS, CreateFramebuffers)                   \
  X(CREATEPROGRAM, CreateProgram)                             \
  X(CREATEQUERIES, CreateQueries)                             \
  X(CREATESHADER, CreateShader)                               \
  X(CREATETEXTURES, CreateTextures)                           \
  X(CREATEVERTEXARRAYS, CreateVertexArrays)                   \
  X(DEBUGMESSAGECALLBACK, DebugMessageCallback)               \
  X(DEBUGMESSAGECONTROL, DebugMessageControl)                 \
  X(DELETEBUFFERS, DeleteBuffers)                             \
  X(DELETEFRAMEBUFFERS, DeleteFramebuffers)                   \
  X(DELETEPROGRAM, DeleteProgram)                             \
  X(DELETEQUERIES, DeleteQueries)                             \
  X(DELETESHADER, DeleteShader)                               \
  X(DELETETEXTURES, DeleteTextures)                           \
  X(DELETEVERTEXARRAYS, DeleteVertexArrays)                   \
  X(DISPATCHCOMPUTE, DispatchCompute)                         \
  X(DRAWARRAYS, DrawArrays)                                   \
  X(ENABLE, Enable)                                           \
  X(ENDQUERY, EndQuery)                                       \
  X(FINISH, Finish)                                           \
  X(GETERROR, GetError)                                       \
  X(GETINTEGER64V, GetInteger64v)                             \
  X(GETINTEGERV, GetIntegerv)                                 \
  X(GETNAMEDBUFFERSUBDATA, GetNamedBufferSubData)             \
  X(GETPROGRAMBINARY, GetProgramBinary)                       \
  X(GETPROGRAMINFOLOG, GetProgramInfoLog)                     \
  X(GETPROGRAMIV, GetProgramiv)                               \
  X(GETQUERYIV, GetQueryiv)                                   \
  X(GETQUERYOBJECTUI64V, GetQueryObjectui64v)                 \
  X(GETSHADERINFOLOG, GetShaderInfoLog)                       \
  X(GETSHADERIV, GetShaderiv)                                 \
  X(GETSTRING, GetString)                                     \
  X(GETUNIFORMLOCATION, GetUniformLocation)                   \
  X(LINKPROGRAM, LinkProgram)                                 \
  X(MEMORYBARRIER, MemoryBarrier)                             \
  X(NAMEDBUFFERSTORAGE, NamedBufferStorage)                   \
  X(NAMEDBUFFERSUBDATA, NamedBufferSubData)                   \
  X(NAMEDFRAMEBUFFERDRAWBUFFERS, NamedFramebufferDrawBuffers) \
  X(NAMEDFRAMEBUFFERREADBUFFER, NamedFramebufferReadBuffer)   \
  X(NAMEDFRAMEBUFFERTEXTURE, NamedFramebufferTexture)         \
  X(PROGRAMBINARY, ProgramBinary)                             \
  X(PROGRAMPARAMETERI, ProgramParameteri)                     \
  X(PROGRAMUNIFORM1F, ProgramUniform1f)                       \
  X(PROGRAMUNIFORM1I, ProgramUniform1i)                       \
  X(PROGRAMUNIFORM1UI, ProgramUniform1ui)                     \
  X(PROGRAMUNIFORM3F, ProgramUniform3f)                       \
  X(READPIXELS, ReadPixels)                                   \
  X(SHADERSOURCE, ShaderSource)                               \
  X(TEXTUREBUFFER, TextureBuffer)                             \
  X(TEXTURESTORAGE2D, TextureStorage2D)                       \
  X(USEPROGRAM, UseProgram)                                   \
  X(VIEWPORT, Viewport)

/// The GL entry points of one context, without the gl prefix. Each context has its own table, since
/// two providers in one process have different functions behind the same names.
struct GlApi {
#define TWINTRACE_GL_MEMBER(type, name) PFNGL##type##PROC name = nullptr;
  TWINTRACE_GL_FUNCTIONS(TWINTRACE_GL_MEMBER)
#undef TWINTRACE_GL_MEMBER
};

using GlFunction = void (*)();
using GlLoader = GlFunction (*)(const char* name);

/// Fills the table; the context must be current.
/// @param load maps "glName" to its address, or null.
/// @throws DeviceError that names the first function the driver lacks.
GlApi loadGlApi(GlLoader load);

}  // namespace twintrace
