// What a person at a terminal sees while a run goes on, and how they stop it.
#pragma once

#include <chrono>
#include <string>

namespace pushfactor::demos {

// A bar on standard error, drawn only when that is a terminal. The destructor ends its line.
class ProgressBar {
  public:
    ProgressBar(std::string label, long total);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(long done);

  private:
    using Clock = std::chrono::steady_clock;

    std::string label_;
    long total_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_, next_;
};

// From now on SIGINT and SIGTERM are only noted.
void note_interrupts();

// Whether one came. May be asked from any thread.
bool interrupted();

// Throws RunError when one came; `what_is_left` says what the run leaves behind.
void stop_if_interrupted(const std::string& what_is_left);

}  // namespace pushfactor::demos
