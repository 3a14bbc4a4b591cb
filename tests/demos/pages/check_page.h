// The claims about every page that the program writes.
#pragma once

#include <string>
#include <vector>

namespace pushfactor::tests {

// Checks that the page is well-formed (tags balanced, texts escaped, ids unique, targets of inner links exist),
// loads nothing external, has a language, a title and, with more than three sections, contents that lead to each;
// that each command is folded and has a button that copies it; that no number in a cell has more than five
// significant digits and no text has a "-0.0".
void check_page(const std::string& page);

// The texts of the page outside of commands, style and script, entities resolved; one for each cell or paragraph.
std::vector<std::string> texts_of(const std::string& page);

}  // namespace pushfactor::tests
