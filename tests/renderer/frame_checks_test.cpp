// A frame that could not be drawn is an error that says why, not a blank image.
#include "renderer/frames/frame_checks.h"

#include "renderer/base/renderer_error.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <string>
#include <vector>

using namespace pushfactor::renderer;
using Catch::Contains;

namespace {

// The next results of a FailingContext's functions; from the front.
std::vector<GLenum> errors;
std::vector<GLenum> statuses;

GLenum next_of(std::vector<GLenum>& answers, GLenum otherwise) {
    if (answers.empty()) return otherwise;
    const GLenum answer = answers.front();
    answers.erase(answers.begin());
    return answer;
}
GLenum failing_error() {
    return next_of(errors, GL_NO_ERROR);
}
GLenum failing_status(GLenum) {
    return next_of(statuses, GL_FRAMEBUFFER_COMPLETE);
}
const GLubyte* old_version(GLenum) {
    return reinterpret_cast<const GLubyte*>("2.1 of old");
}

// A context that works except for the functions that a test removes.
class FailingContext final : public OffscreenContext {
  public:
    FailingContext() {
        errors.clear();
        statuses.clear();
    }
    void make_current() override {
        if (lost) throw RendererError("the context is lost");
        context_->make_current();
    }
    void* function(const char* name) override {
        if (name == missing) return nullptr;
        if (name == std::string("glGetError")) return reinterpret_cast<void*>(&failing_error);
        if (name == std::string("glCheckFramebufferStatus")) return reinterpret_cast<void*>(&failing_status);
        if (old && name == std::string("glGetString")) return reinterpret_cast<void*>(&old_version);
        return context_->function(name);
    }
    std::string description() const override { return "a failing context"; }
    std::string library() const override { return "none"; }

    std::string missing{};  // a removed function
    bool lost = false;
    bool old = false;

  private:
    std::unique_ptr<OffscreenContext> context_ = open_offscreen_context();
};

}  // namespace

TEST_CASE("Pictures of a camera that sees nothing are counted, and those with a little of the ground are not") {
    const auto context = open_offscreen_context();
    Renderer renderer(*context, 64, 36, shader_directory);
    Picture picture = stack_of_cubes(2);
    picture.ground.reset();
    renderer.render(picture);
    CHECK(renderer.blank() == 0);
    picture.camera.target = 2.0f * picture.camera.eye - picture.camera.target;
    renderer.render(picture);
    CHECK(renderer.blank() == 1);
    // Then it sees a little of the ground at the lower edge.
    picture.ground = Ground{};
    renderer.render(picture);
    CHECK(renderer.blank() == 1);
    picture.camera.target = picture.camera.eye + glm::vec3(0.0f, 20.0f, 2.0f);
    renderer.render(picture);
    CHECK(renderer.blank() == 2);
    picture.camera.target.y -= 40.0f;
    renderer.render(picture);
    CHECK(renderer.blank() == 2);
}

TEST_CASE("A picture of nothing has the colour of its background, and is counted") {
    const auto context = open_offscreen_context();
    for (const int samples : {1, 3}) {
        Renderer renderer(*context, 64, 36, shader_directory, samples);
        const Image image = renderer.render(Picture{});
        CHECK(image.pixel(0, 0) == image.pixel(63, 35));
        CHECK(renderer.blank() == 1);
        renderer.render(stack_of_cubes(1));
        CHECK(renderer.blank() == 1);
    }
}

TEST_CASE("A pixel or two of something are enough, and so is one body that fills the frame") {
    OffscreenRenderer offscreen(64, 36);
    CHECK_NOTHROW(
        offscreen.render({.camera = from_the_front, .bodies = {{.shape = Sphere{0.15f}, .colour = red}}}));
    const Body wall{.shape = Box{{30.0f, 30.0f, 1.0f}}, .colour = red};
    const Image image = offscreen.render({.camera = from_the_front, .bodies = {wall}});
    CHECK(is_red(image.pixel(0, 0)));
}

TEST_CASE("An error of OpenGL is named") {
    FailingContext context;
    Renderer renderer(context, 16, 16, shader_directory);
    const Image image = renderer.render(stack_of_cubes(1));
    errors = {GL_OUT_OF_MEMORY};
    CHECK_THROWS_WITH(renderer.render(stack_of_cubes(2)), Contains("out of memory"));
    errors = {GL_INVALID_OPERATION, GL_CONTEXT_LOST};
    CHECK_THROWS_WITH(renderer.render(stack_of_cubes(2)), Contains("invalid operation, context lost"));
    errors = {0x1234};
    CHECK_THROWS_WITH(renderer.render(stack_of_cubes(2)), Contains("0x1234"));
    errors = std::vector<GLenum>(1000, GL_CONTEXT_LOST);
    CHECK_THROWS_WITH(renderer.render(stack_of_cubes(2)), Contains("context lost"));
    errors.clear();
    CHECK(renderer.render(stack_of_cubes(1)) == image);

    errors = {GL_OUT_OF_MEMORY};
    CHECK_THROWS_WITH(Renderer(context, 16, 16, shader_directory), Contains("out of memory"));
}

TEST_CASE("A framebuffer that cannot be drawn into is named") {
    FailingContext context;
    statuses = {GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE};
    CHECK_THROWS_WITH(Renderer(context, 16, 16, shader_directory), Contains("an image of this size: unequal"));
    statuses = {GL_FRAMEBUFFER_COMPLETE, GL_FRAMEBUFFER_UNSUPPORTED};
    CHECK_THROWS_WITH(Renderer(context, 16, 16, shader_directory), Contains("an image of this size: unsupported"));
    Renderer renderer(context, 16, 16, shader_directory);
    statuses = {GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT};
    CHECK_THROWS_WITH(renderer.render(stack_of_cubes(1)), Contains("a shadow map: incomplete attachment"));
    CHECK_NOTHROW(renderer.render(stack_of_cubes(1)));
}

TEST_CASE("A context that is lost, too old or lacks a function is refused with the reason") {
    FailingContext context;
    context.missing = "glBlitFramebuffer";
    CHECK_THROWS_WITH(Renderer(context, 16, 16, shader_directory), Contains("has no function glBlitFramebuffer"));
    context.missing.clear();
    context.old = true;
    CHECK_THROWS_WITH(Renderer(context, 16, 16, shader_directory), Contains("2.1 of old"));
    context.old = false;
    Renderer renderer(context, 16, 16, shader_directory);
    context.lost = true;
    CHECK_THROWS_WITH(renderer.render(stack_of_cubes(1)), Contains("the context is lost"));
    context.lost = false;
    CHECK_NOTHROW(renderer.render(stack_of_cubes(1)));
}
