// The ledger as text: the lines of cost.csv and the tables of the page.
#pragma once

#include "demos/pages/page.h"
#include "demos/reports/cost/ledger.h"

#include <span>
#include <string>

namespace pushfactor::demos::reports::cost {

// A scene of the ledger as it is and with everything constructed.
struct Entry {
    std::string name;
    double start = 0.0;  // s, simulated
    struct Made {
        Ledger ledger;
        std::string command;  // that takes the same steps
    };
    Made as_it_is, with_everything;
};

// Two lines an entry, "as it is" and "everything". Memory is left out where it is not counted.
std::string csv_text(std::span<const Entry> entries);

// At least three digits; whole numbers are not rounded.
std::string three_digits(double value);

// The tables of the page, each under its heading.
std::vector<Section> table_sections(std::span<const Entry> entries);

}  // namespace pushfactor::demos::reports::cost
