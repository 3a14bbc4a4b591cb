// The stress list: which scenes are run, what is measured of them, and what is expected of each preset. The one
// place where they are listed; running, judging and drawing know no case.
#pragma once

#include "demos/options/named_run.h"
#include "demos/scenes/scene_description.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::stability {

// One number and its bar: |measure - target| / scale, in the measure's unit over that of the scale.
struct Check {
    std::string measure{};  // of measures.h, or a number of the summary
    double bar = 0.0;
    bool at_least = false;  // the bar is the least that it may be, else the most
    double target = 0.0;
    double scale = 1.0;
};

// What one preset is known to do. Where its outcome is not the wanted one, bars are judged only if `reached` says
// something.
struct Expected {
    std::string preset;
    std::string outcome;  // as in a summary; or non-finite, refused, failed
    // Of each check what is known to be reached where that is worse than its bar; none: all bars are met.
    std::vector<std::optional<double>> reached{};
};

struct Case {
    std::string name{};   // also of its files
    std::string scene{};  // of the catalogue; empty for a scene of its own
    std::optional<SceneDescription> own{};
    std::optional<std::string> text{};  // of a scene file that is refused
    OptionTexts options{};
    std::string wanted{};  // the outcome that the case asks for; any other that is expected leaves its bars open
    std::vector<Check> checks{};
    std::vector<Expected> expected{};
    std::string field{};  // what a refusal has to name
    bool quick = false;   // also in the quick report
};

// Cases that belong together: one heading of the page.
struct Chapter {
    std::string name;     // of its picture, and of --only
    std::string heading;  // what is asked
    std::vector<Case> cases;
};

// Of the quick report those with quick cases, and only these cases.
std::vector<Chapter> chapters(bool quick);

// Names of all chapters.
std::vector<std::string> chapter_names();

}  // namespace pushfactor::demos::reports::stability
