// Closed loops of hinges and welds, whose rows say the same thing more than once.
#include "demos/runs/measurements.h"
#include "tests/catch.h"
#include "tests/dense_algebra.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <numbers>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Quaternion;
using engine::Vector3;

namespace {

constexpr double thickness = 0.1;  // m

JointDescription hinge(int a, const Vector3& at_a, int b, const Vector3& at_b, bool weld) {
    JointDescription joint{.a = {.body = std::to_string(a), .point = at_a},
                           .b = {.body = std::to_string(b), .point = at_b}};
    joint.hinge = HingeDescription{.axis = Vector3::UnitZ()};
    if (weld) joint.hinge->limits = engine::AngleLimits{0.0, 0.0};
    return joint;
}

void add_bar(SceneDescription& scene, const Vector3& centre, double angle, double length, double mass) {
    scene.bodies.push_back({.name = std::to_string(scene.bodies.size()),
                            .shape = BoxShape{{length, thickness, thickness}},
                            .mass = mass,
                            .position = centre,
                            .orientation = Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ())),
                            .friction = 0.5});
}

// A regular polygon of bars around the origin.
SceneDescription ring(int sides, double length, bool welded) {
    SceneDescription scene;
    scene.name = "ring";
    const double turn = 2.0 * std::numbers::pi / sides, inner = 0.5 * length / std::tan(0.5 * turn);
    for (int k = 0; k < sides; ++k) {
        const double angle = turn * (k + 0.5);
        add_bar(scene, inner * Vector3(std::cos(angle), std::sin(angle), 0), angle + 0.5 * std::numbers::pi, length,
                1.0);
    }
    const Vector3 end(0.5 * length, 0, 0);
    for (int k = 0; k < sides; ++k) scene.joints.push_back(hinge(k, end, (k + 1) % sides, -end, welded));
    return scene;
}

SceneDescription on_the_ground() {
    SceneDescription scene;
    scene.contacts = true;
    scene.gravity = {0, -9.81, 0};
    scene.bodies.push_back({.name = "0", .shape = PlaneShape{}, .friction = 0.5});
    return scene;
}

void add_box(SceneDescription& scene, const Vector3& size, double mass, const Vector3& position) {
    scene.bodies.push_back({.name = std::to_string(scene.bodies.size()),
                            .shape = BoxShape{size},
                            .mass = mass,
                            .position = position,
                            .friction = 0.5});
}

tests::Run run_of(const SceneDescription& scene) {
    const Settings settings = tests::awake_settings("default");
    return tests::Run(Simulation(build_scene(scene, settings), settings));
}

// A plate on four arms with wheels that touch its sides, springs from the arms to the plate, and a load that falls
// on it.
SceneDescription cart(double load, double speed, double radius) {
    SceneDescription scene;
    scene.name = "cart";
    scene.contacts = true;
    scene.gravity = {0, -9.81, 0};
    const auto box = [&](const char* name, const Vector3& size, double mass, const Vector3& position) {
        scene.bodies.push_back(
            {.name = name, .shape = BoxShape{size}, .mass = mass, .position = position, .friction = 0.5});
    };
    const double height = radius + 0.25;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .friction = 0.5});
    box("plate", {2, 0.3, 1}, 5, {0, height, 0});
    box("load", {0.5, 1.5, 0.5}, load, {0, height + 1.0, 0});
    scene.bodies.back().velocity = {0, -speed, 0};
    int number = 0;
    for (const double x : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) {
            const std::string arm = "arm " + std::to_string(number), wheel = "wheel " + std::to_string(number);
            ++number;
            const double out = 0.5 + radius;
            box(arm.c_str(), {0.5, 0.1, 0.1}, 0.3, {0.48 * x, radius, 0.6 * z});
            scene.bodies.push_back({.name = wheel,
                                    .shape = SphereShape{radius},
                                    .mass = 0.2,
                                    .position = {0.73 * x, radius, out * z},
                                    .friction = 0.8});
            const Vector3 inner(-0.25 * x, 0, 0), outer(0.25 * x, 0, 0);
            const HingeDescription free{.axis = Vector3::UnitZ()};
            HingeDescription limited = free;
            limited.limits = engine::AngleLimits{-0.6, 0.6};
            scene.joints.push_back({.a = {.body = "plate", .point = {0.23 * x, -0.25, 0.6 * z}},
                                    .b = {.body = arm, .point = inner},
                                    .hinge = limited});
            scene.joints.push_back({.a = {.body = arm, .point = outer + Vector3(0, 0, (out - 0.6) * z)},
                                    .b = {.body = wheel},
                                    .hinge = free});
            scene.distances.push_back({.a = {.body = "plate", .point = {0.73 * x, 0.15, 0.6 * z}},
                                       .b = {.body = arm, .point = outer},
                                       .spring = engine::Spring{.stiffness = 2000, .damping = 50}});
        }
    }
    return scene;
}

