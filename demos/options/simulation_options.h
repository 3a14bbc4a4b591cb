// The simulation options: one table for the command line, config files and summaries.
#pragma once

#include "demos/options/option_table.h"
#include "demos/options/settings.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pushfactor::demos {

using SimulationOption = TextOption<Settings>;

// The option that is a file to read: in a scene file it is beside that, and what it adds is written as bodies.
inline constexpr std::string_view measured_option = "measured";

// In display order, without `preset`, which the others start from.
std::span<const SimulationOption> simulation_options();

// The names and texts of those that the scene does not decide.
std::vector<std::pair<std::string, std::string>> texts_of(const Settings& settings);

// Whether presets set this option: options of the method, not duration, step, material or threads.
bool is_of_preset(std::string_view option);

// Text of the option `scheme`.
std::string scheme_name(const Settings& settings);

// "preset" and the names of the table: the options that config and scene files may set.
std::vector<std::string> simulation_option_names();

}  // namespace pushfactor::demos
