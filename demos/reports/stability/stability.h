// The stress list: its cases with their scenes, checks and the expectations per preset; and how a case is run and
// judged. Code that runs, judges and draws them knows no particular case.
#pragma once

#include "demos/reports/study.h"
#include "demos/scenes/families/pieces.h"

#include <array>
#include <string_view>
#include <utility>
#include <variant>

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
using MakeChapter = Chapter();
MakeChapter heavy_on_light, heights, step_lengths, sizes_and_places, overlaps, thin, structures;  // standing.cpp
MakeChapter slopes, directions, slab, rolls, hovering;                                            // sliding.cpp
MakeChapter impacts, passing, turning, bounces, seams;                                            // motion.cpp
MakeChapter chains, ball_joints, redundant_bars, little;                                          // motion.cpp

// All chapters in page order; for `quick` only quick cases and their chapters.
std::vector<Chapter> chapters(bool quick);

// Building blocks of the scenes, and those that several files know. Bodies that do not touch each other share a
// scene. Unless stated otherwise cubes have 1 m and bodies 1 kg; speeds are in m/s, angles in rad.

using engine::Vector3;
using families::inclined;
using families::turned;

constexpr double usual_gravity = 10.0;  // m/s^2

inline BodyDescription ground() {
    return {.name = "ground", .shape = PlaneShape{}};
}

inline BodyDescription ball(double radius, const Vector3& position, const Vector3& velocity = Vector3::Zero()) {
    return {.name = "ball", .shape = SphereShape{radius}, .mass = 1.0, .position = position, .velocity = velocity};
}

inline BodyDescription box(const std::string& name, const Vector3& size, const Vector3& position,
                           const Vector3& velocity = Vector3::Zero()) {
    return {.name = name, .shape = BoxShape{size}, .mass = 1.0, .position = position, .velocity = velocity};
}

// Of 1 m, with this number from 0.
inline BodyDescription cube(int number, const Vector3& position, const Vector3& velocity = Vector3::Zero()) {
    return box("cube " + std::to_string(number + 1), Vector3::Ones(), position, velocity);
}

inline BodyDescription wall(const std::string& name, const Vector3& size, const Vector3& position) {
    return {.name = name, .shape = BoxShape{size}, .position = position};
}

// A horizontal vector of this length, turned by `angle` about the vertical from the x axis.
inline Vector3 along(double angle, double length) {
    return turned(angle) * Vector3(length, 0, 0);
}

// Angular velocity [rad/s] with which a ball rolls on level ground at `velocity`.
inline Vector3 rolling(const Vector3& velocity, double radius) {
    return Vector3::UnitY().cross(velocity) / radius;
}

// A view of the origin from the right; `height` is the upward component of the direction. Pictures find their own
// distance.
inline View seen_from(double height) {
    return {.eye = 20.0 * Vector3(0.45, height, 1.0).normalized(), .target = Vector3::Zero()};
}

inline SceneDescription scene_of(const std::string& name, std::vector<BodyDescription> bodies) {
    SceneDescription scene;
    scene.name = name;
    scene.bodies = std::move(bodies);
    return scene;
}

// Bodies that may touch; `height` as in seen_from(), 0 for the usual view.
inline SceneDescription touching(const std::string& name, std::vector<BodyDescription> bodies,
                                 double height = 0.0) {
    SceneDescription scene = scene_of(name, std::move(bodies));
    scene.contacts = true;
    if (height > 0.0) scene.view = seen_from(height);
    return scene;
}

inline SceneDescription with_friction(SceneDescription scene, double friction) {
    for (BodyDescription& body : scene.bodies) body.friction = friction;
    return scene;
}

// Five stacked cubes, each overlapping the one below by a ten-thousandth of its side and slightly offset, so that
// no symmetry helps.
struct Pile {
    double side = 1.0;                 // m, of cubes as dense as water
    Vector3 origin = Vector3::Zero();  // m, below the lowest
    double gravity = usual_gravity;    // m/s^2
};
SceneDescription pile(const Pile& pile);

SceneDescription bouncing_ball();  // radius 0.1 m, dropped by 2 m, restitution 1

// Cards of 1 x 0.01 x 0.6 m: one inclined by `angle` against the edge of a box 0.4 m high; and two that lean
// against each other, each standing on its long edge.
constexpr double card_thickness = 0.01;  // m
SceneDescription card_leaning(double angle);
SceneDescription card_house(double angle);

// s, by the elliptic integral: of a rod 1 x 0.04 x 0.04 m that is hung by its end, from rest, `angle` from hanging.
double rod_pendulum_period(double angle);

// Five rods 0.5 x 0.04 x 0.04 m joined by ball joints, in a straight line `angle` from hanging, at rest.
SceneDescription ball_joint_chain(double angle);

