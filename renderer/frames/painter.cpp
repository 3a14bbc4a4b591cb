#include "renderer/frames/painter.h"

#include "renderer/frames/frame_checks.h"
#include "renderer/images/exposure.h"
#include "renderer/meshes/meshes.h"
#include "renderer/picture/instances.h"
#include "renderer/picture/panels.h"

#include <glm/gtc/color_space.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>

namespace pushfactor::renderer {

namespace {

// In units of the picture's scale: with a squared exponential haze the ground reaches the background colour, up to
// one 8-bit level, well before it ends.
constexpr float haze = 5.0f;

// Minimum width of a bar, so that it does not break into dots: in pixels, and in texels of the shadow map.
constexpr float least_bar_width = 1.2f;

// Powers of ten from 0.1 m upwards, so that lines are some pixels apart at the camera's target.
float line_spacing(float scale) {
    return std::pow(10.0f, std::floor(std::log10(scale / 6.0f)));
}

// From clip space, -1..1, to texture coordinates and depth, 0..1.
glm::mat4 texture_from_clip() {
    return glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)), glm::vec3(0.5f));
}

// Smallest area that contains all of the areas; needs at least one.
PixelArea bounds_of(const std::vector<PixelArea>& areas) {
    PixelArea bounds = areas.front();
    for (const PixelArea& area : areas) {
        const int end_x = std::max(bounds.x + bounds.width, area.x + area.width);
        const int end_y = std::max(bounds.y + bounds.height, area.y + area.height);
        bounds.x = std::min(bounds.x, area.x);
        bounds.y = std::min(bounds.y, area.y);
        bounds.width = end_x - bounds.x;
        bounds.height = end_y - bounds.y;
    }
    return bounds;
}

// Bodies that are visible in the tiles.
std::vector<Instance> seen_in(const Tiles& tiles, const FrameView& view, std::vector<Instance> bodies) {
    std::erase_if(bodies, [&](const Instance& body) {
        return !tiles.show_ball(view.world_to_clip, body.position, bounding_radius(body));
    });
    return bodies;
}

bool reaches_below(const Ground& ground, const Drawing& scene) {
    const auto is_below = [&](const glm::vec3& point, float radius) { return point.y - radius < ground.height; };
    const std::vector<Instance> bodies = scene.bodies.all();
    return std::ranges::any_of(
               bodies, [&](const Instance& body) { return is_below(body.position, bounding_radius(body)); }) ||
           std::ranges::any_of(scene.picture.panels, [&](const Panel& panel) {
               return std::ranges::any_of(panel.corners,
                                          [&](const glm::vec3& corner) { return is_below(corner, 0.0f); });
           });
}

// What a program looks up: nothing; shadows of sun and sky; also what the ground sends up.
enum class Lit { openly, flat, bodily };

// The shaders of a program with the parts that light what it draws.
std::vector<const char*> lit_by(Lit lit, Light light, std::vector<const char*> files) {
    const auto add = [&](std::initializer_list<const char*> more) { files.insert(files.end(), more); };
    add({"light.frag", "haze.frag", lit == Lit::openly ? "no_shadow.frag" : "shadow.frag"});
    add({light == Light::at_once ? "exposed.frag" : "sampled/unexposed.frag"});
    if (light != Light::summed_with_sky || lit == Lit::openly) {
        add({"open_sky.frag"});
    } else {
        add({"sampled/sky.frag", lit == Lit::bodily ? "sampled/bounce.frag" : "sampled/no_bounce.frag"});
    }
    return files;
}

}  // namespace

