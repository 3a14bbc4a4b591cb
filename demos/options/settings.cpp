#include "demos/options/settings.h"

#include <array>
#include <stdexcept>

namespace pushfactor::demos {

namespace {

// The paper's method; where it gives no detail, what reproduces its results (sections 5.2, 6.2.3, 8, 10.1).
Settings paper() {
    Settings settings;
    settings.preset = "paper";
    settings.substeps = 1;
    settings.scheme = Scheme::whole;
    settings.solver = "pgs";
    settings.tolerance_high = 0.0;
    settings.tolerance_low = 0.0;
    settings.contacts = {engine::PushKind::persistent, 0.2};
    settings.distances = {engine::PushKind::persistent, 0.2};
    settings.restitution_model = RestitutionModel::sum;
    settings.start_kick = StartKick::off;
    settings.warm_start = false;
    settings.slop = 0.0;
    settings.margin = 0.0;
    settings.row_order = engine::RowOrder::reverse;
    settings.friction_model = FrictionModel::paper;
    settings.four_points = false;
    settings.rotation = Rotation::paper;
    return settings;
}

// Recommended: the single-frame push of section 8.1, contact caching, slop and margin.
Settings recommended() {
    Settings settings;
    settings.preset = "default";
    settings.rest = true;
    return settings;
}

// Every step solved to rounding, and every error corrected in one step.
Settings exact() {
    Settings settings;
    settings.preset = "exact";
    settings.solver = "direct";
    settings.iterations = 1000;
    settings.tolerance_high = 1e-10;
    settings.tolerance_low = 1e-10;
    settings.contacts.beta = 1.0;
    settings.slop = 0.0;
    settings.friction_model = FrictionModel::coulomb;
    return settings;
}

}  // namespace

bool takes_small_steps(const Settings& settings) {
    if (settings.scheme == Scheme::small_steps) return true;
    return settings.scheme == Scheme::automatic && settings.solver == "auto" && settings.tolerance_high > 0.0;
}

std::span<const Preset> presets() {
    static constexpr std::array table{
        Preset{"default",
               "single-frame push, contact caching, slop and margin, solver auto with two tolerances, sleeping",
               recommended},
        Preset{"exact", "every step solved to rounding, beta 1, no slop", exact},
        Preset{"paper", "the original method: persistent push, 25 iterations from zero, no caching", paper},
    };
    return table;
}

Settings preset_settings(std::string_view name) {
    for (const Preset& preset : presets()) {
        if (preset.name == name) return preset.settings();
    }
    throw std::out_of_range("no preset " + std::string(name));
}

}  // namespace pushfactor::demos
