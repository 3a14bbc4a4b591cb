// The step as a whole, against closed forms (paper sections 5.3, 5.4, 8.1).
#include "engine/world.h"

#include "engine/bodies/diagnostics.h"
#include "engine/constraints/contact_constraints.h"
#include "engine/forces/gravity.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using pushfactor::tests::Random;

namespace {

constexpr double dt = 1.0 / 60.0;
const Vector3 gravity(0, -10, 0);

std::unique_ptr<ContactConstraints> contacts(std::vector<collision::Collider> colliders,
                                             const ContactChoices& choices, FrictionRule friction = nullptr) {
    auto stage = std::make_unique<ContactConstraints>(std::move(colliders), choices);
    stage->set_cache(std::make_unique<ContactCache>());
    if (friction) stage->set_friction(std::move(friction));
    return stage;
}

// A box of 1 m and 2 kg on a plane that is tilted by `angle` about z, at rest on it.
World box_on_slope(double angle, double mu, FrictionRule friction) {
    const Quaternion tilt(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
    World world;
    world.bodies.push_back(static_body(Vector3::Zero(), tilt));
    world.bodies.push_back(box_body(2.0, Vector3::Ones(), tilt * Vector3(0, 0.5, 0), tilt));
    world.forces.push_back(std::make_unique<Gravity>(gravity));
    world.constraints.push_back(contacts({{.body = 0, .shape = collision::Plane{}, .friction = mu},
                                          {.body = 1, .shape = collision::Box{}, .friction = mu}},
                                         {.correction = {}, .detection = {.margin = 0.01}}, std::move(friction)));
    world.solver = solvers::make_solver("pgs");
    world.termination = {.iterations = 1000, .tolerance_high = 1e-12, .tolerance_low = 1e-12};
    return world;
}

double speed_down_slope(double angle, double mu, FrictionRule friction, int steps) {
    World world = box_on_slope(angle, mu, std::move(friction));
    for (int i = 0; i < steps; ++i) world.step(dt);
    const Vector3 downhill(-std::cos(angle), -std::sin(angle), 0);
    return velocity(world.bodies[1]).dot(downhill);
}

}  // namespace

TEST_CASE("a box on a slope rests below atan(mu) and slides at g (sin - mu cos) above") {
    const double mu = 0.5;  // atan = 0.4636
    for (const FrictionRule& rule :
         {weight_friction(gravity), FrictionRule(coulomb_friction), FrictionRule(cone_friction)}) {
        CHECK(std::abs(speed_down_slope(0.45, mu, rule, 120)) < 1e-9);
        for (const double angle : {0.5, 0.6}) {
            const double expected = 10.0 * (std::sin(angle) - mu * std::cos(angle)) * 120 * dt;
            CHECK(speed_down_slope(angle, mu, rule, 120) == Approx(expected).epsilon(1e-6));
        }
    }
}

TEST_CASE("without a friction rule there are no friction rows and a slope is slippery") {
    World world = box_on_slope(0.3, 0.5, nullptr);
    const StepCount count = world.step(dt);
    CHECK(count.rows(RowKind::contact) == 4);
    CHECK(count.rows(RowKind::friction) == 0);
    for (int i = 1; i < 60; ++i) world.step(dt);
    CHECK(velocity(world.bodies[1]).norm() == Approx(10.0 * std::sin(0.3)).epsilon(1e-6));
}

TEST_CASE("under the single-frame push a penetration shrinks by 1 - beta a step and leaves no speed") {
    for (const double beta : {0.05, 0.2, 0.8}) {
        World world;
        world.bodies = {static_body(Vector3::Zero()), box_body(1.0, Vector3::Ones(), {0, 0.3, 0})};
        world.forces.push_back(std::make_unique<Gravity>(gravity));
        world.constraints.push_back(
            contacts({{.body = 0, .shape = collision::Plane{}}, {.body = 1, .shape = collision::Box{}}},
                     {.correction = {PushKind::single_frame, beta}, .slop = 0.0, .detection = {}}));
        world.solver = solvers::make_solver("pgs");
        world.termination = {.iterations = 1000, .tolerance_high = 1e-13, .tolerance_low = 1e-13};
        for (int n = 1; n <= 20; ++n) {
            world.step(dt);
            REQUIRE(0.5 - world.bodies[1].position.y() == Approx(0.2 * std::pow(1.0 - beta, n)).margin(1e-11));
            REQUIRE(velocity(world.bodies[1]).norm() < 1e-11);
        }
    }
}

TEST_CASE("under the persistent push the same penetration becomes speed") {
    World world;
    world.bodies = {static_body(Vector3::Zero()), box_body(1.0, Vector3::Ones(), {0, 0.3, 0})};
    world.forces.push_back(std::make_unique<Gravity>(gravity));
    world.constraints.push_back(
        contacts({{.body = 0, .shape = collision::Plane{}}, {.body = 1, .shape = collision::Box{}}},
                 {.correction = {PushKind::persistent, 0.2}, .slop = 0.0, .detection = {}}));
    world.solver = solvers::make_solver("pgs");
    world.termination = {.iterations = 1000};
    const StepCount count = world.step(dt);
    CHECK(count.columns == 1);
    CHECK(velocity(world.bodies[1]).y() == Approx(0.2 * 0.2 / dt));
}

// Bodies that meet within the step push each other where they are then; angular momentum is kept up to the way that
// they have moved by that time. Without a margin they push where they are at the start.
TEST_CASE("an isolated collision keeps the momenta: all with push none, the linear with any") {
    for (const double margin : {0.0, 0.01})
        for (const PushKind kind : {PushKind::none, PushKind::persistent, PushKind::single_frame}) {
            Random random(11);
            World world;
            for (const double x : {-1.0, 1.0}) {
                Body box = box_body(random.in(0.5, 2), random.vector(1, 2), {x, 0, 0}, random.rotation());
                box.linear_momentum = {-4 * x, random.in(-1, 1), random.in(-1, 1)};
                box.angular_momentum = random.vector(-1, 1);
                world.bodies.push_back(box);
            }
            world.constraints.push_back(contacts({{.body = 0, .shape = collision::Box{Vector3::Constant(0.5)}},
                                                  {.body = 1, .shape = collision::Box{Vector3::Constant(0.5)}}},
                                                 {.correction = {kind, 0.2}, .detection = {.margin = margin}},
                                                 coulomb_friction));
            world.solver = solvers::make_solver("pgs");
            const Vector3 linear = linear_momentum(world.bodies);
            const Vector3 angular = angular_momentum(world.bodies);
            int contact_steps = 0;
            for (int i = 0; i < 120; ++i) contact_steps += world.step(dt).rows() > 0 ? 1 : 0;
            REQUIRE(contact_steps > 0);
            CHECK((linear_momentum(world.bodies) - linear).norm() < 1e-13);
            const double most = margin > 0.0 ? 0.02 : 1e-12;  // 0.010 of an impulse of some 8 N s over up to 0.13 m
            if (kind != PushKind::single_frame) CHECK((angular_momentum(world.bodies) - angular).norm() < most);
        }
}

TEST_CASE("the observer hears of every stage in the order of the step") {
    struct Listener : PhaseObserver {
        std::vector<Phase> heard;
        void phase_ended(Phase stage) override { heard.push_back(stage); }
    } listener;
    World world;
    world.bodies.push_back(box_body(1.0, Vector3::Ones(), Vector3::Zero()));
    world.step(dt, &listener);
    CHECK(listener.heard ==
          std::vector{Phase::forces, Phase::rows, Phase::system, Phase::solve, Phase::remember, Phase::integrate});
}

TEST_CASE("every source gets back its own range of the answers") {
    // Two sources of different numbers of rows; each wants its own push in its rows.
    struct Pusher : ConstraintSource {
        int body, count;
        double expected;
        std::vector<double> heard;
        Pusher(int of_body, int rows, double force) : body(of_body), count(rows), expected(force) {}
        void append_rows(const StepStart&, RowList& rows) override {
            for (int i = 0; i < count; ++i) {
                ConstraintRow& row = rows.emplace_back();
                row.body_b = body;
                row.jacobian.b[i] = 1.0;
                row.push.lasting = expected * dt;  // 1 kg: the force is v / dt
            }
        }
        void remember(std::span<const Lambda> answers) override {
            heard.clear();
            for (const Lambda& answer : answers) heard.push_back(answer.last);
        }
    };
    World world;
    for (int i = 0; i < 3; ++i)
        world.bodies.push_back(i == 0 ? static_body(Vector3::Zero())
                                      : box_body(1.0, Vector3::Ones(), {3.0 * i, 0, 0}));
    auto one = std::make_unique<Pusher>(1, 1, 5.0);
    auto three = std::make_unique<Pusher>(2, 3, 7.0);
    const Pusher& heard_by_one = *one;
    const Pusher& heard_by_three = *three;
    world.constraints.push_back(std::move(one));
    world.constraints.push_back(std::move(three));
    world.solver = solvers::make_solver("pgs");
    world.step(dt);
    REQUIRE(heard_by_one.heard.size() == 1);
    REQUIRE(heard_by_three.heard.size() == 3);
    CHECK(heard_by_one.heard[0] == Approx(5.0));
    for (const double force : heard_by_three.heard) CHECK(force == Approx(7.0));
}

TEST_CASE("two static bodies that overlap make no row") {
    World world;
    world.bodies = {static_body(Vector3::Zero()), static_body(Vector3::Zero())};
    world.constraints.push_back(
        contacts({{.body = 0, .shape = collision::Box{}}, {.body = 1, .shape = collision::Box{}}}, {}));
    world.solver = solvers::make_solver("pgs");
    CHECK(world.step(dt).rows() == 0);
}

TEST_CASE("results turn with the scene: a landing turned about the vertical lands turned") {
    const auto landing = [](const Quaternion& turn) {
        World world;
        const Quaternion tilt(Eigen::AngleAxisd(0.2, Vector3(1, 0, 2).normalized()));
        world.bodies.push_back(static_body(Vector3::Zero(), turn));
        world.bodies.push_back(box_body(1.0, {1.0, 0.6, 0.8}, turn * Vector3(0.1, 1.5, 0.2), turn * tilt));
        world.bodies[1].linear_momentum = turn * Vector3(1, -2, 0.5);
        world.forces.push_back(std::make_unique<Gravity>(gravity));
        world.constraints.push_back(contacts({{.body = 0, .shape = collision::Plane{}},
                                              {.body = 1, .shape = collision::Box{Vector3(0.5, 0.3, 0.4)}}},
                                             {}, weight_friction(gravity)));
        world.solver = solvers::make_solver("pgs");
        for (int i = 0; i < 60; ++i) world.step(dt);
        return world.bodies[1];
    };
    const Quaternion turn(Eigen::AngleAxisd(1.1, Vector3::UnitY()));
    const Body straight = landing(Quaternion::Identity());
    const Body turned = landing(turn);
    CHECK((turned.position - turn * straight.position).norm() < 1e-9);
    CHECK(turned.orientation.angularDistance(turn * straight.orientation) < 1e-9);
}
