#include "demos/base/platform/output_file.h"
#include "demos/base/platform/plain_name.h"
#include "demos/base/platform/progress.h"
#include "demos/base/platform/version.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "demos/commands/commands.h"
#include "demos/pages/check_page.h"
#include "demos/pages/verdict_files.h"
#include "demos/pictures/checks/folder_check.h"

#include <fmt/format.h>

#include <atomic>
#include <ctime>
#include <future>
#include <mutex>
#include <set>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;
using namespace checks;

Rules understand_rules(const Check& request) {
    Rules rules;
    if (request.tolerance && request.flip)
        throw UsageError("--flip: must be given without --tolerance, which it replaces");
    if (request.tolerance) {
        const auto limits = parse_limits(*request.tolerance);
        if (!limits) {
            throw UsageError(
                "--tolerance {}: must be LEVELS or LEVELS:SHARE% (0 to 255, 0 to 100), or "
                "a comma-separated list: 2:0.05%,16:0.005%",
                *request.tolerance);
        }
        rules.tolerance = Tolerance{.limits = *limits};
    }
    if (request.flip) {
        const auto most = parse_number(*request.flip, 0.0, 1.0);
        if (!most) throw UsageError("--flip {}: must be from 0 to 1", *request.flip);
        rules.tolerance = Tolerance{.limits = {}, .flip = *most};
    }
    const std::string physics = request.physics.value_or("hash");
    if (physics == "off") {
        rules.physics = false;
    } else if (physics != "hash") {
        const auto most = parse_number(physics, 0.0);
        if (!most) throw UsageError("--physics {}: must be hash, off, or metres from 0", physics);
        rules.trajectory = *most;
    }
    return rules;
}

// A file name for a folder: what is not plain becomes '-'.
std::string anchor_of(const fs::path& folder) {
    std::string anchor;
    for (const char c : folder.lexically_normal().generic_string()) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
        if (plain || !anchor.empty()) anchor += plain ? c : '-';
    }
    while (anchor.ends_with('-')) anchor.pop_back();
    constexpr std::size_t longest = 100;
    if (anchor.size() > longest) anchor.erase(0, anchor.size() - longest);
    return anchor.empty() ? "pictures" : anchor;
}

// A folder's name as people write it.
std::string name_of(const fs::path& folder) {
    std::string name = folder.lexically_normal().generic_string();
    while (name.size() > 1 && name.ends_with('/')) name.pop_back();
    return name;
}

fs::path pages_of(const Check& request) {
    return request.out.value_or("out/check");
}

void print_lines(const FolderVerdict& verdict) {
    for (const std::string& line : lines_of(verdict)) print(fmt::format("{}\n", line));
}

// A folder to check; the verdict comes last.
struct Task {
    fs::path folder;
    FolderJob job;
    std::unique_ptr<Update> update{};
    std::optional<FolderVerdict> verdict{};
};

// Checks the folders, several at once, and prints the lines of each in their order as soon as they are known.
class Checks {
  public:
    Checks(const Check& request, const Rules& rules)
        : request_(request), rules_(rules), most_(static_cast<std::size_t>(request.jobs.value_or(1))) {
        std::set<std::string> anchors;
        std::set<fs::path> seen;
        for (const std::string& given : request.folders) {
            for (const fs::path& folder : folders_of_pictures(given)) {
                if (is_below(pages_of(request), folder) || !seen.insert(fs::canonical(folder)).second) continue;
                tasks_.push_back({folder,
                                  {.name = name_of(folder),
                                   .anchor = unused_name(anchor_of(folder), anchors),
                                   .pages = pages_of(request)}});
            }
        }
    }

    std::vector<FolderVerdict> carry_out() {
        for (Task& task : tasks_) {
            if (request_.update) task.update = std::make_unique<Update>(task.folder);
        }
        std::vector<std::future<void>> others;  // whose destructors wait for them
        for (std::size_t i = 1; i < std::min(most_, tasks_.size()); ++i) {
            others.push_back(std::async(std::launch::async, [this] { work(); }));
        }
        work();
        for (std::future<void>& other : others) other.get();
        std::vector<FolderVerdict> verdicts;
        for (Task& task : tasks_) verdicts.push_back(task.verdict.value());
        return verdicts;
    }