Painter::Painter(const Gl& gl, int width, int height, Light light, const std::filesystem::path& shaders,
                 Stages* stages)
    : gl_(gl),
      stages_(stages),
      backdrop_(gl, width, height, light == Light::at_once ? Stored::bytes : Stored::light),
      shadow_map_(gl, 0),
      sky_map_(gl, 1),
      bounce_map_(gl, 2),
      light_(light),
      shadow_program_(gl, shaders, std::array{"body.vert"}),
      sphere_shadow_program_(gl, shaders, std::array{"sphere.vert"}),
      bar_shadow_program_(gl, shaders, std::array{"bar.vert"}),
      ground_program_(gl, shaders, lit_by(Lit::openly, light, {"body.vert", "ground.frag", "lines.frag"})),
      shadowed_ground_program_(gl, shaders, lit_by(Lit::flat, light, {"body.vert", "ground.frag", "lines.frag"})),
      contact_program_(gl, shaders, std::array{"contact.vert", "contact.frag", "haze.frag"}),
      body_program_(gl, shaders, lit_by(Lit::bodily, light, {"body.vert", "body.frag"})),
      sphere_program_(gl, shaders, lit_by(Lit::bodily, light, {"sphere.vert", "sphere.frag"})),
      bar_program_(gl, shaders, lit_by(Lit::bodily, light, {"bar.vert", "bar.frag"})),
      panel_program_(gl, shaders, lit_by(Lit::flat, light, {"panel.vert", "panel.frag", "lines.frag"})),
      boxes_(gl, box_mesh()),
      spheres_(gl),
      polyhedra_(gl),
      bars_(gl, square_mesh()),
      ground_(gl, square_mesh()),
      contacts_(gl, square_mesh()),
      panels_(gl) {
    gl.Enable(GL_CULL_FACE);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_FRAMEBUFFER_SRGB);
    check_gl_errors(gl);
}

void Painter::end(Stage stage) const {
    if (!stages_) return;
    gl_.Finish();
    stages_->end(stage);
}

void Painter::draw_shadows(const Drawing& scene) {
    boxes_.set_instances(scene.bodies.boxes);
    polyhedra_.set_instances(scene.bodies.polyhedra, scene.bodies.shapes);
    spheres_.set_instances(scene.bodies.spheres, scene.picture.camera.eye, scene.view.pixel);
    bars_.set_instances(scene.bodies.bars);
    draw_thick_shadows(scene.sun, scene.view.towards_sun, shadow_map_);
    draw_bar_shadows(scene);
    if (scene.sky) {
        // A bar hides next to nothing of the sky, but each direction would show as a streak.
        draw_thick_shadows(scene.sky->above, scene.sky->towards_sky, sky_map_);
        draw_thick_shadows(scene.sky->below, -scene.sky->towards_sky, bounce_map_);
        bounce_map_.bind_texture();
        sky_map_.bind_texture();
    }
    shadow_map_.bind_texture();
    end(Stage::shadow);
}

void Painter::draw_thick_shadows(const SunView& light, const glm::vec3& towards_light, ShadowMap& map) {
    map.begin(light.width, light.height);
    shadow_program_.use();
    shadow_program_.set("world_to_clip", light.world_to_clip);
    boxes_.draw();
    polyhedra_.draw();
    sphere_shadow_program_.use();
    sphere_shadow_program_.set("world_to_clip", light.world_to_clip);
    sphere_shadow_program_.set("viewer", towards_light);
    sphere_shadow_program_.set("parallel", 1);
    spheres_.draw();
}

// Into the map of the sun, which is bound.
void Painter::draw_bar_shadows(const Drawing& scene) {
    bar_shadow_program_.use();
    bar_shadow_program_.set("world_to_clip", scene.sun.world_to_clip);
    bar_shadow_program_.set("viewer", scene.view.towards_sun);
    bar_shadow_program_.set("parallel", 1);
    bar_shadow_program_.set("least_radius", 0.5f * least_bar_width * scene.sun.texel);
    bar_shadow_program_.set("margin", 0.0f);
    gl_.Disable(GL_CULL_FACE);
    bars_.draw();
    gl_.Enable(GL_CULL_FACE);
}

void Painter::draw(const Drawing& scene, const Tiles& tiles, const RenderTarget& target) {
    draw_shadows(scene);
    draw_floor(scene, tiles, target);
    end(Stage::ground);
    // Drawing outside of the tiles is harmless but takes time.
    within({bounds_of(tiles.areas())}, [&] {
        draw_bodies(scene, tiles);
        draw_bars(scene, tiles);
        if (!scene.picture.panels.empty()) draw_panels(scene);
    });
    end(Stage::bodies);
}

