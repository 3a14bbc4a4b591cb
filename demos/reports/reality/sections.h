// The sections of the report on measured motion.
#pragma once

#include "demos/reports/study.h"

namespace pushfactor::demos::reports::reality {

void add_closed_forms(StudyRun& run);  // closed_forms.csv
void add_tosses(StudyRun& run);        // toss_fit.csv, tosses.csv, toss_errors.csv
void add_dice(StudyRun& run);          // dice.csv
void add_packings(StudyRun& run);      // packings.csv

}  // namespace pushfactor::demos::reports::reality
