#include "demos/commands/commands.h"
#include "demos/pages/job_summary.h"
#include "demos/pages/junit.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/platform/version.h"
#include "demos/reports/check/check_page.h"
#include "demos/reports/check/folder_check.h"
#include "demos/reports/check/picture_folders.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <atomic>
#include <ctime>
#include <mutex>
#include <set>
#include <thread>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;
using namespace reports::check;

Rules understand_rules(const CheckRequest& request) {
    Rules rules;
    if (request.tolerance && request.flip)
        throw UsageError("--flip: must be given without --tolerance, which it replaces");
    if (request.tolerance) {
        const auto limits = parse_limits(*request.tolerance);
        if (!limits) {
            throw UsageError(
                fmt::format("--tolerance {}: must be LEVELS or LEVELS:SHARE% (0 to 255, 0 to 100), or "
                            "several with commas: 2:0.05%,16:0.005%",
                            *request.tolerance));
        }
        rules.tolerance = Tolerance{.limits = *limits};
    }
    if (request.flip) {
        const auto most = parse_number(*request.flip);
        if (!most || *most < 0.0 || *most > 1.0) {
            throw UsageError(fmt::format("--flip {}: must be from 0 to 1", *request.flip));
        }
        rules.tolerance = Tolerance{.limits = {}, .flip = *most};
    }
    if (request.physics == "off") {
        rules.physics = false;
    } else if (request.physics != "hash") {
        const auto most = parse_number(request.physics);
        if (!most || *most < 0.0) {
            throw UsageError(fmt::format("--physics {}: must be hash, off, or metres from 0", request.physics));
        }
        rules.trajectory = *most;
    }
    return rules;
}

// File names for folders: what is not plain becomes '-', and a name that is taken gets a number.
class Anchors {
  public:
    std::string operator()(const fs::path& folder) {
        std::string wanted;
        for (const char c : folder.lexically_normal().generic_string()) {
            const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
            if (plain || !wanted.empty()) wanted += plain ? c : '-';
        }
        while (wanted.ends_with('-')) wanted.pop_back();
        if (wanted.empty()) wanted = "pictures";
        std::string anchor = wanted;
        for (int n = 2; !taken_.insert(anchor).second; ++n) anchor = fmt::format("{}-{}", wanted, n);
        return anchor;
    }

  private:
    std::set<std::string> taken_;
};

// A folder's name as people write it.
std::string name_of(const fs::path& folder) {
    std::string name = folder.lexically_normal().generic_string();
    while (name.size() > 1 && name.ends_with('/')) name.pop_back();
    return name;
}

// Checks the folders, several at once, and prints the lines of each in their order as soon as they are known.
class Checks {
  public:
    Checks(const Request& request, const Rules& rules) : request_(request), rules_(rules) {
        Anchors anchors;
        for (const std::string& given : request.check.folders) {
            for (const fs::path& folder : folders_of_runs(given)) {
                expected_.push_back(read_expectation(folder, request.given));
                jobs_.push_back({.name = name_of(folder), .anchor = anchors(folder), .pages = pages()});
            }
        }
        if (rules.trajectory) {
            for (const Expectation& one : expected_) require_trajectory(one);
        }
        updates_.resize(jobs_.size());
        verdicts_.resize(jobs_.size());
        ended_.resize(jobs_.size());
    }

    fs::path pages() const { return request_.out.value_or("out/check"); }