// Of all forces that keep the bodies together those of least norm, with rows of unit length: -A^+ (J M^-1 t +
// dJ/dt v), t being the torque of the spin and A = J M^-1 J^T.
Eigen::VectorXd least_forces(const engine::World& world, std::span<const engine::Joint> joints) {
    const auto rows = world.rows();
    const auto count = static_cast<Eigen::Index>(rows.size()), bodies = std::ssize(world.bodies);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(count, 6 * bodies), weighted = jacobian;
    Eigen::VectorXd asked = Eigen::VectorXd::Zero(count);
    for (Eigen::Index j = 0; j < count; ++j) {
        const engine::ConstraintRow& row = rows[static_cast<std::size_t>(j)];
        const engine::Joint& joint = joints[static_cast<std::size_t>(row.label.point)];
        const auto spin_of = [&](int number) {
            return angular_velocity(world.bodies[static_cast<std::size_t>(number)]);
        };
        if (row.jacobian.b.head<3>().isZero(0.0))  // an axis of the hinge
            asked[j] = row.jacobian.b.tail<3>().dot(spin_of(row.body_b).cross(spin_of(row.body_a)));
        for (const bool first : {true, false}) {
            const int number = first ? row.body_a : row.body_b;
            const engine::Vector6& axis = first ? row.jacobian.a : row.jacobian.b;
            const engine::Body& body = world.bodies[static_cast<std::size_t>(number)];
            const Vector3 spin = spin_of(number);
            const Vector3 arm = body.orientation * (first ? joint.point_a : joint.point_b);
            const engine::Matrix3 inertia = world_inverse_inertia(body);
            jacobian.block<1, 6>(j, 6 * number) = axis.transpose();
            weighted.block<1, 3>(j, 6 * number) = body.inverse_mass * axis.head<3>().transpose();
            weighted.block<1, 3>(j, 6 * number + 3) = axis.tail<3>().transpose() * inertia;
            asked[j] += axis.head<3>().dot(spin.cross(spin.cross(arm)));
            asked[j] -= (inertia * axis.tail<3>()).dot(spin.cross(body.angular_momentum));
        }
    }
    const Eigen::MatrixXd a = weighted * jacobian.transpose();
    const Eigen::VectorXd unit = a.diagonal().cwiseSqrt().cwiseInverse();
    return -(unit.asDiagonal() *
             tests::least_solution(unit.asDiagonal() * a * unit.asDiagonal(), unit.asDiagonal() * asked, 1e-4));
}

}  // namespace

TEST_CASE("wheels that touch their cart do not jam it, however hard a load hits it") {
    tests::Random random(7);
    for (const double load : {2.0, 20.0, 200.0}) {
        for (int trial = 0; trial < 3; ++trial) {
            const SceneDescription scene = cart(load, random.in(1.0, 5.0), random.in(0.2, 0.4));
            tests::Run run = run_of(scene);
            run.advance(4.0);
            INFO(load << " kg, trial " << trial << ", mean substeps " << run.measurements.substeps().mean());
            CHECK(run.measurements.energy_gain() < 0.01 * run.measurements.initial_energy());
            CHECK(tests::largest_joint_force(*run.simulation.scene().joints) < 9.81 * (load + 7.0));
            CHECK(run.measurements.substeps().largest < 60);
        }
    }
}

TEST_CASE("an arm that lies on its own frame rests there, not in it") {
    for (const double mass : {1.0, 100.0}) {
        SceneDescription scene = on_the_ground();
        add_box(scene, {3, 0.1, 0.5}, 5, {0, 0.05, 0});        // base
        add_box(scene, {0.1, 0.5, 0.5}, 1, {-1, 0.35, 0});     // post
        add_box(scene, {0.1, 0.45, 0.5}, 1, {1, 0.325, 0});    // stand
        add_box(scene, {2.3, 0.1, 0.4}, mass, {0.1, 0.6, 0});  // arm
        scene.joints = {hinge(1, {-1, 0.05, 0}, 2, {0, -0.25, 0}, true),
                        hinge(1, {1, 0.05, 0}, 3, {0, -0.225, 0}, true),
                        hinge(2, {0, 0.25, 0}, 4, {-1.1, 0, 0}, false)};
        tests::Run run = run_of(scene);
        run.advance(5.0);
        INFO("arm of " << mass << " kg");
        CHECK(run.measurements.max_penetration() < 1e-5);
        CHECK(engine::kinetic_energy(run.simulation.scene().world.bodies) < 1e-10);
    }
}

// Its loop is closed by contacts alone. Small steps leave 34 of the steps unsolved.
TEST_CASE("an arm that lies flat on a light frame is solved in each step, and stays") {
    SceneDescription scene = on_the_ground();
    add_box(scene, {2, 0.2, 0.6}, 7, {0, 0.1, 0});        // frame
    add_box(scene, {0.2, 0.6, 0.6}, 7, {-1.1, 0.3, 0});   // post
    add_box(scene, {1.6, 0.2, 0.4}, 100, {0.1, 0.3, 0});  // arm
    scene.joints = {hinge(1, {-1, 0.2, 0}, 2, {0.1, 0, 0}, true), hinge(2, {0.1, 0, 0}, 3, {-1.1, 0, 0}, false)};
    tests::Run run = run_of(scene);
    run.advance(5.0);
    CHECK(run.measurements.unsolved().count == 0);
    CHECK((run.simulation.scene().world.bodies[3].position - Vector3(0.1, 0.3, 0)).norm() < 2e-5);
}

