#pragma once

#include "renderer/frames/backdrop.h"
#include "renderer/frames/frame_plan.h"
#include "renderer/frames/panel_mesh.h"
#include "renderer/frames/polyhedron_meshes.h"
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

// Draw distance from the eye, in units of the picture's scale.
constexpr float ground_reach = 12.0f;

// Light of a frame that is rendered once; that of several renderings, to be summed and then exposed; and that with
// what hides the sky in another direction each.
enum class Light { at_once, summed, summed_with_sky };

// One rendering of a picture.
struct Drawing {
    const Picture& picture;
    const Bodies& bodies;  // the visible ones of the picture
    const SunView& sun;
    const FrameView& view;
    const SkyView* sky;  // null without Light::summed_with_sky
};

// Issues the GL draw calls: owns programs and meshes, and defines the drawing order.
class Painter {
  public:
    // For frames of this size in pixels. `stages`, if not null, is notified of each stage. Throws RendererError if
    // a shader is missing or does not compile.
    Painter(const Gl& gl, int width, int height, Light light, const std::filesystem::path& shaders, Stages* stages);

    // Draws these tiles of the scene, at least one; the target is undefined outside of them afterwards.
    void draw(const Drawing& scene, const Tiles& tiles, const RenderTarget& target);

  private:
    void draw_shadows(const Drawing& scene);
    void draw_thick_shadows(const SunView& light, const glm::vec3& towards_light, ShadowMap& map);
    void draw_bar_shadows(const Drawing& scene);
    void draw_floor(const Drawing& scene, const Tiles& tiles, const RenderTarget& target);
    void draw_backdrop(const Drawing& scene, const std::vector<PixelArea>& cleared,
                       const std::vector<PixelArea>& lit);
    glm::vec3 background_of(const Drawing& scene) const;
    void use(const ShaderProgram& program, const Drawing& scene) const;
    void place_ground(const Ground& ground, const Camera& camera);
    void draw_ground(const Drawing& scene, const ShaderProgram& program, const std::vector<PixelArea>& areas);
    void draw_ground_depth(const Drawing& scene, const std::vector<PixelArea>& areas);
    void draw_contacts(const Drawing& scene, const Tiles& tiles);
    void draw_bodies(const Drawing& scene, const Tiles& tiles);
    void draw_bars(const Drawing& scene, const Tiles& tiles);
    void draw_panels(const Drawing& scene);
    // Calls `draw` once per area, clipped to it.
    template <typename Draw>
    void within(const std::vector<PixelArea>& areas, const Draw& draw) const;
    void end(Stage stage) const;

    const Gl& gl_;
    Stages* stages_;
    Backdrop backdrop_;
    ShadowMap shadow_map_;
    ShadowMap sky_map_;
    ShadowMap bounce_map_;
    Light light_;
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
    PolyhedronMeshes polyhedra_;
    InstancedMesh bars_;
    InstancedMesh ground_;
    InstancedMesh contacts_;
    PanelMesh panels_;
};

}  // namespace pushfactor::renderer
