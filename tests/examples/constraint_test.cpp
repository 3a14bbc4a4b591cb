// A constraint source, as engine/README.md shows it.
#include "engine/constraints/constraint_source.h"
#include "engine/forces/gravity.h"
#include "engine/solvers/solver.h"
#include "engine/world.h"
#include "tests/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace pushfactor::engine;

namespace {

// [example: constraint]
// A rail: the centre x of a body stays on the line through p that is fixed in the world. d_1 and d_2 lie across it.
//
//   c_k = d_k . (x - p),   j_c = [d_k, 0],   v = -beta c_k / dt,   k = 1, 2
class Rail : public ConstraintSource {
  public:
    // `point` [m] and `direction` (unit length) of the line, world frame. `ground` is any static body.
    Rail(int ground, int slider, const Vector3& point, const Vector3& direction)
        : ground_(ground), slider_(slider), point_(point), across_{direction.unitOrthogonal(), Vector3::Zero()} {
        across_[1] = direction.cross(across_[0]);
    }

    void append_rows(const StepStart& step, RowList& rows) override {
        const Vector3 offset = step.bodies[static_cast<std::size_t>(slider_)].position - point_;
        for (std::size_t k = 0; k < 2; ++k) {
            const double error = across_[k].dot(offset);
            ConstraintRow& row = rows.emplace_back();
            row.body_a = ground_;
            row.body_b = slider_;
            row.jacobian.b.head<3>() = across_[k];
            row.push = correct({.kind = PushKind::single_frame, .beta = 1.0}, -error, step.dt);
            row.guess = forces_[k];
        }
    }

    void remember(std::span<const Lambda> answers) override {
        std::copy(answers.begin(), answers.end(), forces_.begin());
    }

  private:
    int ground_, slider_;  // indices into the bodies of the world
    Vector3 point_;
    std::array<Vector3, 2> across_;
    std::array<Lambda, 2> forces_;
};
// [end]

// A box of 2 kg that a rail with this slope [rad] leads down, towards +x.
World world_with_rail(double slope, const Vector3& off) {
    World world;
    world.bodies = {static_body(Vector3::Zero()), box_body(2.0, Vector3(0.4, 0.2, 0.3), Vector3(1, 2, 3) + off)};
    world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -10, 0)));
    const Vector3 direction(std::cos(slope), -std::sin(slope), 0);
    world.constraints.push_back(std::make_unique<Rail>(0, 1, Vector3(1, 2, 3), direction));
    world.solver = solvers::make_solver("auto");
    world.termination = {.iterations = 25, .tolerance_high = 1e-8, .tolerance_low = 1e-10};
    return world;
}

double off_the_rail(const World& world, double slope) {
    const Vector3 direction(std::cos(slope), -std::sin(slope), 0);
    return direction.cross(world.bodies[1].position - Vector3(1, 2, 3)).norm();
}

}  // namespace

TEST_CASE("example: a box on a rail stays on it to 1e-9 m and slides with g sin(slope)") {
    const double dt = 1.0 / 60.0;
    for (const double slope : {0.0, 0.3, std::numbers::pi / 2}) {
        World world = world_with_rail(slope, Vector3::Zero());
        for (int n = 1; n <= 300; ++n) {
            world.step(dt);
            CHECK(off_the_rail(world, slope) < 1e-9);
            CHECK(velocity(world.bodies[1]).norm() == Approx(n * dt * 10.0 * std::sin(slope)).margin(1e-9));
        }
    }
}

TEST_CASE("example: a box beside the rail is on it after one step, and the correction leaves it no speed") {
    World world = world_with_rail(0.0, Vector3(0, 0.01, -0.02));
    CHECK(off_the_rail(world, 0.0) > 0.02);
    world.step(1.0 / 60.0);
    CHECK(off_the_rail(world, 0.0) < 1e-9);
    CHECK(velocity(world.bodies[1]).norm() < 1e-9);
}
