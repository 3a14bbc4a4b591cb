#pragma once

#include "renderer/frames/backdrop.h"
#include "renderer/frames/frame_plan.h"
#include "renderer/frames/panel_mesh.h"
#include "renderer/frames/render_target.h"
#include "renderer/frames/shadow_map.h"
#include "renderer/frames/sphere_meshes.h"
#include "renderer/frames/stages.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/shader_program.h"
#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/bodies.h"
#include "renderer/picture/picture.h"
#include "renderer/picture/views.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <vector>

namespace pushfactor::renderer {

// In linear light.
extern const glm::vec3 background;

// How far from the eye anything is drawn, in units of the picture's scale.
constexpr float ground_reach = 12.0f;

// One drawing of a picture.
struct Drawing {
    const Picture& picture;
    const Bodies& bodies;  // those of the picture that are drawn
    const SunView& sun;
    const FrameView& view;
};

// Draws with GL: holds the programs and meshes, and knows in which order things are drawn.
class Painter {
  public:
    // For frames of this size in pixels. `stages`, if not null, is told of each stage. Throws RendererError when a
    // shader is missing or refused.
    Painter(const Gl& gl, int width, int height, const std::filesystem::path& shaders, Stages* stages);

    // Draws these tiles of the scene, of which there is one at least; what is outside of them has no meaning in the
    // target afterwards.
    void draw(const Drawing& scene, const Tiles& tiles, const RenderTarget& target);

  private:
    void draw_shadow(const Drawing& scene);
    void draw_floor(const Drawing& scene, const Tiles& tiles, const RenderTarget& target);
    void draw_backdrop(const Drawing& scene, const std::vector<PixelArea>& cleared,
                       const std::vector<PixelArea>& lit);
    void use(const ShaderProgram& program, const Drawing& scene) const;
    void place_ground(const Ground& ground, const Camera& camera);
    void draw_ground(const Drawing& scene, const ShaderProgram& program, const std::vector<PixelArea>& areas);
    void draw_ground_depth(const Drawing& scene, const std::vector<PixelArea>& areas);
    void draw_contacts(const Drawing& scene, const Tiles& tiles);
    void draw_bodies(const Drawing& scene, const Tiles& tiles);
    void draw_bars(const Drawing& scene, const Tiles& tiles);
    void draw_panels(const Drawing& scene);
    // Calls `draw` once for each area, and nothing outside of it changes.
    template <typename Draw>
    void within(const std::vector<PixelArea>& areas, const Draw& draw) const;
    void end(Stage stage) const;

    const Gl& gl_;
    Stages* stages_;
    Backdrop backdrop_;
    ShadowMap shadow_map_;
    ShaderProgram shadow_program_;
    ShaderProgram sphere_shadow_program_;
    ShaderProgram bar_shadow_program_;
    ShaderProgram ground_program_;
    ShaderProgram shadowed_ground_program_;
    ShaderProgram contact_program_;
    ShaderProgram body_program_;
    ShaderProgram sphere_program_;
    ShaderProgram bar_program_;
    ShaderProgram panel_program_;
    InstancedMesh boxes_;
    SphereMeshes spheres_;
    InstancedMesh bars_;
    InstancedMesh ground_;
    InstancedMesh contacts_;
    PanelMesh panels_;
};

}  // namespace pushfactor::renderer