TEST_CASE("joints of a ring that turns freely have the least forces that hold it together") {
    tests::Random random(6);
    for (int trial = 0; trial < 8; ++trial) {
        SceneDescription scene = ring(3 + trial / 2, random.in(0.5, 1.4), trial % 2 == 1);
        const Vector3 spin = random.in(1.0, 4.0) * random.vector(-1.0, 1.0).normalized();
        const Quaternion turn = random.rotation();
        for (BodyDescription& body : scene.bodies) {
            body.position = turn * body.position;
            body.orientation = turn * body.orientation;
            body.velocity = spin.cross(body.position);
            body.angular_velocity = spin;
        }
        const Settings settings = tests::awake_settings("default");
        Simulation run(build_scene(scene, settings), settings);
        const engine::JointConstraints& joints = *run.scene().joints;
        std::vector<double> ratios;  // of norms
        for (int n = 0; n < 180; ++n) {
            run.advance();
            double squared = 0.0;
            for (const engine::JointForce& force : joints.forces()) {
                for (const engine::Lambda& of_row : force) squared += of_row.last * of_row.last;
            }
            ratios.push_back(std::sqrt(squared) / least_forces(run.scene().world, joints.joints()).norm());
        }
        INFO(scene.joints.size() << " bars, trial " << trial);
        std::sort(ratios.begin(), ratios.end());
        CHECK(ratios[90] == Approx(1.0).epsilon(0.01));
        CHECK(ratios[170] < 1.2);
    }
}

// Four slender bars of mass m, with the joints d from the middle, begin to turn about any axis; w_1 and w_2 are
// along the diagonals. Momentum of two bars that meet at a joint, and moment about their middles, give its force in
// the plane: m d / 2 times the norm of (w_1 w_2, w_3^2 + (w_1^2 + w_2^2) / 2), and nothing across the plane. The
// second step has half more, because the first goes straight on.
TEST_CASE("joints of a square that begins to turn freely have the force that its bars need") {
    tests::Random random(8);
    for (int trial = 0; trial < 6; ++trial) {
        SceneDescription scene = ring(4, random.in(1.2, 2.0), false);
        for (BodyDescription& body : scene.bodies) {
            BoxShape& box = std::get<BoxShape>(body.shape);
            box.size.y() = box.size.z() = 0.02 * box.size.x();
        }
        const Vector3 spin = random.in(1.0, 4.0) * random.vector(-1.0, 1.0).normalized();
        for (BodyDescription& body : scene.bodies) {
            body.velocity = spin.cross(body.position);
            body.angular_velocity = spin;
        }
        Settings settings = tests::awake_settings("default");
        settings.substeps = 8;
        Simulation run(build_scene(scene, settings), settings);
        run.advance();
        const double from_middle = scene.bodies[0].position.norm() * std::numbers::sqrt2;
        const double along = spin.z() * spin.z() + 0.5 * spin.head<2>().squaredNorm();
        const double expected = 0.5 * from_middle * std::hypot(along, spin.x() * spin.y());
        for (const engine::JointForce& force : run.scene().joints->forces()) {
            CHECK(Vector3(force[0].last, force[1].last, force[2].last).norm() == Approx(expected).epsilon(0.01));
        }
    }
}

TEST_CASE("a door with one, two and three hinges opens alike, and three share its weight") {
    std::vector<double> angles;
    for (const int hinges : {1, 2, 3}) {
        SceneDescription scene;
        scene.name = "door";
        scene.gravity = {0, -10, 0};
        scene.bodies.push_back({.name = "0",
                                .shape = BoxShape{{1, 2, 0.1}},
                                .mass = 20.0,
                                .position = {0.5, 0, 0},
                                .velocity = {0, 0, -0.5},
                                .angular_velocity = {0, 1, 0}});
        for (int k = 0; k < hinges; ++k) {
            const double height = hinges == 1 ? 0.0 : -0.8 + 1.6 * k / (hinges - 1);
            JointDescription joint{.a = {.body = "world", .point = {0, height, 0}},
                                   .b = {.body = "0", .point = {-0.5, height, 0}}};
            joint.hinge = HingeDescription{.axis = Vector3::UnitY()};
            scene.joints.push_back(joint);
        }
        const Settings settings = tests::awake_settings("default");
        Simulation run(build_scene(scene, settings), settings);
        tests::advance(run, 1.0);
        angles.push_back(angle_of(run.scene().joints->joints()[0], run.scene().world.bodies));
        double carried = 0.0;
        for (const engine::JointForce& force : run.scene().joints->forces()) {
            CHECK(force[1].last == Approx(200.0 / hinges).epsilon(0.01));
            carried += force[1].last;
        }
        CHECK(carried == Approx(200.0).epsilon(1e-3));
    }
    CHECK(angles[0] == Approx(1.0).epsilon(1e-3));
    CHECK(angles[1] == Approx(angles[0]).epsilon(1e-4));
    CHECK(angles[2] == Approx(angles[0]).epsilon(1e-4));
}
