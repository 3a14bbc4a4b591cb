// The simulation options: one table for the command line, config files and summaries.
#pragma once

#include "demos/options/settings.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

struct SimulationOption {
    std::string_view name;         // without the leading dashes
    std::string_view placeholder;  // what stands for the value in help texts
    std::string help;
    std::string allowed;                                     // completes "must be ..."
    bool (*set)(Settings& settings, std::string_view text);  // false: the text is not allowed, nothing is set
    std::string (*get)(const Settings& settings);            // text that `set` takes; empty when the scene decides
};

// In the order in which they are shown. `preset` is not among them: it is where the others start from.
std::span<const SimulationOption> simulation_options();

// Whether a preset chooses this option: those of the method, not how long and how finely a scene runs, what its
// bodies are made of, and what it runs on.
bool is_of_preset(std::string_view option);

// What the option `scheme` is set to.
std::string scheme_name(const Settings& settings);

// "preset" and the names of the table: what a config or a scene file may set.
std::vector<std::string> simulation_option_names();

}  // namespace pushfactor::demos
