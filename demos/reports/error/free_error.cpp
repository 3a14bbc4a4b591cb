// Free bodies: a parabola, and for boxes with three different edges the closed form of free rotation.
#include "demos/reports/error/true_errors.h"
#include "demos/scenes/exact_motions/free_rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace pushfactor::demos::reports::error {

namespace {

using engine::Body;
using engine::Matrix3;
using engine::Quaternion;
using engine::Vector3;

struct Flight {
    Vector3 start, velocity;                         // m, m/s
    Vector3 half_size = Vector3::Zero();             // m, of a box
    std::optional<scenes::FreeRotation> rotation{};  // of a box

    Vector3 place(double time, const Vector3& gravity) const {
        return start + time * velocity + 0.5 * time * time * gravity;
    }
};

// From the description, because the start kick may already have changed the momenta.
Flight flight_of(const BodyDescription& described, const Body& body) {
    Flight flight{.start = described.position, .velocity = described.velocity};
    if (const auto* box = std::get_if<BoxShape>(&described.shape)) {
        flight.half_size = 0.5 * box->size;
        flight.rotation.emplace(
            scenes::FreeBody{.inertia = body.inverse_inertia.cwiseInverse(),
                             .start = described.orientation,
                             .angular_rate = described.orientation.conjugate() * described.angular_velocity});
    }
    return flight;
}

class FreeError : public TrueError {
  public:
    explicit FreeError(const Simulation& start) : gravity_(start.scene().gravity) {
        const BuiltScene& scene = start.scene();
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            flights_.push_back(flight_of(scene.bodies[i], scene.world.bodies[i]));
        }
        turning_energy_ = turning_energy(scene.world.bodies);
    }

    void observe(const Simulation& simulation) override {
        const auto& bodies = simulation.scene().world.bodies;
        const double time = simulation.sample().time;
        for (std::size_t i = 0; i < flights_.size(); ++i) {
            const double flown = (bodies[i].position - flights_[i].place(time, gravity_)).squaredNorm();
            flight_.add(flown);
            if (!flights_[i].rotation) continue;
            const Quaternion exact = flights_[i].rotation->at(time);
            const Matrix3 apart = bodies[i].orientation.toRotationMatrix() - exact.toRotationMatrix();
            // Mean over all corners: terms linear in the offset cancel between opposite ones.
            corners_.add(flown + (apart * flights_[i].half_size.asDiagonal()).squaredNorm());
            angle_.add(std::pow(bodies[i].orientation.angularDistance(exact) * 180.0 / std::numbers::pi, 2));
        }
        energy_ = std::max(energy_, std::abs(turning_energy(bodies) / turning_energy_ - 1.0));
    }

    std::vector<NamedError> result() const override {
        return {{"corners_rms_m", corners_.value()},
                {"flight_rms_m", flight_.value()},
                {"angle_rms_deg", angle_.value()},
                {"turning_energy_max", energy_}};
    }

  private:
    static double turning_energy(const std::vector<Body>& bodies) {
        double sum = 0.0;
        for (const Body& body : bodies) sum += 0.5 * angular_velocity(body).dot(body.angular_momentum);
        return sum;
    }

    Vector3 gravity_;
    std::vector<Flight> flights_;
    double turning_energy_ = 0.0, energy_ = 0.0;
    Rms corners_, flight_, angle_;
};

}  // namespace

std::unique_ptr<TrueError> free_error(const Simulation& start) {
    return std::make_unique<FreeError>(start);
}

}  // namespace pushfactor::demos::reports::error