    // After carry_out().
    void update() {
        for (Task& task : tasks_) {
            if (!task.verdict->made) print(fmt::format("{}: cannot be updated\n", task.job.name));
            const long count = task.verdict->made ? task.update->apply() : 0;
            if (count == 0) continue;
            print(fmt::format("{}: {} {} updated\n", task.job.name, count, count == 1 ? "file" : "files"));
        }
    }

    std::string driver() const { return driver_; }

  private:
    void work() {
        try {
            std::optional<pictures::OffscreenRenderer> offscreen;
            std::string made_for;
            for (std::size_t i = next_++; i < tasks_.size(); i = next_++) {
                if (!fs::exists(tasks_[i].folder / config_file)) {
                    fail(tasks_[i], "there is no config.json, as `render` writes it, for the pictures", false);
                    continue;
                }
                try {
                    const Expectation expected = read_expectation(tasks_[i].folder, request_.given);
                    const std::string& gl = expected.sequence.panels.front().choices.frames.gl;
                    if (!offscreen || gl != made_for) {
                        const std::lock_guard lock(mutex_);  // the first context sets the environment
                        offscreen.reset();
                        offscreen.emplace(gl);
                        made_for = gl;
                        driver_ = offscreen->driver();
                    }
                    check(tasks_[i], expected, *offscreen);
                } catch (const UsageError& error) {
                    fail(tasks_[i], error.what());
                }
            }
        } catch (...) {
            next_ = tasks_.size();
            throw;
        }
    }

    // A folder that cannot be read fails, and the others are checked.
    void fail(Task& task, const std::string& why, bool compared = true) {
        end(task, {.name = task.job.name,
                   .anchor = task.job.anchor,
                   .how = "not at all",
                   .runs = {{.subject = "folder", .holds = !compared, .text = why, .compared = compared}},
                   .made = false});
    }

    void check(Task& task, const Expectation& expected, pictures::OffscreenRenderer& offscreen) {
        FolderJob job = task.job;
        std::optional<ProgressBar> bar;  // of one folder at a time
        if (most_ == 1) {
            bar.emplace(job.name, static_cast<long>(expected.sequence.frame_count()));
            job.progress = [&bar](long drawn) { bar->show(drawn); };
        }
        FolderVerdict verdict = check_folder(expected, rules_, job, offscreen, task.update.get());
        bar.reset();
        end(task, std::move(verdict));
    }

    void end(Task& task, FolderVerdict verdict) {
        const std::lock_guard lock(mutex_);
        task.verdict = std::move(verdict);
        for (; printed_ < tasks_.size() && tasks_[printed_].verdict; ++printed_) {
            print_lines(*tasks_[printed_].verdict);
        }
    }

    const Check& request_;
    Rules rules_;
    std::size_t most_;  // at once
    std::vector<Task> tasks_;
    std::atomic<std::size_t> next_ = 0;

    std::mutex mutex_;  // guards verdicts and the members below
    std::size_t printed_ = 0;
    std::string driver_;
};

void write_results(const Check& request, const std::vector<FolderVerdict>& verdicts, const std::string& driver) {
    const fs::path page = pages_of(request) / "index.html";
    make_folder(pages_of(request));
    write_file(page, page_of(verdicts, "pushfactor " + version_text() + (driver.empty() ? "" : ", " + driver)));
    const std::vector<SuiteVerdict> suites = suites_of(verdicts);
    if (request.junit) write_file(*request.junit, junit_xml(suites, std::time(nullptr)));
    if (request.markdown) write_file(*request.markdown, job_summary(headline(verdicts), suites));
}

void judge(const Check& request, const std::vector<FolderVerdict>& verdicts) {
    long failures = 0;
    for (const FolderVerdict& verdict : verdicts) {
        const bool is_mended = request.update && verdict.made;
        if (!is_mended) failures += verdict.failures();
        if (request.allow_not_compared) continue;
        failures += std::ssize(verdict.unexpected) + (is_mended ? 0 : verdict.not_compared());
    }
    const std::string text =
        fmt::format("{}; see {}", headline(verdicts), (pages_of(request) / "index.html").string());
    if (failures > 0) throw CheckError(text);
    print(text + "\n");
}

