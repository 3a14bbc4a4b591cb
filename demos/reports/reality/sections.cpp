#include "demos/reports/reality/sections.h"

#include "demos/figures/plot.h"
#include "demos/reports/reality/closed_forms.h"
#include "demos/reports/reality/dice.h"
#include "demos/reports/reality/packing.h"
#include "demos/reports/reality/statistics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::demos::reports::reality {

void add_closed_forms(StudyRun& run) {
    Table table{
        {"motion", "formula", "exact", "cone", "square", "paper", "error_cone", "error_square", "error_paper"}};
    run.begin(closed_forms().size());
    for (const ClosedForm& form : closed_forms()) {
        run.stop_if_interrupted();
        const double cone = form.computed(FrictionModel::cone), square = form.computed(FrictionModel::coulomb),
                     paper = form.computed(FrictionModel::paper);
        table.rows.push_back({form.name, form.formula, form.exact, cone, square, paper, std::abs(cone - form.exact),
                              std::abs(square - form.exact), std::abs(paper - form.exact)});
        run.count_run();
    }
    run.write("closed_forms.csv", table);
    SectionContent content;
    content.table = page_lines(table);
    content.files = {"closed_forms.csv"};
    content.caption =
        "Steps of 1 ms (0.1 ms for the rocking block), otherwise default, under each model of friction: the round "
        "cone, a square of two tangents, and the paper's, whose friction does not know the force of its contact.";
    run.sections.push_back({"closed-forms", "Motions that are known in closed form", content});
}

namespace {

std::vector<Bounce> bounces_of(bool quick) {
    std::vector<Bounce> all;
    for (const double friction : quick ? std::vector{0.2, 0.4} : std::vector{0.2, 0.3, 0.4, 0.6}) {
        for (const double restitution : quick ? std::vector{0.3, 0.6} : std::vector{0.2, 0.4, 0.6}) {
            all.push_back({friction, restitution});
        }
    }
    return all;
}

std::string key_of(const Bounce& bounce, int throws) {
    return fmt::format("reality: {} throws of each die, friction {}, restitution {}", throws, bounce.friction,
                       bounce.restitution);
}

Piece throws_of(const std::vector<Die>& dice, const Bounce& bounce, int throws) {
    return {
        key_of(bounce, throws), [=](const std::function<void()>& check) {
            std::vector<double> shares;
            for (const Die& die : dice) {
                shares.push_back(static_cast<double>(square_faces(die.length, bounce, 0, throws, check)) / throws);
            }
            return json_numbers(shares);
        }};
}

double variance(double share, int throws) {
    // One throw more of each outcome, so that a share of 0 has an error too.
    const double p = (share * throws + 1.0) / (throws + 2.0);
    return p * (1.0 - p) / throws;
}

}  // namespace

void add_dice(StudyRun& run) {
    const std::vector<Die> dice = read_dice();
    const int throws = run.quick() ? 200 : 2000;
    const std::vector<Bounce> bounces = bounces_of(run.quick());
    Pieces pieces;
    for (const Bounce& bounce : bounces) pieces.push_back(throws_of(dice, bounce, throws));
    run.gather(pieces);

    std::vector<std::vector<double>> shares;
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    Table fits{{"friction", "restitution", "chi2_of_15"}};
    for (std::size_t i = 0; i < bounces.size(); ++i) {
        shares.push_back(numbers_in(run.result(pieces[i].key)));
        double sum = 0.0;
        for (std::size_t d = 0; d < dice.size(); ++d) {
            const double off = shares[i][d] - dice[d].share;
            sum += off * off / (variance(dice[d].share, dice[d].throws) + variance(shares[i][d], throws));
        }
        fits.rows.push_back({bounces[i].friction, bounces[i].restitution, sum});
        if (sum < least) {
            least = sum;
            best = i;
        }
    }
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
    run.write("dice.csv", table);
    run.write("dice_fit.csv", fits);
    SectionContent content;
    content.table = page_lines(table);
    content.files = {"dice.csv", "dice_fit.csv"};
    content.caption = fmt::format(
        "Share of throws of steel dice that end with a square face on top, over their length divided by the edge "
        "of the square. Measured: Mathematical Gazette 97.16 (2013), 9,329 throws. Computed: {} throws of each, "
        "dropped from 0.2 m (17 edges) in any orientation, turning about any axis at up to 60 rad/s, at up to 1 "
        "m/s sideways, onto a plane; how the real ones were thrown is not known. Friction {} and restitution {} "
        "fit best of {} pairs (chi squared {:.0f} for 15 dice); lowest and highest are over all pairs. Errors are "
        "one standard deviation. Off by more than 0.05: {}. A share that falls with length cannot meet all: those "
        "measured at 1.16 and 1.23 are in the other order.",
        throws, bounces[best].friction, bounces[best].restitution, bounces.size(), least,
        far.empty() ? "none" : fmt::format("{} of 15 (length over edge {})", far.size(), fmt::join(far, ", ")));
    add_plot({.script = "dice", .data = "dice.dat", .name = "dice_shares"}, csv_text(table), run.folder(), content);
    run.sections.push_back({"dice", "Dice of fifteen lengths", content});
}

