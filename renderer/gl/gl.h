#pragma once

// Only for the types of the functions: none of them is linked.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace pushfactor::renderer {

class OffscreenContext;

#define PUSHFACTOR_GL_FUNCTIONS(X) \
    X(ActiveTexture)               \
    X(AttachShader)                \
    X(BindBuffer)                  \
    X(BindFramebuffer)             \
    X(BindRenderbuffer)            \
    X(BindTexture)                 \
    X(BindVertexArray)             \
    X(BlendFunc)                   \
    X(BlendFuncSeparate)           \
    X(BlitFramebuffer)             \
    X(BufferData)                  \
    X(CheckFramebufferStatus)      \
    X(Clear)                       \
    X(ClearColor)                  \
    X(ColorMask)                   \
    X(CompileShader)               \
    X(CreateProgram)               \
    X(CreateShader)                \
    X(DeleteBuffers)               \
    X(DeleteFramebuffers)          \
    X(DeleteProgram)               \
    X(DeleteRenderbuffers)         \
    X(DeleteShader)                \
    X(DeleteTextures)              \
    X(DeleteVertexArrays)          \
    X(DepthMask)                   \
    X(Disable)                     \
    X(DrawArrays)                  \
    X(DrawBuffer)                  \
    X(DrawElementsInstanced)       \
    X(Enable)                      \
    X(EnableVertexAttribArray)     \
    X(Finish)                      \
    X(FramebufferRenderbuffer)     \
    X(FramebufferTexture2D)        \
    X(GenBuffers)                  \
    X(GenFramebuffers)             \
    X(GenRenderbuffers)            \
    X(GenTextures)                 \
    X(GenVertexArrays)             \
    X(GetError)                    \
    X(GetIntegerv)                 \
    X(GetProgramInfoLog)           \
    X(GetProgramiv)                \
    X(GetShaderInfoLog)            \
    X(GetShaderiv)                 \
    X(GetString)                   \
    X(GetUniformLocation)          \
    X(LinkProgram)                 \
    X(PixelStorei)                 \
    X(ReadBuffer)                  \
    X(ReadPixels)                  \
    X(RenderbufferStorage)         \
    X(Scissor)                     \
    X(ShaderSource)                \
    X(TexImage2D)                  \
    X(TexParameterfv)              \
    X(TexParameteri)               \
    X(Uniform1f)                   \
    X(Uniform1i)                   \
    X(Uniform3fv)                  \
    X(UniformMatrix4fv)            \
    X(UseProgram)                  \
    X(VertexAttribDivisor)         \
    X(VertexAttribPointer)         \
    X(Viewport)

// The GL functions that are used, without their prefix: `gl.Clear(GL_COLOR_BUFFER_BIT)`.
struct Gl {
#define PUSHFACTOR_GL_MEMBER(name) decltype(&gl##name) name = nullptr;  // NOLINT(bugprone-macro-parentheses)
    PUSHFACTOR_GL_FUNCTIONS(PUSHFACTOR_GL_MEMBER)
#undef PUSHFACTOR_GL_MEMBER
};

// Makes the context current and loads its functions. Throws RendererError when the context is older than
// GL 3.3 or lacks a function.
Gl load_gl(OffscreenContext& context);

}  // namespace pushfactor::renderer
