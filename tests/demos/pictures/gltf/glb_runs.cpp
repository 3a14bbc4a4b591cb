#include "tests/demos/pictures/gltf/glb_runs.h"

#include "demos/options/named_run.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/scenes/catalogue.h"
#include "tests/demos/csv.h"

#include <algorithm>

namespace pushfactor::tests {

using namespace demos;

namespace {

Trajectory trajectory_of(const std::string& csv) {
    Trajectory found;
    const auto table = table_of(csv);
    for (std::size_t line = 1; line < table.size(); ++line) {
        std::array<double, 7> pose{};
        for (std::size_t i = 0; i < 7; ++i) pose[i] = std::stod(table[line][i + 2]);
        found[std::stoi(table[line][1])].push_back(pose);
    }
    return found;
}

}  // namespace

Glb recorded(const Choices& choices, const std::function<void(const Simulation&)>& observe) {
    const Folder folder;
    Simulation run(choices);
    const std::vector<ComparedRun> runs{{.label = "", .choices = choices}};
    const long steps = whole_steps(choices.settings);
    const std::vector<Frames> frames{plan_frames(choices.frames, choices.settings.dt, steps)};
    pictures::SurveyOnce survey(frames);
    const auto record = pictures::glb_record(folder / "a.glb", runs, survey, run);
    if (observe) observe(run);
    while (run.sample().step < steps) {
        run.advance();
        record->observe(run);
        if (observe) observe(run);
    }
    record->finish();
    return Glb(folder.read("a.glb"));
}

double apart(const std::array<double, 7>& a, const Vector3& position, const Quaternion& rotation) {
    const Eigen::Vector4d q(a[4], a[5], a[6], a[3]);
    const double turned =
        std::min((q - rotation.coeffs()).cwiseAbs().maxCoeff(), (q + rotation.coeffs()).cwiseAbs().maxCoeff());
    return std::max((Vector3(a.data()) - position).cwiseAbs().maxCoeff(), turned);
}

Written::Written(const std::string& scene) {
    const Ended ended =
        shell(folder, "pushfactor run " + scene +
                          " --seconds 0.5 --fps 60 --glb a.glb --trajectory a.csv --summary /dev/null");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    trajectory = trajectory_of(folder.read("a.csv"));
    REQUIRE(!trajectory.empty());
}

std::vector<std::string> named_scenes() {
    std::vector<std::string> names;
    for (const SceneEntry& entry : catalogue()) names.emplace_back(entry.name);
    return names;
}

}  // namespace pushfactor::tests