    std::vector<FolderVerdict> carry_out() {
        if (request_.check.update) {
            for (std::size_t i = 0; i < jobs_.size(); ++i) {
                updates_[i] = std::make_unique<Update>(expected_[i].folder);
            }
        }
        const auto most = static_cast<std::size_t>(request_.check.jobs);
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < std::min(most, jobs_.size()); ++i) others.emplace_back([this] { work(); });
        work();
        for (std::thread& thread : others) thread.join();
        if (error_) std::rethrow_exception(error_);
        return std::move(verdicts_);
    }

    // After carry_out().
    void update(const std::vector<FolderVerdict>& verdicts) {
        for (std::size_t i = 0; i < updates_.size(); ++i) {
            if (!updates_[i]) continue;
            const long count = updates_[i]->apply();
            if (count > 0) fmt::print("{}: {} files are new\n", verdicts[i].name, count);
        }
    }

    std::string driver() const { return driver_; }

  private:
    static void require_trajectory(const Expectation& one) {
        if (fs::exists(one.folder / "trajectory.csv")) return;
        throw UsageError(
            fmt::format("{0}: must have a trajectory.csv for --physics in metres: `render --trajectory "
                        "{0}/trajectory.csv`",
                        one.folder.string()));
    }

    void work() {
        try {
            std::optional<pictures::Studio> studio;
            std::string made_for;
            while (const auto next = take()) {
                const std::string& gl = expected_[*next].sequence.panels.front().choices.frames.gl;
                if (!studio || gl != made_for) {
                    const std::lock_guard lock(mutex_);  // the first context sets the environment
                    studio.reset();
                    studio.emplace(gl);
                    made_for = gl;
                    driver_ = studio->driver();
                }
                check(*next, *studio);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!error_) error_ = std::current_exception();
            next_ = jobs_.size();
        }
    }

    std::optional<std::size_t> take() {
        const std::lock_guard lock(mutex_);
        if (next_ >= jobs_.size()) return std::nullopt;
        return next_++;
    }

    void check(std::size_t i, pictures::Studio& studio) {
        FolderJob job = jobs_[i];
        std::optional<ProgressBar> bar;  // of one folder at a time
        if (request_.check.jobs == 1) {
            bar.emplace(job.name, static_cast<long>(expected_[i].sequence.frame_count()));
            job.progress = [&bar](long drawn) { bar->show(drawn); };
        }
        FolderVerdict verdict = check_folder(expected_[i], rules_, job, studio, updates_[i].get());
        bar.reset();
        const std::lock_guard lock(mutex_);
        verdicts_[i] = std::move(verdict);
        ended_[i] = true;
        for (; printed_ < ended_.size() && ended_[printed_]; ++printed_) {
            for (const std::string& line : lines_of(verdicts_[printed_])) fmt::print("{}\n", line);
        }
    }

    const Request& request_;
    Rules rules_;
    std::vector<Expectation> expected_;
    std::vector<FolderJob> jobs_;
    std::vector<std::unique_ptr<Update>> updates_;

    std::mutex mutex_;  // guards the members below
    std::size_t next_ = 0, printed_ = 0;
    std::vector<FolderVerdict> verdicts_;
    std::vector<bool> ended_;
    std::string driver_;
    std::exception_ptr error_;
};

void write_results(const Request& request, const std::vector<FolderVerdict>& verdicts, const fs::path& folder,
                   const std::string& driver) {
    const std::string made_with = "pushfactor " + version_text() + (driver.empty() ? "" : ", " + driver);
    make_folder(folder);
    write_file(folder / "index.html", page_of(verdicts, made_with));
    const std::vector<SuiteVerdict> suites = suites_of(verdicts);
    if (request.junit) write_file(*request.junit, junit_xml(suites, std::time(nullptr)));
    if (request.markdown) write_file(*request.markdown, job_summary(headline(verdicts), suites));
}

void conclude(const std::vector<FolderVerdict>& verdicts, const fs::path& folder, bool updated) {
    long failures = 0;
    for (const FolderVerdict& verdict : verdicts) failures += verdict.failures();
    const std::string page = (folder / "index.html").string();
    if (failures == 0 || updated) {
        fmt::print("{}; see {}\n", headline(verdicts), page);
        return;
    }
    throw CheckError(fmt::format("{}; see {}", headline(verdicts), page));
}

void check_other_pictures(const Request& request, const Rules& rules) {
    if (request.check.folders.size() != 1) {
        throw UsageError(fmt::format("--against {}: must be with one folder", *request.check.against));
    }
    if (request.check.update) throw UsageError("--update: must be without --against, which renders nothing");
    const fs::path expected = request.check.folders.front(), folder = request.out.value_or("out/check");
    const std::vector<FolderVerdict> verdicts{
        check_pictures(expected, *request.check.against, rules.tolerance.value_or(exactly()),
                       {.name = name_of(expected), .anchor = Anchors()(expected), .pages = folder})};
    for (const std::string& line : lines_of(verdicts.front())) fmt::print("{}\n", line);
    write_results(request, verdicts, folder, "");
    conclude(verdicts, folder, false);
}

}  // namespace

void check(const Request& request) {
    const Rules rules = understand_rules(request.check);
    if (request.check.folders.empty()) throw UsageError("check: a folder of expected pictures is missing");
    if (request.check.against) {
        check_other_pictures(request, rules);
        return;
    }
    Checks checks(request, rules);
    make_folder(checks.pages());
    const std::vector<FolderVerdict> verdicts = checks.carry_out();
    write_results(request, verdicts, checks.pages(), checks.driver());
    if (request.check.update) checks.update(verdicts);
    conclude(verdicts, checks.pages(), request.check.update);
}

}  // namespace pushfactor::demos::commands
