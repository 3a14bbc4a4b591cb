// Paper section 10.3 and Figure 10: "50 balls with the top of each ball attached to a fixed point in the world with
// a distance constraint. The varied length generates the wave like procession". The paper gives no numbers: here
// ball k makes 40 + k swings in 120 s, so that all are in phase again after two minutes and form two, three and
// four groups after 60, 40 and 30 s. The balls never touch, and the scene has no collision detection.
#include "demos/scenes/exact_motions/ball_on_bar.h"
#include "demos/scenes/named/named_scenes.h"
#include "engine/base/invalid_input.h"
#include "engine/bodies/diagnostics.h"
#include "engine/world.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::scenes {

using engine::Quaternion;
using engine::Vector3;

namespace {

constexpr double bob_radius = 0.1;     // m
constexpr double wave_spacing = 0.25;  // m
constexpr double cycle = 120.0;        // s
constexpr int fewest_swings = 40;      // in a cycle, of the longest
constexpr double beam = 3.2;           // m, height of the points in space

// Angle error of the balls against their exact motion, and energy loss of the swing.
class WaveMeasure : public SceneMeasure {
  public:
    WaveMeasure(const engine::World& world, const Vector3& gravity, std::vector<BallOnBar> pendulums,
                double amplitude, MomentaAt momenta)
        : gravity_(gravity),
          momenta_(momenta),
          pendulums_(std::move(pendulums)),
          reference_(pendulums_.size(), Swing{.a = amplitude, .b = amplitude}),
          initial_energy_(engine::potential_energy(world.bodies, gravity)) {
        for (const BallOnBar& p : pendulums_)
            swing_energy_ += p.gravity * (p.length + p.radius) * (1.0 - elementary::cos(amplitude));
        potential_ = initial_energy_;
    }

    void observe(const engine::World& world) override {
        const double dt = world.time() - time_;
        const int steps = std::max(1, static_cast<int>(std::ceil(dt * 960.0)));
        for (std::size_t i = 0; i < pendulums_.size(); ++i) {
            reference_[i] = advance(pendulums_[i], reference_[i], dt, steps);
            const Vector3& centre = world.bodies[i].position;
            const double angle = elementary::atan2(centre.z(), beam - centre.y());
            const double error = angle - centre_angle(pendulums_[i], reference_[i]);
            squares_ += error * error;
        }
        samples_ += static_cast<double>(pendulums_.size());
        time_ = world.time();

        // If momenta are half a step before positions, the kinetic energies of two steps are averaged around the
        // potential energy between them.
        const double kinetic = engine::kinetic_energy(world.bodies);
        const double potential = engine::potential_energy(world.bodies, gravity_);
        energy_ =
            momenta_ == MomentaAt::whole_steps ? potential + kinetic : potential_ + 0.5 * (kinetic_ + kinetic);
        kinetic_ = kinetic;
        potential_ = potential;
    }

    std::vector<std::pair<std::string, double>> result() const override {
        const double rms = samples_ > 0.0 ? std::sqrt(squares_ / samples_) : 0.0;
        return {{"angle_error_rms_deg", rms * 180.0 / std::numbers::pi},
                {"energy_loss_of_swing", samples_ > 0.0 ? (initial_energy_ - energy_) / swing_energy_ : 0.0}};
    }

    bool is_costly() const override { return true; }

  private:
    Vector3 gravity_;
    MomentaAt momenta_;
    std::vector<BallOnBar> pendulums_;
    std::vector<Swing> reference_;
    double time_ = 0.0, squares_ = 0.0, samples_ = 0.0;
    double initial_energy_, swing_energy_ = 0.0, energy_ = 0.0, kinetic_ = 0.0, potential_ = 0.0;
};

constexpr std::array pendulum_wave_parameters{
    Parameter{"count", "N", "number of pendulums [50]", 50, 1, 122, true},
    Parameter{"amplitude", "DEG", "angle at which they are released, in degrees [22.9183, which is 0.4 rad]",
              0.4 * 180.0 / std::numbers::pi, 0.1, 80},
};

SceneDescription describe_pendulum_wave(const ParameterValues& parameters) {
    SceneDescription scene;
    const double amplitude = parameters.number("amplitude") * std::numbers::pi / 180.0;
    const int count = parameters.whole("count");
    std::vector<BallOnBar> pendulums;
    for (int k = 0; k < count; ++k) {
        BallOnBar pendulum{.length = 0.0, .radius = bob_radius, .gravity = -scene.gravity.y()};
        pendulum.length = length_for_period(pendulum, amplitude, cycle / (fewest_swings + k));
        if (!(pendulum.length > 0.0))
            throw engine::InvalidInput(
                "count", std::to_string(count),
                "at most " + std::to_string(k) + " at this amplitude: no bar is short enough");
        pendulums.push_back(pendulum);

        // Bar and ball aligned at the amplitude, swinging in the y-z plane.
        const Vector3 hook(wave_spacing * (k - 0.5 * (count - 1)), beam, 0.0);
        const Vector3 along(0.0, -elementary::cos(amplitude), elementary::sin(amplitude));
        BodyDescription ball{
            .name = "ball " + std::to_string(k + 1), .shape = SphereShape{bob_radius}, .mass = 1.0};
        ball.position = hook + (pendulum.length + bob_radius) * along;
        ball.orientation = exponential(-amplitude * Vector3::UnitX());
        scene.bodies.push_back(ball);
        scene.distances.push_back(
            {.a = {"world", hook}, .b = {ball.name, Vector3(0, bob_radius, 0)}, .length = pendulum.length});
    }
    scene.measure = [pendulums, amplitude, gravity = scene.gravity](const engine::World& world, MomentaAt momenta) {
        return std::make_unique<WaveMeasure>(world, gravity, pendulums, amplitude, momenta);
    };
    scene.view = {.eye = Vector3(-9.2, 3.3, 6.2), .target = Vector3(-1.2, 1.75, 0), .floor = 0.0};
    return scene;
}

}  // namespace

constinit const SceneEntry pendulum_wave{
    "pendulum-wave",
    "Fifty pendulums of graded length run out of phase and, after two minutes, back in (Figure 10).",
    pendulum_wave_parameters, describe_pendulum_wave};

}  // namespace pushfactor::demos::scenes
