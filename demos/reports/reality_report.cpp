// Measured motion beside computed motion, each number with the noise of its measurement: tosses of a cube, throws
// of dice, packings, and motions with friction whose result is known in closed form.
#include "demos/base/text/suggest.h"
#include "demos/reports/reality/sections.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports {

namespace {

using namespace reality;
using engine::Vector3;

constexpr double g = 9.81;    // m/s^2
constexpr double dt = 0.001;  // s

BuiltScene built(FrictionModel model, SceneDescription scene, double friction) {
    Settings settings = preset_settings("default");
    settings.friction_model = model;
    settings.friction = friction;
    settings.threads = 1;
    for (BodyDescription& body : scene.bodies) body.friction = friction;
    return build_scene(scene, settings);
}

// After `seconds`; of the two bodies the second is looked at.
engine::World moved(double seconds, BuiltScene scene) {
    for (long step = std::lround(seconds / dt); step > 0; --step) scene.step(scene.world, dt);
    return std::move(scene.world);
}

// One body of 1 kg on a level plane.
SceneDescription on_plane(BodyDescription body) {
    body.name = "body";
    body.mass = 1.0;
    return one_on_another("closed form", {.name = "ground", .shape = PlaneShape{}}, std::move(body));
}

// A box 0.3 m wide and 0.6 m high that slides along its width: the friction below its centre tips it forwards.
SceneDescription tall_box(double speed) {
    return on_plane({.shape = BoxShape{Vector3(0.3, 0.6, 0.3)},
                     .position = Vector3(0, 0.3, 0),
                     .velocity = Vector3(speed, 0, 0)});
}

// Share of the weight on the rear edge while it slides.
double rear_share(FrictionModel model, double friction) {
    const engine::World world = moved(0.1, built(model, tall_box(3.0), friction));
    double rear = 0.0, all = 0.0;
    const auto rows = world.rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].label.kind != engine::RowKind::contact) continue;
        // The angular part of the axis is r x n; its z component is the offset along x of an upward normal.
        const auto& part = rows[i].body_a == 1 ? rows[i].jacobian.a : rows[i].jacobian.b;
        const double force = world.lambda()(static_cast<Eigen::Index>(i), world.lambda().cols() - 1);
        all += force;
        if (part[5] * part[1] < 0.0) rear += force;
    }
    return rear / all;
}

double way_to_stop(FrictionModel model) {
    return moved(1.5, built(model, tall_box(3.0), 0.4)).bodies.at(1).position.x();
}

double rolling_speed(FrictionModel model) {
    constexpr double radius = 0.1;
    const SceneDescription scene = on_plane({.shape = SphereShape{radius},
                                             .position = Vector3(0, radius, 0),
                                             .velocity = Vector3(2, 0, 0),
                                             .angular_velocity = Vector3(0, 0, 30)});
    return velocity(moved(2.0, built(model, scene, 0.3)).bodies.at(1)).x();
}

// Diagonally, where the square is widest.
double sliding_down(FrictionModel model) {
    constexpr double angle = 0.5;
    const Vector3 along = g * std::sin(angle) * Vector3(std::sqrt(0.5), 0, std::sqrt(0.5));
    SceneDescription scene = on_plane({.shape = BoxShape{Vector3(1, 0.2, 1)}, .position = Vector3(0, 0.1, 0)});
    scene.gravity = along - g * std::cos(angle) * Vector3::UnitY();
    return velocity(moved(1.0, built(model, scene, 0.3)).bodies.at(1)).norm();
}

// Whether a flat box 1 m from the axis leaves its place on a turntable.
bool leaves(FrictionModel model, double friction, double rate) {
    const BodyDescription table{
        .name = "table",
        .shape = BoxShape{Vector3(6, 0.2, 6)},
        .motion = MotionDescription{.kind = SteadyMotion{.angular_velocity = Vector3(0, rate, 0)}},
        .position = Vector3(0, -0.1, 0)};
    const BodyDescription body{.name = "body",
                               .shape = BoxShape{Vector3(0.05, 0.01, 0.05)},
                               .mass = 1.0,
                               .position = Vector3(1, 0.005, 0),
                               .velocity = Vector3(0, 0, -rate),
                               .angular_velocity = Vector3(0, rate, 0)};
    const auto world = moved(4.0, built(model, one_on_another("turntable", table, body), friction));
    return std::hypot(world.bodies.at(1).position.x(), world.bodies.at(1).position.z()) > 1.01;
}

double rate_that_slides(FrictionModel model) {
    double holds = 0.5, slides = 4.0;
    while (slides - holds > 2e-4) {
        const double middle = 0.5 * (holds + slides);
        (leaves(model, 0.4, middle) ? slides : holds) = middle;
    }
    return 0.5 * (slides + holds);
}

constexpr double slender = 0.4;  // rad, between the diagonal of the rocking block and its height

