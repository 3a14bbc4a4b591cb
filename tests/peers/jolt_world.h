// Jolt behind plain numbers. What includes its headers is compiled for its instruction set, with which Eigen's
// types would have another alignment than in the rest of the program: no Eigen here.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace pushfactor::tests::peers {

struct JoltState {
    std::array<float, 3> position{};
    std::array<float, 4> orientation{0, 0, 0, 1};  // x, y, z, w
    std::array<float, 3> velocity{}, angular_velocity{};
};

enum class JoltShape { plane, box, sphere };  // a plane's normal is the body's y axis

struct JoltBody {
    JoltShape shape = JoltShape::sphere;
    std::array<float, 3> half_edges{};  // of a box, m
    float radius = 0.0F;                // of a sphere, m
    float mass = 0.0F;                  // kg; zero: fixed
    std::array<float, 3> moments{};     // kg m^2, about the body's axes
    float friction = 0.0F, restitution = 0.0F;
    JoltState start;
};

struct JoltLink {
    int a = -1;  // place in JoltScene::bodies, or -1: the world
    int b = -1;
    std::array<float, 3> point_a{}, point_b{};  // body frame, m
    float length = 0.0F;                        // m
};

// Linked bodies would collide: no case has both links and contacts.
struct JoltScene {
    std::array<float, 3> gravity{};  // m/s^2
    std::vector<JoltBody> bodies;
    std::vector<JoltLink> links;
    bool contacts = false;
    float step = 0.0F;  // s
};

class JoltWorld {
  public:
    explicit JoltWorld(const JoltScene& scene);
    ~JoltWorld();
    JoltWorld(const JoltWorld&) = delete;
    JoltWorld& operator=(const JoltWorld&) = delete;

    // False where it had no room for all contacts and has left some out.
    bool step();

    JoltState state(std::size_t body) const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

std::string jolt_version();

}  // namespace pushfactor::tests::peers
