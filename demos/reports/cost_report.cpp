// Work and time per step of each scene, and the savings from absent parts: cost.csv, side_by_side.csv, plots, and
// files of the scenes with everything and of the common worlds.
#include "demos/base/platform/plain_name.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"
#include "demos/figures/plot.h"
#include "demos/reports/cost/cost.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace pushfactor::demos::reports {

namespace {

using namespace cost;

constexpr const char* side_by_side = "side-by-side";

// A scene as it is and with everything, and the commands that reproduce the steps.
struct Entry {
    std::string name;
    double start = 0.0;  // s, simulated
    Ledger own, all;
};

double thousandths(double us) {
    return std::round(1000.0 * us) / 1000.0;
}

std::string joined(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, " + "));
}

// A line of cost.csv, by column.
std::vector<std::pair<std::string, Cell>> line_of(const Entry& entry, bool everything) {
    const auto& [parts, bodies, counts, times, command] = everything ? entry.all : entry.own;
    std::vector<std::pair<std::string, Cell>> line{{"scene", entry.name},
                                                   {"start_s", entry.start},
                                                   {"made", everything ? "everything" : "as it is"},
                                                   {"bodies", bodies},
                                                   {"force_sources", joined(parts.forces)},
                                                   {"constraint_sources", joined(parts.constraints)},
                                                   {"contact_rules", joined(parts.contacts)},
                                                   {"step_rules", joined(parts.step_rules)}};
    for (const CountColumn& column : row_columns) line.emplace_back(column.name, counts.*column.value);
    for (std::size_t k = 0; k < island_kinds.size(); ++k) {
        for (std::size_t w = 0; w < island_ways.size(); ++w)
            line.emplace_back(fmt::format("{}_{}", island_kinds[k], island_ways[w]), counts.islands[k].by_way[w]);
    }
    for (const CountColumn& column : work_columns) line.emplace_back(column.name, counts.*column.value);
    const bool touches = counts.contact_rows > 0.0;
    line.emplace_back("step_us", thousandths(times.step));
    line.emplace_back("us_per_contact", touches ? Cell(thousandths(times.step / counts.contact_rows)) : Cell());
    line.emplace_back("bytes_per_contact",
                      touches && times.bytes ? Cell(std::round(*times.bytes / counts.contact_rows)) : Cell());
    for (std::size_t i = 0; i < phase_names.size(); ++i)
        line.emplace_back(fmt::format("{}_us", phase_names[i]), thousandths(times.stages[i]));
    line.emplace_back("command", command);
    return line;
}

// A line per entry for the scene as it is, and if `both` another with everything.
Table table_of(const std::vector<Entry>& entries, bool both) {
    Table table;
    for (const Entry& entry : entries) {
        for (const bool everything : both ? std::vector{false, true} : std::vector{false}) {
            table.columns.clear();
            std::vector<Cell>& row = table.rows.emplace_back();
            for (const auto& [column, cell] : line_of(entry, everything)) {
                table.columns.push_back(column);
                row.push_back(cell);
            }
        }
    }
    return table;
}

// A line per scene and kind of island.
Table islands_of(const std::vector<Entry>& entries) {
    Table table{{"scene", "kind", "islands", "kept", "swept", "exact", "small steps"}};
    for (const Entry& entry : entries) {
        for (std::size_t k = 0; k < island_kinds.size(); ++k) {
            const IslandCounts& kind = entry.own.counts.islands[k];
            if (kind.all() == 0.0) continue;
            std::vector<Cell>& row = table.rows.emplace_back();
            row = {entry.name, island_kinds[k], kind.all()};
            row.insert(row.end(), kind.by_way.begin(), kind.by_way.end());
        }
    }
    return table;
}

Cell ratio(double everything, double as_it_is) {
    if (everything == as_it_is) return 1.0;
    return as_it_is > 0.0 ? fmt::format("{:.2f}", everything / as_it_is) : "from 0";
}

