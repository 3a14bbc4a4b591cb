// Thumbnails of the last states of a chapter's runs, on one sheet.
#pragma once

#include "demos/figures/figure_output.h"
#include "demos/reports/stability/trial.h"

#include <memory>
#include <span>

namespace pushfactor::demos::reports::stability {

class Gallery {
  public:
    // Pictures are written to `folder`. Without an offscreen context there are none.
    explicit Gallery(const std::filesystem::path& folder);

    // The reason why there are no pictures, one line; empty if there are.
    const std::string& missing() const { return missing_; }

    // Writes NAME.png and returns that name; empty without pictures. Throws OutputError.
    std::string hang(const std::string& name, std::span<const Trial> trials);

  private:
    std::string missing_;
    std::unique_ptr<figures::FigureOutput> output_;
};

}  // namespace pushfactor::demos::reports::stability
