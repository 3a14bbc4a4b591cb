// Tables of reports and figures, as CSV and as rows of a page.
#include "demos/pages/table.h"

#include "tests/catch.h"
#include "tests/demos/csv.h"

using namespace pushfactor::demos;

TEST_CASE("fields of a CSV table are in quotes where they need them, and numbers have all their digits") {
    const Table table{{"name", "value_m"},
                      {{"pgs, warm", 0.1}, {"a \"b\"", {}}, {"plain", 1e-20}, {"", 12345678.0}}};
    CHECK(csv_text(table) == "name,value_m\n\"pgs, warm\",0.1\n\"a \"\"b\"\"\",\nplain,1e-20\n,12345678\n");
    CHECK(pushfactor::tests::table_of(csv_text(table)).at(1).at(0) == "pgs, warm");
}

TEST_CASE("the lines of a page have the chosen columns and three digits, and whole numbers are not rounded") {
    const Table table{{"scene", "step_us", "rows"}, {{"stack", 1.23456, 1234}, {"wave", -0.00012345, 0}}};
    CHECK(page_lines(table, {"rows", "step_us"}) ==
          std::vector<std::vector<std::string>>{{"rows", "step us"}, {"1234", "1.23"}, {"0", "-0.000123"}});
    CHECK(page_lines(table).at(1) == std::vector<std::string>{"stack", "1.23", "1234"});
}
