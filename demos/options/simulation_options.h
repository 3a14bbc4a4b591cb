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
    std::string_view placeholder;  // of the value, in help texts
    std::string help;
    std::string allowed;                                     // completes "must be ..."
    bool (*set)(Settings& settings, std::string_view text);  // false and no change if the text is not allowed
    std::string (*get)(const Settings& settings);  // a text that `set` accepts; empty if the scene decides
    // A file that is read: in a scene file it is beside that, and what it adds is written as bodies.
    bool reads_file = false;
};

// In display order, without `preset`, which the others start from.
std::span<const SimulationOption> simulation_options();

// Whether presets set this option: options of the method, not duration, step, material or threads.
bool is_of_preset(std::string_view option);

// Text of the option `scheme`.
std::string scheme_name(const Settings& settings);

// "preset" and the names of the table: the options that config and scene files may set.
std::vector<std::string> simulation_option_names();

}  // namespace pushfactor::demos
