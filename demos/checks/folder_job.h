#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

namespace pushfactor::demos::checks {

// What there is to do and where its pictures go.
struct FolderJob {
    std::string name;             // of the verdict
    std::string anchor;           // of the verdict
    std::filesystem::path pages;  // folder of the page
    std::function<void(long)> progress = [](long) {};
};

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace pushfactor::demos::checks
