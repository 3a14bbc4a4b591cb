// What the ledger is about: every scene of the catalogue as it comes, and some in other sizes and moments.
#pragma once

#include "demos/options/named_run.h"

#include <string>
#include <vector>

namespace pushfactor::demos::reports::cost {

struct CostCase {
    std::string name;     // "funnel of 200, falling"
    std::string scene;    // of the catalogue
    OptionTexts options;  // of the command line
    double start = 0.0;   // s, simulated, when counting begins

    // Without blanks, for the names of files.
    std::string file_name() const;
};

// `quick`: the small ones.
std::vector<CostCase> cost_cases(bool quick);

}  // namespace pushfactor::demos::reports::cost
