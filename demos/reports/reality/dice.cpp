// Cuboid dice with a square cross-section: how often one of the two square faces ends up on top.
#include "demos/base/platform/assets.h"
#include "demos/figures/plot.h"
#include "demos/reports/reality/sections.h"
#include "demos/scenes/random.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Vector3;

constexpr double square = 0.012;  // m, edge of the square face
constexpr double steel = 7800.0;  // kg/m^3
constexpr double gravity = 9.81;  // m/s^2
constexpr int most_seconds = 10;

SceneDescription thrown(double length, const Law& law, int number) {
    scenes::Random random(number);
    const Vector3 size(square, length * square, square);
    const engine::Quaternion orientation = scenes::random_orientation(random);
    const Vector3 axis = scenes::random_orientation(random) * Vector3::UnitX();
    const double rate = random.in(0.0, 60.0), speed = random.in(0.0, 1.0);
    return one_on_another("die", {.name = "table", .shape = PlaneShape{}},
                          {.name = "die",
                           .shape = BoxShape{size},
                           .mass = steel * size.prod(),
                           .position = Vector3(0, 0.2, 0),
                           .orientation = orientation,
                           .velocity = Vector3(speed, 0, 0),
                           .angular_velocity = rate * axis},
                          law);
}

// The face below, if the die can no longer get over one of its edges: 1 for the square one, none while it can. Over
// the border between two faces, where up_i / half_i is the same for both, the centre is nowhere lower than over
// their edge.
std::optional<Eigen::Index> decided_axis(const engine::Body& die, double length) {
    const Vector3 half(0.5 * square, 0.5 * length * square, 0.5 * square);
    const Vector3 up = die.orientation.conjugate() * Vector3::UnitY();
    Eigen::Index axis = 0;
    up.cwiseAbs().cwiseQuotient(half).maxCoeff(&axis);
    double barrier = half.norm();
    for (Eigen::Index other = 0; other < 3; ++other) {
        if (other != axis) barrier = std::min(barrier, std::hypot(half[axis], half[other]));
    }
    const double kinetic = 0.5 * die.inverse_mass * die.linear_momentum.squaredNorm() +
                           0.5 * die.angular_momentum.dot(engine::angular_velocity(die));
    if (kinetic * die.inverse_mass + gravity * die.position.y() >= gravity * barrier) return {};
    return axis;
}

bool ends_on_square(double length, const Law& law, int number) {
    Settings settings = preset_settings("default");
    settings.threads = 1;
    BuiltScene scene = build_scene(thrown(length, law, number), settings);
    const engine::Body& die = scene.world.bodies.at(1);
    for (int step = 0; step < most_seconds * 240; ++step) {
        if (const auto axis = decided_axis(die, length)) return *axis == 1;
        scene.step(scene.world, 1.0 / 240.0);
    }
    throw RunError("a die of length {} does not come to rest", length);
}

// Of assets/measured/dice.csv (Mathematical Gazette 97.16, 2013): steel dice.
struct Die {
    double length = 1.0;  // over the edge of the square
    double share = 0.0;   // of throws with a square face on top
    int throws = 0;
};

double variance(double share, int throws) {
    // One throw more of each outcome, so that a share of 0 has an error too.
    const double p = (share * throws + 1.0) / (throws + 2.0);
    return p * (1.0 - p) / throws;
}

}  // namespace

int square_faces(double length, const Law& law, int throws, const StopCheck& check) {
    int found = 0;
    for (int number = 0; number < throws; ++number) {
        check();
        found += ends_on_square(length, law, number) ? 1 : 0;
    }
    return found;
}

void add_dice(StudyRun& run) {
    std::vector<Die> dice;
    for (const auto& line :
         numbers_of(asset_folder("measured") / "dice.csv", "length_over_square_edge,share_square_face_up,throws")) {
        dice.push_back({line[0], line[1], static_cast<int>(line[2])});
    }
    const int throws = run.quick() ? 200 : 2000;
    std::vector<Law> laws;
    Pieces pieces;
    for (const double friction : run.quick() ? std::vector{0.2, 0.4} : std::vector{0.2, 0.3, 0.4, 0.6}) {
        for (const double restitution : run.quick() ? std::vector{0.3, 0.6} : std::vector{0.2, 0.4, 0.6}) {
            const Law& law = laws.emplace_back(Law{friction, restitution});
            pieces.push_back({fmt::format("reality: {} throws of each die, friction {}, restitution {}", throws,
                                          friction, restitution),
                              [=](const StopCheck& check) {
                                  std::vector<double> shares;
                                  for (const Die& die : dice)
                                      shares.push_back(square_faces(die.length, law, throws, check) /
                                                       static_cast<double>(throws));
                                  return json_numbers(shares);
                              }});
        }
    }
    run.gather(pieces);

    std::vector<std::vector<double>> shares;
    std::vector<double> sums;
    Table fits{{"friction", "restitution", "chi2_of_15"}};
    for (std::size_t i = 0; i < laws.size(); ++i) {
        shares.push_back(numbers_in(run.result(pieces[i].key)));
        double sum = 0.0;
        for (std::size_t d = 0; d < dice.size(); ++d) {
            const double off = shares[i][d] - dice[d].share;
            sum += off * off / (variance(dice[d].share, dice[d].throws) + variance(shares[i][d], throws));
        }
        fits.rows.push_back({laws[i].friction, laws[i].restitution, sum});
        sums.push_back(sum);
    }
    const auto best = static_cast<std::size_t>(std::ranges::min_element(sums) - sums.begin());
    Table table{{"length_over_edge", "measured", "measured_error", "computed", "computed_error", "off", "lowest",
                 "highest"}};
    std::vector<double> far;
    for (std::size_t d = 0; d < dice.size(); ++d) {
        const auto [low, high] = std::ranges::minmax(shares, {}, [d](const auto& one) { return one[d]; });
        const double off = shares[best][d] - dice[d].share;
        if (std::abs(off) > 0.05) far.push_back(dice[d].length);
        table.rows.push_back({dice[d].length, dice[d].share, std::sqrt(variance(dice[d].share, dice[d].throws)),
                              shares[best][d], std::sqrt(variance(shares[best][d], throws)), off, low[d], high[d]});
    }
    SectionContent content = run.tabulated("dice.csv", table, "");
    run.write("dice_fit.csv", fits);
    content.files.emplace_back("dice_fit.csv");
    content.caption = fmt::format(
        "Share of throws of steel dice that end with a square face on top, over their length divided by the edge "
        "of the square. Measured: Mathematical Gazette 97.16 (2013), 9,329 throws. Computed: {} throws of each, "
        "dropped from 0.2 m (17 edges) in any orientation, turning about any axis at up to 60 rad/s, at up to 1 "
        "m/s sideways, onto a plane; how the real ones were thrown is not known. Friction {} and restitution {} "
        "fit best of {} pairs (chi squared {:.0f} for 15 dice); lowest and highest are over all pairs. Errors are "
        "one standard deviation. Off by more than 0.05: {}. A share that falls with length cannot meet all: those "
        "measured at 1.16 and 1.23 are in the other order.",
        throws, laws[best].friction, laws[best].restitution, laws.size(), sums[best],
        far.empty() ? "none" : fmt::format("{} of 15 (length over edge {})", far.size(), fmt::join(far, ", ")));
    add_plot({.script = "dice", .data = "dice.dat", .name = "dice_shares"}, csv_text(table), run.folder(), content);
    run.sections.push_back({"dice", "Dice of fifteen lengths", content});
}

}  // namespace pushfactor::demos::reports::reality
