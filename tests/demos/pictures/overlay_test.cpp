// The overlays against closed forms.
#include "demos/pictures/overlays/overlay.h"

#include "demos/base/text/errors.h"
#include "demos/options/choices.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/lettering.h"
#include "demos/pictures/overlays/acting.h"
#include "demos/pictures/to_glm.h"
#include "demos/runs/simulation.h"
#include "tests/catch.h"
#include "tests/settings.h"

using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;
namespace renderer = pushfactor::renderer;
using pushfactor::engine::Vector3;

namespace {

Choices run_of(const std::string& scene, std::initializer_list<std::pair<const char*, const char*>> options) {
    GivenOptions given;
    for (const auto& [name, text] : options) given.add(name, text, name);
    return understand(scene, given);
}

Simulation after(const Choices& choices, long steps) {
    Simulation run(choices);
    while (run.sample().step < steps) run.advance();
    return run;
}

Vector3 sum_of(const std::vector<Quantity>& quantities, std::size_t kind) {
    Vector3 sum = Vector3::Zero();
    for (const Quantity& quantity : quantities) {
        if (quantity.kind == kind) sum += quantity.value;
    }
    return sum;
}

}  // namespace

TEST_CASE("the contact forces of a stack at rest carry what lies above them, and point upwards") {
    const Simulation run = after(run_of("stack", {}), 600);
    const auto forces = quantities(run.scene(), OverlayKind::forces);
    CHECK(forces.size() == 20);
    // 60 + 48 + 36 + 24 + 12 N
    CHECK((sum_of(forces, 0) - Vector3(0, 180, 0)).norm() < 1e-4);
    CHECK(std::all_of(forces.begin(), forces.end(), [](const Quantity& q) { return q.value.y() >= 0.0; }));
    // Four points below each cube, at the heights of the joints.
    for (const Quantity& contact : quantities(run.scene(), OverlayKind::contacts)) {
        const double joint = contact.place.y() / 2.4;
        CHECK(joint == Approx(std::round(joint)).margin(0.01));
    }
}

TEST_CASE("a contact point that carries load is none within the margin, however small its gap is") {
    for (const char* const rest : {"on", "off"}) {
        const Simulation run = after(run_of("stack", {{"rest", rest}, {"slop", "0"}}), 600);
        for (const Acting& at : acting_in(run.scene())) {
            CHECK((at.kind == Acting::Kind::touching || at.force.norm() == 0.0));
        }
    }
}

TEST_CASE("the line of thrust of a leaning tower is where the weight above is") {
    // Two cubes of 2.4 m, the upper one moved 0.6 m aside: its centre of pressure is below its centre, and that of
    // both together halfway between their centres.
    Choices tower = run_of("stack", {{"count", "2"}, {"gap", "0"}, {"solver", "direct"}});
    tower.description.bodies[2].position.x() += 0.6;
    const Simulation run = after(tower, 60);
    const auto centres = pressure_centres(run.scene());
    REQUIRE(centres.size() == 2);
    const double lower = run.scene().world.bodies[1].position.x(), upper = run.scene().world.bodies[2].position.x();
    CHECK(upper - lower == Approx(0.6).margin(1e-6));
    CHECK(centres[0].place.x() == Approx(0.5 * (lower + upper)).margin(1e-4));
    CHECK(centres[1].place.x() == Approx(upper).margin(1e-4));
    const auto line = line_of_thrust(centres, run.scene());
    REQUIRE(line.size() == 1);
    CHECK(line[0].first.y() == Approx(0.0).margin(1e-2));
    CHECK(line[0].second.y() == Approx(2.4).margin(1e-2));
}

TEST_CASE("the line of thrust goes through bodies that sleep, which have no rows") {
    const Simulation run = after(run_of("stack", {}), 600);
    REQUIRE(run.scene().world.rows().empty());
    renderer::Picture picture;
    add_overlay(run.scene(), OverlayKind::thrust, 1.0, picture);
    CHECK(picture.dots.size() == 5);
    CHECK(picture.arrows.size() == 4);
}

