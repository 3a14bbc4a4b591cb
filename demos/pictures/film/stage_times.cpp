#include "demos/pictures/film/stage_times.h"

#include <fmt/format.h>
#include <pthread.h>

#include <algorithm>
#include <array>

namespace pushfactor::demos::pictures {

namespace {

double seconds(clockid_t clock) {
    std::timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

StageTime between(const StageTime& from, const StageTime& to) {
    return {.wall = to.wall - from.wall, .cpu = to.cpu - from.cpu};
}

// In the order of renderer::Stage.
constexpr std::array<const char*, 7> stage_names{"plan",      "shadow map",   "ground", "bodies",
                                                 "read back", "smooth edges", "marks"};

}  // namespace

StageTime process_time() {
    return {.wall = seconds(CLOCK_MONOTONIC), .cpu = seconds(CLOCK_PROCESS_CPUTIME_ID)};
}

StageTimes::StageTimes() : drawn_until_(process_time()), start_(drawn_until_) {}

void StageTimes::add(const std::string& stage, const StageTime& time) {
    const std::lock_guard lock(mutex_);
    auto sum = std::ranges::find(sums_, stage, &Sum::first);
    if (sum == sums_.end()) sum = sums_.emplace(sum, stage, StageTime{});
    sum->second.wall += time.wall;
    sum->second.cpu += time.cpu;
}

double StageTimes::drawing_cpu() const {
    const std::lock_guard lock(mutex_);
    double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID) - ended_cpu_;
    for (const clockid_t clock : watched_) cpu -= seconds(clock);
    return cpu;
}

void StageTimes::begin_drawing() {
    drawn_until_ = {.wall = seconds(CLOCK_MONOTONIC), .cpu = drawing_cpu()};
}

void StageTimes::end(renderer::Stage stage) {
    end_drawing(stage_names.at(static_cast<std::size_t>(stage)));
}

void StageTimes::end_drawing(const std::string& stage) {
    const StageTime now{.wall = seconds(CLOCK_MONOTONIC), .cpu = drawing_cpu()};
    add(stage, between(drawn_until_, now));
    drawn_until_ = now;
}

StageTime StageTimes::sum(const std::string& stage) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(sums_, stage, &Sum::first);
    return found == sums_.end() ? StageTime{} : found->second;
}

std::string StageTimes::table(long frames) const {
    const std::lock_guard lock(mutex_);
    const double scale = 1e3 / static_cast<double>(frames);
    const StageTime all = between(start_, process_time());
    std::string text = fmt::format("{:<24}{:>12}{:>12}\n", "ms per frame", "CPU", "wall");
    const auto line = [&](const std::string& name, const StageTime& time) {
        text += fmt::format("{:<24}{:>12.2f}{:>12.2f}\n", name, scale * time.cpu, scale * time.wall);
    };
    for (const auto& [name, time] : sums_) line(name, time);
    line("total, with startup", all);
    text += fmt::format("{} frames: {:.1f} per second; {:.1f} per second of CPU time\n", frames,
                        static_cast<double>(frames) / all.wall, static_cast<double>(frames) / all.cpu);
    return text;
}

StageWatch::StageWatch(StageTimes* times) : times_(times) {
    if (!times_) return;
    pthread_getcpuclockid(pthread_self(), &clock_);
    skip();
    const std::lock_guard lock(times_->mutex_);
    times_->watched_.push_back(clock_);
}

StageWatch::~StageWatch() {
    if (!times_) return;
    const std::lock_guard lock(times_->mutex_);
    std::erase(times_->watched_, clock_);
    times_->ended_cpu_ += seconds(clock_);
}

void StageWatch::end(const std::string& stage) {
    if (!times_) return;
    const StageTime last = last_;
    skip();
    times_->add(stage, between(last, last_));
}

void StageWatch::skip() {
    if (times_) last_ = {.wall = seconds(CLOCK_MONOTONIC), .cpu = seconds(clock_)};
}

}  // namespace pushfactor::demos::pictures
