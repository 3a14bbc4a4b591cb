// The page that shows all figures. It opens from disk and needs nothing from elsewhere.
#pragma once

#include "demos/figures/figure.h"

#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::figures {

std::string page_text(const std::vector<std::pair<Figure, Plate>>& plates);

}  // namespace pushfactor::demos::figures
