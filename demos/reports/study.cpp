#include "demos/reports/study.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/platform/plain_name.h"
#include "demos/base/platform/processors.h"
#include "demos/base/platform/version.h"
#include "demos/pictures/replay/replay.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <future>
#include <mutex>
#include <thread>

namespace pushfactor::demos::reports {

namespace {

namespace fs = std::filesystem;

std::string version_of_pieces() {
    static const std::string version = version_text();
    const bool exact = version.find("-dirty") == std::string::npos && version.find("unknown") == std::string::npos;
    // Content, because another build of modified sources has the same version.
    static const std::string content =
        exact ? "" : fmt::format(", program {:016x}", text_hash(read_bytes_of("/proc/self/exe").value_or("")));
    return version + content;
}

fs::path folder_of_pieces(const fs::path& folder) {
    return folder / "pieces" / piece_version();
}

fs::path place_of(const fs::path& folder, const std::string& key) {
    const std::string name = fmt::format("{:016x}", text_hash(key));
    return folder_of_pieces(folder) / name.substr(0, 2) / (name.substr(2) + ".json");
}

// The JSON of a whole piece of this version; none if it is missing or damaged.
std::optional<Json> find_piece(const std::vector<fs::path>& folders, const std::string& key) {
    for (const fs::path& folder : folders) {
        const auto text = read_bytes_of(place_of(folder, key));
        if (!text) continue;
        Json json = json_or_null(*text);
        const bool whole = json.is_object() && json.value("key", "") == key && json.contains("result") &&
                           json.value("made_with", "") == version_of_pieces();
        if (whole) return json;
    }
    return std::nullopt;
}

void write_into_folder(const fs::path& path, const std::string& text) {
    make_folder_of(path);
    write_file(path, text);
}

// The content of a scene that is a file, with everything that it includes. Read once, as a report has many runs of
// it.
std::string content_of(const std::string& scene) {
    static std::mutex mutex;
    static std::map<std::string, std::string> known;
    const std::lock_guard lock(mutex);
    std::string& content = known[scene];
    if (content.empty()) {
        const Choices choices = run_of(scene, {});
        content =
            fmt::format("{} {:016x}", choices.description.name, text_hash(scene_file_text(spelled_out(choices))));
    }
    return content;
}

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

// What about_json() says, as a line for captions.
std::string about_line() {
    const std::string cpu = cpu_model();
    return fmt::format("pushfactor {}, {}, {}; {}{} cores", version_text(), compiler, compile_flags(),
                       cpu.empty() ? "" : cpu + ", ", std::thread::hardware_concurrency());
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
    const auto goes_on = [&] {
        if (ended) throw Dropped();
        check();
    };
    const auto work = [&] {
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
    for (std::size_t i = 0; i < std::min(jobs, pieces.size()); ++i)
        workers.push_back(std::async(std::launch::async, work));
    for (std::future<void>& worker : workers) worker.get();
}

}  // namespace

std::string run_key(const std::string& scene, const OptionTexts& options) {
    return command_text("run", find_scene(scene) ? scene : content_of(scene), options);
}

Json json_number(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

double number_in(const Json& json) {
    return json.is_string() ? std::stod(json.get_ref<const std::string&>()) : json.get<double>();
}

Json json_numbers(const std::vector<double>& values) {
    Json json = Json::array();
    for (const double value : values) json.push_back(json_number(value));
    return json;
}

std::vector<double> numbers_in(const Json& json) {
    std::vector<double> values;
    for (const Json& one : json) values.push_back(number_in(one));
    return values;
}

std::string replay_of(const std::string& scene, const OptionTexts& options, const StopCheck& check) {
    const StagedFile file(std::filesystem::temp_directory_path() / "replay", ".html");  // removed at the end
    const Choices choices = run_of(scene, options);
    Session session({.panels = {{.label = "", .choices = choices}}, .frames = {pictures::replay_frames(choices)}});
    pictures::Replay replay({.file = file.path(),
                             .poses_only = true,
                             .command = command_text("run", scene, options) + " --replay replay.html"},
                            session);
    try {
        session.play({&replay}, [&](const Simulation&) {
            check();
            return true;
        });
        replay.finish();
    } catch (const NonFiniteError& error) {
        replay.finish(error.what());
    }
    return read_bytes_of(file.path()).value_or("");
}

std::optional<std::string> piece_note_in(const fs::path& folder) {
    return read_bytes_of(folder_of_pieces(folder) / "report.json");
}

std::string piece_version() {
    return plain_name(version_of_pieces(), '-', ".");  // "0.1.0-commit-0123456789ab"
}

std::set<std::string> piece_versions_in(const fs::path& folder) {
    std::set<std::string> versions;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder / "pieces", error)) {
        if (entry.is_directory()) versions.insert(entry.path().filename());
    }
    return versions;
}

StudyRun::StudyRun(const Study& study, StudyRequest request)
    : study_(study),
      request_(std::move(request)),
      machine_(about_line()),
      stores_(request_.merged.empty() ? std::vector{request_.folder} : request_.merged) {
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

StopCheck StudyRun::check() const {
    return [this] {
        if (!interrupted()) return;
        stop_if_interrupted(
            fmt::format("{} of {} runs are in {}{}", done_.load(), runs_, folder().string(), hint_));
    };
}

void StudyRun::gather(const Pieces& pieces) {
    const bool merges = !request_.merged.empty();
    std::vector<const Piece*> missing;
    std::set<std::string> machines;
    for (const Piece& piece : pieces) {
        if (request_.shard && !request_.shard->takes(text_hash(piece.key))) continue;
        ++count_.all;
        if (const auto found = find_piece(stores_, piece.key)) {
            ++count_.there;
            machines.insert(found->value("machine", ""));
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
        if (piece_note_in(folder()) != request_.note)
            write_into_folder(folder_of_pieces(folder()) / "report.json", request_.note);
        begin(count_.all, count_.there, "; the same command resumes from there");
        std::mutex mutex;
        const auto keep = [&, here = about_line()](const Piece& piece, const Json& result) {
            const bool failed = result.is_object() && result.contains("failed");
            const Json json{
                {"key", piece.key}, {"made_with", version_of_pieces()}, {"machine", here}, {"result", result}};
            // In a file with a name of its own that is renamed: a piece that is there is whole.
            if (!failed) write_into_folder(place_of(folder(), piece.key), json_text(json, -1) + "\n");
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
    auto found = find_piece(stores_, key);
    return found ? std::optional<Json>(std::move(found->at("result"))) : std::nullopt;
}

Json StudyRun::result(const std::string& key) const {
    auto found = find(key);
    if (!found) throw RunError("{}: a piece has vanished: {}", folder().string(), key);
    return std::move(*found);
}

void StudyRun::write(const std::string& name, const std::string& text) const {
    write_into_folder(folder() / name, text);
}

void StudyRun::write(const std::string& name, const Table& table) const {
    write(name, fmt::format("# {}\n{}", machine_, csv_text(table)));
}

SectionContent StudyRun::tabulated(const std::string& name, const Table& table, const std::string& caption) const {
    write(name, table);
    return {.files = {name}, .caption = caption, .table = page_lines(table)};
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
    throw CheckError("{} of {} pieces of shard {} failed and are not kept", failed, all, to_text(*request.shard));
}

std::string about_json() {
    const std::string cpu = cpu_model();
    return json_text(Json{{"program", "pushfactor " + version_text()},
                          {"compiler", compiler},
                          {"flags", compile_flags()},
                          {"cpu", cpu.empty() ? Json(nullptr) : Json(cpu)},
                          {"cores", std::thread::hardware_concurrency()}});
}

std::vector<Study> all_studies() {
    return {error_study(), stability_study(), cost_study(), atlas_study(), reality_study()};
}

}  // namespace pushfactor::demos::reports
