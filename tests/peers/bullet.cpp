// Bullet, double precision. It has no joint that keeps two points at a distance: a link is a point-to-point joint
// at the end of an arm that is fixed to the lower body.
#include "tests/peers/engine.h"

#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace pushfactor::tests::peers {

namespace {

struct BulletOptions {
    bool sleeping = false;
    bool multipoint = true;  // all points of a box on a plane at once; as shipped one more per step
    bool direct = false;     // the MLCP solver with Dantzig's method instead of sequential impulses
    bool swept = false;      // continuous collision detection for spheres
    int iterations = 10;
    int substeps = 1;
};

btVector3 to_bullet(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}

Vector3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

btTransform place(const State& s) {
    const Quaternion& q = s.orientation;
    return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(s.position));
}

std::unique_ptr<btCollisionShape> shape_of(const Body& body) {
    switch (body.shape) {
        case Shape::plane:
            return std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), 0.0);
        case Shape::box:
            return std::make_unique<btBoxShape>(to_bullet(0.5 * body.size));
        case Shape::sphere:
            break;
    }
    return std::make_unique<btSphereShape>(body.radius);
}

std::unique_ptr<btConstraintSolver> solver(btMLCPSolverInterface* direct) {
    if (direct != nullptr) return std::make_unique<btMLCPSolver>(direct);
    return std::make_unique<btSequentialImpulseConstraintSolver>();
}

class BulletWorld : public World {
  public:
    BulletWorld(const Scene& scene, const BulletOptions& options)
        : options_(options),
          step_(scene.step),
          dispatcher_(&configuration_),
          solver_(solver(options.direct ? &direct_ : nullptr)),
          world_(&dispatcher_, &broadphase_, solver_.get(), &configuration_) {
        if (options.multipoint) configuration_.setPlaneConvexMultipointIterations();
        world_.setGravity(to_bullet(scene.gravity));
        world_.getSolverInfo().m_numIterations = options.iterations;
        if (options.direct) {
            world_.getSolverInfo().m_minimumSolverBatchSize =
                1;  // separate islands: it solves one dense matrix each
            // Four points of a face make the matrix singular; without this it falls back to a few sweeps.
            world_.getSolverInfo().m_globalCfm = 1e-7;
        }
        for (const Body& body : scene.fixed) add(body, 0.0, scene.contacts);
        first_ = bodies_.size();
        for (const Body& body : scene.movable) add(body, body.mass, scene.contacts);
        for (const Link& link : scene.links) add_link(link, starts(scene));
    }

    ~BulletWorld() override {
        for (const auto& joint : joints_) world_.removeConstraint(joint.get());
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }

    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    void step() override {
        for (int i = 0; i < options_.substeps; ++i) world_.stepSimulation(step_ / options_.substeps, 0);
    }

    std::vector<State> states() const override {
        std::vector<State> result;
        for (std::size_t i = first_; i < bodies_.size(); ++i) {
            const btRigidBody& body = *bodies_[i];
            const btQuaternion q = body.getWorldTransform().getRotation();
            result.push_back({from_bullet(body.getWorldTransform().getOrigin()),
                              Quaternion(q.w(), q.x(), q.y(), q.z()), from_bullet(body.getLinearVelocity()),
                              from_bullet(body.getAngularVelocity())});
        }
        return result;
    }

