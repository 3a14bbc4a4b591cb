// Pages as browsers get them: numbers, tables, commands, contents, colours.
#include "demos/pages/page.h"

#include "demos/pages/short_numbers.h"
#include "tests/catch.h"
#include "tests/demos/pages/check_page.h"
#include "tests/texts.h"

#include <algorithm>
#include <cmath>
#include <regex>

using namespace pushfactor::demos;
using namespace pushfactor::tests;

namespace {

int times(const std::string& text, const std::string& part) {
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

std::vector<Section> sections_of(std::size_t count) {
    std::vector<Section> sections;
    for (std::size_t i = 0; i < count; ++i)
        sections.push_back({.name = "one of many", .heading = "Some & <others>", .content = {}});
    return sections;
}

std::string page_of(const TextTable& table) {
    Section section{.name = "table", .heading = "Table", .content = {}};
    section.content.table = table;
    return page_text("Title", "Opening", std::vector{section});
}

using Colours = std::map<std::string, double>;  // relative luminance by name

Colours colours_in(const std::string& css) {
    Colours colours;
    const std::regex line("--([a-z-]+): #([0-9a-f]{6})");
    for (std::sregex_iterator i(css.begin(), css.end(), line), end; i != end; ++i) {
        const int rgb = std::stoi((*i)[2], nullptr, 16);
        const auto part = [rgb](int shift) {
            const double c = ((rgb >> shift) & 255) / 255.0;
            return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        };
        colours[(*i)[1]] = 0.2126 * part(16) + 0.7152 * part(8) + 0.0722 * part(0);
    }
    return colours;
}

double contrast(const Colours& colours, const std::string& a, const std::string& b) {
    const auto [dark, light] = std::minmax(colours.at(a), colours.at(b));
    return (light + 0.05) / (dark + 0.05);
}

}  // namespace

TEST_CASE("numbers of a text are shown with four digits, and no zero is negative") {
    CHECK(with_short_numbers("0.30000000000000004 m") == "0.3000 m");
    CHECK(with_short_numbers("at 59.99997, 1234.5678 and 12345.678 N") == "at 60.00, 1235 and 12346 N");
    CHECK(with_short_numbers("999.9999 and 99999.9") == "1000 and 1.000e5");
    CHECK(with_short_numbers("-9.87654321e-06") == "-9.877e-6");
    CHECK(with_short_numbers("1e-06, 2.5e+20, 123456.7") == "1e-6, 2.5e20, 1.235e5");
    CHECK(with_short_numbers("-0.0, -0.00 m/s, -0, 0.0 and -0.01") == "0.0, 0.00 m/s, 0, 0.0 and -0.01");
    CHECK(with_short_numbers("is 0.99999.") == "is 1.000.");
    CHECK(with_short_numbers("|speed_m_per_s - 0.406312| / 2") == "|speed_m_per_s - 0.4063| / 2");
}

TEST_CASE("versions, names, dates, ranges, commits and whole numbers in a text stay as they are") {
    for (const char* const text :
         {"g++ 12.2.0, 20240131", "cube-200-m-per-s-from-4.12345", "at-1e6-m", "12.2.1", "2.60123GHz", "5410e28",
          "1.23456-2.34567", "a1.23456", "seed 1234567", "5 of 12", "push.12345", "", "-", "1e", "--beta"}) {
        CHECK(with_short_numbers(text) == text);
    }
}

TEST_CASE("in a cell long whole numbers are rounded too") {
    CHECK(short_cell("1234567") == "1.235e6");
    CHECK(short_cell("1000000") == "1e6");
    CHECK(short_cell("0.00010002") == "0.0001");
    CHECK(short_cell("0.30000000000000004") == "0.3");
    CHECK(short_cell("12345") == "12345");
    CHECK(short_cell("<= 0.123456") == "≤ 0.1235");
    CHECK(short_cell("rest; >= 1e-06 instead") == "rest; ≥ 1e-6 instead");
}

TEST_CASE("a page is whole whatever its texts are") {
    std::vector<Section> sections = sections_of(5);
    SectionContent& content = sections[1].content;
    content.caption = "a < b && \"c\" -0.0 </p>";
    content.pictures = {"a \"b\".png"};
    content.files = {"a#b.csv"};
    content.commands = {"pushfactor run a.json > b && echo '<p>'", "pushfactor run \"b\""};
    content.table = {{"verdict", "<case>", "command"}, {"holds", "a & b", "x < y"}, {"fails", "", ""}, {"perhaps"}};
    const std::string page = page_text("A <title>", "An opening & more", sections);
    check_page(page);
    CHECK(times(page, "<section id=\"one-of-many") == 5);
    CHECK(times(page, "<a href=\"#one-of-many-3\">") == 1);
    CHECK(times(page, "class=\"copy\"") == 3);
    CHECK(page.find("a%23b.csv") != std::string::npos);
}

TEST_CASE("a page of few sections has no contents") {
    CHECK(page_text("Title", "Opening", sections_of(3)).find("<nav") == std::string::npos);
    CHECK(page_text("Title", "Opening", sections_of(4)).find("<nav") != std::string::npos);
}

TEST_CASE("a column that is empty in every line is left out") {
    const std::string page = page_of({{"case", "measure", "value"}, {"a", "", "1"}, {"b"}});
    check_page(page);
    CHECK(page.find("measure") == std::string::npos);
    CHECK(times(page, "<td") == 2);
    CHECK(page_of({{"case", "measure"}}).find("measure") != std::string::npos);
}

TEST_CASE("verdicts are a word and a sign besides the colour, and are counted where the section begins") {
    const std::string page =
        page_of({{"verdict", "case"}, {"holds", "a"}, {"holds", "b"}, {"known miss", "c"}, {"fails", "d"}});
    check_page(page);
    CHECK(times(page, "<span aria-hidden=\"true\">✓</span> <span class=\"word\">holds</span></span>") == 2);
    CHECK(times(page, "<span aria-hidden=\"true\">≈</span> <span class=\"word\">known miss</span></span>") == 1);
    CHECK(times(page, "<span aria-hidden=\"true\">✗</span> <span class=\"word\">fails</span></span>") == 1);
    CHECK(times(page, "holds: </span>2</span>") == 1);
    CHECK(times(page, "fails: </span>1</span>") == 1);
}

TEST_CASE("what a line only repeats is one cell with the line above, numbers never are") {
    const std::string page = page_of({{"verdict", "case", "preset", "value", "command"},
                                      {"holds", "a", "default", "1.5", "run a"},
                                      {"holds", "a", "default", "1.5", "run a"},
                                      {"holds", "a", "exact", "1.5", "run a --preset exact"},
                                      {"holds", "b", "exact", "1.5", "run b"}});
    check_page(page);
    CHECK(page.find("<th scope=\"row\" rowspan=\"3\">a</th><td rowspan=\"2\">default</td>") != std::string::npos);
    CHECK(times(page, "<td>exact</td>") == 2);
    CHECK(times(page, ">1.5</td>") == 4);
    CHECK(times(page, "<code>") == 3);
    CHECK(times(page, "class=\"copy\"") == 3);
    CHECK(times(page, "<th scope=\"col\" class=\"number\">value</th>") == 1);
    CHECK(times(page, "aria-label=\"Copy the command: a, exact\"") == 1);
}

TEST_CASE("colours of the pages have the contrast that WCAG 2 asks for at level AA, in light and in dark") {
    const std::string css = read_file(std::string(PUSHFACTOR_SOURCE_DIR) + "/assets/pages/page.css");
    const auto dark = css.find("@media (prefers-color-scheme: dark)");
    REQUIRE(dark != std::string::npos);
    for (const std::string& scheme : {css.substr(0, dark), css.substr(dark, css.find("\n}", dark) - dark)}) {
        const Colours colours = colours_in(scheme);
        REQUIRE(colours.size() == 12);
        for (const auto& [text, ground] :
             {std::pair{"ink", "paper"}, std::pair{"ink", "tint"}, std::pair{"faint", "paper"},
              std::pair{"link", "paper"}, std::pair{"holds", "holds-tint"}, std::pair{"known", "known-tint"},
              std::pair{"fails", "fails-tint"}}) {
            INFO(text << " on " << ground);
            CHECK(contrast(colours, text, ground) >= 4.5);
        }
    }
}