// 16 cubes in a ring that slide outwards, each in a different direction relative to its edges, on a plane or a box.
SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box);

// A slab of 1 x 0.2 x 1 m that slides and turns by `spin` [rad/s] about the vertical; gravity 9.81 m/s^2.
SceneDescription spinning_slab(double speed, double spin, double friction);

// Sliding distance of a slab that spins about the vertical while it slides: rigid, Coulomb friction at its four
// lower corners, always lying flat.
//
// The loads N of the corners follow from the weight and the moments about both horizontal axes (friction acts half
// the height below the centre): three equations for four unknowns. The fourth is a choice: here loads are linear in
// the position, as for a slab on elastic ground. Shifting a tenth of the weight from one pair of opposite corners
// to the other changes the result by half a percent.
struct Slab {
    double side = 1.0;      // m, of its square
    double height = 0.2;    // m
    double friction = 0.3;  // mu
    double gravity = 9.81;  // m/s^2
};

// Distance from start to stop [m] for `speed` [m/s] and `spin` [rad/s], not both zero.
double slide_of(const Slab& slab, double speed, double spin);

struct Ride {
    double speed = 4.0;   // m/s
    double angle = 0.0;   // rad, about the vertical, between the direction of motion and the rows of boxes
    double uneven = 0.0;  // m, by which every other box lies lower
};

// A cube and a plank 2 x 0.2 x 0.2 m, which slide without friction, and on an even floor a rolling ball of radius
// 0.5 m: on a floor of boxes, and the same bodies again on a single box behind it. The higher boxes of an uneven
// floor carry the bodies, so that both should move alike.
SceneDescription seam_floor(const Ride& ride);

// A trial: one case under one preset, run in a separate process so that cases cannot affect each other, and its
// verdicts; and the measures by which it is judged, computed from the output files of the run.

// A CSV file of numbers, by column; other text is NaN.
using Columns = std::map<std::string, std::vector<double>, std::less<>>;

// Output of one run.
struct Evidence {
    const SceneDescription* scene = nullptr;
    Json summary{};
    std::map<std::string, Columns> outputs{};  // by option: "csv", "trajectory", "rows"
};

// The measured value, or one per body; empty if the run does not have it.
std::vector<double> take(const std::string& measure, const Evidence& evidence);

// The option whose file the measure is computed from; empty if the summary is enough.
std::string_view output_of(const std::string& measure);

struct Verdict {
    const Check* check = nullptr;   // null if only the outcome is checked
    std::optional<double> value{};  // the worst of several bodies
    std::optional<double> known{};  // known to be reached, instead of the bar
    bool met = true;                // the bar is met
    bool holds = true;              // as expected, or better
};

class Trial {
  public:
    // `one` and `expected` must outlive the trial. Its scene file, if it has one, is in `folder`/scenes; the output
    // of the run is in `folder`/runs.
    Trial(const Case& one, const Expected& expected, const std::filesystem::path& folder);

    const Case& one() const { return one_; }
    const Expected& expected() const { return expected_; }
    std::string name() const { return one_.name + "-" + expected_.preset; }
    const std::string& command() const { return command_; }  // that reproduces it

    // Names everything that decides the result.
    std::string key() const;

    // Runs it: outcome, values of each check, none if it does not reach its end, and files. `program` is the path
    // of this program. Throws ChildProcessError.
    Json run(const std::filesystem::path& program, const StopCheck& check) const;

    // Judges what run() returned, here or elsewhere, and writes its files.
    void judge(const Json& result);

    // Valid after judge().
    const std::string& outcome() const { return outcome_; }
    const std::vector<Verdict>& verdicts() const { return verdicts_; }  // at least one
    bool holds() const { return std::ranges::all_of(verdicts_, &Verdict::holds); }

    const SceneDescription& start() const { return start_; }

    // In the folder; missing if the run did not start.
    std::string replay() const { return "runs/" + name() + ".html"; }

    // Scene file of the last state; missing if the run failed.
    std::filesystem::path state() const { return file("-state.json"); }

  private:
    // Of the run, relative to the folder and in it.
    std::string name_of(const std::string& what) const { return "runs/" + name() + what; }
    std::filesystem::path file(const std::string& what) const { return folder_ / name_of(what); }

    const Case& one_;
    const Expected& expected_;
    std::filesystem::path folder_;
    std::string scene_;
    OptionTexts options_;
    SceneDescription start_;
    std::vector<std::string> outputs_;  // output options that the measures need
    std::string command_;
    std::string outcome_;
    std::vector<Verdict> verdicts_;
};

// Writes the scene files of the cases with a scene of their own.
void write_scenes(const std::vector<Chapter>& chapters, const std::filesystem::path& folder);

}  // namespace pushfactor::demos::reports::stability