TEST_CASE("a contact force turns with the body on which it acts: the upper of two, the movable one of a pair") {
    // Cubes whose contacts are made in either order of bodies give the same picture.
    const Simulation run = after(run_of("funnel", {{"rest", "off"}}), 1200);
    Vector3 from_walls = Vector3::Zero();
    const auto sites = run.scene().contacts->sites();
    const auto forces = quantities(run.scene(), OverlayKind::forces);
    REQUIRE(sites.size() == forces.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const bool wall = run.scene().world.bodies[static_cast<std::size_t>(sites[i].body_a)].is_static();
        if (wall)
            from_walls += forces[i].value;
        else
            CHECK(forces[i].value.dot(sites[i].normal) * sites[i].normal.y() >= -1e-6);
    }
    CHECK((from_walls - Vector3(0, 200, 0)).norm() < 1e-4);  // 20 balls of 1 kg
}

TEST_CASE("the push of an overlap is beta d / dt, and lies in the part that the kind of push says") {
    for (const auto& [kind, entry] : {std::pair{"single-frame", 0u}, std::pair{"persistent", 1u}}) {
        const Simulation run = after(
            run_of("intersecting-stack", {{"push", kind}, {"beta", "0.2"}, {"slop", "0"}, {"count", "1"}}), 1);
        const auto push = quantities(run.scene(), OverlayKind::push);
        CHECK(push.size() == 8);  // both parts of four points
        CHECK((sum_of(push, entry) - Vector3(0, 4 * 0.2 * 1.2 * 60, 0)).norm() < 1e-9);
        CHECK(sum_of(push, 1 - entry).norm() == 0.0);
    }
}

TEST_CASE("the bar of a hanging ball pulls it up with its weight") {
    const Simulation run = after(run_of("pendulum-wave", {{"count", "1"}, {"amplitude", "0.1"}}), 3000);
    const auto forces = quantities(run.scene(), OverlayKind::forces);
    REQUIRE(forces.size() == 1);
    CHECK(forces[0].kind == 1);
    CHECK(forces[0].value.y() == Approx(10.0).epsilon(1e-3));
    CHECK(forces[0].place.y() > run.scene().world.bodies[0].position.y());
}

TEST_CASE("velocities are there from the start, all else from the first step on") {
    const Simulation run = after(run_of("stack", {}), 0);
    CHECK(quantities(run.scene(), OverlayKind::velocities).size() == 5);
    for (const OverlayKind kind : {OverlayKind::contacts, OverlayKind::forces, OverlayKind::push}) {
        CHECK(quantities(run.scene(), kind).empty());
    }
}

TEST_CASE("an overlay for which a scene has no part is refused with its reason") {
    const Simulation wave = after(run_of("pendulum-wave", {{"count", "2"}}), 0);
    CHECK_THROWS_WITH(require_shown(wave.scene(), {{.kind = OverlayKind::contacts}}),
                      "--overlay contacts: scene pendulum-wave has no contacts, so there is nothing to show");
    CHECK_NOTHROW(require_shown(wave.scene(), {{.kind = OverlayKind::forces}, {.kind = OverlayKind::velocities}}));
}

TEST_CASE("a survey finds the usual size of what is shown and how far the bodies go") {
    const Choices choices = run_of("intersecting-stack", {{"preset", "paper"}, {"overlay", "velocities,push"}});
    std::vector<Frame> frames;
    for (long step = 0; step <= 30; ++step) frames.push_back({step, ""});
    const Survey found = survey({{.label = "", .choices = choices}}, {frames});
    double top = 0.0;
    for (const Ball& ball : found.reached) top = std::max(top, ball.centre.y());
    CHECK(top > 21.0);  // 22.2 m at 0.5 s
    CHECK(top < 23.0);
    CHECK(found.typical.at(OverlayKind::velocities) > 20.0);
    CHECK(found.shown.contains({OverlayKind::push, 1}));
    CHECK(!found.shown.contains({OverlayKind::push, 0}));
}

