#include "renderer/renderer.h"

#include "renderer/bodies.h"
#include "renderer/frame_checks.h"
#include "renderer/frame_plan.h"
#include "renderer/gl.h"
#include "renderer/instanced_mesh.h"
#include "renderer/instances.h"
#include "renderer/marks.h"
#include "renderer/meshes.h"
#include "renderer/panel_mesh.h"
#include "renderer/panels.h"
#include "renderer/render_target.h"
#include "renderer/renderer_error.h"
#include "renderer/sampling.h"
#include "renderer/shader_program.h"
#include "renderer/shadow_map.h"
#include "renderer/sphere_meshes.h"
#include "renderer/views.h"

#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::renderer {
namespace {

const glm::vec3 background = glm::convertSRGBToLinear(glm::vec3(0.85f, 0.875f, 0.90f));

// In units of the picture's scale: with a squared exponential haze the ground has the background's colour to
// within a level of 8 bits well before it ends.
constexpr float haze = 5.0f;
constexpr float ground_reach = 12.0f;

// The least width of a bar, so that it does not break into dots: in pixels, and in the shadow map's texels.
constexpr float least_bar_width = 1.2f;

struct Scene {
    const Picture& picture;
    const Bodies& bodies;
    float scale;  // m
    glm::vec3 towards_sun;
    SunView sun;
    glm::mat4 world_to_clip;
    FramePlan plan;
};

// From 0.1 m upwards by tens, so that lines stay some pixels apart at the camera's target.
float line_spacing(float scale) {
    return std::pow(10.0f, std::floor(std::log10(scale / 6.0f)));
}

// Clip space reaches from -1 to 1, a texture and its depth from 0 to 1.
glm::mat4 texture_from_clip() {
    return glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)), glm::vec3(0.5f));
}

int checked_side(int pixels) {
    if (pixels < 1 || pixels > Renderer::max_side) {
        throw RendererError("a picture's sides are 1 to " + std::to_string(Renderer::max_side) + " pixels, not " +
                            std::to_string(pixels));
    }
    return pixels;
}

int checked_samples(int samples) {
    if (samples < 1 || samples > Renderer::max_samples) {
        throw RendererError("a picture is the mean of 1 to " + std::to_string(Renderer::max_samples) +
                            " samples, not of " + std::to_string(samples));
    }
    return samples;
}

}  // namespace

class Renderer::Pipeline {
  public:
    Pipeline(OffscreenContext& context, int width, int height, const std::filesystem::path& shaders, int samples)
        : gl_(load_gl(context)),
          samples_(samples),
          width_(width),
          height_(height),
          aspect_(static_cast<float>(width) / static_cast<float>(height)),
          target_(gl_, width, height),
          shadow_map_(gl_),
          shadow_program_(gl_, shaders, {"body.vert"}),
          sphere_shadow_program_(gl_, shaders, {"sphere.vert"}),
          ground_program_(gl_, shaders,
                          {"body.vert", "ground.frag", "lines.frag", "light.frag", "no_shadow.frag", "haze.frag"}),
          shadowed_ground_program_(
              gl_, shaders, {"body.vert", "ground.frag", "lines.frag", "light.frag", "shadow.frag", "haze.frag"}),
          contact_program_(gl_, shaders, {"contact.vert", "contact.frag", "haze.frag"}),
          body_program_(gl_, shaders, {"body.vert", "body.frag", "light.frag", "shadow.frag", "haze.frag"}),
          sphere_program_(gl_, shaders, {"sphere.vert", "sphere.frag", "light.frag", "shadow.frag", "haze.frag"}),
          panel_program_(gl_, shaders,
                         {"panel.vert", "panel.frag", "lines.frag", "light.frag", "shadow.frag", "haze.frag"}),
          boxes_(gl_, box_mesh()),
          spheres_(gl_),
          bars_(gl_, capsule_mesh()),
          squares_(gl_, square_mesh()),
          panels_(gl_) {
        gl_.Enable(GL_CULL_FACE);
        gl_.Enable(GL_DEPTH_TEST);
        gl_.Enable(GL_FRAMEBUFFER_SRGB);
        check_gl_errors(gl_);
    }

