// Open Dynamics Engine. Its distance joint (double ball) is the same constraint as ours.
#include "tests/peers/engine.h"

#include <ode/ode.h>

#include <array>
#include <cmath>

namespace pushfactor::tests::peers {

namespace {

struct OdeOptions {
    bool quick = false;   // dWorldQuickStep instead of dWorldStep
    int iterations = 20;  // of dWorldQuickStep; as shipped
    int substeps = 1;
    double cfm = 1e-10;                      // as shipped
    double surface_layer = 0.0;              // m
    double correcting_velocity = dInfinity;  // m/s
};

void quiet(int, const char*, va_list) {}

// As often as one likes.
void start_quietly() {
    dInitODE2(0);
    dSetMessageHandler(quiet);
    dSetErrorHandler(quiet);
}

// Of a geometry.
struct Surface {
    double friction = 0.0, restitution = 0.0;
};

class OdeWorld : public World {
  public:
    OdeWorld(const Scene& scene, const OdeOptions& options) : options_(options), step_(scene.step) {
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
        dWorldSetGravity(world_, scene.gravity.x(), scene.gravity.y(), scene.gravity.z());
        dWorldSetQuickStepNumIterations(world_, options.iterations);
        dWorldSetCFM(world_, options.cfm);
        dWorldSetContactSurfaceLayer(world_, options.surface_layer);
        dWorldSetContactMaxCorrectingVel(world_, options.correcting_velocity);
        surfaces_.reserve(scene.fixed.size() + scene.movable.size());
        if (scene.contacts) {
            for (const Body& body : scene.fixed) add_fixed(body);
        }
        for (const Body& body : scene.movable) add_movable(body, scene.contacts);
        for (const Link& link : scene.links) add_link(link, starts(scene));
    }

    ~OdeWorld() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }

    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    void step() override {
        for (int i = 0; i < options_.substeps; ++i) {
            dSpaceCollide(space_, this, &OdeWorld::near);
            if (options_.quick) {
                dWorldQuickStep(world_, step_ / options_.substeps);
            } else {
                dWorldStep(world_, step_ / options_.substeps);
            }
            dJointGroupEmpty(contacts_);
        }
    }

    std::vector<State> states() const override {
        std::vector<State> result;
        for (dBodyID body : bodies_) {
            const dReal* x = dBodyGetPosition(body);
            const dReal* q = dBodyGetQuaternion(body);
            const dReal* v = dBodyGetLinearVel(body);
            const dReal* w = dBodyGetAngularVel(body);
            result.push_back(
                {{x[0], x[1], x[2]}, Quaternion(q[0], q[1], q[2], q[3]), {v[0], v[1], v[2]}, {w[0], w[1], w[2]}});
        }
        return result;
    }

  private:
    void add_fixed(const Body& body) {
        const Vector3& x = body.start.position;
        if (body.shape == Shape::plane) {
            const Vector3 n = body.start.orientation * Vector3::UnitY();
            remember(dCreatePlane(space_, n.x(), n.y(), n.z(), n.dot(x)), body);
            return;
        }
        const dGeomID geom = shape_of(body);
        dGeomSetPosition(geom, x.x(), x.y(), x.z());
        remember(geom, body);
    }

    void add_movable(const Body& body, bool collides) {
        dMass mass;
        const Vector3 moments = inertia(body);
        dMassSetParameters(&mass, body.mass, 0, 0, 0, moments.x(), moments.y(), moments.z(), 0, 0, 0);
        const dBodyID id = dBodyCreate(world_);
        dBodySetMass(id, &mass);
        const State& s = body.start;
        const std::array<dReal, 4> q{s.orientation.w(), s.orientation.x(), s.orientation.y(), s.orientation.z()};
        dBodySetPosition(id, s.position.x(), s.position.y(), s.position.z());
        dBodySetQuaternion(id, q.data());
        dBodySetLinearVel(id, s.velocity.x(), s.velocity.y(), s.velocity.z());
        dBodySetAngularVel(id, s.angular_velocity.x(), s.angular_velocity.y(), s.angular_velocity.z());
        bodies_.push_back(id);
        if (!collides) return;
        const dGeomID geom = shape_of(body);
        dGeomSetBody(geom, id);
        remember(geom, body);
    }

    dGeomID shape_of(const Body& body) {
        return body.shape == Shape::box ? dCreateBox(space_, body.size.x(), body.size.y(), body.size.z())
                                        : dCreateSphere(space_, body.radius);
    }

    void remember(dGeomID geom, const Body& body) {
        surfaces_.push_back({body.friction, body.restitution});
        dGeomSetData(geom, &surfaces_.back());
    }

