#pragma once

#include "renderer/gl/gl.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <span>

namespace pushfactor::renderer {

// A program linked from files. The extension of a file is its stage, .vert or .frag; several files of a stage can
// call each other's functions after declaring them.
class ShaderProgram {
  public:
    // Throws RendererError with the name of a file that cannot be read or compiled, and the compiler's message.
    ShaderProgram(const Gl& gl, const std::filesystem::path& directory, std::span<const char* const> files);
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void use() const;

    // Sets a uniform of the program in use. Ignores uniforms that the program does not have, so that one function
    // can set those shared by all programs of a frame.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const glm::vec3& value) const;
    void set(const char* uniform, const glm::mat4& value) const;

  private:
    explicit ShaderProgram(const Gl& gl);

    const Gl& gl_;
    GLuint program_;
};

}  // namespace pushfactor::renderer