    Image draw(const Picture& picture) {
        const float scale = scale_of(picture.camera);
        // Bodies beyond the reach of the ground are lost in the haze, however far they have been thrown.
        const Bodies bodies = visible_bodies(picture, ground_reach * scale);
        boxes_.set_instances(bodies.boxes);
        spheres_.set_instances(bodies.spheres, picture.camera.eye, pixel_at_one_metre(picture.camera, height_));
        bars_.set_instances(bodies.bars);
        panels_.set_triangles(panel_triangles(picture.panels, picture.camera.eye));

        // The corners of the ground are the farthest that is drawn.
        const glm::mat4 view = camera_view(picture.camera, aspect_, 1.5f * ground_reach * scale);
        const auto draw_sample = [&](int index) {
            const auto [pixel, towards_sun] = sample_offset(index, samples_, glm::normalize(picture.towards_sun));
            const SunView sun = sun_view(picture.camera, towards_sun, bodies.all(), ShadowMap::max_side);
            const glm::vec2 clip = 2.0f * pixel / glm::vec2(width_, height_);
            const glm::mat4 world_to_clip = glm::translate(glm::mat4(1.0f), glm::vec3(clip, 0.0f)) * view;
            draw({picture, bodies, scale, towards_sun, sun, world_to_clip,
                  plan_frame(width_, height_, world_to_clip, bodies, picture, towards_sun, sun.texel)});
            Image image = target_.read();
            check_gl_errors(gl_);
            return image;
        };
        if (samples_ == 1) return draw_sample(0);
        SampleMean mean(width_, height_);
        for (int index = 0; index < samples_; ++index) mean.add(draw_sample(index));
        return mean.mean();
    }

