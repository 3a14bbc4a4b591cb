// Thumbnails of how the runs of a chapter ended, on one sheet.
#pragma once

#include "demos/pages/figure_output.h"
#include "demos/reports/stability/trial.h"

#include <memory>
#include <span>

namespace pushfactor::demos::reports::stability {

class Gallery {
  public:
    // Pictures lie in `folder`. Without an offscreen context there are none.
    explicit Gallery(const std::filesystem::path& folder);

    // Why there are no pictures, one line; empty when there are.
    const std::string& missing() const { return missing_; }

    // Writes NAME.png and gives that name; empty when there is nothing to be seen. Throws OutputError.
    std::string hang(const std::string& name, std::span<const Trial> trials);

  private:
    std::string missing_;
    std::unique_ptr<figures::FigureOutput> output_;
};

}  // namespace pushfactor::demos::reports::stability
