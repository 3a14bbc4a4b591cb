// The sections of the report on measured motion, and what they are made of.
#pragma once

#include "demos/reports/reality/tosses.h"
#include "demos/reports/study.h"

namespace pushfactor::demos::reports::reality {

void add_closed_forms(StudyRun& run);  // closed_forms.csv
void add_tosses(StudyRun& run);        // toss_fit.csv, tosses.csv, toss_errors.csv
void add_dice(StudyRun& run);          // dice.csv
void add_packings(StudyRun& run);      // packings.csv

// A body on another one with this law of contact, under gravity of 9.81 m/s^2.
inline SceneDescription one_on_another(const std::string& name, BodyDescription below, BodyDescription body,
                                       const Law& law = {}) {
    for (BodyDescription* const one : {&below, &body}) {
        one->friction = law.friction;
        one->restitution = law.restitution;
    }
    SceneDescription scene;
    scene.name = name;
    scene.gravity = engine::Vector3(0, -9.81, 0);
    scene.contacts = true;
    scene.bodies = {std::move(below), std::move(body)};
    return scene;
}

// Motions with friction whose result is known in closed form.
struct ClosedForm {
    std::string name;  // with what is measured and its unit
    std::string formula;
    double exact = 0.0;
    double (*computed)(FrictionModel model);
};
const std::vector<ClosedForm>& closed_forms();

// Cuboid dice with a square cross-section, `length` edges long: how many of `throws` computed ones end with a
// square face on top. A die of 12 mm falls from 0.2 m, at up to 1 m/s sideways, in any orientation and turning
// about any axis at up to 60 rad/s.
int square_faces(double length, const Law& law, int throws, const StopCheck& check);

// Packings of spheres and regular solids: those of assets/measured/packings.csv, shares of the volume, +-0.01:
// regular solids by Baker and Kudrolli (2010, arXiv 1008.1728); none where nothing was measured.
struct MeasuredPacking {
    std::string solid;
    std::optional<double> loose{}, dense{};
};
// Throws UsageError for a missing or damaged file.
std::vector<MeasuredPacking> read_packings();

// A box with a square floor.
struct Container {
    double width = 0.0;     // m
    int bodies = 0;         // all of the volume of a ball of 1 m
    double friction = 0.0;  // of bodies and walls
    int shakes = 0;
};

// Shares of the volume away from walls and surface after pouring and after shaking, each the mean over eight parts
// of the region.
struct Packing {
    Mean loose{}, dense{};
    double deepest = 0.0;  // m, overlap at the end
};
Packing packed(const std::string& solid, const Container& container, const StopCheck& check);

// The tosses as this engine computes them: one pose per frame, the start first; and the scene that gives these
// poses, with the measured motion of the cube.
std::vector<Pose> computed(const Restart& start, const Law& law, std::size_t frames);
SceneDescription scene_of(const Toss& toss, const Law& law);

}  // namespace pushfactor::demos::reports::reality