  private:
    void draw(const Scene& scene) {
        draw_shadow(scene);
        shadow_map_.bind_texture();
        gl_.ClearColor(background.r, background.g, background.b, 1.0f);

        target_.bind_image();
        gl_.Clear(GL_COLOR_BUFFER_BIT);
        draw_floor(scene, scene.plan.bare);

        target_.bind_samples();
        for (const auto* parts : {&scene.plan.edged.lit, &scene.plan.edged.shadowed}) {
            within(*parts, [&] { gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); });
        }
        draw_floor(scene, scene.plan.edged);
        draw_bodies(scene);
        if (!scene.picture.panels.empty()) draw_panels(scene);
        for (const auto* parts : {&scene.plan.edged.lit, &scene.plan.edged.shadowed}) target_.resolve(*parts);
    }

    // Calls `draw` once for each rectangle, and nothing outside of it changes.
    template <typename Draw>
    void within(std::span<const Rectangle> parts, const Draw& draw) const {
        gl_.Enable(GL_SCISSOR_TEST);
        for (const auto& [x, y, width, height] : parts) {
            gl_.Scissor(x, y, width, height);
            draw();
        }
        gl_.Disable(GL_SCISSOR_TEST);
    }

    void draw_floor(const Scene& scene, const FramePlan::Part& part) {
        if (!scene.picture.ground) return;
        draw_ground(scene, part);
        draw_contacts(scene, *scene.picture.ground);
    }

    void draw_shadow(const Scene& scene) {
        shadow_map_.begin(scene.sun.width, scene.sun.height);
        shadow_program_.use();
        shadow_program_.set("world_to_clip", scene.sun.world_to_clip);
        shadow_program_.set("least_bevel", 0.0f);
        boxes_.draw();
        shadow_program_.set("least_bevel", 0.5f * least_bar_width * scene.sun.texel);
        bars_.draw();
        sphere_shadow_program_.use();
        sphere_shadow_program_.set("world_to_clip", scene.sun.world_to_clip);
        sphere_shadow_program_.set("viewer", scene.towards_sun);
        sphere_shadow_program_.set("parallel", 1);
        spheres_.draw();
    }

    // Takes a program into use and sets all that does not depend on what it draws.
    void use(const ShaderProgram& program, const Scene& scene) const {
        program.use();
        program.set("world_to_clip", scene.world_to_clip);
        program.set("eye", scene.picture.camera.eye);
        program.set("towards_sun", scene.towards_sun);
        program.set("background", background);
        program.set("haze_distance", haze * scene.scale);
        program.set("world_to_shadow", texture_from_clip() * scene.sun.world_to_clip);
        program.set("shadow_texel", scene.sun.texel);
        program.set("shadow_map", 0);
    }

    void draw_ground(const Scene& scene, const FramePlan::Part& part) {
        const Instance square =
            ground_instance(*scene.picture.ground, scene.picture.camera.eye, ground_reach * scene.scale);
        squares_.set_instances(std::span(&square, 1));
        const auto draw_with = [&](const ShaderProgram& program, std::span<const Rectangle> parts) {
            use(program, scene);
            program.set("line_spacing", line_spacing(scene.scale));
            within(parts, [&] { squares_.draw(); });
        };
        draw_with(ground_program_, part.lit);
        draw_with(shadowed_ground_program_, part.shadowed);
    }

    // Nothing but the ground has been drawn when this darkens it, so there is no depth to test.
    void draw_contacts(const Scene& scene, const Ground& ground) {
        squares_.set_instances(touching(ground, scene.bodies.thick()));
        use(contact_program_, scene);
        contact_program_.set("ground_height", ground.height);
        gl_.Disable(GL_DEPTH_TEST);
        gl_.Enable(GL_BLEND);
        gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
        squares_.draw();
        gl_.Disable(GL_BLEND);
        gl_.Enable(GL_DEPTH_TEST);
    }

    void draw_bodies(const Scene& scene) {
        use(body_program_, scene);
        body_program_.set("least_bevel", 0.0f);
        boxes_.draw();
        const float pixel = pixel_at_one_metre(scene.picture.camera, height_);
        body_program_.set("least_bevel", 0.5f * least_bar_width * pixel);
        bars_.draw();
        use(sphere_program_, scene);
        sphere_program_.set("viewer", scene.picture.camera.eye);
        sphere_program_.set("parallel", 0);
        spheres_.draw();
    }

    // Last, over all that they let through; they hide nothing from each other.
    void draw_panels(const Scene& scene) {
        use(panel_program_, scene);
        panel_program_.set("line_spacing", line_spacing(scene.scale));
        gl_.Disable(GL_CULL_FACE);
        gl_.DepthMask(GL_FALSE);
        gl_.Enable(GL_BLEND);
        gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        panels_.draw();
        gl_.Disable(GL_BLEND);
        gl_.DepthMask(GL_TRUE);
        gl_.Enable(GL_CULL_FACE);
    }

    Gl gl_;
    int samples_;
    int width_;   // pixels
    int height_;  // pixels
    float aspect_;
    RenderTarget target_;
    ShadowMap shadow_map_;
    ShaderProgram shadow_program_;
    ShaderProgram sphere_shadow_program_;
    ShaderProgram ground_program_;
    ShaderProgram shadowed_ground_program_;
    ShaderProgram contact_program_;
    ShaderProgram body_program_;
    ShaderProgram sphere_program_;
    ShaderProgram panel_program_;
    InstancedMesh boxes_;
    SphereMeshes spheres_;
    InstancedMesh bars_;
    InstancedMesh squares_;
    PanelMesh panels_;
};

Renderer::Renderer(OffscreenContext& context, int width, int height, const std::filesystem::path& shader_directory,
                   int samples)
    : context_(context),
      pipeline_(std::make_unique<Pipeline>(context, checked_side(width), checked_side(height), shader_directory,
                                           checked_samples(samples))) {}

// What the pipeline holds is deleted in its own context.
Renderer::~Renderer() {
    context_.make_current();
}

Image Renderer::render(const Picture& picture) {
    check(picture);
    context_.make_current();
    Image image = pipeline_->draw(picture);
    draw_marks(image, picture);
    check_in_view(image, background, picture.camera);
    return image;
}

}  // namespace pushfactor::renderer
