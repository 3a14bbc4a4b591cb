// The stress list: its cases with their scenes, checks and the expectations per preset. Code that runs, judges and
// draws them knows no particular case.
#pragma once

#include "demos/options/named_run.h"
#include "demos/scenes/scene_description.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pushfactor::demos::reports::stability {

// A measured number and its bar: |measure - target| / scale, in units of measure / scale.
struct Check {
    std::string measure{};  // one of measures.cpp, or a number of the summary
    double bar = 0.0;
    double target = 0.0;
    double scale = 1.0;
    bool at_least = false;  // the bar is a minimum, else a maximum
};
using Checks = std::vector<Check>;

// Per check the value known to be reached if it misses its bar; empty: all bars are met.
using Reached = std::vector<std::optional<double>>;

// The known result of a case under one preset. If its outcome is not the wanted one, bars are judged only if
// `reached` is given.
struct Expected {
    std::string preset;
    std::string outcome;  // of the summary; or non-finite, failed
    Reached reached{};
};
using Expectations = std::vector<Expected>;

using CaseScene = std::variant<std::string, SceneDescription>;  // name in the catalogue, or its own scene

struct Case {
    std::string name{};  // also of its files
    CaseScene scene{};
    OptionTexts options{};
    std::string wanted{};  // required outcome; bars are not judged where another one is expected
    Checks checks{};
    Expectations expected{};
    bool quick = false;  // also in the quick report

    const SceneDescription* own() const { return std::get_if<SceneDescription>(&scene); }
};

// Engine steps of 1/60 s, and 16 in each; the quick report has only the first.
struct Steps {
    double dt;  // s, of an engine step
    const char *suffix, *substeps;
};
inline constexpr std::array both_steps{Steps{1.0 / 60.0, "", "1"}, Steps{1.0 / 960.0, "-16-substeps", "16"}};

// Related cases under one heading of the page.
struct Chapter {
    std::string name;     // of its picture, and of --only
    std::string heading;  // what the cases test
    std::vector<Case> cases{};

    // Adds a case with these members.
    void add(const std::string& case_name, const CaseScene& scene, const OptionTexts& options,
             const std::string& wanted, const Checks& checks, const Expectations& expected, bool quick = false) {
        cases.push_back({case_name, scene, options, wanted, checks, expected, quick});
    }
    void add(const Steps& steps, const std::string& case_name, const SceneDescription& scene,
             const std::string& seconds, const std::string& wanted, const Checks& checks,
             const Expectations& expected, bool quick = false) {
        add(case_name + steps.suffix, scene, {{"seconds", seconds}, {"substeps", steps.substeps}}, wanted, checks,
            expected, quick && steps.dt == both_steps[0].dt);
    }
};

// Contacts of the default preset settle by up to `seat` [m] at a time that rounding decides, and tilt a cube of 1 m
// as much; those of exact do not. So default may miss its bars by this amount.
constexpr double seat = 2e-6;

// The same expectation for the presets default and exact.
inline Expectations of_both(const std::string& outcome, const Reached& of_default = {}) {
    return {{"default", outcome, of_default}, {"exact", outcome}};
}

inline Expectations with_paper(const std::string& outcome, const std::string& of_paper,
                               const Reached& reached = {}) {
    return {{"default", outcome}, {"exact", outcome}, {"paper", of_paper, reached}};
}

// The chapters of each source file.
std::vector<Chapter> standing_chapters();   // towers, cubes of all sizes, overlaps, thin bodies
std::vector<Chapter> structure_chapters();  // members of the families
std::vector<Chapter> motion_chapters();     // fast, rotating and bouncing bodies
std::vector<Chapter> sliding_chapters();    // friction
std::vector<Chapter> seam_chapters();       // floors of flush boxes
std::vector<Chapter> bar_chapters();        // bars, and scenes with little or nothing in them

// All chapters in page order; for `quick` only quick cases and their chapters.
std::vector<Chapter> chapters(bool quick);

}  // namespace pushfactor::demos::reports::stability
