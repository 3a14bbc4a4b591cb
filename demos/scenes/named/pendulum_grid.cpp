// Paper section 10.3 and Figure 9: "a grid of 5 by 5 pendulums ... stable enough to hold various other shapes. Each
// pendulum is attached only to one point in space by a bar. If enough force is applied to one of the spheres
// resting on top it will push the pendulums to the side and fall through." The paper gives no numbers; with these
// all five objects are held, and a steady force of 40 N presses one through.
#include "demos/scenes/named/named_scenes.h"
#include "engine/world.h"

#include <array>
#include <cmath>

namespace pushfactor::demos::scenes {

using engine::Vector3;

namespace {

constexpr double ball_radius = 0.5;    // m, of a pendulum's ball
constexpr double mass = 3.0;           // kg
constexpr double grid_spacing = 1.12;  // m between the pendulums
constexpr double bar = 2.0;            // m, from the top of the ball to the point in space
constexpr double sphere_radius = 0.6;
constexpr double ground = -4.0;  // m

// Number of objects whose centres are above those of the pendulums.
class OnTop : public SceneMeasure {
  public:
    OnTop(std::size_t first, std::size_t count) : first_(first), count_(count) {}

    void observe(const engine::World& world) override {
        on_top_ = 0;
        for (std::size_t i = first_; i < first_ + count_; ++i)
            on_top_ += world.bodies[i].position.y() > 0.0 ? 1 : 0;
    }
    std::vector<std::pair<std::string, double>> result() const override { return {{"on_top", on_top_}}; }

  private:
    std::size_t first_, count_;
    int on_top_ = 0;
};

void add_pendulums(SceneDescription& scene) {
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            const Vector3 centre((i - 2) * grid_spacing, 0.0, (j - 2) * grid_spacing);
            BodyDescription ball{.name = "pendulum " + std::to_string(i + 1) + "-" + std::to_string(j + 1),
                                 .shape = SphereShape{ball_radius},
                                 .mass = mass,
                                 .position = centre,
                                 .colour = "blue"};
            scene.distances.push_back({.a = {"world", centre + Vector3(0, ball_radius + bar, 0)},
                                       .b = {ball.name, Vector3(0, ball_radius, 0)},
                                       .length = bar});
            scene.bodies.push_back(ball);
        }
    }
}

void add_object(SceneDescription& scene, const std::string& name, const BodyShape& shape, const Vector3& position,
                const char* colour) {
    scene.bodies.push_back({.name = name, .shape = shape, .mass = 1.0, .position = position, .colour = colour});
}

constexpr std::array pendulum_grid_parameters{
    Parameter{"poke", "N", "steady force in N down on the sphere in the corner pocket [0]", 0, 0, 1e6},
    Parameter{"poke-at", "S", "when it begins, in s [2]", 2, 0, 1e6},
};

SceneDescription describe_pendulum_grid(const ParameterValues& parameters) {
    SceneDescription scene;
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .position = Vector3(0, ground, 0)});
    add_pendulums(scene);

    // A sphere in a pocket touches four balls: their middles are half a diagonal of the spacing away.
    const double reach = ball_radius + sphere_radius;
    const double pocket = std::sqrt(reach * reach - 0.5 * grid_spacing * grid_spacing) + 0.02;
    const double s = grid_spacing;
    const std::size_t first = scene.bodies.size();
    add_object(scene, "sphere 1", SphereShape{sphere_radius}, {-0.5 * s, pocket, -0.5 * s}, "vermilion");
    add_object(scene, "sphere 2", SphereShape{sphere_radius}, {1.5 * s, pocket, 1.5 * s}, "orange");
    add_object(scene, "sphere 3", SphereShape{sphere_radius}, {-1.5 * s, pocket, 1.5 * s}, "orange");
    add_object(scene, "flat box", BoxShape{{1.4, 0.8, 1.4}}, {1.5 * s, 0.92, -1.5 * s}, "green");
    add_object(scene, "cube", BoxShape{{1.2, 1.2, 1.2}}, {0.5 * s, 1.12, 0.5 * s}, "violet");
    const std::size_t count = scene.bodies.size() - first;

    if (const double poke = parameters.number("poke"); poke > 0.0) {
        scene.forces.push_back(
            {.body = "sphere 1", .force = Vector3(0, -poke, 0), .from = parameters.number("poke-at")});
    }
    scene.measure = [first, count](const engine::World&, MomentaAt) {
        return std::make_unique<OnTop>(first, count);
    };
    // The sphere that may be poked is not hidden by others in this view.
    scene.view = view_of({0, -0.6, 0}, 6.1);
    scene.view.eye =
        scene.view.target + (scene.view.eye - scene.view.target).norm() * Vector3(-1, 0.45, 0.4).normalized();
    return scene;
}

}  // namespace

constinit const SceneEntry pendulum_grid{
    "pendulum-grid", "Twenty-five pendulums side by side hold spheres and boxes up, until one is poked (Figure 9).",
    pendulum_grid_parameters, describe_pendulum_grid};

}  // namespace pushfactor::demos::scenes
