// Reading CSV files.
#include "demos/base/text/csv.h"

#include "demos/base/text/errors.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

using namespace pushfactor;
using namespace pushfactor::demos;

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows read(const std::string& text) {
    const tests::Folder folder;
    folder.write("a.csv", text);
    return read_csv("--beside", folder / "a.csv", {"name", "value"});
}

}  // namespace

TEST_CASE("cells may be in quotes, comments are left out, and joined files have several headings") {
    CHECK(read("# made by hand\nname,value\n\"a, b\",1\n# no\nname,value\nc,\n") == Rows{{"a, b", "1"}, {"c", ""}});
    CHECK(read("name,value\n").empty());
    CHECK(read("name,value\n\"a \"\"b\"\", c\",\"\"\n") == Rows{{"a \"b\", c", ""}});
}

TEST_CASE("a CSV file that is none names the line and what it must be") {
    using Catch::Contains;
    CHECK_THROWS_WITH(read("name,speed\na,1\n"), Contains("--beside") && Contains("line 1: must be name,value"));
    CHECK_THROWS_WITH(read("name,value\na,1\nb\n"), Contains("line 3: must have 2 cells, not 1"));
    CHECK_THROWS_WITH(read("# nothing\n"), Contains("must begin with name,value"));
    CHECK_THROWS_WITH(read_csv("--beside", "/nowhere.csv", {"name"}), Contains("/nowhere.csv: cannot be read"));
}