Table comparison_of(const std::vector<Entry>& entries) {
    Table table{{"scene", "rows", "with everything", "columns", "with everything", "multiply-adds",
                 "with everything", "times", "us per step", "with everything", "times"}};
    for (const auto& [name, start, own, all] : entries) {
        table.rows.push_back({name, own.counts.rows(), all.counts.rows(), own.counts.columns, all.counts.columns,
                              own.counts.multiply_adds, all.counts.multiply_adds,
                              ratio(all.counts.multiply_adds, own.counts.multiply_adds), own.times.step,
                              all.times.step, ratio(all.times.step, own.times.step)});
    }
    return table;
}

Table sums_of(const std::vector<SumOfParts>& sums) {
    Table table{{"scenes", "islands", "parts_us", "together_us", "ratio", "parts_multiply_adds",
                 "together_multiply_adds", "first_part_moved_m"}};
    for (const SumOfParts& sum : sums) {
        table.rows.push_back({sum.name, sum.islands, thousandths(sum.parts_us), thousandths(sum.together_us),
                              fmt::format("{:.4f}", sum.ratio), sum.parts_multiply_adds, sum.together_multiply_adds,
                              sum.moved});
    }
    return table;
}

// Cumulative, in percent of a step, for stacked bars from the top down.
Table stages_of(const std::vector<Entry>& entries) {
    Table table{{"# scene"}};
    for (const std::string_view stage : phase_names) table.columns.push_back(fmt::format("end of {} in %", stage));
    for (const Entry& entry : entries) {
        const Times& times = entry.own.times;
        const double all = std::max(std::accumulate(times.stages.begin(), times.stages.end(), 0.0), 1e-9);
        auto& row = table.rows.emplace_back();
        row.emplace_back(fmt::format("{}: {} us", entry.name, Cell(times.step).rounded()));
        double end = 0.0;
        for (const double us : times.stages) row.emplace_back(fmt::format("{:.4f}", 100.0 * (end += us) / all));
    }
    return table;
}

Table times_of(const std::vector<Entry>& entries) {
    Table table{{"# scene", "us per step as it is", "with everything"}};
    for (const Entry& entry : entries) {
        table.rows.push_back(
            {entry.name, fmt::format("{:.4g}", entry.own.times.step), fmt::format("{:.4g}", entry.all.times.step)});
    }
    return table;
}

class CostReport {
  public:
    explicit CostReport(StudyRun& run)
        : run_(run),
          cases_(run.request().wanted(cost_cases(run.quick()), &CostCase::scene)),
          neighbours_(run.request().wants(side_by_side) ? neighbours(run.quick()) : std::vector<Neighbours>{}) {}

    void make() {
        run_.begin(cases_.size() + neighbours_.size());
        for (const CostCase& one : cases_) {
            entries_.push_back(entry_of(one));
            run_.write("cost.csv", table_of(entries_, true));
            show();
        }
        for (const Neighbours& scenes : neighbours_) {
            run_.write(fmt::format("{}/{}.json", side_by_side, plain_name(scenes.together.name, '-')),
                       scene_file_text(scenes.together));
            sums_.push_back(measure(scenes, repeats(), run_.check()));
            run_.write("side_by_side.csv", sums_of(sums_));
            show();
        }
    }

  private:
    int repeats() const { return run_.quick() ? 3 : 5; }

    Entry entry_of(const CostCase& one) const {
        const Choices choices = run_of(one.scene, one.options).on_one_thread();
        const std::string file = "everything/" + plain_name(one.name, '-') + ".json";
        run_.write(file, scene_file_text(with_everything(spelled_out(choices))));
        const Choices everything = understand((run_.folder() / file).string(), {}).on_one_thread();
        OptionTexts own = one.options;
        own.emplace_back("seconds", to_text(one.start));
        const Ledger all = ledger_of(everything, one.start, command_text("run", file, {own.back()}));
        return {one.name, one.start, ledger_of(choices, one.start, command_text("run", one.scene, own)), all};
    }

    Ledger ledger_of(const Choices& choices, double start, const std::string& command) const {
        const Choices moment = moment_at(choices, start, run_.check());
        const BuiltScene scene = build_scene(moment);
        return {.parts = parts_of(scene, moment.settings),
                .bodies = static_cast<int>(scene.world.bodies.size()),
                .counts = count_steps(moment),
                .times = time_steps(moment, repeats(), run_.check()),
                .command = command + " --timing"};
    }

