// The maps of the stability atlas, outcomes of runs over two of their parameters. A cell of a map is a run,
// coloured by the outcome of its summary, with a number of it.
#pragma once

#include "demos/base/text/palette.h"
#include "demos/reports/study.h"
#include "demos/runs/measurements.h"

#include <array>
#include <string_view>

namespace pushfactor::demos::reports::atlas {

struct AtlasAxis {
    std::string option;               // the varied option, without dashes
    std::string label;                // of the axis, with the unit
    std::vector<std::string> values;  // as on the command line, in ascending order of the shown numbers
    double scale = 1.0;               // shown number / number of the text
    bool logarithmic = true;
    bool names = false;  // values are no numbers; they are shown as 0, 1, 2, ...

    double shown(const std::string& value) const;
};

// A number of the summary that is shown in each cell.
struct AtlasMeasure {
    std::string key;    // in the summary
    std::string words;  // with the unit
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

// The maps of the report; `quick`: with the first, the middle and the last value of each axis.
std::vector<AtlasMap> atlas_maps(bool quick = false);

// A map that people ask for, of any two options or parameters of a scene. Throws UsageError, one line, for what no
// run accepts and for a measure that the summary lacks.
AtlasMap grid_map(const GridRequest& request);

// A run of a map.
struct AtlasCell {
    std::string scene, x, y;  // the values of the axes
    OptionTexts options;      // of the run, with these values
    std::string measure;      // in the summary

    // "pushfactor run ...", the command that reproduces it.
    std::string command() const { return command_text("run", scene, options); }
};

// The cell at these values, which need not be among those of the axes.
AtlasCell cell_at(const AtlasMap& map, const std::string& x, const std::string& y);

// Cells of a map, row by row from below; and those whose replays were asked for.
std::vector<AtlasCell> cells_of(const AtlasMap& map);
std::vector<AtlasCell> cells_with_replay(const AtlasMap& map, const GridRequest& request);

struct CellResult {
    std::string outcome;  // of the summary, or "non-finite"
    double value = 0.0;  // of the map's measure, up to the last finite step; NaN if the summary has no number there
};

// Throws the exceptions of errors.h except NonFiniteError.
CellResult run_cell(const AtlasCell& cell, const StopCheck& check);

struct OutcomeLook {
    std::string_view outcome;
    std::string_view words;  // for the legend
    int colour;              // 0xRRGGBB
    int ink;                 // on that colour
};

inline constexpr std::string_view non_finite = "non-finite";

// All outcomes of a run, from good to bad. The greys differ in lightness from all colours of the palette.
inline const std::array outcome_looks{
    OutcomeLook{"rest", "rest", number_of("green"), 0x111111},
    OutcomeLook{"jitter", "jitter: shakes in place", number_of("ivory"), 0x222222},
    OutcomeLook{"creep", "creep: drifts slowly", number_of("blue"), 0xffffff},
    OutcomeLook{"moving", "moving", number_of("orange"), 0x222222},
    OutcomeLook{"fall", "fall: came down", number_of("vermilion"), 0x111111},
    OutcomeLook{"torn", "torn: bars gave way", 0x555555, 0xffffff},
    OutcomeLook{"fly", "fly: was thrown away", number_of("violet"), 0xffffff},
    OutcomeLook{"tunnel", "tunnel: is in the ground", 0x888888, 0x111111},
    OutcomeLook{non_finite, "non-finite numbers", 0x111111, 0xffffff},
};

// A number short enough for a cell: "0.31", "12", "4e-7", "0".
std::string short_number(double value);

}  // namespace pushfactor::demos::reports::atlas
