// Overlays, the camera and the sun in glTF files.
#include "demos/options/named_run.h"
#include "demos/pictures/overlays/overlay.h"
#include "renderer/picture/picture.h"
#include "tests/demos/pictures/gltf/glb_runs.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;

TEST_CASE("arrows in a glTF file are the forces of each frame, and have no size in frames that have fewer") {
    Choices choices = run_of("intersecting-stack", {{"seconds", "1"}});
    choices.frames.overlay = {{OverlayKind::forces, 50.0}};  // N per metre
    std::vector<std::vector<pictures::Quantity>> frames;
    const Glb glb = recorded(choices, [&](const Simulation& run) {
        frames.push_back(pictures::quantities(run.scene(), OverlayKind::forces));
    });
    check_sound(glb);
    std::vector<std::size_t> arrows;
    for (const Json& child : glb.json["nodes"][glb.node("contact force")]["children"]) arrows.push_back(child);
    std::size_t most = 0, least = 1000;
    for (std::size_t n = 0; n < frames.size(); ++n) {
        const double time = static_cast<double>(n) / 60.0;
        Vector3 forces = Vector3::Zero(), drawn = Vector3::Zero(), moment = Vector3::Zero(), drawn_moment = moment;
        std::size_t acting = 0, shown = 0;
        for (const pictures::Quantity& quantity : frames[n]) {
            acting += quantity.value.norm() > 1e-4;
            forces += quantity.value;
            moment += quantity.place.cross(quantity.value);
        }
        for (const std::size_t arrow : arrows) {
            const Vector3 scale = glb.vector(arrow, "scale", time);
            CHECK((scale.x() == scale.y() && scale.y() == scale.z()));
            const Vector3 force = 50.0 * (glb.rotation(arrow, time) * Vector3(0, scale.y(), 0));
            shown += force.norm() > 1e-4;
            drawn += force;
            drawn_moment += glb.vector(arrow, "translation", time).cross(force);
        }
        INFO("frame " << n);
        CHECK(shown == acting);
        CHECK((drawn - forces).norm() < 1e-3);
        CHECK((drawn_moment - moment).norm() < 1e-2);
        most = std::max(most, acting);
        least = std::min(least, acting);
    }
    CHECK(least == 0);
    CHECK(arrows.size() == most);
    for (const std::size_t arrow : arrows) {
        for (const char* const path : {"translation", "rotation", "scale"}) {
            const Json* const sampler = glb.sampler(arrow, path);
            if (sampler) CHECK((*sampler)["interpolation"] == "STEP");
        }
    }
}

TEST_CASE("lines of overlays are in a glTF file as long as in the picture") {
    Choices choices = run_of("rover", {{"seconds", "0.1"}});
    choices.frames.overlay = {{.kind = OverlayKind::no_contacts}};
    std::vector<pictures::Quantity> lines;
    const Glb glb = recorded(choices, [&](const Simulation& run) {
        lines = pictures::quantities(run.scene(), OverlayKind::no_contacts);
    });
    REQUIRE(!lines.empty());
    double lengths = 0.0, drawn = 0.0;
    for (const pictures::Quantity& line : lines) lengths += line.value.norm();
    for (const Json& node : glb.json["nodes"]) {
        const std::string name = node.value("name", "");
        if (!node.contains("mesh") || glb.json["meshes"][node["mesh"].get<std::size_t>()]["name"] == "bar")
            continue;
        if (!name.starts_with("do not touch") && !name.starts_with("one group")) continue;
        const Vector3 scale = glb.vector(glb.node(name), "scale", 0.1);
        drawn += 2.0 * (scale.y() - scale.x());
    }
    CHECK(drawn == Approx(lengths).epsilon(1e-4));
}

TEST_CASE("the camera of a glTF file looks as the film's does, and the sun shines as the renderer's") {
    Choices choices = run_of("stack", {{"seconds", "1"}});
    choices.frames.camera.degrees_a_second = 90.0;
    const Glb glb = recorded(choices);
    const std::size_t camera = glb.node("camera");
    const View& view = choices.description.view;
    for (const double time : {0.0, 0.5, 1.0}) {
        const View at = turned(choices.frames.camera, view, time);
        const Vector3 eye = glb.vector(camera, "translation", time);
        const Vector3 forward = glb.rotation(camera, time) * Vector3(0, 0, -1);
        const Vector3 right = glb.rotation(camera, time) * Vector3(1, 0, 0);
        CHECK((eye - at.eye).norm() < 1e-5);
        CHECK((forward - (at.target - at.eye).normalized()).norm() < 1e-6);
        CHECK(std::abs(right.y()) < 1e-6);
    }
    const Json& lens = glb.json["cameras"][0]["perspective"];
    CHECK(lens["yfov"].get<double>() == Approx(view.field_of_view * 3.14159265358979 / 180.0));
    CHECK(lens["aspectRatio"].get<double>() == Approx(1280.0 / 720.0));
    const Vector3 shines = glb.rotation(glb.node("sun"), 0.0) * Vector3(0, 0, -1);
    const glm::vec3 sun = renderer::Picture{}.towards_sun;
    CHECK((shines + Vector3(sun.x, sun.y, sun.z).normalized()).norm() < 1e-6);
    CHECK(glb.json["extensionsUsed"] == Json::array({"KHR_lights_punctual"}));
}
