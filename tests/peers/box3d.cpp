// Box3D, single precision. It has no planes: a plane is the upper face of a wide fixed box.
#include "tests/peers/engine.h"

#include <box3d/box3d.h>
#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::tests::peers {

namespace {

constexpr int substeps = 4;  // those of its documentation and its samples

b3Vec3 to_box3d(const Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

b3Quat to_box3d(const Quaternion& q) {
    return {to_box3d(Vector3(q.vec())), static_cast<float>(q.w())};
}

Vector3 from_box3d(const b3Vec3& v) {
    return {v.x, v.y, v.z};
}

b3MassData mass_of(const Body& body) {
    const b3Vec3 moments = to_box3d(inertia(body));
    b3MassData mass{};
    mass.mass = static_cast<float>(body.mass);
    mass.inertia.cx.x = moments.x;
    mass.inertia.cy.y = moments.y;
    mass.inertia.cz.z = moments.z;
    return mass;
}

// A ball around all movable bodies at the start.
struct Region {
    Vector3 centre = Vector3::Zero();
    double radius = 0.0;  // m
};

Region region_of(const Scene& scene) {
    Region region;
    for (const Body& body : scene.movable)
        region.centre += body.start.position / static_cast<double>(scene.movable.size());
    for (const Body& body : scene.movable)
        region.radius = std::max(region.radius, (body.start.position - region.centre).norm());
    return region;
}

class Box3dWorld : public World {
  public:
    explicit Box3dWorld(const Scene& scene)
        : step_(static_cast<float>(scene.step)), contacts_(scene.contacts), region_(region_of(scene)) {
        b3WorldDef definition = b3DefaultWorldDef();
        definition.gravity = to_box3d(scene.gravity);
        definition.enableSleep = false;
        definition.workerCount = 1;
        world_ = b3CreateWorld(&definition);
        const b3BodyDef fixed = b3DefaultBodyDef();
        space_ = b3CreateBody(world_, &fixed);
        for (const Body& body : scene.fixed) add(body, b3_staticBody);
        for (const Body& body : scene.movable) bodies_.push_back(add(body, b3_dynamicBody));
        for (const Link& link : scene.links) add_link(link);
    }

    ~Box3dWorld() override { b3DestroyWorld(world_); }

    Box3dWorld(const Box3dWorld&) = delete;
    Box3dWorld& operator=(const Box3dWorld&) = delete;

    void step() override { b3World_Step(world_, step_, substeps); }

    std::vector<State> states() const override {
        std::vector<State> result;
        for (const b3BodyId body : bodies_) {
            const b3Quat q = b3Body_GetRotation(body);
            result.push_back({from_box3d(b3Body_GetPosition(body)), Quaternion(q.s, q.v.x, q.v.y, q.v.z),
                              from_box3d(b3Body_GetLinearVelocity(body)),
                              from_box3d(b3Body_GetAngularVelocity(body))});
        }
        return result;
    }

  private:
    b3BodyId add(const Body& body, b3BodyType type) {
        b3BodyDef definition = b3DefaultBodyDef();
        definition.type = type;
        definition.position = to_box3d(body.start.position);
        definition.rotation = to_box3d(body.start.orientation);
        definition.linearVelocity = to_box3d(body.start.velocity);
        definition.angularVelocity = to_box3d(body.start.angular_velocity);
        const b3BodyId id = b3CreateBody(world_, &definition);
        add_shape(id, body);
        if (type == b3_dynamicBody) b3Body_SetMassData(id, mass_of(body));
        return id;
    }

    void add_shape(b3BodyId id, const Body& body) const {
        b3ShapeDef definition = b3DefaultShapeDef();
        definition.baseMaterial.friction = static_cast<float>(body.friction);
        definition.baseMaterial.restitution = static_cast<float>(body.restitution);
        if (!contacts_) definition.filter.maskBits = 0;
        if (body.shape == Shape::sphere) {
            const b3Sphere sphere{{0, 0, 0}, static_cast<float>(body.radius)};
            b3CreateSphereShape(id, &definition, &sphere);
            return;
        }
        const b3Vec3 half = to_box3d(0.5 * body.size);
        const b3BoxHull hull = body.shape == Shape::plane ? below(body) : b3MakeBoxHull(half.x, half.y, half.z);
        b3CreateHullShape(id, &definition, &hull.base);
    }

    // No larger than needed: the coordinates of its corners are rounded to single precision.
    b3BoxHull below(const Body& plane) const {
        constexpr double margin = 20.0, depth = 10.0;  // m
        Vector3 middle = plane.start.orientation.conjugate() * (region_.centre - plane.start.position);
        const auto half = static_cast<float>(region_.radius + middle.y() + margin);
        middle.y() = -depth;
        return b3MakeOffsetBoxHull(half, static_cast<float>(depth), half, to_box3d(middle));
    }

    void add_link(const Link& link) const {
        b3DistanceJointDef definition = b3DefaultDistanceJointDef();
        definition.base.bodyIdA = link.a < 0 ? space_ : bodies_[static_cast<std::size_t>(link.a)];
        definition.base.bodyIdB = bodies_[static_cast<std::size_t>(link.b)];
        definition.base.localFrameA.p = to_box3d(link.point_a);
        definition.base.localFrameB.p = to_box3d(link.point_b);
        definition.length = static_cast<float>(link.length);
        b3CreateDistanceJoint(world_, &definition);
    }

    float step_;  // s
    bool contacts_;
    Region region_;
    b3WorldId world_{};
    b3BodyId space_{};  // links to the world are attached to this
    std::vector<b3BodyId> bodies_;
};

Setting setting(const std::vector<std::string>& cases) {
    const b3Version version = b3GetVersion();
    Setting result;
    result.engine = fmt::format("Box3D {}.{}.{}", version.major, version.minor, version.revision);
    result.name = "as shipped with 4 substeps, never sleeps";
    result.cases = cases;
    result.substeps = substeps;
    result.build = [](const Scene& scene) { return std::make_unique<Box3dWorld>(scene); };
    return result;
}

}  // namespace

std::vector<Setting> box3d_settings() {
    return {setting({}), setting({"piles", "tosses"})};
}

std::vector<Series> box3d_series() {
    return {};
}

}  // namespace pushfactor::tests::peers