namespace {

// How many measured values are within 0.02 of what is computed for the frictions, or between.
struct Met {
    int met = 0, all = 0;

    void add(const std::optional<double>& measured, const std::vector<double>& computed) {
        if (!measured) return;
        const auto [low, high] = std::ranges::minmax(computed);
        ++all;
        met += *measured > low - 0.02 && *measured < high + 0.02 ? 1 : 0;
    }
};

}  // namespace

void add_packings(StudyRun& run) {
    const std::vector<double> frictions = run.quick() ? std::vector{0.5} : std::vector{0.2, 0.8};
    const double width = run.quick() ? 6.0 : 8.0;
    const int bodies = run.quick() ? 300 : 600, shakes = run.quick() ? 10 : 40;
    const auto key = [&](const std::string& solid, double friction) {
        return fmt::format("reality: {} of {} with friction {}, shaken {} times", bodies, solid, friction, shakes);
    };
    Pieces pieces;
    std::vector<MeasuredPacking> wanted = read_packings();
    if (run.quick()) wanted = {wanted[0], wanted[2]};
    for (const MeasuredPacking& one : wanted) {
        for (const double friction : frictions) {
            const Container container{width, bodies, friction, shakes};
            pieces.push_back({key(one.solid, friction), [=, solid = one.solid](const std::function<void()>& check) {
                                  const Packing found = packed(solid, container, check);
                                  return json_numbers({found.loose, found.loose_error, found.dense,
                                                       found.dense_error, found.deepest});
                              }});
        }
    }
    run.gather(pieces);
    Table table{{"solid", "friction", "poured", "poured_error", "measured_loose", "shaken", "shaken_error",
                 "measured_dense", "deepest_overlap_m"}};
    Met loose, dense;
    for (const MeasuredPacking& one : wanted) {
        std::vector<double> poured, shaken;
        for (const double friction : frictions) {
            const std::vector<double> found = numbers_in(run.result(key(one.solid, friction)));
            table.rows.push_back(
                {one.solid, friction, found[0], found[1], one.loose, found[2], found[3], one.dense, found[4]});
            poured.push_back(found[0]);
            shaken.push_back(found[2]);
        }
        loose.add(one.loose, poured);
        dense.add(one.dense, shaken);
    }
    run.write("packings.csv", table);
    SectionContent content;
    content.table = page_lines(table);
    content.files = {"packings.csv"};
    content.caption = fmt::format(
        "Share of the volume that {} equal bodies fill in a box {} m wide, 2 m and more from walls and surface; "
        "all have the volume of a ball of 1 m. They are poured in layers of 25, each from just above the heap, "
        "then shaken up and down {} times at 3 Hz by 0.1 m (3.6 g). Errors: one standard deviation of the mean "
        "over eight parts of the region. Measured: Baker and Kudrolli (2010, arXiv 1008.1728), +-0.01. Their "
        "friction is not known, and it decides how loose a heap is: {} of {} loose and {} of {} dense values are "
        "between those that are computed, or within 0.02 of one.",
        bodies, width, shakes, loose.met, loose.all, dense.met, dense.all);
    run.sections.push_back({"packings", "Heaps of spheres and regular solids", content});
}

}  // namespace pushfactor::demos::reports::reality
