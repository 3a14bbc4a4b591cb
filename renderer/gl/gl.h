#pragma once

#include "renderer/gl/gl_types.h"

#include <type_traits>

namespace pushfactor::renderer {

class OffscreenContext;

// Names and types, as in glcorearb.h (see gl_types.h).
#define PUSHFACTOR_GL_FUNCTIONS(X)                                                                                 \
    X(ActiveTexture, void(GLenum texture))                                                                         \
    X(AttachShader, void(GLuint program, GLuint shader))                                                           \
    X(BindBuffer, void(GLenum target, GLuint buffer))                                                              \
    X(BindFramebuffer, void(GLenum target, GLuint framebuffer))                                                    \
    X(BindRenderbuffer, void(GLenum target, GLuint renderbuffer))                                                  \
    X(BindTexture, void(GLenum target, GLuint texture))                                                            \
    X(BindVertexArray, void(GLuint array))                                                                         \
    X(BlendFunc, void(GLenum sfactor, GLenum dfactor))                                                             \
    X(BlendFuncSeparate, void(GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha, GLenum dfactorAlpha))     \
    X(BlitFramebuffer, void(GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0, GLint dstY0,          \
                            GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter))                             \
    X(BufferData, void(GLenum target, GLsizeiptr size, const void* data, GLenum usage))                            \
    X(CheckFramebufferStatus, GLenum(GLenum target))                                                               \
    X(Clear, void(GLbitfield mask))                                                                                \
    X(ClearColor, void(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha))                                   \
    X(ColorMask, void(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha))                            \
    X(CompileShader, void(GLuint shader))                                                                          \
    X(CreateProgram, GLuint())                                                                                     \
    X(CreateShader, GLuint(GLenum type))                                                                           \
    X(DeleteBuffers, void(GLsizei n, const GLuint* buffers))                                                       \
    X(DeleteFramebuffers, void(GLsizei n, const GLuint* framebuffers))                                             \
    X(DeleteProgram, void(GLuint program))                                                                         \
    X(DeleteRenderbuffers, void(GLsizei n, const GLuint* renderbuffers))                                           \
    X(DeleteShader, void(GLuint shader))                                                                           \
    X(DeleteTextures, void(GLsizei n, const GLuint* textures))                                                     \
    X(DeleteVertexArrays, void(GLsizei n, const GLuint* arrays))                                                   \
    X(DepthMask, void(GLboolean flag))                                                                             \
    X(Disable, void(GLenum cap))                                                                                   \
    X(DrawArrays, void(GLenum mode, GLint first, GLsizei count))                                                   \
    X(DrawBuffer, void(GLenum buf))                                                                                \
    X(DrawElementsInstanced,                                                                                       \
      void(GLenum mode, GLsizei count, GLenum type, const void* indices, GLsizei instancecount))                   \
    X(Enable, void(GLenum cap))                                                                                    \
    X(EnableVertexAttribArray, void(GLuint index))                                                                 \
    X(Finish, void())                                                                                              \
    X(FramebufferRenderbuffer,                                                                                     \
      void(GLenum target, GLenum attachment, GLenum renderbuffertarget, GLuint renderbuffer))                      \
    X(FramebufferTexture2D, void(GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level)) \
    X(GenBuffers, void(GLsizei n, GLuint*))                                                                        \
    X(GenFramebuffers, void(GLsizei n, GLuint*))                                                                   \
    X(GenRenderbuffers, void(GLsizei n, GLuint*))                                                                  \
    X(GenTextures, void(GLsizei n, GLuint*))                                                                       \
    X(GenVertexArrays, void(GLsizei n, GLuint*))                                                                   \
    X(GetError, GLenum())                                                                                          \
    X(GetIntegerv, void(GLenum pname, GLint*))                                                                     \
    X(GetProgramInfoLog, void(GLuint program, GLsizei size, GLsizei*, GLchar*))                                    \
    X(GetProgramiv, void(GLuint program, GLenum pname, GLint*))                                                    \
    X(GetShaderInfoLog, void(GLuint shader, GLsizei size, GLsizei*, GLchar*))                                      \
    X(GetShaderiv, void(GLuint shader, GLenum pname, GLint*))                                                      \
    X(GetString, const GLubyte*(GLenum name))                                                                      \
    X(GetUniformLocation, GLint(GLuint program, const GLchar* name))                                               \
    X(LinkProgram, void(GLuint program))                                                                           \
    X(PixelStorei, void(GLenum pname, GLint param))                                                                \
    X(ReadBuffer, void(GLenum src))                                                                                \
    X(ReadPixels, void(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels)) \
    X(RenderbufferStorage, void(GLenum target, GLenum internalformat, GLsizei width, GLsizei height))              \
    X(Scissor, void(GLint x, GLint y, GLsizei width, GLsizei height))                                              \
    X(ShaderSource, void(GLuint shader, GLsizei count, const GLchar* const* string, const GLint* length))          \
    X(TexImage2D, void(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,            \
                       GLint border, GLenum format, GLenum type, const void* pixels))                              \
    X(TexParameterfv, void(GLenum target, GLenum pname, const GLfloat* params))                                    \
    X(TexParameteri, void(GLenum target, GLenum pname, GLint param))                                               \
    X(Uniform1f, void(GLint location, GLfloat v0))                                                                 \
    X(Uniform1i, void(GLint location, GLint v0))                                                                   \
    X(Uniform3fv, void(GLint location, GLsizei count, const GLfloat* value))                                       \
    X(UniformMatrix4fv, void(GLint location, GLsizei count, GLboolean transpose, const GLfloat* value))            \
    X(UseProgram, void(GLuint program))                                                                            \
    X(VertexAttribDivisor, void(GLuint index, GLuint divisor))                                                     \
    X(VertexAttribPointer,                                                                                         \
      void(GLuint index, GLint size, GLenum type, GLboolean normalized, GLsizei stride, const void* pointer))      \
    X(Viewport, void(GLint x, GLint y, GLsizei width, GLsizei height))

// The GL functions in use, without their prefix: `gl.Clear(GL_COLOR_BUFFER_BIT)`.
struct Gl {
#define PUSHFACTOR_GL_MEMBER(name, type) std::add_pointer_t<type> name = nullptr;
    PUSHFACTOR_GL_FUNCTIONS(PUSHFACTOR_GL_MEMBER)
#undef PUSHFACTOR_GL_MEMBER
};

// Makes the context current and loads its functions. Throws RendererError if the context is older than GL 3.3 or
// lacks a function.
Gl load_gl(OffscreenContext& context);

}  // namespace pushfactor::renderer
