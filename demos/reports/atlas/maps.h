// The list of maps of the stability atlas and their axes. A cell of a map is a run, coloured by the outcome of its
// summary.
#pragma once

#include "demos/options/named_run.h"
#include "demos/runs/measurements.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::atlas {

struct AtlasAxis {
    std::string option;               // the varied option, without dashes
    std::string label;                // of the axis, with the unit
    std::vector<std::string> values;  // as on the command line, in ascending order of the shown numbers
    double scale = 1.0;               // shown number / number of the text
    bool logarithmic = true;
    bool names = false;  // values are no numbers; they are shown as 0, 1, 2, ...

    double shown(const std::string& value) const;
    std::string tick(const std::string& value) const;  // the text of the shown number
};

// A number of the summary that is shown in each cell.
struct AtlasMeasure {
    std::string key;                                  // in the summary
    std::string words;                                // with the unit
    double (Measurements::*value)() const = nullptr;  // null: only the summary has it
};

// A theoretical limit: a line on the map.
struct AtlasTheory {
    std::string label;
    double (*y)(double x);  // both in shown numbers
};

struct AtlasMap {
    std::string name;
    std::string title;
    std::string caption;
    std::string scene;   // of the catalogue, or a file
    OptionTexts common;  // options of all its runs
    AtlasAxis x, y;
    AtlasMeasure measure;
    std::optional<AtlasTheory> theory{};
    std::string moving = "moving";  // meaning of this outcome here, for the legend
};

std::vector<AtlasMap> atlas_maps();

// The same map with the first, the middle and the last value of each axis.
AtlasMap quick(const AtlasMap& map);

}  // namespace pushfactor::demos::reports::atlas
