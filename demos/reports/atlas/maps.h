// Which maps the stability atlas has, and over what: the one place where they are listed. A cell of a map is a run,
// and its outcome is the one of the run's summary.
#pragma once

#include "demos/options/named_run.h"
#include "demos/runs/measurements.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::atlas {

struct AtlasAxis {
    std::string option;               // that is varied, without dashes
    std::string label;                // what it is, with its unit
    std::vector<std::string> values;  // as on the command line; the shown numbers rise
    double scale = 1.0;               // shown number over that of the text
    bool logarithmic = true;

    double shown(const std::string& value) const;
    std::string tick(const std::string& value) const;  // the text of the shown number
};

// A number of the summary, written beside the outcome.
struct AtlasMeasure {
    std::string key;    // in the summary
    std::string words;  // with the unit
    double (Measurements::*value)() const;
};

// What theory says beforehand: a line on the map.
struct AtlasTheory {
    std::string label;
    double (*y)(double x);  // both as shown
};

struct AtlasMap {
    std::string name;
    std::string title;
    std::string caption;
    std::string scene;   // of the catalogue
    OptionTexts common;  // of all its runs
    AtlasAxis x, y;
    AtlasMeasure measure;
    std::optional<AtlasTheory> theory{};
    std::string moving = "moving";  // what this outcome means here, for the legend
};

std::vector<AtlasMap> atlas_maps();

// The same map with the first, the middle and the last value of each axis.
AtlasMap quick(const AtlasMap& map);

}  // namespace pushfactor::demos::reports::atlas
