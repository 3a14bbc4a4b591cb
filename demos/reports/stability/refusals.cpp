#include "demos/reports/stability/refusals.h"

#include "demos/options/simulation_options.h"
#include "demos/scenes/scene_file.h"
#include "demos/text/json.h"

#include <algorithm>

namespace pushfactor::demos::reports::stability {

namespace {

// One of everything that holds a number.
SceneDescription everything() {
    SceneDescription scene;
    scene.name = "everything";
    scene.contacts = true;
    scene.bodies = {{.name = "ground", .shape = PlaneShape{}},
                    {.name = "box", .shape = BoxShape{}, .mass = 1.0, .position = {0, 2, 0}, .restitution = 0.5},
                    {.name = "ball", .shape = SphereShape{}, .mass = 1.0, .position = {3, 2, 0}}};
    scene.bodies[1].velocity = {1, 2, 3};
    scene.bodies[1].angular_velocity = {1, 2, 3};
    scene.bodies[1].surface_velocity = {1, 0, 0};
    scene.bodies[1].friction = 0.25;
    scene.bodies[2].linear_momentum = engine::Vector3(1, 2, 3);
    scene.bodies[2].angular_momentum = engine::Vector3(1, 2, 3);
    scene.distances = {
        {.a = {"box", {0.1, 0.2, 0.3}}, .b = {"ball", {0.1, 0.2, 0.3}}, .length = 3.0, .max_force = 9.0}};
    scene.forces = {{.body = "ball", .force = {1, 2, 3}, .from = 0.5, .until = 1.5}};
    scene.view.floor = -1.0;
    scene.options = {{"seconds", "0.1"}};
    return scene;
}

struct Forbidden {
    std::string key;
    std::vector<std::string> numbers;
};

const std::vector<Forbidden> out_of_range{{"mass_kg", {"0", "-1"}},          {"radius_m", {"0", "-1"}},
                                          {"size_m", {"0", "-1"}},           {"friction", {"-1"}},
                                          {"restitution", {"-1", "1.0001"}}, {"length_m", {"-1"}},
                                          {"max_force_n", {"-1"}},           {"field_of_view_deg", {"0", "-1"}}};

// "/bodies/1/size_m/0": "size_m".
std::string key_of(Json::json_pointer pointer) {
    while (std::isdigit(static_cast<unsigned char>(pointer.back().front())) != 0) pointer.pop_back();
    return pointer.back();
}

std::string name_of(const std::string& pointer) {
    std::string name = pointer.substr(1);
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

// A scene file whose number at `pointer` is the text `number`, which JSON may not know.
std::string spoilt(Json scene, const Json::json_pointer& pointer, const std::string& number) {
    const std::string mark = "here";
    scene[pointer] = mark;
    std::string text = scene.dump(2);
    return text.replace(text.find('"' + mark + '"'), mark.size() + 2, number);
}

Case refused(const std::string& name, const std::string& field) {
    return {.name = name,
            .scene = "stack",
            .wanted = "refused",
            .expected = {{"default", "refused"}},
            .field = field,
            .quick = true};
}

void add_fields(std::vector<Case>& cases) {
    const Json scene = Json::parse(scene_file_text(everything()));
    const Json numbers_and_words = scene.flatten();
    for (const auto& [text, value] : numbers_and_words.items()) {
        if (!value.is_number()) continue;
        const Json::json_pointer pointer(text);
        std::vector<std::string> numbers{"NaN", "Infinity"};
        for (const Forbidden& forbidden : out_of_range) {
            if (forbidden.key != key_of(pointer)) continue;
            numbers.insert(numbers.end(), forbidden.numbers.begin(), forbidden.numbers.end());
        }
        for (const std::string& number : numbers) {
            Case one = refused(name_of(text) + "=" + number, key_of(pointer));
            one.text = spoilt(scene, pointer, number);
            cases.push_back(one);
        }
    }
}

void add_option(std::vector<Case>& cases, const std::string& scene, const std::string& option,
                const std::string& number) {
    Case one = refused("option_" + option + "=" + number, "--" + option);
    one.scene = scene;
    one.options = {{option, number}};
    cases.push_back(one);
}

void add_options(std::vector<Case>& cases) {
    for (const SimulationOption& option : simulation_options()) {
        for (const char* const number : {"nan", "inf", "-1"}) {
            add_option(cases, "stack", std::string(option.name), number);
        }
    }
    for (const char* const option : {"dt", "substeps", "iterations", "max-push-speed"}) {
        add_option(cases, "stack", option, "0");
    }
    add_option(cases, "stack", "restitution", "1.0001");
    add_option(cases, "stack", "beta", "1.5");
    for (const char* const number : {"nan", "inf", "0", "-1"}) {
        add_option(cases, "stack", "count", number);
        add_option(cases, "heavy-on-light", "mass-ratio", number);
    }
}

}  // namespace

Chapter refusals() {
    Chapter chapter{.name = "refusals",
                    .heading = "Not a number, infinite, zero or negative where it may not be: refused by name",
                    .cases = {}};
    add_fields(chapter.cases);
    add_options(chapter.cases);
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
