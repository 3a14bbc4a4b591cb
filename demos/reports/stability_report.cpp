// The report on the stress list: stability.csv (one line per case, preset and check), thumbnails, the scenes that
// are not in the catalogue, and the summary and last state of each run.
#include "demos/pages/mark.h"
#include "demos/pages/page.h"
#include "demos/reports/stability/gallery.h"
#include "demos/reports/study.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace pushfactor::demos::reports {

namespace {

using namespace stability;

// "|acceleration_m_per_s2 - 0.4063| / 2"
std::string text_of_measure(const Check& check) {
    std::string text = check.measure;
    if (check.target != 0.0) text = fmt::format("|{} - {}|", text, to_text(check.target));
    if (check.scale != 1.0) text += " / " + to_text(check.scale);
    return text;
}

std::string text_of_bar(const Check& check, double bar) {
    return fmt::format("{} {}", check.at_least ? ">=" : "<=", to_text(bar));
}

std::string text_of_expected(const Trial& trial, const Verdict& verdict) {
    const Expected& expected = trial.expected();
    const auto index = static_cast<std::size_t>(&verdict - trial.verdicts().data());
    if (!verdict.check || index >= expected.reached.size() || !expected.reached[index]) return expected.outcome;
    return fmt::format("{}; {} instead of the bar", expected.outcome,
                       text_of_bar(*verdict.check, *expected.reached[index]));
}

void add_lines(const Trial& trial, Table& table) {
    for (const Verdict& verdict : trial.verdicts()) {
        const Check* const check = verdict.check;
        table.rows.push_back({trial.one().name, trial.expected().preset, trial.outcome(),
                              text_of_expected(trial, verdict), check ? text_of_measure(*check) : "", verdict.value,
                              check ? text_of_bar(*check, check->bar) : "", verdict.holds ? "yes" : "no",
                              trial.command()});
    }
}

Mark mark_for(const Verdict& verdict) {
    if (!verdict.holds) return Mark::fails;
    return verdict.met ? Mark::holds : Mark::known_miss;
}

// Page lines of a table of trials, with the verdict in front.
std::vector<std::vector<std::string>> lines_with_verdicts(const Table& table, std::span<const Trial> trials) {
    // The verdict says on the page what the column `holds` says in the file.
    Table shown = table;
    const auto column = std::ranges::find(shown.columns, "holds") - shown.columns.begin();
    shown.columns.erase(shown.columns.begin() + column);
    for (auto& row : shown.rows) row.erase(row.begin() + column);
    std::vector<std::vector<std::string>> lines = page_lines(shown);
    lines.front().insert(lines.front().begin(), std::string(verdict_column));
    std::size_t line = 1;
    for (const Trial& trial : trials) {
        for (const Verdict& verdict : trial.verdicts()) {
            lines.at(line).insert(lines.at(line).begin(), std::string(word_of(mark_for(verdict))));
            ++line;
        }
    }
    return lines;
}

// Empty if all verdicts hold.
std::string failure_of(const Trial& trial) {
    std::string text;
    for (const Verdict& verdict : trial.verdicts()) {
        if (verdict.holds) continue;
        const std::string measured = verdict.check
                                         ? fmt::format("{} is {}, ", text_of_measure(*verdict.check),
                                                       verdict.value ? to_text(*verdict.value) : "unknown")
                                         : "";
        text += fmt::format("{}{}outcome {}, expected {}", text.empty() ? "" : "; ", measured, trial.outcome(),
                            text_of_expected(trial, verdict));
    }
    return text.empty() ? text : text + "; " + trial.command();
}

// All trials of the request in order; they refer to the chapters.
std::vector<Trial> trials_of(const std::vector<Chapter>& chapters, const std::filesystem::path& folder) {
    std::vector<Trial> trials;
    for (const Chapter& chapter : chapters) {
        for (const Case& one : chapter.cases) {
            for (const Expected& expected : one.expected) trials.emplace_back(one, expected, folder);
        }
    }
    return trials;
}

std::vector<Chapter> chapters_of(const StudyRequest& request) {
    std::vector<Chapter> all = chapters(request.quick);
    std::erase_if(all, [&](const Chapter& chapter) { return !request.wants(chapter.name); });
    return all;
}

// A piece is a trial.
Pieces stability_pieces(const StudyRequest& request) {
    struct Trials {
        std::vector<Chapter> chapters;
        std::vector<Trial> trials;
    };
    const auto all = std::make_shared<Trials>();
    all->chapters = chapters_of(request);
    all->trials = trials_of(all->chapters, request.folder);
    if (request.merged.empty()) write_scenes(all->chapters, request.folder);
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    Pieces pieces;
    for (std::size_t i = 0; i < all->trials.size(); ++i) {
        pieces.push_back({all->trials[i].key(), [all, i, program](const std::function<void()>& check) {
                              return all->trials[i].run(program, check);
                          }});
    }
    return pieces;
}

class StabilityReport {
  public:
    explicit StabilityReport(StudyRun& run)
        : run_(run),
          chapters_(chapters_of(run.request())),
          gallery_(run.folder()),
          trials_(trials_of(chapters_, run.folder())) {
        write_scenes(chapters_, run.folder());
        std::size_t end = 0;
        for (const Chapter& chapter : chapters_) {
            for (const Case& one : chapter.cases) end += one.expected.size();
            ends_.push_back(end);
        }
    }