// Draws everything behind the bodies, and the depth of the ground. Draws more than the tiles where nothing depends
// on it, because each separate area takes time.
void Painter::draw_floor(const Drawing& scene, const Tiles& tiles, const RenderTarget& target) {
    const std::optional<Ground>& ground = scene.picture.ground;
    Tiles shadowed(scene.view.width, scene.view.height);
    if (ground) shadowed = shadowed_tiles(scene.view, scene.bodies.all(), *ground);
    if (ground && scene.sky) {
        FrameView from_sky = scene.view;
        from_sky.towards_sun = scene.sky->towards_sky;
        from_sky.texel = scene.sky->above.texel;
        shadowed.add(shadowed_tiles(from_sky, scene.bodies.all(), *ground));
    }
    const FramePlan plan = plan_frame(tiles, shadowed);
    const std::vector<PixelArea> all{bounds_of(tiles.areas())};
    if (ground) place_ground(*ground, scene.picture.camera);
    const BackdropView view{.world_to_clip = scene.view.world_to_clip,
                            .towards_sun = scene.view.towards_sun,
                            .camera = scene.picture.camera,
                            .background = scene.picture.background,
                            .ground = ground};
    gl_.Disable(GL_DEPTH_TEST);
    if (backdrop_.is_worth_keeping(view)) {
        if (!backdrop_.is_drawn()) {
            backdrop_.bind();
            draw_backdrop(scene, {backdrop_.whole()}, {backdrop_.whole()});
        }
        target.bind();
        target.copy_colour(backdrop_.image(), tiles.areas());
    } else {
        target.bind();
        draw_backdrop(scene, all, plan.lit);
    }
    if (ground) {
        draw_ground(scene, shadowed_ground_program_, plan.shadowed);
        // What hides the sky is better than a guess at it.
        if (!scene.sky) draw_contacts(scene, tiles);
    }
    gl_.Enable(GL_DEPTH_TEST);
    within(all, [&] { gl_.Clear(GL_DEPTH_BUFFER_BIT); });
    if (ground && reaches_below(*ground, scene)) draw_ground_depth(scene, all);
}

// In linear light, before exposure if that comes later.
glm::vec3 Painter::background_of(const Drawing& scene) const {
    const glm::vec3 light = glm::convertSRGBToLinear(scene.picture.background.colour);
    return light_ == Light::at_once ? light : unexposed(light);
}

void Painter::draw_backdrop(const Drawing& scene, const std::vector<PixelArea>& cleared,
                            const std::vector<PixelArea>& lit) {
    const glm::vec3 background = background_of(scene);
    gl_.ClearColor(background.r, background.g, background.b, 0.0f);
    within(cleared, [&] { gl_.Clear(GL_COLOR_BUFFER_BIT); });
    if (scene.picture.ground) draw_ground(scene, ground_program_, lit);
}

template <typename Draw>
void Painter::within(const std::vector<PixelArea>& areas, const Draw& draw) const {
    gl_.Enable(GL_SCISSOR_TEST);
    for (const auto& [x, y, width, height] : areas) {
        gl_.Scissor(x, y, width, height);
        draw();
    }
    gl_.Disable(GL_SCISSOR_TEST);
}

// Binds a program and sets all uniforms that do not depend on what it draws.
void Painter::use(const ShaderProgram& program, const Drawing& scene) const {
    program.use();
    program.set("world_to_clip", scene.view.world_to_clip);
    program.set("eye", scene.picture.camera.eye);
    program.set("viewer", scene.picture.camera.eye);
    program.set("parallel", 0);
    program.set("towards_sun", scene.view.towards_sun);
    program.set("background", background_of(scene));
    const float without_haze = 1e6f;
    program.set("haze_distance",
                (scene.picture.background.haze ? haze : without_haze) * scale_of(scene.picture.camera));
    program.set("line_spacing", line_spacing(scale_of(scene.picture.camera)));
    program.set("world_to_shadow", texture_from_clip() * scene.sun.world_to_clip);
    program.set("shadow_texel", scene.sun.texel);
    program.set("shadow_map", 0);
    // A brighter sky where what hides it shows.
    program.set("sun_share", scene.sky ? 0.7f : 1.0f);
    if (!scene.sky) return;
    program.set("sky_map", 1);
    program.set("bounce_map", 2);
    program.set("world_to_sky", texture_from_clip() * scene.sky->above.world_to_clip);
    program.set("world_to_bounce", texture_from_clip() * scene.sky->below.world_to_clip);
    program.set("sky_texel", std::max(scene.sky->above.texel, scene.sky->below.texel));
    program.set("towards_sky", scene.sky->towards_sky);
    program.set("sky_weight", scene.sky->weight);
    // Far below where there is none: no shadow of the sun reaches there.
    const float far_below = scene.picture.camera.target.y - ground_reach * scale_of(scene.picture.camera);
    program.set("ground_height", scene.picture.ground ? scene.picture.ground->height : far_below);
}