  private:
    void add(const Body& body, double mass, bool collides) {
        shapes_.push_back(shape_of(body));
        btVector3 moments(0, 0, 0);
        if (mass > 0.0) moments = to_bullet(inertia(body));
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shapes_.back().get(), moments);
        info.m_startWorldTransform = place(body.start);
        info.m_friction = std::sqrt(body.friction);  // Bullet multiplies
        info.m_restitution = std::sqrt(body.restitution);
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody& added = *bodies_.back();
        added.setLinearVelocity(to_bullet(body.start.velocity));
        added.setAngularVelocity(to_bullet(body.start.angular_velocity));
        if (!options_.sleeping) added.setActivationState(DISABLE_DEACTIVATION);
        if (options_.swept && mass > 0.0) {
            added.setCcdMotionThreshold(body.radius);
            added.setCcdSweptSphereRadius(0.5 * body.radius);
        }
        if (collides) {
            world_.addRigidBody(&added);
        } else {
            world_.addRigidBody(&added, 0, 0);
        }
    }

    void add_link(const Link& link, const std::vector<State>& states) {
        btRigidBody& b = *bodies_[first_ + static_cast<std::size_t>(link.b)];
        const State& of_b = states[static_cast<std::size_t>(link.b)];
        const Vector3 on_a = end_a(link, states);
        const btVector3 arm = to_bullet(of_b.orientation.conjugate() * (on_a - of_b.position));
        btTransform at_b = btTransform::getIdentity(), at_a = btTransform::getIdentity();
        at_b.setOrigin(arm);
        at_a.setOrigin(to_bullet(link.point_a));
        btRigidBody& a = link.a < 0 ? space_ : *bodies_[first_ + static_cast<std::size_t>(link.a)];
        auto joint = std::make_unique<btGeneric6DofConstraint>(b, a, at_b, at_a, true);
        joint->setLinearLowerLimit({0, 0, 0});
        joint->setLinearUpperLimit({0, 0, 0});
        joint->setAngularLowerLimit({1, 1, 1});  // above the upper ones: free
        joint->setAngularUpperLimit({-1, -1, -1});
        joints_.push_back(std::move(joint));
        world_.addConstraint(joints_.back().get(), true);
    }

    BulletOptions options_;
    double step_;  // s
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btRigidBody space_{0.0, nullptr, nullptr};  // links to the world are attached to this
    btDantzigSolver direct_;
    std::unique_ptr<btConstraintSolver> solver_;
    btDiscreteDynamicsWorld world_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;  // the fixed ones first
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
    std::size_t first_ = 0;  // movable body in bodies_
};

Setting setting(const std::string& name, const std::vector<std::string>& cases, const BulletOptions& options) {
    Setting result;
    const int version = btGetVersion();
    result.engine = "Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100);
    result.name = name;
    result.cases = cases;
    result.joint = Joint::rigid_arm;
    result.substeps = options.substeps;
    result.build = [options](const Scene& scene) { return std::make_unique<BulletWorld>(scene, options); };
    return result;
}

Setting reference_for_piles(int iterations) {
    const std::string count = std::to_string(iterations);
    Setting result =
        setting("multipoint, never sleeps, " + count + " iterations", {"piles"}, {.iterations = iterations});
    result.reference = "Bullet " + count;
    return result;
}

}  // namespace

std::vector<Setting> bullet_settings() {
    return {
        setting("multipoint", {"tosses"}, {}),
        setting("as shipped, sleeps", {}, {.sleeping = true, .multipoint = false}),
        setting("multipoint, never sleeps",
                {"stack", "tower", "heavy", "chain", "chain-light", "wave", "parting", "funnel"}, {}),
        setting("multipoint, never sleeps, 100 iterations", {"stack", "tower", "chain", "chain-light", "parting"},
                {.iterations = 100}),
        setting("multipoint, never sleeps, 1000 iterations", {"heavy"}, {.iterations = 1000}),
        setting("multipoint, never sleeps, Dantzig, cfm 1e-7", {"stack", "tower", "heavy", "parting"},
                {.direct = true}),
        setting("multipoint, never sleeps, 4 substeps",
                {"stack", "tower", "heavy", "chain", "chain-light", "wave", "funnel", "free-box", "free-rod",
                 "parting"},
                {.substeps = 4}),
        setting("multipoint, 4 substeps", {"tosses"}, {.substeps = 4}),
        setting("continuous collision detection", {"plate-50", "plate-200"}, {.swept = true}),
        reference_for_piles(25),
        reference_for_piles(10),
    };
}

std::vector<Series> bullet_series() {
    const auto over = [](const std::string& name, const std::string& knob, const std::vector<int>& values,
                         const std::vector<std::string>& cases, auto options_at) {
        return Series{"Bullet, " + name, knob, values, cases,
                      [options_at](int value) { return setting("", {}, options_at(value)); }};
    };
    return {
        over("sweeps", "sweeps", {1, 2, 5, 10, 25, 50, 100, 250, 1000}, {"stack", "brick_wall", "pile_of_cubes"},
             [](int value) { return BulletOptions{.iterations = value}; }),
        over("small steps", "substeps", {1, 2, 4, 8, 16, 32, 64},
             {"stack", "brick_wall", "pile_of_cubes", "pendulum-wave", "chain"},
             [](int value) { return BulletOptions{.substeps = value}; }),
        over("Dantzig", "substeps", {1, 2, 4, 8}, {"stack"},
             [](int value) { return BulletOptions{.direct = true, .substeps = value}; }),
    };
}

}  // namespace pushfactor::tests::peers
