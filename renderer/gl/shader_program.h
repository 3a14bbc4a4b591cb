#pragma once

#include "renderer/gl/gl.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <initializer_list>

namespace pushfactor::renderer {

// A program linked from files. The stage of a file is its extension, .vert or .frag; several files of one
// stage see each other's functions once they declare them.
class ShaderProgram {
  public:
    // Throws RendererError with the name of a file that cannot be read or compiled, and the compiler's
    // message.
    ShaderProgram(const Gl& gl, const std::filesystem::path& directory, std::initializer_list<const char*> files);
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void use() const;

    // Sets a uniform of the program in use. A uniform that the program does not have is ignored, so that one
    // function can set what all programs of a frame share.
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
