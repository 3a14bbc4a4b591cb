// Settings of one simulation, and the presets.
#pragma once

#include "demos/base/text/rational.h"
#include "engine/constraints/contact_order.h"
#include "engine/constraints/push_factor.h"
#include "engine/step/small_steps.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos {

enum class FrictionModel { paper, coulomb, cone };
enum class RestitutionModel { sum, larger };
enum class StartKick { off, on, where_it_fits };
enum class Rotation { paper, exponential, splitting };
// Stepping scheme: the paper's whole step, small steps for islands where they converge better, or RATTLE for scenes
// of bars alone. Automatic: small steps with the solver auto and a tolerance, else whole.
enum class Scheme { automatic, whole, small_steps, rattle, rattle4, rattle6 };

constexpr bool is_rattle(Scheme scheme) {
    return scheme >= Scheme::rattle;
}

struct Settings {
    std::string preset;

    Rational dt{1, 60};           // s
    std::optional<int> substeps;  // engine steps per step of the run; none: as many as bars and joints need
    double seconds = 10.0;        // simulated time, rounded down to whole steps

    std::string solver = "auto";   // name in the solver table
    int iterations = 25;           // per solve, at most
    double tolerance_high = 1e-8;  // m/s: cached forces with a residual below it are kept
    double tolerance_low = 1e-10;  // m/s: a solve stops below it

    Scheme scheme = Scheme::automatic;
    std::optional<engine::SmallSteps::Division> small_steps;  // none: chosen per island

    engine::Correction contacts{engine::PushKind::single_frame, 0.2};
    engine::Correction distances{engine::PushKind::curve, 1.0};
    bool warm_start = true;
    double slop = 0.002;   // fraction of the body's size
    double margin = 0.01;  // fraction of the body's size
    engine::RowOrder row_order = engine::RowOrder::bottom_up;
    bool four_points = true;  // face manifolds are reduced to four points

    FrictionModel friction_model = FrictionModel::cone;
    std::optional<double> friction;  // mu of all bodies; none: the scene's own

    RestitutionModel restitution_model = RestitutionModel::larger;
    std::optional<double> restitution;  // epsilon of all bodies; none: the scene's own

    // Initial momenta shifted back by half a step; where_it_fits: without contacts and from rest.
    StartKick start_kick = StartKick::where_it_fits;
    Rotation rotation = Rotation::splitting;

    std::string measured{};  // file of measured poses beside the scene (measured_motion.h); none when empty

    int threads = 0;    // per step, with bit-identical results; 0: all hardware threads
    bool rest = false;  // sleeping islands are skipped (engine/step/rest.h); never in RATTLE steps
};

struct Preset {
    std::string_view name;
    std::string_view description;
    Settings (*settings)();
};

// With a fixed number of iterations or another solver than auto, the automatic scheme keeps steps whole.
bool takes_small_steps(const Settings& settings);

std::span<const Preset> presets();

// Throws std::out_of_range when there is no such preset.
Settings preset_settings(std::string_view name);

}  // namespace pushfactor::demos
