// One run with everything that was asked to watch it: measurements, and the CSV files that were named.
#pragma once

#include "demos/measurements.h"
#include "demos/records.h"
#include "demos/request.h"

#include <memory>
#include <vector>

namespace pushfactor::demos {

class ObservedRun {
  public:
    ObservedRun(const Choices& choices, const Request& request);

    const Simulation& simulation() const { return simulation_; }
    void advance();

    // Completes the CSV files and gives the summary.
    std::string finish();

  private:
    Choices choices_;
    Simulation simulation_;
    Measurements measurements_;
    std::vector<std::unique_ptr<Record>> records_;
};

// CPU time of this thread in us.
double thread_cpu_us();

}  // namespace pushfactor::demos
