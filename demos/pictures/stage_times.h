// Where the time of a film goes.
#pragma once

#include "renderer/frames/stages.h"

#include <ctime>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace pushfactor::demos::pictures {

struct StageTime {
    double wall = 0.0;  // s
    double cpu = 0.0;   // s, of all threads that work for it
};

// Of the program since it began; wall time since some moment.
StageTime process_time();

// Sums of the times of stages, which run on several threads at once. May be used from all of them.
//
// A software rasteriser draws with threads of its own. So the CPU time of a stage of drawing is that of the whole
// program without that of the threads that have a ThreadWatch.
class StageTimes final : public renderer::Stages {
  public:
    StageTimes();

    void add(const std::string& stage, const StageTime& time);

    // Drawing begins anew: what was before it belongs to none of its stages.
    void begin_drawing();
    void end(renderer::Stage stage) override;
    void end_drawing(const std::string& stage);

    // Of all of its times; zero when it had none.
    StageTime sum(const std::string& stage) const;

    // A line for each stage and each of `frames` frames, and the rates.
    std::string table(long frames) const;

  private:
    friend class ThreadWatch;

    double drawing_cpu() const;

    mutable std::mutex mutex_;
    std::vector<std::string> names_;  // in the order of their first time
    std::map<std::string, StageTime> sums_;
    std::vector<clockid_t> watched_;  // threads that do not draw
    double ended_cpu_ = 0.0;          // s, of those that have ended
    StageTime drawn_until_;
    StageTime start_;
};

// Takes a thread's CPU time out of that of drawing, from its construction to its destruction on that thread. Does
// nothing when `times` is null.
class ThreadWatch {
  public:
    explicit ThreadWatch(StageTimes* times);
    ~ThreadWatch();
    ThreadWatch(const ThreadWatch&) = delete;
    ThreadWatch& operator=(const ThreadWatch&) = delete;

  private:
    StageTimes* times_;
    clockid_t clock_{};
};

// Times stages of this thread. Does nothing when `times` is null.
class StageWatch {
  public:
    explicit StageWatch(StageTimes* times);

    // The time since the last call belongs to this stage.
    void end(const std::string& stage);
    // It belongs to none.
    void skip();

  private:
    StageTimes* times_;
    StageTime last_;
};

}  // namespace pushfactor::demos::pictures
