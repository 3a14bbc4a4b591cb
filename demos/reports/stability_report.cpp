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
#include <chrono>
#include <thread>

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
    std::vector<std::vector<std::string>> lines = page_lines(table);
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

// Chapters are completed in order; runs are concurrent.
class StabilityReport {
  public:
    explicit StabilityReport(StudyRun& run)
        : run_(run), chapters_(run.wanted(chapters(run.quick()), &Chapter::name)), gallery_(run.folder()) {
        write_scenes(chapters_, run.folder());
        for (const Chapter& chapter : chapters_) {
            for (const Case& one : chapter.cases) {
                for (const Expected& expected : one.expected) trials_.emplace_back(one, expected, run.folder());
            }
            ends_.push_back(trials_.size());
        }
    }

    void make() {
        run_.begin(trials_.size(), 0, "; the table has the complete chapters");
        while (ended_ < trials_.size()) {
            start_some();
            if (!end_some()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            complete_chapters();
        }
        const std::string headline =
            unexpected_.empty() ? fmt::format("{} runs are as expected", trials_.size())
                                : fmt::format("{} of {} runs are not as expected", unexpected_.size(), trials_.size());
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

    void start_some() {
        run_.stop_if_interrupted();
        const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
        while (running_.size() < most && next_ < trials_.size()) {
            trials_[next_].start(program_);
            running_.push_back(next_++);
        }
    }

    bool end_some() {
        const std::size_t before = running_.size();
        std::erase_if(running_, [this](std::size_t i) {
            if (!trials_[i].has_ended()) return false;
            trials_[i].judge();
            run_.count_run();
            return true;
        });
        ended_ += before - running_.size();
        return running_.size() < before;
    }

    void complete_chapters() {
        const std::size_t first_open =
            running_.empty() ? next_ : std::min(next_, *std::min_element(running_.begin(), running_.end()));
        while (run_.sections.size() < chapters_.size() && ends_[run_.sections.size()] <= first_open) {
            const std::size_t done = run_.sections.size();
            const std::size_t begin = done == 0 ? 0 : ends_[done - 1];
            add_section(chapters_[done], std::span(trials_).subspan(begin, ends_[done] - begin));
        }
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
        Plate plate;
        plate.table = lines_with_verdicts(own, trials);
        const std::string picture = gallery_.hang(chapter.name, trials);
        if (!picture.empty()) plate.pictures.push_back(picture);
        for (const Trial& trial : trials) {
            if (std::filesystem::exists(run_.folder() / trial.replay())) plate.replays.push_back(trial.replay());
        }
        run_.sections.push_back({chapter.name, chapter.heading, plate});
        run_.write("stability.csv", csv_text(table_));
        run_.write_page(fmt::format(
            "Stiff and extreme cases, each run and judged by the program. The outcome is that of the last "
            "second; the bar is what is required, and where it is known not to be met the table gives under "
            "\"expected\" the value that is reached. {} runs, {} numbers beyond their bar, {} not as expected. The "
            "numbers are in stability.csv. Made with {}.{}{}",
            ends_[run_.sections.size() - 1], missed_bars_, unexpected_.size(), run_.machine(),
            run_.quick() ? " This is the quick report: the short cases." : "",
            gallery_.missing().empty() ? "" : " There are no pictures: " + gallery_.missing()));
    }

    StudyRun& run_;
    std::filesystem::path program_ = std::filesystem::read_symlink("/proc/self/exe");
    std::vector<Chapter> chapters_;
    Gallery gallery_;
    std::vector<Trial> trials_;
    std::vector<std::size_t> ends_;     // of the chapters, in trials_
    std::vector<std::size_t> running_;  // in trials_
    std::size_t next_ = 0, ended_ = 0;
    Table table_{{"case", "preset", "outcome", "expected", "measure", "value", "bar", "holds", "command"}};
    int missed_bars_ = 0;
    std::vector<std::string> unexpected_;
};

}  // namespace

Study stability_study() {
    std::vector<std::string> parts;
    for (const Chapter& chapter : chapters(false)) parts.push_back(chapter.name);
    return {"stability", "stability", parts, [](StudyRun& run) { StabilityReport(run).make(); }, true};
}

}  // namespace pushfactor::demos::reports
