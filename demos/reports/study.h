// A study: many runs, compared or judged, as tables and plots on one page. What all of them share is here.
#pragma once

#include "demos/pages/page.h"
#include "demos/pages/table.h"
#include "demos/platform/progress.h"
#include "demos/runs/simulation.h"
#include "demos/text/errors.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

class StudyRun;

struct Study {
    std::string name;                // "error": of the command
    std::string title;               // of the page
    std::vector<std::string> parts;  // for --only
    void (*make)(StudyRun& run);
};

struct StudyRequest {
    std::filesystem::path folder;
    bool quick = false;              // few and short runs
    bool problems = false;           // frozen problems as files too; only the study of errors has them
    std::vector<std::string> parts;  // all when empty
};

// A study in the making: its folder, what was asked for, progress and interruption, tables and the page.
class StudyRun {
  public:
    StudyRun(const Study& study, StudyRequest request);

    bool quick() const { return request_.quick; }
    bool problems() const { return request_.problems; }
    const std::filesystem::path& folder() const { return request_.folder; }
    const std::string& machine() const { return machine_; }  // program, compiler and processor
    bool wants(const std::string& part) const;

    // Of these things those whose part was asked for; `part_of` gives its name.
    template <typename Things, typename PartOf>
    Things wanted(Things things, const PartOf& part_of) const {
        std::erase_if(things, [&](const auto& thing) { return !wants(std::invoke(part_of, thing)); });
        return things;
    }

    // How many runs there are and how many of them are done; `hint` is said when interrupted.
    void begin(std::size_t runs, std::size_t done = 0, std::string hint = "");
    void count_run();
    void stop_if_interrupted() const;
    std::function<void()> check() const;  // the same as a function

    // Whole or not at all, like all files.
    void write(const std::string& name, const std::string& text) const;
    void write(const std::string& name, const Table& table) const;  // below a line with the machine

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

// Writes the files of a study; whole after each part, so that an interrupted one keeps what it had. Throws what
// errors.h names; CheckError when all was written but something is not as expected.
void make_study(const Study& study, const StudyRequest& request);

Study error_study();      // errors of methods against their work
Study stability_study();  // extreme cases, judged
Study cost_study();       // what steps do and take
Study atlas_study();      // outcomes over two parameters
std::vector<Study> all_studies();

inline bool before_end(const Simulation& run) {
    return run.sample().step < whole_steps(run.settings());
}

// Steps a run while `goes_on` says so, and shows it to the observers after each step.
template <typename GoesOn, typename... Observers>
void play(Simulation& run, const GoesOn& goes_on, Observers&... observers) {
    while (goes_on(run)) {
        run.advance();
        (observers.observe(run), ...);
    }
}

// Up to the end; `check` is called before each step. False when the run left the finite numbers, where it stops.
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