void Painter::place_ground(const Ground& ground, const Camera& camera) {
    const Instance square = ground_instance(ground, camera.eye, ground_reach * scale_of(camera));
    ground_.set_instances(std::span(&square, 1));
}

void Painter::draw_ground(const Drawing& scene, const ShaderProgram& program, const std::vector<PixelArea>& areas) {
    use(program, scene);
    within(areas, [&] { ground_.draw(); });
}

// Hides the parts of bodies and panels below the ground.
void Painter::draw_ground_depth(const Drawing& scene, const std::vector<PixelArea>& areas) {
    shadow_program_.use();
    shadow_program_.set("world_to_clip", scene.view.world_to_clip);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    within(areas, [&] { ground_.draw(); });
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Drawn right after the ground, so it darkens nothing else.
void Painter::draw_contacts(const Drawing& scene, const Tiles& tiles) {
    const Ground& ground = *scene.picture.ground;
    std::vector<Instance> bodies = touching(ground, scene.bodies.thick());
    std::erase_if(bodies, [&](const Instance& body) {
        const glm::vec3 below(body.position.x, ground.height, body.position.z);
        return !tiles.show_ball(scene.view.world_to_clip, below, std::sqrt(2.0f) * contact_reach(body));
    });
    contacts_.set_instances(bodies);
    use(contact_program_, scene);
    contact_program_.set("ground_height", ground.height);
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
    contacts_.draw();
    gl_.Disable(GL_BLEND);
}

void Painter::draw_bodies(const Drawing& scene, const Tiles& tiles) {
    boxes_.set_instances(seen_in(tiles, scene.view, scene.bodies.boxes));
    use(body_program_, scene);
    boxes_.draw();
    polyhedra_.set_instances(seen_in(tiles, scene.view, scene.bodies.polyhedra), scene.bodies.shapes);
    polyhedra_.draw();
    spheres_.set_instances(seen_in(tiles, scene.view, scene.bodies.spheres), scene.picture.camera.eye,
                           scene.view.pixel);
    use(sphere_program_, scene);
    spheres_.draw();
}

// Back to front, because edges are blended with what is behind them. Bars are drawn with smooth edges.
void Painter::draw_bars(const Drawing& scene, const Tiles& tiles) {
    std::vector<Instance> bars = seen_in(tiles, scene.view, scene.bodies.bars);
    std::ranges::reverse(bars);
    bars_.set_instances(bars);
    use(bar_program_, scene);
    bar_program_.set("least_radius", 0.5f * least_bar_width * scene.view.pixel);
    bar_program_.set("margin", scene.view.pixel);
    gl_.Disable(GL_CULL_FACE);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ZERO);
    bars_.draw();
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_CULL_FACE);
}

// Drawn last, over everything visible through them; panels do not hide each other.
void Painter::draw_panels(const Drawing& scene) {
    panels_.set_triangles(panel_triangles(scene.picture.panels, scene.picture.camera.eye));
    use(panel_program_, scene);
    gl_.Disable(GL_CULL_FACE);
    gl_.DepthMask(GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    panels_.draw();
    gl_.Disable(GL_BLEND);
    gl_.DepthMask(GL_TRUE);
    gl_.Enable(GL_CULL_FACE);
}

}  // namespace pushfactor::renderer
