#include "demos/options/simulation_options.h"

#include "engine/solvers/solver.h"
#include "tests/catch.h"

#include <set>

using namespace pushfactor::demos;

TEST_CASE("every option reads back what it wrote, in every preset") {
    for (const Preset& preset : presets()) {
        const Settings settings = preset.settings();
        CHECK(settings.preset == preset.name);
        Settings copy = preset_settings(preset.name == "paper" ? "default" : "paper");
        for (const SimulationOption& option : simulation_options()) {
            const std::string text = option.get(settings);
            INFO(option.name << " " << text);
            if (text.empty()) continue;
            CHECK(option.set(copy, text));
            CHECK(option.get(copy) == text);
        }
    }
}

TEST_CASE("every option refuses nonsense and then changes nothing") {
    for (const SimulationOption& option : simulation_options()) {
        Settings settings = preset_settings("default");
        const std::string before = option.get(settings);
        for (const char* nonsense : {"", "nan", "-1", "1e999", "maybe", "0/0/0", "5 m"}) {
            INFO(option.name << " " << nonsense);
            CHECK(!option.set(settings, nonsense));
            CHECK(option.get(settings) == before);
        }
        CHECK(!option.help.empty());
        CHECK(!option.allowed.empty());
    }
}

TEST_CASE("no two options share a name, and every solver can be chosen") {
    std::set<std::string_view> names;
    for (const SimulationOption& option : simulation_options()) {
        CHECK(names.insert(option.name).second);
        if (option.name != "solver") continue;
        for (const auto& entry : pushfactor::engine::solvers::solver_table()) {
            Settings settings;
            CHECK(option.set(settings, entry.name));
            CHECK(settings.solver == entry.name);
        }
    }
}

TEST_CASE("the presets differ where the paper and this project do") {
    const Settings paper = preset_settings("paper");
    const Settings ours = preset_settings("default");
    CHECK(paper.contacts.kind == pushfactor::engine::PushKind::persistent);
    CHECK(paper.contacts.beta == 0.2);
    CHECK(paper.iterations == 25);
    CHECK(paper.tolerance_high == 0.0);
    CHECK(!paper.warm_start);
    CHECK(ours.contacts.kind == pushfactor::engine::PushKind::single_frame);
    CHECK(ours.warm_start);
}

TEST_CASE("what a preset does not choose is the same in every preset") {
    const Settings ours = preset_settings("default");
    int chosen = 0;
    for (const SimulationOption& option : simulation_options()) {
        if (is_of_preset(option.name)) {
            ++chosen;
            continue;
        }
        INFO(option.name);
        for (const Preset& preset : presets()) CHECK(option.get(preset.settings()) == option.get(ours));
    }
    CHECK(chosen > 10);
    CHECK(!is_of_preset("seconds"));
    CHECK(!is_of_preset("camera"));  // of the picture
}
