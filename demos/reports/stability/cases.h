// The stress list: which scenes are run, what is measured of them, and what is expected of each preset. The one
// place where they are listed; running, judging and drawing know no case.
#pragma once

#include "demos/options/named_run.h"
#include "demos/scenes/scene_description.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pushfactor::demos::reports::stability {

// One number and its bar: |measure - target| / scale, in the measure's unit over that of the scale.
struct Check {
    std::string measure{};  // of measures.h, or a number of the summary
    double bar = 0.0;
    double target = 0.0;
    double scale = 1.0;
    bool at_least = false;  // the bar is the least that it may be, else the most
};
using Checks = std::vector<Check>;

// Of each check what is known to be reached where that is worse than its bar; none: all bars are met.
using Reached = std::vector<std::optional<double>>;

// What one preset is known to do. Where its outcome is not the wanted one, bars are judged only if `reached` says
// something.
struct Expected {
    std::string preset;
    std::string outcome;  // as in a summary; or non-finite, failed
    Reached reached{};
};
using Expectations = std::vector<Expected>;

using CaseScene = std::variant<std::string, SceneDescription>;  // of the catalogue by its name, or its own

struct Case {
    std::string name{};  // also of its files
    CaseScene scene{};
    OptionTexts options{};
    std::string wanted{};  // the outcome that the case asks for; any other that is expected leaves its bars open
    Checks checks{};
    Expectations expected{};
    bool quick = false;  // also in the quick report

    const SceneDescription* own() const { return std::get_if<SceneDescription>(&scene); }
};

// Cases that belong together: one heading of the page.
struct Chapter {
    std::string name;     // of its picture, and of --only
    std::string heading;  // what is asked
    std::vector<Case> cases{};

    // A case whose members these are.
    void add(const std::string& case_name, const CaseScene& scene, const OptionTexts& options,
             const std::string& wanted, const Checks& checks, const Expectations& expected, bool quick = false) {
        cases.push_back({case_name, scene, options, wanted, checks, expected, quick});
    }

    // The same scene at 60 Hz and with 16 engine steps in each step, for as many seconds. `checks` and `expected`
    // may depend on the length of an engine step [s]; in the quick report it is only at 60 Hz.
    template <typename MakeChecks, typename MakeExpected>
    void add_at_both_steps(const std::string& case_name, const SceneDescription& scene, const std::string& seconds,
                           const std::string& wanted, const MakeChecks& checks, const MakeExpected& expected,
                           bool quick = false) {
        constexpr double step = 1.0 / 60.0;
        add(case_name, scene, {{"seconds", seconds}}, wanted, checks(step), expected(step), quick);
        add(case_name + "-16-substeps", scene, {{"seconds", seconds}, {"substeps", "16"}}, wanted,
            checks(step / 16.0), expected(step / 16.0));
    }
};

// The same expectation of the presets default and exact.
inline Expectations of_both(const std::string& outcome) {
    return {{"default", outcome}, {"exact", outcome}};
}

inline Expectations with_paper(const std::string& outcome, const std::string& of_paper,
                               const Reached& reached = {}) {
    return {{"default", outcome}, {"exact", outcome}, {"paper", of_paper, reached}};
}

// Contacts of the default preset settle by `seat` [m] at a moment that roundings decide, and tilt a cube of 1 m by
// as much; those of exact do not. So default may miss its bars by this, check by check.
constexpr double seat = 2e-6;

inline Expectations settling(const std::string& outcome, const Reached& reached) {
    return {{"default", outcome, reached}, {"exact", outcome}};
}

// Chapters, file by file.
std::vector<Chapter> standing_chapters();   // towers, cubes of all sizes, overlaps, cards and planks, structures
std::vector<Chapter> structure_chapters();  // members of the families
std::vector<Chapter> motion_chapters();     // what is fast, turns or bounces
std::vector<Chapter> sliding_chapters();    // friction, and floors of flush boxes
std::vector<Chapter> bar_chapters();        // bars, and scenes with little or nothing in them

// All in the order of the page; of the quick report those with quick cases, and only these cases.
std::vector<Chapter> chapters(bool quick);

}  // namespace pushfactor::demos::reports::stability