// Rate of turning after the impact over that before it.
double rocking_ratio(FrictionModel model) {
    constexpr double tilt = 0.1;
    const double half_width = 0.5 * std::sin(slender), half_height = 0.5 * std::cos(slender);
    const engine::Quaternion turned(Eigen::AngleAxisd(-tilt, Vector3::UnitZ()));
    const Vector3 corner(half_width, 0, 0), centre(0, half_height, 0);
    BodyDescription body{.shape = BoxShape{Vector3(2 * half_width, 2 * half_height, 0.5)}, .orientation = turned};
    body.position = corner + turned * (centre - corner);
    BuiltScene scene = built(model, on_plane(std::move(body)), 2.0);
    // In short steps, because gravity acts on both sides of the impact, which takes two steps: the last in which
    // the gap closes, and the next.
    constexpr double short_dt = 1e-4;
    std::vector<double> rates;
    for (int step = 0; step < 4000; ++step) {
        scene.step(scene.world, short_dt);
        rates.push_back(angular_velocity(scene.world.bodies.at(1)).z());
    }
    std::size_t at = 2;
    for (std::size_t i = 2; i + 2 < rates.size(); ++i) {
        if (rates[i - 1] - rates[i] > rates[at - 1] - rates[at]) at = i;
    }
    return rates[at + 1] / rates[at - 2];
}

struct Part {
    const char* name;
    void (*add)(StudyRun& run);
};
constexpr std::array parts{Part{"closed-forms", add_closed_forms}, Part{"tosses", add_tosses},
                           Part{"dice", add_dice}, Part{"packings", add_packings}};

void make_reality(StudyRun& run) {
    for (const auto& [name, add] : parts) {
        if (run.request().wants(name)) add(run);
    }
    run.write_page(fmt::format(
        "How far rigid bodies with Coulomb friction and one number for restitution go. What has a solution is "
        "computed to its digits. A tossed cube can be followed through its bounces to about 13 % of its edge, with "
        "one friction and one restitution for all of them; where it ends is right for four of five, because after "
        "some bounces a hair decides. What many throws have in common, shares of dice and volumes of heaps, does "
        "not hang on the hair: there two numbers come near to what is measured, though not everywhere within its "
        "error. What they cannot tell is what a real impact does with an edge: in reality restitution depends on "
        "speed, on the place that is hit, and on which other point touches. Made with {}.{}",
        run.machine(), run.quick() ? " This is the quick report: few tosses, throws and bodies." : ""));
}

}  // namespace

const std::vector<ClosedForm>& reality::closed_forms() {
    static const std::vector<ClosedForm> all{
        {"tall box that slides, friction 0.4: share of its weight on the rear edge", "1/2 - mu h / w", 0.1,
         [](FrictionModel model) { return rear_share(model, 0.4); }},
        {"the same with friction 0.5", "1/2 - mu h / w", 0.0,
         [](FrictionModel model) { return rear_share(model, 0.5); }},
        {"way until it stops from 3 m/s, friction 0.4, m", "v^2 / (2 mu g) - v dt / 2", 9.0 / (0.8 * g) - 1.5 * dt,
         way_to_stop},
        {"ball of 0.1 m with backspin of 30 rad/s at 2 m/s: speed once it rolls, m/s", "(5 v - 2 r w) / 7",
         (10.0 - 6.0) / 7.0, rolling_speed},
        {"slab on a slope of 0.5 rad, friction 0.3: speed after 1 s, m/s", "g (sin a - mu cos a)",
         g * (std::sin(0.5) - 0.3 * std::cos(0.5)), sliding_down},
        {"turntable, friction 0.4, 1 m from its axis: rate that slides, rad/s", "sqrt(mu g / r)",
         std::sqrt(0.4 * g), rate_that_slides},
        {"rocking block of slenderness 0.4 rad: rate after its impact over that before",
         "1 - 1.5 sin^2 a (Housner)", 1.0 - 1.5 * std::sin(slender) * std::sin(slender), rocking_ratio},
    };
    return all;
}

void reality::add_closed_forms(StudyRun& run) {
    Table table{
        {"motion", "formula", "exact", "cone", "square", "paper", "error_cone", "error_square", "error_paper"}};
    run.begin(closed_forms().size());
    for (const ClosedForm& form : closed_forms()) {
        run.check()();
        const double cone = form.computed(FrictionModel::cone), square = form.computed(FrictionModel::coulomb),
                     paper = form.computed(FrictionModel::paper);
        table.rows.push_back({form.name, form.formula, form.exact, cone, square, paper, std::abs(cone - form.exact),
                              std::abs(square - form.exact), std::abs(paper - form.exact)});
        run.count_run();
    }
    run.sections.push_back(
        {"closed-forms", "Motions that are known in closed form",
         run.tabulated(
             "closed_forms.csv", table,
             "Steps of 1 ms (0.1 ms for the rocking block), otherwise default, under each model of "
             "friction: the round cone, a square of two tangents, and the paper's, whose friction does not "
             "know the force of its contact.")});
}

Study reality_study() {
    return {.name = "reality",
            .title = "beside measured motion",
            .parts = [] { return names_of(parts); },
            .make = make_reality};
}

}  // namespace pushfactor::demos::reports
