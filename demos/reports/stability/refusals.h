// What is no number, infinite, zero or negative where it may not be: every number of a scene file and every option
// has to be refused by its name.
#pragma once

#include "demos/reports/stability/cases.h"

namespace pushfactor::demos::reports::stability {

Chapter refusals();

}  // namespace pushfactor::demos::reports::stability
