#include "demos/base/platform/progress.h"

#include "demos/base/platform/messages.h"
#include "demos/base/text/errors.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

namespace pushfactor::demos {

namespace {

std::atomic<bool> interrupt_came = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler needs a lock-free flag");

}  // namespace

ProgressBar::ProgressBar(std::string label, long total)
    : label_(std::move(label)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      next_(start_) {}

ProgressBar::~ProgressBar() {
    if (drawn_) say("\n");
}

void ProgressBar::show(long done) {
    const auto now = Clock::now();
    if (!terminal_ || total_ <= 0 || (now < next_ && done < total_)) return;
    next_ = now + std::chrono::milliseconds(100);
    drawn_ = true;

    constexpr int width = 30;
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    const int filled = static_cast<int>(share * width);
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double left = share > 0.0 ? elapsed * (1.0 - share) / share : 0.0;
    say(fmt::format("\r{} [{:=<{}}{: <{}}] {}/{}  {:.0f} s left ", label_, "", filled, "", width - filled, done,
                    total_, left));
}

void note_interrupts() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        // A shell starts background jobs with SIGINT ignored, nohup with SIGHUP; that stays.
        if (std::signal(signal, [](int) { interrupt_came = true; }) == SIG_IGN) std::signal(signal, SIG_IGN);
    }
}

bool interrupted() {
    return interrupt_came;
}

void stop_if_interrupted(const std::string& what_is_left) {
    if (interrupted()) throw RunError("interrupted: " + what_is_left);
}

}  // namespace pushfactor::demos
