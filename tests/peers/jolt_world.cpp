#include "tests/peers/jolt_world.h"

#include <Jolt/Jolt.h>
// Jolt.h has to come before its other headers.
#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/BroadPhase/ObjectVsBroadPhaseLayerFilterTable.h>
#include <Jolt/Physics/Collision/ObjectLayerPairFilterTable.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/PlaneShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Constraints/DistanceConstraint.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

namespace pushfactor::tests::peers {

namespace {

constexpr JPH::ObjectLayer fixed = 0, movable = 1;

JPH::Vec3 to_jolt(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

std::array<float, 3> from_jolt(JPH::Vec3Arg v) {
    return {v.GetX(), v.GetY(), v.GetZ()};
}

void register_types() {
    static const bool once = [] {
        JPH::RegisterDefaultAllocator();
        JPH::Factory::sInstance = new JPH::Factory();
        JPH::RegisterTypes();
        return true;
    }();
    static_cast<void>(once);
}

JPH::Ref<JPH::Shape> shape_of(const JoltBody& body) {
    switch (body.shape) {
        case JoltShape::plane:
            return new JPH::PlaneShape(JPH::Plane(JPH::Vec3::sAxisY(), 0.0F));
        case JoltShape::box:
            return new JPH::BoxShape(to_jolt(body.half_edges));
        case JoltShape::sphere:
            break;
    }
    return new JPH::SphereShape(body.radius);
}

JPH::BodyCreationSettings settings_of(const JoltBody& body) {
    const bool moves = body.mass > 0.0F;
    const JoltState& s = body.start;
    const JPH::Ref<JPH::Shape> shape = shape_of(body);
    JPH::BodyCreationSettings settings(
        shape.GetPtr(), to_jolt(s.position),
        JPH::Quat(s.orientation[0], s.orientation[1], s.orientation[2], s.orientation[3]),
        moves ? JPH::EMotionType::Dynamic : JPH::EMotionType::Static, moves ? movable : fixed);
    settings.mFriction = body.friction;
    settings.mRestitution = body.restitution;
    settings.mAllowSleeping = false;
    settings.mLinearDamping = settings.mAngularDamping = 0.0F;
    if (!moves) return settings;
    settings.mLinearVelocity = to_jolt(s.velocity);
    settings.mAngularVelocity = to_jolt(s.angular_velocity);
    settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = body.mass;
    settings.mMassPropertiesOverride.mInertia = JPH::Mat44::sScale(to_jolt(body.moments));
    return settings;
}

}  // namespace

struct JoltWorld::Inside {
    explicit Inside(const JoltScene& scene) : step(scene.step), pairs(2) {
        layers.MapObjectToBroadPhaseLayer(fixed, JPH::BroadPhaseLayer(0));
        layers.MapObjectToBroadPhaseLayer(movable, JPH::BroadPhaseLayer(1));
        if (scene.contacts) {
            pairs.EnableCollision(fixed, movable);
            pairs.EnableCollision(movable, movable);
        }
        filter = std::make_unique<JPH::ObjectVsBroadPhaseLayerFilterTable>(layers, 2, pairs, 2);
        // Far more than any case needs; step() reports when it is not.
        const auto count = static_cast<JPH::uint>(scene.bodies.size());
        system.Init(count + 16, 0, 64 * count + 1024, 32 * count + 1024, layers, *filter, pairs);
        system.SetGravity(to_jolt(scene.gravity));
        for (const JoltBody& body : scene.bodies) add(body);
        for (const JoltLink& link : scene.links) add(link);
        system.OptimizeBroadPhase();
    }

    void add(const JoltBody& body) {
        JPH::Body* const added = system.GetBodyInterface().CreateBody(settings_of(body));
        system.GetBodyInterface().AddBody(added->GetID(), JPH::EActivation::Activate);
        bodies.push_back(added);
    }

    void add(const JoltLink& link) {
        JPH::DistanceConstraintSettings settings;
        settings.mSpace = JPH::EConstraintSpace::LocalToBodyCOM;
        settings.mPoint1 = to_jolt(link.point_a);
        settings.mPoint2 = to_jolt(link.point_b);
        settings.mMinDistance = settings.mMaxDistance = link.length;
        JPH::Body& a = link.a < 0 ? JPH::Body::sFixedToWorld : *bodies[static_cast<std::size_t>(link.a)];
        system.AddConstraint(settings.Create(a, *bodies[static_cast<std::size_t>(link.b)]));
    }

    float step;  // s
    JPH::BroadPhaseLayerInterfaceTable layers{2, 2};
    JPH::ObjectLayerPairFilterTable pairs;
    std::unique_ptr<JPH::ObjectVsBroadPhaseLayerFilterTable> filter;
    JPH::TempAllocatorImplWithMallocFallback memory{64 * 1024 * 1024};
    JPH::JobSystemSingleThreaded jobs{JPH::cMaxPhysicsJobs};
    JPH::PhysicsSystem system;
    std::vector<JPH::Body*> bodies;  // of the system
};

JoltWorld::JoltWorld(const JoltScene& scene) {
    register_types();
    inside_ = std::make_unique<Inside>(scene);
}

JoltWorld::~JoltWorld() = default;

bool JoltWorld::step() {
    return inside_->system.Update(inside_->step, 1, &inside_->memory, &inside_->jobs) ==
           JPH::EPhysicsUpdateError::None;
}

JoltState JoltWorld::state(std::size_t body) const {
    const JPH::Body& of = *inside_->bodies[body];
    const JPH::Quat q = of.GetRotation();
    return {from_jolt(of.GetPosition()),
            {q.GetX(), q.GetY(), q.GetZ(), q.GetW()},
            from_jolt(of.GetLinearVelocity()),
            from_jolt(of.GetAngularVelocity())};
}

std::string jolt_version() {
    return std::to_string(JPH_VERSION_MAJOR) + "." + std::to_string(JPH_VERSION_MINOR) + "." +
           std::to_string(JPH_VERSION_PATCH);
}

}  // namespace pushfactor::tests::peers
