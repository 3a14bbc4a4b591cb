// "Did you mean" suggestions for misspelt words.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// Of the entries of a table.
template <typename Table>
std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> names;
    for (const auto& entry : table) names.emplace_back(entry.name);
    return names;
}

// "; did you mean WORD?" for the nearest of `known`, or empty if none is near.
std::string suggestion(std::string_view typed, std::span<const std::string> known);

// The same, or "; there are A, B" if none is near.
std::string nearest_or_all(std::string_view typed, std::span<const std::string> known);

// "must be one of A, B; did you mean B?"
std::string one_of(std::string_view typed, std::span<const std::string> known);

// Throws UsageError "FIELD TYPED: must be one of ..." for an unknown word.
void require_known(std::string_view field, std::string_view typed, std::span<const std::string> known);

}  // namespace pushfactor::demos
