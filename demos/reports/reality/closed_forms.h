// Motions with friction whose result is known in closed form.
#pragma once

#include "demos/options/settings.h"

#include <string>
#include <vector>

namespace pushfactor::demos::reports::reality {

struct ClosedForm {
    std::string name;  // with what is measured and its unit
    std::string formula;
    double exact = 0.0;
    double (*computed)(FrictionModel model);
};
const std::vector<ClosedForm>& closed_forms();

}  // namespace pushfactor::demos::reports::reality
