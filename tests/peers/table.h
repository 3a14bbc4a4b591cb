// Results as Markdown for people and as CSV for programs.
#pragma once

#include "tests/peers/cases.h"

#include <iosfwd>

namespace pushfactor::tests::peers {

struct Line {
    std::string engine, setting;
    Values values;
    std::string reference = {};  // as in Setting
};

void write_markdown(std::ostream& out, const Case& of, const std::vector<Line>& lines);
void write_csv_header(std::ostream& out);
void write_csv(std::ostream& out, const Case& of, const std::vector<Line>& lines);

}  // namespace pushfactor::tests::peers
