#include "demos/reports/cost_report.h"

#include "demos/pages/about.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/reports/cost/cases.h"
#include "demos/reports/cost/everything.h"
#include "demos/reports/cost/neighbours.h"
#include "demos/reports/cost/plots.h"
#include "demos/reports/cost/tables.h"
#include "demos/reports/parts.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/scene_file.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports {

namespace {

using namespace cost;

class CostReport {
  public:
    explicit CostReport(const CostRequest& request)
        : request_(request), made_on_(line_of(about_this())), cases_(wanted_cases()) {
        make_folder(request_.folder / "everything");
        if (!is_wanted(side_by_side, request_.parts)) return;
        neighbours_ = neighbours(request_.quick);
        make_folder(request_.folder / side_by_side);
    }

    void make() {
        ProgressBar bar("report cost", static_cast<long>(cases_.size() + neighbours_.size()));
        for (const CostCase& one : cases_) {
            entries_.push_back(entry_of(one));
            write_file(request_.folder / "cost.csv", fmt::format("# {}\n{}", made_on_, csv_text(entries_)));
            write_page(sections());
            bar.show(done());
        }
        for (const Neighbours& scenes : neighbours_) {
            write_file(request_.folder / side_by_side / (scenes.file_name() + ".json"),
                       scene_file_text(scenes.together));
            sums_.push_back(measure(scenes, request_.quick ? 3 : 5, [this] { check(); }));
            write_file(request_.folder / "side_by_side.csv", fmt::format("# {}\n{}", made_on_, csv_text(sums_)));
            write_page(sections());
            bar.show(done());
        }
        std::vector<Section> all = sections();
        add_plots(entries_, made_on_, request_.folder, all);
        write_page(all);
    }

    static constexpr const char* side_by_side = "side-by-side";

  private:
    long done() const { return static_cast<long>(entries_.size() + sums_.size()); }

    std::vector<Section> sections() const {
        std::vector<Section> all;
        if (!entries_.empty()) all = table_sections(entries_);
        if (!sums_.empty()) all.push_back(section_of(sums_));
        return all;
    }

    std::vector<CostCase> wanted_cases() const {
        std::vector<CostCase> cases = cost_cases(request_.quick);
        std::erase_if(cases, [this](const CostCase& one) { return !is_wanted(one.scene, request_.parts); });
        return cases;
    }

    void check() const {
        stop_if_interrupted(fmt::format("{} of {} scenes are in {}", done(), cases_.size() + neighbours_.size(),
                                        request_.folder.string()));
    }

    Entry entry_of(const CostCase& one) const {
        const Choices choices = run_of(one.scene, one.options).on_one_thread();
        const std::string file = "everything/" + one.file_name() + ".json";
        write_file(request_.folder / file, scene_file_text(with_everything(spelled_out(choices))));
        const Choices everything = understand((request_.folder / file).string(), {}).on_one_thread();

        OptionTexts run{{"seconds", to_text(one.start)}};
        Entry entry{.name = one.name, .start = one.start, .as_it_is = {}, .with_everything = {}};
        entry.with_everything = {ledger_of(everything, one.start), command_text("run", file, run) + " --timing"};
        run.insert(run.begin(), one.options.begin(), one.options.end());
        entry.as_it_is = {ledger_of(choices, one.start), command_text("run", one.scene, run) + " --timing"};
        return entry;
    }

    Ledger ledger_of(const Choices& choices, double start) const {
        const auto check_now = [this] { check(); };
        const MeasuredState moment = moment_at(choices, start, check_now);
        const BuiltScene scene = moment.build();
        return {.parts = parts_of(scene, moment.settings),
                .bodies = static_cast<int>(scene.world.bodies.size()),
                .counts = count_steps(moment),
                .times = time_steps(moment, request_.quick ? 3 : 5, check_now)};
    }

    void write_page(const std::vector<Section>& sections) const {
        const std::string opening = fmt::format(
            "What a scene does not need is not constructed, and costs nothing. Counts are the same in every run; "
            "CPU times were measured on {}. The numbers are in cost.csv, the scenes with everything in "
            "everything.{}",
            made_on_, request_.quick ? " This is the quick report: small scenes." : "");
        write_file(request_.folder / "index.html", page_text("Pushfactor: what a step costs", opening, sections));
    }

    CostRequest request_;
    std::string made_on_;
    std::vector<CostCase> cases_;
    std::vector<Neighbours> neighbours_;
    std::vector<Entry> entries_;
    std::vector<SumOfParts> sums_;
};

}  // namespace

std::vector<std::string> cost_parts() {
    std::vector<std::string> names;
    for (const SceneEntry& scene : catalogue()) names.emplace_back(scene.name);
    names.emplace_back(CostReport::side_by_side);
    return names;
}

void report_cost(const CostRequest& request) {
    CostReport(request).make();
}

}  // namespace pushfactor::demos::reports
