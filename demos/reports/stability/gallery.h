// Thumbnails of how the runs of a chapter ended, on one sheet.
#pragma once

#include "demos/reports/stability/trial.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace pushfactor::demos::pictures {
class Studio;
}

namespace pushfactor::demos::reports::stability {

class Gallery {
  public:
    // Pictures lie in `folder`. Without an offscreen context there are none.
    explicit Gallery(std::filesystem::path folder);
    ~Gallery();

    // Why there are no pictures, one line; empty when there are.
    const std::string& missing() const { return missing_; }

    // Writes NAME.png and gives that name; empty when there is nothing to be seen. Throws OutputError.
    std::string hang(const std::string& name, std::span<const Trial> trials) const;

  private:
    std::filesystem::path folder_;
    std::string missing_;
    std::unique_ptr<pictures::Studio> studio_;
};

}  // namespace pushfactor::demos::reports::stability