    void make() {
        for (Trial& trial : trials_) trial.judge(run_.result(trial.key()));
        for (std::size_t c = 0; c < chapters_.size(); ++c) {
            const std::size_t begin = c == 0 ? 0 : ends_[c - 1];
            add_section(chapters_[c], std::span(trials_).subspan(begin, ends_[c] - begin));
        }
        run_.write("stability.csv", csv_text(table_));
        write_page();
        const std::string headline = unexpected_.empty() ? fmt::format("{} runs are as expected", trials_.size())
                                                         : fmt::format("{} of {} runs are not as expected",
                                                                       unexpected_.size(), trials_.size());
        run_.write(headline, suites());
        if (unexpected_.empty()) return;
        throw CheckError(fmt::format("{}, the first is {}; see {}", headline, unexpected_.front(),
                                     (run_.folder() / "stability.csv").string()));
    }

  private:
    // One suite per chapter, one case per run.
    std::vector<SuiteVerdict> suites() const {
        std::vector<SuiteVerdict> suites;
        for (std::size_t c = 0; c < chapters_.size(); ++c) {
            SuiteVerdict& suite = suites.emplace_back(SuiteVerdict{.name = "stability/" + chapters_[c].name});
            for (std::size_t i = c == 0 ? 0 : ends_[c - 1]; i < ends_[c]; ++i) {
                suite.cases.push_back({.name = trials_[i].name(), .failure = failure_of(trials_[i])});
            }
        }
        return suites;
    }

    void add_section(const Chapter& chapter, std::span<const Trial> trials) {
        Table own{table_.columns};
        for (const Trial& trial : trials) {
            add_lines(trial, own);
            for (const Verdict& verdict : trial.verdicts()) missed_bars_ += verdict.met ? 0 : 1;
            if (!trial.holds()) {
                unexpected_.push_back(
                    fmt::format("{} ({}): {}", trial.one().name, trial.expected().preset, trial.outcome()));
            }
        }
        table_.rows.insert(table_.rows.end(), own.rows.begin(), own.rows.end());
        SectionContent plate;
        plate.table = lines_with_verdicts(own, trials);
        const std::string picture = gallery_.hang(chapter.name, trials);
        if (!picture.empty()) plate.pictures.push_back(picture);
        for (const Trial& trial : trials) {
            if (std::filesystem::exists(run_.folder() / trial.replay())) plate.replays.push_back(trial.replay());
        }
        run_.sections.push_back({chapter.name, chapter.heading, plate});
    }

    void write_page() const {
        run_.write_page(
            fmt::format("Stiff and extreme cases, each run and judged by the program. The outcome is that of the "
                        "last second; the bar is what is required, and where it is known not to be met the table "
                        "gives under \"expected\" the value that is reached. {} runs, {} numbers beyond their bar, "
                        "{} not as expected. The numbers are in stability.csv. Made with {}.{}{}",
                        trials_.size(), missed_bars_, unexpected_.size(), run_.machine(),
                        run_.quick() ? " This is the quick report: the short cases." : "",
                        gallery_.missing().empty() ? "" : " There are no pictures: " + gallery_.missing()));
    }

    StudyRun& run_;
    std::vector<Chapter> chapters_;
    Gallery gallery_;
    std::vector<Trial> trials_;
    std::vector<std::size_t> ends_;  // of the chapters, in trials_
    Table table_{{"case", "preset", "outcome", "expected", "measure", "value", "bar", "holds", "command"}};
    int missed_bars_ = 0;
    std::vector<std::string> unexpected_;
};

}  // namespace

Study stability_study() {
    std::vector<std::string> parts;
    for (const Chapter& chapter : chapters(false)) parts.push_back(chapter.name);
    return {.name = "stability",
            .title = "stability",
            .parts = parts,
            .make = [](StudyRun& run) { StabilityReport(run).make(); },
            .judges = true,
            .pieces = stability_pieces};
}

}  // namespace pushfactor::demos::reports