    // Writes the page; plots are drawn only when all results are complete.
    void show() {
        run_.count_run();
        run_.sections.clear();
        if (!entries_.empty()) add_ledger();
        if (!sums_.empty()) {
            add(side_by_side, "A world costs the sum of its parts",
                "Scenes too far apart to touch, in one world: mean number of islands, CPU time and multiply-adds "
                "of the solver per step, as the sum of the parts alone and together, and how far the first part is "
                "from its place when alone. The scenes are in side-by-side/.",
                page_lines(sums_of(sums_)));
            run_.sections.back().content.files = {"side_by_side.csv"};
        }
        run_.write_page(fmt::format(
            "A part that a scene does not need is absent, and costs nothing. Counts are the same in every run; CPU "
            "times were measured on {}. The numbers are in cost.csv, the scenes with everything in everything.{}",
            run_.machine(), run_.quick() ? " This is the quick report: small scenes." : ""));
    }

    void add_ledger() {
        const Table own = table_of(entries_, false);
        add("parts", "Parts of each scene", "A part that is not named here is absent.",
            page_lines(own,
                       {"scene", "bodies", "force_sources", "constraint_sources", "contact_rules", "command"}));
        add("counts", "Work of a step",
            "Means over 120 steps of 1/60 s, as each scene is. Sweeps are those of the island with the most of "
            "them: none where the last forces are accurate enough.",
            page_lines(own, {"scene", "pairs", "touches", "contact_rows", "friction_rows", "distance_rows",
                             "columns", "bodies_at_rest", "sweeps", "multiply_adds"}));
        add("islands", "How the islands are solved",
            "Bodies that rows join are an island, and each is solved by itself. Mean number per step of islands of "
            "one body, of at most 1.5 pairs per body (threads) and of more (heaps); of these, how many keep their "
            "last forces, are swept, and are solved exactly.",
            page_lines(islands_of(entries_)));
        std::vector<std::string> times{"scene", "step_us", "us_per_contact", "bytes_per_contact"};
        for (const std::string_view stage : phase_names) times.push_back(fmt::format("{}_us", stage));
        add("times", "CPU time of the stages",
            "CPU time in us per step, as each scene is; the stages without what reading the clock takes. Per "
            "contact point: the time of a whole step, and the heap that the world holds, spare room included.",
            page_lines(own, times), "cost_stages", stages_of(entries_));
        add("everything", "Savings from absent parts",
            "The same scene with every part there is: a poke, a distance, contacts with friction, restitution, "
            "sweep and cache, two columns in each step, and rules that may divide it.",
            page_lines(comparison_of(entries_)), "cost_everything", times_of(entries_));
    }

    void add(const char* name, const char* heading, const char* caption, TextTable lines,
             const std::string& script = "", const Table& data = {}) {
        SectionContent plate{.caption = caption, .table = std::move(lines)};
        const bool complete = entries_.size() + sums_.size() == cases_.size() + neighbours_.size();
        const auto bars = static_cast<double>(data.rows.size());
        if (complete && bars > 0.0) {
            add_plot({.script = script,
                      .data = script + ".dat",
                      .name = script,
                      .aspect = 1600.0 / (260.0 + 52.0 * bars),
                      .variables = {{"bars", bars}, {"made_on", run_.machine()}}},
                     fmt::format("# {}\n{}", run_.machine(), csv_text(data)), run_.folder(), plate);
        }
        run_.sections.push_back({name, heading, std::move(plate)});
    }

    StudyRun& run_;
    std::vector<CostCase> cases_;
    std::vector<Neighbours> neighbours_;
    std::vector<Entry> entries_;
    std::vector<SumOfParts> sums_;
};

}  // namespace

Study cost_study() {
    return {.name = "cost",
            .title = "what a step costs",
            .parts =
                [] {
                    std::vector<std::string> parts = names_of(catalogue());
                    parts.emplace_back(side_by_side);
                    return parts;
                },
            .make = [](StudyRun& run) { CostReport(run).make(); }};
}

}  // namespace pushfactor::demos::reports
