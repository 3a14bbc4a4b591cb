#include "demos/pictures/live/live_run.h"

#include "demos/base/platform/shell_words.h"
#include "demos/base/platform/version.h"
#include "demos/options/simulation_options.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/overlays/acting.h"
#include "demos/pictures/replay/stage.h"
#include "demos/scenes/catalogue.h"
#include "engine/bodies/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::pictures::live {

namespace {

constexpr double aspect = 16.0 / 9.0;  // of a view that shows all of a scene without a camera

template <typename Vector>
void append(const Vector& vector, std::vector<double>& numbers) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(vector[axis]);
}

ComparedRun run_with(const std::string& scene, const OptionTexts& options) {
    GivenOptions given;
    for (const auto& [name, text] : options) given.add(name, text, "--" + name);
    return {.label = "", .choices = understand(scene, given)};
}

View view_of(const ComparedRun& run, const BuiltScene& scene) {
    if (run.choices.description.has_camera) return scene.view;
    return overview(scene.view, movable_balls(scene), {}, aspect);
}

double speed_upwards(const BuiltScene& scene) {
    double largest = 0.0;
    for (const engine::Body& body : scene.world.bodies) {
        if (!body.is_static()) largest = std::max(largest, velocity(body).y());
    }
    return largest;
}

Json scenes() {
    Json scenes = Json::array();
    for (const SceneEntry& entry : catalogue()) {
        Json parameters = Json::array();
        for (const Parameter& parameter : entry.parameters) {
            parameters.push_back({{"name", parameter.name},
                                  {"help", parameter.help},
                                  {"value", parameter.fallback},
                                  {"low", parameter.low},
                                  {"high", parameter.high},
                                  {"whole", parameter.whole}});
        }
        scenes.push_back(
            {{"name", entry.name}, {"sentence", entry.sentence}, {"parameters", std::move(parameters)}});
    }
    return scenes;
}

Json options() {
    Json options = Json::array();
    for (const SimulationOption& option : simulation_options()) {
        if (!is_on_menu(option.name)) continue;
        Json values = Json::object();
        for (const Preset& preset : presets()) values[std::string(preset.name)] = option.get(preset.settings());
        options.push_back({{"name", option.name},
                           {"help", option.help},
                           {"allowed", option.allowed},
                           {"values", std::move(values)}});
    }
    return options;
}

}  // namespace

LiveRun::LiveRun(const std::string& scene, const OptionTexts& options)
    : options_(options),
      run_(run_with(scene, options)),
      simulation_(run_.choices),
      recorded_(replay::recorded_bodies(simulation_.scene())) {
    measure();
}

Json LiveRun::about() const {
    Json about = replay::stage_of(run_, simulation_);
    const BuiltScene& scene = simulation_.scene();
    about["scene"] = run_.choices.description.name;
    about["camera"] = replay::camera_of(view_of(run_, scene), movable_balls(scene));
    about["seconds_a_step"] = simulation_.settings().dt.value();
    return about;
}

std::string LiveRun::meshes() const {
    return replay::polyhedra_of(simulation_);
}

void LiveRun::advance(long steps) {
    for (long step = 0; step < steps; ++step) {
        simulation_.advance();
        measure();
    }
}

void LiveRun::measure() {
    const Sample& sample = simulation_.sample();
    measures_.insert(measures_.end(), {sample.kinetic_energy, sample.potential_energy, sample.penetration.max,
                                       sample.max_speed, sample.residual, speed_upwards(simulation_.scene())});
}

std::vector<double> LiveRun::numbers() {
    const BuiltScene& scene = simulation_.scene();
    const std::vector<Acting> acting = all_acting_in(scene);
    constexpr std::size_t of_a_line = 6;
    const Sample& sample = simulation_.sample();
    std::vector<double> numbers{static_cast<double>(sample.step),
                                sample.time,
                                static_cast<double>(measures_.size() / of_a_line),
                                static_cast<double>(scene.world.bodies.size()),
                                static_cast<double>(recorded_.size()),
                                static_cast<double>(acting.size())};
    numbers.insert(numbers.end(), measures_.begin(), measures_.end());
    measures_.clear();
    for (const engine::Body& body : scene.world.bodies) append(body.position, numbers);
    for (const engine::Body& body : scene.world.bodies) {
        const engine::Quaternion& q = body.orientation;
        numbers.insert(numbers.end(), {q.w(), q.x(), q.y(), q.z()});
    }
    for (const std::size_t body : recorded_) {
        append(velocity(scene.world.bodies[body]), numbers);
        append(angular_velocity(scene.world.bodies[body]), numbers);
    }
    for (const Acting& at : acting) {
        numbers.insert(numbers.end(),
                       {static_cast<double>(at.kind), static_cast<double>(at.body), static_cast<double>(at.other)});
        for (const engine::Vector3& vector : {at.place, at.force, at.correcting, at.lasting})
            append(vector, numbers);
    }
    return numbers;
}

std::string LiveRun::state_hash() const {
    return fmt::format("{:016x}", engine::state_hash(simulation_.scene().world.bodies));
}

std::string LiveRun::command() const {
    std::vector<std::string> words{"run", run_.choices.scene};
    for (const auto& [name, text] : options_) words.insert(words.end(), {"--" + name, text});
    const Rational time = simulation_.settings().dt * Rational{simulation_.sample().step, 1};
    words.insert(words.end(), {"--seconds", to_text(time)});
    return command_of(words);
}

bool is_on_menu(std::string_view option) {
    return option != "seconds" && option != "threads";
}

Json menu() {
    Json named = Json::array();
    for (const Preset& preset : presets()) named.push_back({{"name", preset.name}, {"help", preset.description}});
    return {{"scenes", scenes()},
            {"presets", std::move(named)},
            {"options", options()},
            {"legend", replay::legend_of_arrows()},
            {"version", version_text()}};
}

}  // namespace pushfactor::demos::pictures::live
