// The ledger in two pictures: the share of each stage, and what the parts cost that a scene does without.
#pragma once

#include "demos/reports/cost/tables.h"

#include <filesystem>

namespace pushfactor::demos::reports::cost {

// Adds pictures and their data, made in `folder`, to the sections of table_sections() that they belong to.
void add_plots(std::span<const Entry> entries, const std::string& made_on, const std::filesystem::path& folder,
               std::vector<Section>& sections);

}  // namespace pushfactor::demos::reports::cost