    void add_link(const Link& link, const std::vector<State>& states) {
        const dJointID joint = dJointCreateDBall(world_, nullptr);
        const dBodyID a = link.a < 0 ? nullptr : bodies_[static_cast<std::size_t>(link.a)];
        dJointAttach(joint, bodies_[static_cast<std::size_t>(link.b)], a);
        const Vector3 on_b = end_b(link, states);
        const Vector3 on_a = end_a(link, states);
        dJointSetDBallAnchor1(joint, on_b.x(), on_b.y(), on_b.z());
        dJointSetDBallAnchor2(joint, on_a.x(), on_a.y(), on_a.z());
        dJointSetDBallDistance(joint, link.length);
    }

    static void near(void* self, dGeomID a, dGeomID b) {
        const dBodyID body_a = dGeomGetBody(a);
        const dBodyID body_b = dGeomGetBody(b);
        if (body_a == nullptr && body_b == nullptr) return;
        const auto* world = static_cast<OdeWorld*>(self);
        std::array<dContact, 8> contacts;
        const int count = dCollide(a, b, static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
        const auto &of_a = *static_cast<Surface*>(dGeomGetData(a)), &of_b = *static_cast<Surface*>(dGeomGetData(b));
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            contacts[i].surface = {};
            contacts[i].surface.mode = dContactApprox1;  // else mu is a force in N
            contacts[i].surface.mu = std::sqrt(of_a.friction * of_b.friction);
            if (of_a.restitution > 0.0) {
                contacts[i].surface.mode |= dContactBounce;
                contacts[i].surface.bounce = of_a.restitution;
            }
            dJointAttach(dJointCreateContact(world->world_, world->contacts_, &contacts[i]), body_a, body_b);
        }
    }

    OdeOptions options_;
    double step_;  // s
    dWorldID world_ = nullptr;
    dSpaceID space_ = nullptr;
    dJointGroupID contacts_ = nullptr;
    std::vector<dBodyID> bodies_;
    std::vector<Surface> surfaces_;  // never grows beyond what was reserved: the geometries point into it
};

Setting setting(const std::string& name, const std::vector<std::string>& cases, const OdeOptions& options) {
    Setting result;
    result.engine = "ODE " PEERS_ODE_VERSION;
    result.name = name;
    result.cases = cases;
    result.substeps = options.substeps;
    result.build = [options](const Scene& scene) { return std::make_unique<OdeWorld>(scene, options); };
    return result;
}

}  // namespace

std::vector<Series> ode_series() {
    start_quietly();
    const auto over = [](const std::string& name, const std::string& knob, const std::vector<int>& values,
                         const std::vector<std::string>& cases, auto options_at) {
        return Series{"ODE, " + name, knob, values, cases,
                      [options_at](int value) { return setting("", {}, options_at(value)); }};
    };
    return {
        over("quick step", "sweeps", {1, 2, 5, 10, 20, 50, 100, 250, 1000},
             {"stack", "brick_wall", "pile_of_cubes"},
             [](int value) { return OdeOptions{.quick = true, .iterations = value}; }),
        over("step", "substeps", {1, 2, 4, 8, 16, 32, 64}, {"stack", "pendulum-wave", "chain"},
             [](int value) { return OdeOptions{.substeps = value}; }),
        // One dense matrix for all contacts: more steps take minutes.
        over("step", "substeps", {1, 2}, {"brick_wall", "pile_of_cubes"},
             [](int value) { return OdeOptions{.substeps = value}; }),
    };
}

std::vector<Setting> ode_settings() {
    start_quietly();
    return {
        setting("dWorldStep", {}, {}),
        setting("dWorldStep", {"tosses"}, {}),
        setting("dWorldStep, 4 substeps", {"tosses"}, {.substeps = 4}),
        setting("dWorldQuickStep, 20 iterations",
                {"stack", "tower", "heavy", "chain", "chain-light", "wave", "parting", "funnel"}, {.quick = true}),
        setting("dWorldStep, surface layer 1 mm, correction up to 1 m/s", {"stack", "tower", "heavy", "parting"},
                {.surface_layer = 0.001, .correcting_velocity = 1.0}),
        // Its manual's remedy where four points of a face make the matrix singular.
        setting("dWorldStep, cfm 1e-5", {"stack", "tower", "heavy", "parting"}, {.cfm = 1e-5}),
        setting("dWorldStep, 4 substeps",
                {"stack", "chain", "chain-light", "wave", "funnel", "free-box", "free-rod", "plate-50"},
                {.substeps = 4}),
    };
}

}  // namespace pushfactor::tests::peers
