#include "renderer/gl/shader_program.h"

#include "renderer/base/renderer_error.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <fstream>
#include <iterator>
#include <string>

namespace pushfactor::renderer {
namespace {

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw RendererError("cannot read the shader " + file.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

class Shader {
  public:
    Shader(const Gl& gl, GLenum stage) : gl_(gl), name_(gl.CreateShader(stage)) {}
    ~Shader() { gl_.DeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    GLuint name() const { return name_; }

  private:
    const Gl& gl_;
    GLuint name_;
};

void attach(const Gl& gl, GLuint program, const std::filesystem::path& file) {
    const std::string text = read_text(file);
    const char* source = text.c_str();
    const Shader shader(gl, file.extension() == ".vert" ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    gl.ShaderSource(shader.name(), 1, &source, nullptr);
    gl.CompileShader(shader.name());

    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        std::array<char, 1024> message{};
        gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(message.size()), nullptr, message.data());
        throw RendererError(file.string() + " does not compile: " + message.data());
    }
    gl.AttachShader(program, shader.name());  // the program keeps it alive
}

}  // namespace

ShaderProgram::ShaderProgram(const Gl& gl) : gl_(gl), program_(gl.CreateProgram()) {}

// Delegates, so that the destructor deletes the program if a file throws.
ShaderProgram::ShaderProgram(const Gl& gl, const std::filesystem::path& directory,
                             std::span<const char* const> files)
    : ShaderProgram(gl) {
    for (const char* file : files) attach(gl, program_, directory / file);
    gl.LinkProgram(program_);

    GLint linked = GL_FALSE;
    gl.GetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string names;
        for (const char* file : files) names += std::string(file) + " ";
        std::array<char, 1024> message{};
        gl.GetProgramInfoLog(program_, static_cast<GLsizei>(message.size()), nullptr, message.data());
        throw RendererError(names + "in " + directory.string() + " do not link: " + message.data());
    }
}

ShaderProgram::~ShaderProgram() {
    gl_.DeleteProgram(program_);
}

void ShaderProgram::use() const {
    gl_.UseProgram(program_);
}

void ShaderProgram::set(const char* uniform, int value) const {
    gl_.Uniform1i(gl_.GetUniformLocation(program_, uniform), value);
}

void ShaderProgram::set(const char* uniform, float value) const {
    gl_.Uniform1f(gl_.GetUniformLocation(program_, uniform), value);
}

void ShaderProgram::set(const char* uniform, const glm::vec3& value) const {
    gl_.Uniform3fv(gl_.GetUniformLocation(program_, uniform), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* uniform, const glm::mat4& value) const {
    gl_.UniformMatrix4fv(gl_.GetUniformLocation(program_, uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace pushfactor::renderer
