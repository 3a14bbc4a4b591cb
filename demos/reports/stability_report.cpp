#include "demos/reports/stability_report.h"

#include "demos/pages/about.h"
#include "demos/pages/page.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/reports/parts.h"
#include "demos/reports/stability/gallery.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace pushfactor::demos::reports {

namespace {

using namespace stability;

constexpr const char* csv_heading = "case,preset,outcome,expected,measure,value,bar,holds,command";

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

std::vector<std::string> line_of_verdict(const Trial& trial, const Verdict& verdict) {
    const Check* const check = verdict.check;
    return {trial.one().name,
            trial.expected().preset,
            trial.outcome(),
            text_of_expected(trial, verdict),
            check ? text_of_measure(*check) : "",
            verdict.value ? to_text(*verdict.value) : "",
            check ? text_of_bar(*check, check->bar) : "",
            verdict.holds ? "yes" : "no",
            trial.command()};
}

Mark mark_for(const Verdict& verdict) {
    if (!verdict.holds) return Mark::fails;
    return verdict.met ? Mark::holds : Mark::known_miss;
}

std::string quoted(const std::string& field) {
    if (field.find_first_of(",\"\n") == std::string::npos) return field;
    std::string text = "\"";
    for (const char c : field) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

struct Count {
    int trials = 0, missed_bars = 0;
    std::vector<std::string> unexpected{};
};

// Chapters are made in their order; their runs go on beside each other.
class StabilityReport {
  public:
    explicit StabilityReport(const StabilityRequest& request)
        : request_(request), chapters_(wanted_chapters()), gallery_(made_folder()) {
        write_scenes(chapters_, request_.folder);
        for (const Chapter& chapter : chapters_) {
            for (const Case& one : chapter.cases) {
                for (const Expected& expected : one.expected) trials_.emplace_back(one, expected, request_.folder);
            }
            ends_.push_back(trials_.size());
        }
    }

    void make() {
        ProgressBar bar("report stability", static_cast<long>(trials_.size()));
        while (ended_ < trials_.size()) {
            start_some();
            if (!end_some()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            complete_chapters();
            bar.show(static_cast<long>(ended_));
        }
    }

    const Count& count() const { return count_; }

  private:
    std::vector<Chapter> wanted_chapters() const {
        std::vector<Chapter> wanted = chapters(request_.quick);
        std::erase_if(wanted, [this](const Chapter& chapter) { return !is_wanted(chapter.name, request_.parts); });
        return wanted;
    }

    const std::filesystem::path& made_folder() const {
        make_folder(request_.folder);
        return request_.folder;
    }

    void start_some() {
        stop_if_interrupted(fmt::format("{} of {} runs were judged, whole chapters are in {}", ended_,
                                        trials_.size(), request_.folder.string()));
        const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
        while (running_.size() < most && next_ < trials_.size()) {
            trials_[next_].start(program_);
            running_.push_back(next_++);
        }
    }

    bool end_some() {
        const auto ended = std::stable_partition(running_.begin(), running_.end(),
                                                 [this](std::size_t i) { return !trials_[i].has_ended(); });
        const bool any = ended != running_.end();
        for (auto i = ended; i != running_.end(); ++i) trials_[*i].judge();
        ended_ += static_cast<std::size_t>(running_.end() - ended);
        running_.erase(ended, running_.end());
        return any;
    }

    void complete_chapters() {
        const std::size_t first_open =
            running_.empty() ? next_ : std::min(next_, *std::min_element(running_.begin(), running_.end()));
        while (sections_.size() < chapters_.size() && ends_[sections_.size()] <= first_open) {
            const std::size_t done = sections_.size();
            const std::size_t begin = done == 0 ? 0 : ends_[done - 1];
            add_section(chapters_[done], std::span(trials_).subspan(begin, ends_[done] - begin));
        }
    }

    void add_section(const Chapter& chapter, std::span<const Trial> trials) {
        Plate plate;
        plate.table.push_back(
            {verdict_column, "case", "preset", "outcome", "expected", "measure", "value", "bar", command_column});
        for (const Trial& trial : trials) {
            ++count_.trials;
            for (const Verdict& verdict : trial.verdicts()) add_line(trial, verdict, plate);
            if (trial.holds()) continue;
            count_.unexpected.push_back(
                fmt::format("{} ({}): {}", trial.one().name, trial.expected().preset, trial.outcome()));
        }
        const std::string picture = gallery_.hang(chapter.name, trials);
        if (!picture.empty()) plate.pictures.push_back(picture);
        sections_.push_back({chapter.name, chapter.heading, plate});
        write_file(request_.folder / "stability.csv", fmt::format("{}\n{}", csv_heading, lines_));
        write_page();
    }

    void add_line(const Trial& trial, const Verdict& verdict, Plate& plate) {
        const std::vector<std::string> line = line_of_verdict(trial, verdict);
        std::vector<std::string> fields;
        std::transform(line.begin(), line.end(), std::back_inserter(fields), quoted);
        lines_ += fmt::format("{}\n", fmt::join(fields, ","));
        if (!verdict.met) ++count_.missed_bars;
        plate.table.push_back({std::string(word_of(mark_for(verdict))), line[0], line[1], line[2], line[3], line[4],
                               line[5], line[6], line[8]});
    }

    void write_page() const {
        const std::string opening = fmt::format(
            "Stiff and extreme cases, each run by the program and judged by it. An outcome is that of the last "
            "second; the bar is what is asked. A known miss is beyond its bar or has another outcome than the "
            "wanted one, but is no worse than the table says under \"expected\". {} runs, {} numbers beyond their "
            "bar, {} not as expected. The numbers are in stability.csv. Made with {}.{}{}",
            count_.trials, count_.missed_bars, count_.unexpected.size(), line_of(about_this()),
            request_.quick ? " This is the quick report: the short cases." : "",
            gallery_.missing().empty() ? "" : " There are no pictures: " + gallery_.missing());
        write_file(request_.folder / "index.html", page_text("Pushfactor: stability", opening, sections_));
    }

    StabilityRequest request_;
    std::filesystem::path program_ = std::filesystem::read_symlink("/proc/self/exe");
    std::vector<Chapter> chapters_;
    Gallery gallery_;
    std::vector<Trial> trials_;
    std::vector<std::size_t> ends_;     // of the chapters, in trials_
    std::vector<std::size_t> running_;  // in trials_
    std::size_t next_ = 0, ended_ = 0;
    std::string lines_;
    std::vector<Section> sections_;
    Count count_;
};

}  // namespace

std::vector<std::string> stability_parts() {
    return chapter_names();
}

void report_stability(const StabilityRequest& request) {
    StabilityReport report(request);
    report.make();
    const Count& count = report.count();
    if (count.unexpected.empty()) return;
    throw CheckError(fmt::format("{} of {} runs are not as expected, the first is {}; see {}",
                                 count.unexpected.size(), count.trials, count.unexpected.front(),
                                 (request.folder / "stability.csv").string()));
}

}  // namespace pushfactor::demos::reports
