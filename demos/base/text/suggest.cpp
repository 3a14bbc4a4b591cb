#include "demos/base/text/suggest.h"

#include "demos/base/text/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace pushfactor::demos {

namespace {

// Levenshtein distance.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

}  // namespace

std::string suggestion(std::string_view typed, std::span<const std::string> known) {
    const std::string* nearest = nullptr;
    std::size_t least = std::max<std::size_t>(2, typed.size() / 3) + 1;
    for (const std::string& word : known) {
        const std::size_t d = distance(typed, word);
        if (d < least) {
            least = d;
            nearest = &word;
        }
    }
    return nearest ? "; did you mean " + *nearest + "?" : std::string();
}

std::string nearest_or_all(std::string_view typed, std::span<const std::string> known) {
    const std::string nearest = suggestion(typed, known);
    return nearest.empty() ? fmt::format("; there are {}", fmt::join(known, ", ")) : nearest;
}

std::string one_of(std::string_view typed, std::span<const std::string> known) {
    return fmt::format("must be one of {}{}", fmt::join(known, ", "), suggestion(typed, known));
}

void require_known(std::string_view field, std::string_view typed, std::span<const std::string> known) {
    if (std::ranges::find(known, typed) != known.end()) return;
    throw UsageError("{} {}: {}", field, typed, one_of(typed, known));
}

}  // namespace pushfactor::demos
