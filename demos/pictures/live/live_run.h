// A page in a browser that steps a run as it likes: what it has to choose from, and what the run shows as numbers
// and as JSON. The browser's side is in assets/live.
#pragma once

#include "demos/base/text/json.h"
#include "demos/options/comparison.h"
#include "demos/options/named_run.h"
#include "demos/runs/simulation.h"

#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::pictures::live {

class LiveRun {
  public:
    // A scene of the catalogue, or the path of a scene file, with options as on the command line. Throws UsageError
    // and engine::InvalidInput as the command line does.
    LiveRun(const std::string& scene, const OptionTexts& options);

    // What does not change: bodies, links, camera (replay::stage_of), the length of a step.
    Json about() const;
    // Of polyhedra, as replay::polyhedra_of.
    std::string meshes() const;

    // Takes steps. Throws NonFiniteError as Simulation::advance() does.
    void advance(long steps);

    // The state: step, time [s], and how many follow of each: lines of measures, bodies, recorded bodies, what
    // acts. Then per step since the last call, or for the start, the measures: kinetic and potential energy [J],
    // deepest overlap [m], largest speed, residual, largest stored speed upwards [m/s]. Then per body position [m]
    // and orientation (w first); per recorded body velocity and angular velocity [m/s, rad/s]; and 15 numbers each
    // for what acts: kind, body, other, place [m], force [N], push of this step only and push that lasts [m/s].
    // Everything with its last bit.
    std::vector<double> numbers();

    // engine::state_hash in 16 hexadecimal digits.
    std::string state_hash() const;
    // The command that makes the same run up to here, and prints this hash.
    std::string command() const;

    const Simulation& simulation() const { return simulation_; }

  private:
    void measure();

    OptionTexts options_;
    ComparedRun run_;
    Simulation simulation_;
    std::vector<std::size_t> recorded_;  // bodies
    std::vector<double> measures_;       // since the last call of numbers()
};

// The scenes with their parameters, the presets, the options of a simulation with what they allow, what the arrows
// mean, version and build.
Json menu();

// Whether the page has an option of a simulation: it steps as long as it is looked at, and on one thread.
bool is_on_menu(std::string_view option);

}  // namespace pushfactor::demos::pictures::live
