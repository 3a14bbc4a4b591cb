// In place of threads.cpp where there is no oneTBB: in a browser, and when building for another processor.
#include "engine/base/threads.h"

namespace pushfactor::engine {

struct Threads::Arena {};
struct Threads::Crew {};

void Team::wait_for_all() {}

Threads::Threads(int) : count_(1) {}

Threads::~Threads() = default;

int Threads::all() {
    return 1;
}

void Threads::share(std::size_t count, std::size_t, const Part& work) {
    if (count > 0) work(0, count, 0);
}

void Threads::as_team(const std::function<void(Team& team)>& work) {
    Team alone;
    work(alone);
}

void Threads::keep_at_hand(const std::function<void()>& work) {
    work();
}

}  // namespace pushfactor::engine