void check_other_pictures(const Check& request, const Rules& rules) {
    const fs::path expected = request.folders.front();
    const std::vector<FolderVerdict> verdicts{
        check_pictures(expected, *request.against, rules.tolerance.value_or(exactly()),
                       {.name = name_of(expected), .anchor = anchor_of(expected), .pages = pages_of(request)})};
    print_lines(verdicts.front());
    write_results(request, verdicts, "");
    judge(request, verdicts);
}

std::vector<Option> check_options() {
    const std::string group = "Options";
    return {
        {"against", "DIR",
         "compare the PNG files of FOLDER with those of this folder instead; nothing is rendered"},
        {"tolerance", "LIST",
         "comma-separated list of LEVELS[:SHARE%]: at most SHARE of the pixels differ by more than LEVELS of "
         "255 [0, equal pixels, with the program and driver that made the pictures; else 2:0.05%,16:0.005%]"},
        {"flip", "N", "largest mean FLIP error instead, 0 to 1: what a person would see at 67 pixels per degree"},
        {"physics", "hash|M|off",
         "hash: the final state is bit-identical; M: poses are within M metres and radians of trajectory.csv "
         "in the folder (made by render --trajectory), for another compiler or C library; off [hash]"},
        {"update", "",
         "print the differences and replace pictures, summary.json and trajectory.csv of a folder, all or nothing; "
         "config.json is never overwritten"},
        {"jobs", "N", "folders that are checked at once [1]"},
        {"gl", "osmesa|egl", "OpenGL back end [as in the config.json]"},
        {"out", "DIR", "folder for the page, with the 20 worst pictures of each folder [out/check]"},
        {"junit", "FILE", "the verdicts as JUnit XML, for CI servers", group, OptionKind::writes},
        {"markdown", "FILE", "a summary as Markdown, for $GITHUB_STEP_SUMMARY", group, OptionKind::writes},
        {"allow-not-compared", "", "status 0 even if something could not be compared, or is unexpected"},
    };
}

AnyCommand read_check(Words& words) {
    Check command;
    command.folders = words.take_names();
    command.against = words.take("against");
    command.tolerance = words.take("tolerance");
    command.flip = words.take("flip");
    if (command.folders.empty()) throw UsageError("check: a folder of expected pictures is missing");
    if (command.against && command.folders.size() != 1) {
        throw UsageError("--against {}: must be with one folder", *command.against);
    }
    const bool renders = !command.against;
    const char* const must = "without --against, which renders nothing";
    command.physics = words.take("physics", renders, must);
    command.update = words.take("update", renders, must).has_value();
    for (const char* const option : {"jobs", "gl"}) words.take(option, renders, must);
    command.jobs = words.take_whole("jobs", 1, 256);
    if (const auto gl = words.take_word("gl", {"osmesa", "egl"})) command.given.add("gl", *gl, "--gl");
    command.out = words.take("out");
    command.junit = words.take("junit");
    command.markdown = words.take("markdown");
    command.allow_not_compared = words.take_flag("allow-not-compared");
    understand_rules(command);
    std::vector<std::string> folders = command.folders;
    folders.push_back(pages_of(command));
    for (const std::string& folder : folders) require_own_endings(folder, command.junit, command.markdown);
    return command;
}

}  // namespace

void carry_out(const Check& request) {
    const Rules rules = understand_rules(request);
    if (request.against) return check_other_pictures(request, rules);
    Checks checks(request, rules);
    make_folder(pages_of(request));
    const std::vector<FolderVerdict> verdicts = checks.carry_out();
    write_results(request, verdicts, checks.driver());
    if (request.update) checks.update();
    judge(request, verdicts);
}

const Entry check_entry{
    "check", "FOLDER...",
    "renders folders of pictures again and says what differs. FOLDER was made by `render`, or contains "
    "such folders",
    check_options, read_check};

}  // namespace pushfactor::demos::commands
