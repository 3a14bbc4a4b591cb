// The page of a campaign: the table of families, and for each family the member that is farthest beyond a limit, at
// its start, in the middle and at its end.
#pragma once

#include "tests/fuzz/family_campaign.h"

#include <filesystem>

namespace pushfactor::tests {

// Writes `folder`/index.html and a picture of each family. Without an offscreen context there are no pictures, and
// the page says why. Throws OutputError.
void write_family_page(const std::vector<JudgedMember>& judged, const FamilyRequest& request,
                       const std::filesystem::path& folder);

}  // namespace pushfactor::tests
