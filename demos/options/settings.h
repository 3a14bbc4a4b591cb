// The choices of one simulation, and the presets that name whole sets of them.
#pragma once

#include "demos/text/rational.h"
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
// How a step is gone through: as the paper does, in small ones where that gets farther, or for bars alone in
// another way. Automatic: in small steps with the solver auto and a tolerance, else whole.
enum class Scheme { automatic, whole, small_steps, rattle, rattle4, rattle6 };

constexpr bool is_rattle(Scheme scheme) {
    return scheme >= Scheme::rattle;
}

struct Settings {
    std::string preset;

    Rational dt{1, 60};               // s
    std::optional<int> substeps = 1;  // engine steps in one step of the run; as many as the state asks for without
    double seconds = 10.0;            // simulated time, whole steps of it

    std::string solver = "auto";   // name in the solver table
    int iterations = 25;           // at most, a solve
    double tolerance_high = 1e-8;  // m/s: below it the cached answer is kept
    double tolerance_low = 1e-10;  // m/s: above it a solve goes on

    Scheme scheme = Scheme::automatic;
    std::optional<engine::SmallSteps::Division> small_steps;  // none: as many as suit an island

    engine::Correction contacts{engine::PushKind::single_frame, 0.2};
    engine::Correction distances{engine::PushKind::persistent, 1.0};
    bool warm_start = true;
    double slop = 0.002;   // fraction of the body's size
    double margin = 0.01;  // fraction of the body's size
    engine::RowOrder row_order = engine::RowOrder::bottom_up;
    bool four_points = true;  // a face manifold keeps at most four

    FrictionModel friction_model = FrictionModel::cone;
    std::optional<double> friction;  // mu of all bodies; each scene has its own otherwise

    RestitutionModel restitution_model = RestitutionModel::larger;
    std::optional<double> restitution;  // epsilon of all bodies; each scene has its own otherwise

    // Half a kick back before the first step of euler; it fits where a scene has no contacts and starts from rest.
    StartKick start_kick = StartKick::where_it_fits;
    Rotation rotation = Rotation::splitting;

    int threads = 0;    // that share a step, to the same bits; 0: as many as the machine runs at once
    bool rest = false;  // islands that stay where they are are left out of steps (engine/step/rest.h)
};

struct Preset {
    std::string_view name;
    std::string_view description;
    Settings (*settings)();
};

std::span<const Preset> presets();

// Throws std::out_of_range when there is no such preset.
Settings preset_settings(std::string_view name);

}  // namespace pushfactor::demos
