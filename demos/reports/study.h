// Studies: many runs, compared or judged, as tables and plots on one page. The common part of all reports.
#pragma once

#include "demos/pages/page.h"
#include "demos/pages/table.h"
#include "demos/pages/verdicts.h"
#include "demos/platform/progress.h"
#include "demos/runs/simulation.h"
#include "demos/text/errors.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

class StudyRun;

struct Study {
    std::string name;                // as in the command: "error"
    std::string title;               // of the page
    std::vector<std::string> parts;  // for --only
    void (*make)(StudyRun& run);
    bool judges = false;  // it writes verdicts
};

struct StudyRequest {
    std::filesystem::path folder;
    bool quick = false;                               // few and short runs
    std::vector<std::filesystem::path> problems{};    // of others, for the error report
    std::optional<std::filesystem::path> beside{};    // points of other solvers on these, or else of other engines
    std::optional<std::filesystem::path> exported{};  // folder for frozen problems
    std::vector<std::string> parts{};                 // all when empty
    std::optional<std::string> junit{}, markdown{};   // paths, for the verdicts of a study that judges
};

// A running study: its folder, request, progress and interruption, tables and page.
class StudyRun {
  public:
    StudyRun(const Study& study, StudyRequest request);

    bool quick() const { return request_.quick; }
    const StudyRequest& request() const { return request_; }
    const std::filesystem::path& folder() const { return request_.folder; }
    const std::string& machine() const { return machine_; }  // program, compiler and processor
    bool wants(const std::string& part) const;

    // The things whose part was requested; `part_of` gives the part's name.
    template <typename Things, typename PartOf>
    Things wanted(Things things, const PartOf& part_of) const {
        std::erase_if(things, [&](const auto& thing) { return !wants(std::invoke(part_of, thing)); });
        return things;
    }

    // Sets the number of runs and of those already done; `hint` ends the message of an interruption.
    void begin(std::size_t runs, std::size_t done = 0, std::string hint = "");
    void count_run();
    void stop_if_interrupted() const;
    std::function<void()> check() const;  // stop_if_interrupted() as a function

    // Writes a file, whole or not at all.
    void write(const std::string& name, const std::string& text) const;
    void write(const std::string& name, const Table& table) const;  // below a line with the machine

    // Writes the files for CI servers that were asked for.
    void write(const std::string& headline, std::span<const SuiteVerdict> verdicts) const;

    std::vector<Section> sections{};
    void write_page(const std::string& opening) const;

  private:
    const Study& study_;
    StudyRequest request_;
    std::string machine_;
    std::optional<ProgressBar> bar_;
    std::size_t runs_ = 0, done_ = 0;
    std::string hint_;
};

// Runs a study and writes its files, complete after each part, so that an interrupted one keeps its results. Throws
// the exceptions of errors.h; CheckError if everything was written but a result is not as expected.
void make_study(const Study& study, const StudyRequest& request);

Study error_study();      // errors of methods against their work
Study stability_study();  // judged extreme cases
Study cost_study();       // work and time per step
Study atlas_study();      // outcomes over two parameters
std::vector<Study> all_studies();

inline bool before_end(const Simulation& run) {
    return run.sample().step < whole_steps(run.settings());
}

// Steps a run while `goes_on` returns true, and calls the observers after each step.
template <typename GoesOn, typename... Observers>
void play(Simulation& run, const GoesOn& goes_on, Observers&... observers) {
    while (goes_on(run)) {
        run.advance();
        (observers.observe(run), ...);
    }
}

// Steps a run to its end; `check` is called before each step. Stops and returns false if it becomes non-finite.
template <typename... Observers>
bool play_to_end(Simulation& run, const std::function<void()>& check, Observers&... observers) {
    const auto goes_on = [&check](const Simulation& now) {
        check();
        return before_end(now);
    };
    try {
        play(run, goes_on, observers...);
    } catch (const NonFiniteError&) {
        return false;
    }
    return true;
}

}  // namespace pushfactor::demos::reports
