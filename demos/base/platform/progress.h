// Progress bars and interruption by signals.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace pushfactor::demos {

// A progress bar on standard error, drawn only on a terminal. The destructor ends its line.
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

// Installs handlers that only record SIGINT, SIGTERM and SIGHUP, unless they are ignored.
void note_interrupts();

// Whether such a signal was received. Thread-safe.
bool interrupted();

// Throws RunError if one was received; `what_is_left` describes the output that remains.
void stop_if_interrupted(const std::string& what_is_left);

// Called often during long work; its exceptions end that.
using StopCheck = std::function<void()>;

}  // namespace pushfactor::demos
