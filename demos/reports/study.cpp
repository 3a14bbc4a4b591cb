#include "demos/reports/study.h"

#include "demos/platform/output_file.h"
#include "demos/platform/processors.h"
#include "demos/platform/version.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <future>
#include <mutex>
#include <set>
#include <thread>

namespace pushfactor::demos::reports {

namespace {

#ifdef __clang__
constexpr const char* compiler = "clang " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

// Model name; empty if unknown.
std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "";
}

// Ends a piece in progress.
struct Dropped {};

// Makes the pieces on `jobs` threads, in order, and calls `keep` for each in the thread that made it; `check` is
// called often. An exception of theirs or of a piece ends all: pieces in progress are dropped, and the exception is
// thrown.
void make_pieces(const std::vector<const Piece*>& pieces, std::size_t jobs,
                 const std::function<void(const Piece&, const Json& result)>& keep, const StopCheck& check) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> ended = false;
    const auto work = [&] {
        const auto goes_on = [&ended] {
            if (ended) throw Dropped();
        };
        try {
            for (std::size_t i = next++; i < pieces.size(); i = next++) {
                goes_on();
                keep(*pieces[i], pieces[i]->make(goes_on));
            }
        } catch (const Dropped&) {
        } catch (...) {
            ended = true;
            throw;
        }
    };
    std::vector<std::future<void>> workers;  // whose destructors wait for them
    try {
        for (std::size_t i = 0; i < std::min(jobs, pieces.size()); ++i)
            workers.push_back(std::async(std::launch::async, work));
        for (std::future<void>& worker : workers) {
            while (worker.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) check();
            worker.get();
        }
    } catch (...) {
        ended = true;
        throw;
    }
}

}  // namespace

StudyRun::StudyRun(const Study& study, StudyRequest request)
    : study_(study),
      request_(std::move(request)),
      machine_(about_line()),
      store_(request_.merged.empty() ? std::vector{request_.folder} : request_.merged, machine_) {
    make_folder(request_.folder);
}

void StudyRun::begin(std::size_t runs, std::size_t done, std::string hint) {
    runs_ = runs;
    done_ = done;
    hint_ = std::move(hint);
    bar_.emplace("report " + study_.name, static_cast<long>(runs));
}

void StudyRun::count_run() {
    bar_->show(static_cast<long>(++done_));
}

void StudyRun::stop_if_interrupted() const {
    demos::stop_if_interrupted(
        fmt::format("{} of {} runs are in {}{}", done_.load(), runs_, folder().string(), hint_));
}

void StudyRun::gather(const Pieces& pieces) {
    const bool merges = !request_.merged.empty();
    std::vector<const Piece*> missing;
    std::set<std::string> machines;
    for (const Piece& piece : pieces) {
        if (request_.shard && !request_.shard->takes(text_hash(piece.key))) continue;
        ++count_.all;
        if (const auto found = store_.find(piece.key)) {
            ++count_.there;
            machines.insert(found->machine);
        } else {
            missing.push_back(&piece);
        }
    }
    if (merges && !missing.empty()) {
        std::vector<std::string> keys;
        for (const Piece* const piece : missing) keys.push_back(piece->key);
        throw MissingPieces(fmt::format("{} of {} pieces are missing", missing.size(), pieces.size()), keys);
    }
    if (!merges) {
        store_.put_note(request_.note);
        begin(count_.all, count_.there, "; the same command resumes from there");
        std::mutex mutex;
        const auto keep = [&](const Piece& piece, const Json& result) {
            const bool failed = result.is_object() && result.contains("failed");
            if (!failed) store_.put(piece.key, result);
            const std::lock_guard lock(mutex);
            if (failed) failures_[piece.key] = result;
            count_run();
        };
        const int at_once = study_.at_once > 0 ? study_.at_once : usable_cores();
        make_pieces(missing, static_cast<std::size_t>(request_.jobs.value_or(at_once)), keep, check());
        count_.failed = failures_.size();
    }
    if (!missing.empty()) machines.insert(machine_);
    if (!machines.empty()) machine_ = fmt::format("{}", fmt::join(machines, "; "));
}

std::optional<Json> StudyRun::find(const std::string& key) const {
    if (const auto failed = failures_.find(key); failed != failures_.end()) return failed->second;
    auto found = store_.find(key);
    if (!found) return std::nullopt;
    return std::move(found->result);
}

Json StudyRun::result(const std::string& key) const {
    auto found = find(key);
    if (!found) throw RunError(fmt::format("{}: a piece has vanished: {}", folder().string(), key));
    return std::move(*found);
}

void StudyRun::write(const std::string& name, const std::string& text) const {
    write_file(folder() / name, text);
}

void StudyRun::write(const std::string& name, const Table& table) const {
    write(name, fmt::format("# {}\n{}", machine_, csv_text(table)));
}

SectionContent StudyRun::tabulated(const std::string& name, const Table& table, const std::string& caption) const {
    write(name, table);
    return {.files = {name}, .caption = caption, .table = page_lines(table)};
}

void StudyRun::write(const std::string& headline, std::span<const SuiteVerdict> verdicts) const {
    if (request_.junit) write_file(*request_.junit, junit_xml(verdicts, std::time(nullptr)));
    if (request_.markdown) write_file(*request_.markdown, job_summary(headline, verdicts));
}

void StudyRun::write_page(const std::string& opening) const {
    write_index(folder(), page_text("Pushfactor: " + study_.title, opening, sections));
}

StudyRun::Count make_study(const Study& study, const StudyRequest& request) {
    StudyRun run(study, request);
    if (study.pieces) run.gather(study.pieces(request));
    if (!request.shard) {
        study.make(run);
        return run.count();
    }
    const auto [all, there, failed] = run.count();
    if (failed == 0) return run.count();
    throw CheckError(
        fmt::format("{} of {} pieces of shard {} failed and are not kept", failed, all, to_text(*request.shard)));
}

std::string about_json() {
    const std::string cpu = cpu_model();
    return json_text(Json{{"program", "pushfactor " + version_text()},
                          {"compiler", compiler},
                          {"flags", compile_flags()},
                          {"cpu", cpu.empty() ? Json(nullptr) : Json(cpu)},
                          {"cores", std::thread::hardware_concurrency()}});
}

std::string about_line() {
    const std::string cpu = cpu_model();
    return fmt::format("pushfactor {}, {}, {}; {}{} cores", version_text(), compiler, compile_flags(),
                       cpu.empty() ? "" : cpu + ", ", std::thread::hardware_concurrency());
}

std::vector<Study> all_studies() {
    return {error_study(), stability_study(), cost_study(), atlas_study(), reality_study()};
}

}  // namespace pushfactor::demos::reports
