// Time measurements of the stages of a film.
#pragma once

#include "renderer/frames/stages.h"

#include <ctime>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::pictures {

struct StageTime {
    double wall = 0.0;  // s
    double cpu = 0.0;   // s, of all its threads
};

// CPU time of the program since its start; wall time since an arbitrary moment.
StageTime process_time();

// Total times of stages that run on several threads at once. Thread-safe.
//
// A software rasteriser has threads of its own. So the CPU time of a drawing stage is that of the whole program
// minus the threads that have a StageWatch.
class StageTimes final : public renderer::Stages {
  public:
    StageTimes();

    void add(const std::string& stage, const StageTime& time);

    // Starts a drawing: earlier time belongs to none of its stages.
    void begin_drawing();
    void end(renderer::Stage stage) override;
    void end_drawing(const std::string& stage);

    // Total of a stage; zero for an unknown one.
    StageTime sum(const std::string& stage) const;

    // Text: a line per stage with its time per frame, and the frame rates.
    std::string table(long frames) const;

  private:
    friend class StageWatch;

    using Sum = std::pair<std::string, StageTime>;

    double drawing_cpu() const;

    mutable std::mutex mutex_;
    std::vector<Sum> sums_;           // of stages, in the order in which they first ended
    std::vector<clockid_t> watched_;  // threads that do not draw
    double ended_cpu_ = 0.0;          // s, of watched threads that have ended
    StageTime drawn_until_;
    StageTime start_;
};

// Times the stages of the thread that constructs and destroys it, one watch per thread, and excludes its CPU time
// from the drawing time. Does nothing if `times` is null.
class StageWatch {
  public:
    explicit StageWatch(StageTimes* times);
    ~StageWatch();
    StageWatch(const StageWatch&) = delete;
    StageWatch& operator=(const StageWatch&) = delete;

    // Adds the time since the last call to this stage.
    void end(const std::string& stage);
    // Drops the time since the last call.
    void skip();

  private:
    StageTimes* times_;
    clockid_t clock_{};
    StageTime last_;
};

}  // namespace pushfactor::demos::pictures
