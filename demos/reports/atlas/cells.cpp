#include "demos/reports/atlas/cells.h"

#include "demos/reports/atlas/outcomes.h"
#include "demos/reports/study.h"
#include "demos/text/errors.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace pushfactor::demos::reports::atlas {

namespace {

OptionTexts options_of(const AtlasCell& cell) {
    OptionTexts options = cell.map->common;
    options.emplace_back(cell.map->x.option, cell.x);
    options.emplace_back(cell.map->y.option, cell.y);
    return options;
}

// Threads that run cells, and the results that have not been fetched yet.
class Crew {
  public:
    explicit Crew(std::span<const AtlasCell> cells) : cells_(cells) {
        const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
        for (std::size_t i = 0; i < std::min(cores, cells.size()); ++i) {
            workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
        }
    }

    // Requests all stops before the first join.
    ~Crew() {
        for (std::jthread& worker : workers_) worker.request_stop();
    }

    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    using Finished = std::vector<std::pair<std::size_t, CellResult>>;  // number of the cell

    // Results since the last call; waits briefly if there are none. Throws what a run threw.
    Finished fetch() {
        std::unique_lock lock(mutex_);
        news_.wait_for(lock, std::chrono::milliseconds(100), [this] { return !finished_.empty() || error_; });
        if (error_) std::rethrow_exception(error_);
        return std::exchange(finished_, {});
    }

  private:
    void work(const std::stop_token& stop) {
        try {
            for (std::size_t i = next_++; i < cells_.size(); i = next_++) {
                const auto result = run_cell(cells_[i], stop);
                if (!result) return;
                const std::lock_guard lock(mutex_);
                finished_.emplace_back(i, *result);
                news_.notify_one();
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            error_ = std::current_exception();
            news_.notify_one();
        }
    }

    std::span<const AtlasCell> cells_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;  // guards the two below
    Finished finished_;
    std::exception_ptr error_;
    std::condition_variable news_;
    std::vector<std::jthread> workers_;  // last, so that they are joined first
};

}  // namespace

std::vector<AtlasCell> cells_of(const AtlasMap& map) {
    std::vector<AtlasCell> cells;
    for (const std::string& y : map.y.values) {
        for (const std::string& x : map.x.values) cells.push_back({&map, x, y});
    }
    return cells;
}

std::string command_of(const AtlasCell& cell) {
    return command_text("run", cell.map->scene, options_of(cell));
}

std::optional<CellResult> run_cell(const AtlasCell& cell, const std::stop_token& stop) {
    const Choices choices = run_of(cell.map->scene, options_of(cell));
    Simulation run(choices);
    Measurements measurements(run);
    const auto result = [&](std::string_view outcome) {
        return CellResult{std::string(outcome), (measurements.*cell.map->measure.value)()};
    };
    try {
        play(
            run, [&](const Simulation& now) { return before_end(now) && !stop.stop_requested(); }, measurements);
    } catch (const NonFiniteError&) {
        return result(non_finite);
    }
    if (before_end(run)) return std::nullopt;
    return result(name_of(measurements.outcome()));
}

void run_cells(std::span<const AtlasCell> cells,
               const std::function<void(const AtlasCell&, const CellResult&)>& finished,
               const std::function<void()>& check) {
    Crew crew(cells);
    for (std::size_t done = 0; done < cells.size();) {
        check();
        for (const auto& [i, result] : crew.fetch()) {
            finished(cells[i], result);
            ++done;
        }
    }
}

}  // namespace pushfactor::demos::reports::atlas