TEST_CASE("islands: bodies have the colour of their island, another one than the next, and ivory when in none") {
    // Two balls on each other, one that lies alone, and one in flight.
    SceneDescription scene;
    scene.name = "islands";
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    const auto add = [&](const char* name, double x, double y) {
        scene.bodies.push_back(
            {.name = name, .shape = SphereShape{0.5}, .mass = 1.0, .position = {x, y, 0}, .colour = "green"});
    };
    add("lower", 0, 0.5);
    scene.bodies.push_back({.name = "plate", .shape = BoxShape{{2, 0.2, 2}}, .position = {9, 1, 0}});
    add("upper", 0, 1.5);
    add("alone", 3, 0.5);
    add("flying", 6, 5);
    const Settings settings = pushfactor::tests::awake_settings("default");
    Simulation run(build_scene(scene, settings), settings);
    const auto picture = [&] {
        auto all = draw_list(run.scene(), run.scene().view);
        const auto before = all;
        add_overlay(run.scene(), OverlayKind::islands, 1.0, all);
        CHECK(all.bodies[1].colour == before.bodies[1].colour);  // static
        CHECK(all.arrows.empty());
        return all;
    };
    const glm::vec3 ivory = to_glm(*find_colour("ivory"));
    for (const auto& body : picture().bodies) CHECK((body.index == 2 || body.colour == ivory));  // before a step
    run.advance();
    const auto bodies = picture().bodies;
    REQUIRE(bodies.size() == 5);
    CHECK(bodies[0].colour == bodies[2].colour);
    CHECK(bodies[0].colour != bodies[3].colour);
    CHECK(bodies[3].colour != ivory);
    CHECK(bodies[4].colour == ivory);
    CHECK(quantities(run.scene(), OverlayKind::islands).size() == 4);
    CHECK_NOTHROW(require_shown(run.scene(), {{.kind = OverlayKind::islands}}));
}

TEST_CASE("a body that stands has no arrow of its velocity, whatever solves and rounding have left of it") {
    Simulation run = after(run_of("stack", {}), 600);
    const auto fastest = [&] {
        double most = 0.0;
        for (const Quantity& of : quantities(run.scene(), OverlayKind::velocities))
            most = std::max(most, of.value.norm());
        return most;
    };
    CHECK(fastest() == 0.0);  // of 2e-15 m/s before
    const Choices choices = run_of("stack", {{"overlay", "velocities"}, {"at", "10"}});
    CHECK(survey({{.label = "", .choices = choices}}, {std::vector<Frame>{{600, ""}}}).shown.empty());
}

TEST_CASE("the torque of a motor has another colour than every force, and trails have an entry in the legend") {
    const Colour motor = entries_of(OverlayKind::torques)[1].colour;
    for (const LegendEntry& force : entries_of(OverlayKind::forces)) CHECK(force.colour.name != motor.name);
    const Choices choices = run_of("chain", {{"overlay", "trails"}, {"at", "0"}});
    CHECK(survey({{.label = "", .choices = choices}}, {std::vector<Frame>{{0, ""}}}).shown.size() == 1);
    CHECK(entries_of(OverlayKind::trails).size() == 1);
}

TEST_CASE("a panel too narrow for its name shows the end, by which panels differ, and a caption its beginning") {
    const Lettering lettering;
    const renderer::Rectangle narrow{0.0f, 0.0f, 80.0f, 40.0f};
    const auto named = [&](const std::string& name) {
        renderer::Image image = renderer::blank_image(80, 40, glm::vec3(1.0f));
        lettering.name(image, narrow, name, 11.0f);
        return image;
    };
    const auto captioned = [&](const std::string& caption) {
        renderer::Image image = renderer::blank_image(80, 40, glm::vec3(1.0f));
        lettering.caption(image, narrow, caption, 11.0f);
        return image;
    };
    CHECK(named("iterations 25") != named("iterations 50"));
    CHECK(named("a longer name of iterations 25") == named("another of many iterations 25"));
    CHECK(captioned("iterations 25") == captioned("iterations 50"));
    CHECK(named("preset \u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2") ==
          named("\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2\u03b2"));
}
