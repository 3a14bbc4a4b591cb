// Thin bodies that stand, lean or fall over.
#include "demos/scenes/families/pieces.h"

#include <cmath>

namespace pushfactor::demos::families {

namespace {

using engine::Vector3;

// Pairs of leaning cards with floors across their upper ends, each storey with one pair less.
Prospect describe_card_house(const ParameterValues& values, Random&) {
    constexpr double lean = 0.2, height = 1.0, depth = 0.6, mass = 0.1;  // rad, m, m, kg
    constexpr double floor = 1.0, pitch = 1.01;  // m: length of a floor, distance between tops
    const double thickness = height / values.number("slenderness");
    // Half of the space that a leaning card takes.
    const double beside = 0.5 * (height * elementary::sin(lean) + thickness * elementary::cos(lean));
    const double above = 0.5 * (height * elementary::cos(lean) + thickness * elementary::sin(lean));
    const int storeys = values.whole("storeys");
    SceneDescription scene = on_ground(values);
    for (int k = 0; k < storeys; ++k) {
        const std::string storey = "storey " + std::to_string(k + 1);
        const double ground = k * (2.0 * above + thickness);
        for (int i = 0; i < storeys - k; ++i) {
            const double top = (i - 0.5 * (storeys - k - 1)) * pitch;
            for (const int side : {-1, 1}) {
                add_body(scene, storey + (side < 0 ? " left " : " right ") + std::to_string(i + 1),
                         BoxShape{{thickness, height, depth}}, mass, {top + side * beside, ground + above, 0})
                    .orientation = inclined(side * lean);
            }
            if (i == 0) continue;
            add_body(scene, storey + " floor " + std::to_string(i), BoxShape{{floor, thickness, depth}}, mass,
                     {top - 0.5 * pitch, ground + 2.0 * above + 0.5 * thickness, 0});
        }
    }
    return standing(std::move(scene));
}

// The first one rotates about its lower front edge, with 1.5 times the energy that takes it past its balance.
Prospect describe_dominoes(const ParameterValues& values, Random&) {
    constexpr double height = 1.0, depth = 0.5;  // m
    const double thickness = values.number("thickness");
    Prospect prospect{.scene = on_ground(values), .ends = Ends::topples, .rest_by = 0.0};
    const int count = values.whole("count");
    for (int i = 0; i < count; ++i) {
        const std::string name = "domino " + std::to_string(i + 1);
        add_body(prospect.scene, name, BoxShape{{thickness, height, depth}}, 1.0,
                 {i * values.number("spacing"), 0.5 * height, 0});
        prospect.leaving.push_back(name);
    }
    const double diagonal = elementary::hypot(height, thickness);
    const double climb = 0.5 * (diagonal - height);    // m, of its centre
    const double inertia = diagonal * diagonal / 3.0;  // m^2, about the edge, of 1 kg
    BodyDescription& first = prospect.scene.bodies[1];
    first.angular_velocity = Vector3(0, 0, -std::sqrt(1.5 * 2.0 * gravity * climb / inertia));
    first.velocity = first.angular_velocity.cross(Vector3(-0.5 * thickness, 0.5 * height, 0));
    prospect.rest_by = 5.0 + 0.3 * count;
    look_at_all(prospect.scene);
    return prospect;
}

// A slab of length l and thickness t leans by phi against a wall and touches ground and wall with the edges of one
// face. Its centre is a = l/2 sin(phi) - t/2 cos(phi) from the foot. With the wall's friction fully used, moments
// about the foot give the wall's force N = W a / (l cos(phi) + mu_w l sin(phi)), and the ground holds it while
// N <= mu (W - mu_w N):
//
//   mu_limit = a / (l cos(phi) + mu_w (l sin(phi) - a))
Prospect describe_leaning_slab(const ParameterValues& values, Random&) {
    constexpr double length = 2.0, width = 0.5;  // m
    const double phi = values.number("lean"), thickness = values.number("thickness");
    const double of_wall = values.number("wall-friction");
    const double sine = elementary::sin(phi), cosine = elementary::cos(phi);
    const double out = 0.5 * (length * sine - thickness * cosine);
    const double limit = out / (length * cosine + of_wall * (length * sine - out));
    const double mu = limit * more_than_limit(values);

    // A pair has the geometric mean of its coefficients.
    SceneDescription scene = on_ground(mu * mu);
    constexpr double high = 3.0;  // m
    scene.bodies.push_back({.name = "wall",
                            .shape = BoxShape{{1.0, high, 2.0}},
                            .position = {0.5, 0.5 * high, 0},
                            .friction = of_wall * of_wall});
    BodyDescription& slab =
        add_body(scene, "slab", BoxShape{{thickness, length, width}}, 1.0,
                 {-0.5 * (length * sine + thickness * cosine), 0.5 * (length * cosine + thickness * sine), 0});
    slab.orientation = inclined(-phi);
    slab.friction = 1.0;
    return ends_by_limit(values, std::move(scene), Ends::slides, 8.0, "slab");
}

}  // namespace

const Family card_house{
    "card-house",
    "A house of cards of 1 m and 0.1 kg that lean by 0.2 rad.",
    "Stands: at the ground a pair needs a friction of about tan(0.2) / 2 to hold and has much more.",
    {{{"storeys", "N", "number of storeys", 0, 1, 5, true}},
     {{"slenderness", "R", "height of a card over its thickness", 0, 10, 50}},
     friction_of(0.7, 1.0)},
    describe_card_house};

const Family dominoes{"dominoes",
                      "A row of dominoes of 1 m, the first of which tips over.",
                      "Topples: each has passed its balance before it hits the next one, and falls on.",
                      {{{"count", "N", "number of dominoes", 0, 3, 200, true}, Draw::by_decades},
                       {{"spacing", "M", "from one to the next, m", 0, 0.35, 0.7}},
                       {{"thickness", "M", "of a domino, m", 0, 0.05, 0.12}},
                       friction_of(0.4, 0.8)},
                      describe_dominoes};

const Family leaning_slab{"leaning-slab",
                          "A slab leans against a wall, with more or less friction at the ground than it needs.",
                          "With more than the static limit it stands, with less it slides down.",
                          {{{"lean", "RAD", "from the vertical, rad", 0, 0.15, 0.8}},
                           {{"thickness", "M", "of the slab of 2 m, m", 0, 0.02, 0.2}},
                           {{"wall-friction", "MU", "friction coefficient at the wall", 0, 0, 0.6}},
                           inside_of("1: more friction than the limit, 0: less"),
                           beyond_of(0.05, 0.5, "share of the limit by which it is more or less")},
                          describe_leaning_slab};

}  // namespace pushfactor::demos::families
