// Files for CI servers.
#include "demos/pages/verdict_files.h"

#include "tests/catch.h"
#include "tests/texts.h"

using namespace pushfactor::demos;
using namespace pushfactor::tests;

namespace {

std::vector<SuiteVerdict> many(int pictures) {
    SuiteVerdict suite{.name = "goldens/a \"long\" & <odd> name"};
    for (int i = 0; i < pictures; ++i) {
        suite.cases.push_back({.name = "frame_" + std::to_string(i) + ".png",
                               .failure = "3.1 % of the pixels differ by more than 2 levels (0.2 % allowed)",
                               .badness = 0.001 * i});
    }
    return {suite, {.name = "good", .cases = {{.name = "one"}}}};
}

}  // namespace

TEST_CASE("JUnit XML counts, escapes, and has what the schemas require") {
    std::vector<SuiteVerdict> suites = many(2);
    suites.front().cases.push_back({.name = "fine"});
    suites.front().cases[0].failure = "a < b & \"c\"\x01\nnext";
    const std::string expected = R"xml(<?xml version="1.0" encoding="UTF-8"?>
<testsuites>
  <testsuite name="goldens/a &quot;long&quot; &amp; &lt;odd&gt; name" package="pushfactor" id="0" timestamp="2001-09-09T01:46:40" hostname="localhost" tests="3" failures="2" errors="0" skipped="0" time="0.000">
    <properties/>
    <testcase classname="goldens/a &quot;long&quot; &amp; &lt;odd&gt; name" name="frame_0.png" time="0.000">
      <failure type="difference" message="a &lt; b &amp; &quot;c&quot;�&#10;next">a &lt; b &amp; &quot;c&quot;�&#10;next</failure>
    </testcase>
    <testcase classname="goldens/a &quot;long&quot; &amp; &lt;odd&gt; name" name="frame_1.png" time="0.000">
      <failure type="difference" message="3.1 % of the pixels differ by more than 2 levels (0.2 % allowed)">3.1 % of the pixels differ by more than 2 levels (0.2 % allowed)</failure>
    </testcase>
    <testcase classname="goldens/a &quot;long&quot; &amp; &lt;odd&gt; name" name="fine" time="0.000"/>
    <system-out/>
    <system-err/>
  </testsuite>
  <testsuite name="good" package="pushfactor" id="1" timestamp="2001-09-09T01:46:40" hostname="localhost" tests="1" failures="0" errors="0" skipped="0" time="0.000">
    <properties/>
    <testcase classname="good" name="one" time="0.000"/>
    <system-out/>
    <system-err/>
  </testsuite>
</testsuites>
)xml";
    CHECK(junit_xml(suites, 1000000000) == expected);
}

TEST_CASE("the summary of a job lists the worst first, as text, and fits") {
    const std::string text = job_summary("2 of 3 pictures | differ", many(2));
    const std::vector<std::string> expected{"### 2 of 3 pictures \\| differ",
                                            "",
                                            "| failure | |",
                                            "|---|---|",
                                            "| goldens/a \"long\" \\& \\<odd\\> name: frame\\_1.png | 3.1 % of the "
                                            "pixels differ by more than 2 levels (0.2 % "
                                            "allowed) |",
                                            "| goldens/a \"long\" \\& \\<odd\\> name: frame\\_0.png | 3.1 % of the "
                                            "pixels differ by more than 2 levels (0.2 % "
                                            "allowed) |",
                                            "",
                                            "| | | checked | failed | not compared |",
                                            "|---|---|---|---|---|",
                                            "| ❌ | goldens/a \"long\" \\& \\<odd\\> name | 2 | 2 | 0 |",
                                            "| ✅ | good | 1 | 0 | 0 |"};
    CHECK(lines_of(text) == expected);

    CHECK(job_summary("1000", many(1000)).size() < 1'000'000);
    CHECK(job_summary("1000", many(1000)).find("no room") == std::string::npos);
    const std::string large = job_summary("100000", many(100000));
    CHECK(large.size() <= 500'000);
    CHECK(large.find("no room") != std::string::npos);
}

TEST_CASE("JUnit XML is UTF-8 for any name, and what was not compared is skipped") {
    const std::vector<SuiteVerdict> suites{
        {.name = "caf\xe9",
         .cases = {{.name = "\xef\xbf\xbf\xed\xa0\x80.png"},
                   {.name = "physics", .skipped = "no <summary>", .seconds = 1.5}}}};
    const std::string xml = junit_xml(suites, 0);
    CHECK(xml.find("name=\"caf\ufffd\"") != std::string::npos);
    CHECK(xml.find("name=\"\ufffd\ufffd\ufffd\ufffd.png\"") != std::string::npos);
    CHECK(xml.find("skipped=\"1\"") != std::string::npos);
    CHECK(xml.find("time=\"1.500\">\n      <skipped message=\"no &lt;summary&gt;\"/>") != std::string::npos);
}
