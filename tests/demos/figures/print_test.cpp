// Figures for print: sizes on paper, letters, LaTeX, and colours that stay apart in grey.
#include "demos/base/text/numbers.h"
#include "demos/base/text/palette.h"
#include "demos/base/text/wrapped.h"
#include "demos/figures/printing/latex.h"
#include "demos/figures/printing/sheet.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/skip.h"

#include <cmath>
#include <cstdlib>
#include <regex>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;

namespace {

bool installed(const char* program) {
    return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

// CIE L* of an sRGB colour, 0 to 100: what is left of it in grey.
double lightness(const Colour& colour) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
    return 116.0 * std::cbrt(y) - 16.0;
}

// Width and height of a PNG, and whether it has an alpha channel.
struct Header {
    int width = 0, height = 0;
    bool alpha = false;
};

Header header_of(const std::string& png) {
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(png.at(at + i));
        return value;
    };
    return {number(16), number(20), png.at(25) == 6};
}

double number_in(const std::string& text, const std::string& pattern) {
    std::smatch match;
    REQUIRE(std::regex_search(text, match, std::regex(pattern)));
    return std::stod(match[1]);
}

}  // namespace

TEST_CASE("lengths have a unit") {
    CHECK(parse_length_mm("85mm") == 85.0);
    CHECK(parse_length_mm("8.5cm") == 85.0);
    CHECK(*parse_length_mm("72pt") == Approx(25.4));
    CHECK(parse_length_mm("1in") == 25.4);
    for (const char* wrong : {"85", "mm", "85 ft", "", "1e400mm"}) CHECK(!parse_length_mm(wrong));
}

TEST_CASE("the colours of print stay apart in grey") {
    const char* const from_dark_to_light[] = {"violet", "blue", "vermilion", "green", "orange", "ivory"};
    double last = -100.0;
    for (const char* name : from_dark_to_light) {
        const auto colour = std::find_if(print_palette.begin(), print_palette.end(),
                                         [&](const Colour& one) { return one.name == name; });
        REQUIRE(colour != print_palette.end());
        INFO(name);
        CHECK(lightness(*colour) > last + 9.0);
        last = lightness(*colour);
    }
}

TEST_CASE("captions become LaTeX") {
    CHECK(latex_text("100 % of 10 m/s^2, a_b & {c}") == "100 \\% of 10 m/s$^{2}$, a\\_b \\& \\{c\\}");
    CHECK(latex_text("1.2e-09 J, 3e5, 2e+08") == "$1.2\\cdot10^{-9}$ J, $3\\cdot10^{5}$, $2\\cdot10^{8}$");
    CHECK(latex_text("β = 0.2 < 1, Jᵀ λ₁") == "$\\beta$ = 0.2 $<$ 1, J$^T$ $\\lambda$$_1$");
    const std::string narrow = latex_figure("a", "a.pdf", {.width_mm = 85.0}, "What.");
    CHECK(narrow.find("\\begin{figure}\n") != std::string::npos);
    CHECK(narrow.find("\\label{fig:a}") != std::string::npos);
    CHECK(latex_figure("a", "a.pdf", {.width_mm = 170.0}, "").find("\\begin{figure*}\n") != std::string::npos);
    CHECK(bibliography().find("@misc{pushfactor,") != std::string::npos);
}

TEST_CASE("labels are broken between words") {
    const pictures::Lettering lettering;
    const float width = lettering.width("single-frame push,", 20.0f);
    const auto fits = [&](const std::string& line) { return lettering.width(line, 20.0f) <= width; };
    CHECK(wrapped("single-frame push, 0.5 s", fits) == std::vector<std::string>{"single-frame push,", "0.5 s"});
    CHECK(wrapped("a", [](const std::string&) { return false; }) == std::vector<std::string>{"a"});
}

TEST_CASE("Figure 7 in a column of 85 mm has letters of 8 points, in its PDF and in a LaTeX document") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor figures figure_07 --width 85mm --samples 1 --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    const Header header = header_of(folder.read("figure_07.png"));
    CHECK(header.width == 1004);  // 85 mm at 300 dpi
    // Under the panels, whose width over height is 0.72, are a line of text and the legend.
    CHECK(header.height > 1004 / 3 / 0.72 + 4.0 * 8.0 / 72.0 * 300.0);
    REQUIRE(std::filesystem::exists(folder / "figure_07.pdf"));
    CHECK(folder.files() == std::vector<std::string>{"figure_07.html", "figure_07.pdf", "figure_07.png",
                                                     "figure_07.tex", "index.html", "pushfactor.bib"});
    if (!installed("pdflatex") || !installed("pdftohtml") || !installed("pdfinfo")) {
        skip("needs texlive-latex-base and poppler-utils");
        return;
    }
    folder.write("paper.tex",
                 "\\documentclass[twocolumn]{article}\\usepackage[utf8]{inputenc}\\usepackage{graphicx}\n"
                 "\\begin{document}\\input{figure_07}\\bibliographystyle{plain}\\bibliography{pushfactor}"
                 "\\end{document}\n");
    const Ended made = shell(folder, "pdflatex -interaction=nonstopmode -halt-on-error paper.tex");
    INFO(made.out);
    REQUIRE(made.status == 0);
    const std::string size = shell(folder, "pdfinfo figure_07.pdf").out;
    CHECK(number_in(size, "Page size: +([0-9.]+)") == Approx(85.0 / 25.4 * 72.0).margin(0.6));
    for (const char* file : {"figure_07.pdf", "paper.pdf"}) {
        INFO(file);
        const std::string xml = shell(folder, std::string("pdftohtml -xml -i -stdout -zoom 1 ") + file).out;
        // The font of the texts under the panels.
        const double font = number_in(xml, "font=\"([0-9]+)\">(?:<[^>]*>)*a\\) start");
        CHECK(number_in(xml, "<fontspec id=\"" + std::to_string(static_cast<int>(font)) + "\" size=\"([0-9]+)\"") ==
              8.0);
    }
}

TEST_CASE("plots for print have the font embedded, and those for talks a dark or no background") {
    const Folder folder;
    const Ended ended =
        shell(folder,
              "pushfactor figures pendulum_energy --width 3.5in --dpi 200 --font-size 9pt --theme dark "
              "--background none --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    const Header header = header_of(folder.read("pendulum_energy.png"));
    CHECK(header.width == 700);
    CHECK(header.alpha);
    REQUIRE(
        shell(folder, "pushfactor figures figure_11 --width 400 --samples 1 --background none --out .").status ==
        0);
    CHECK(header_of(folder.read("figure_11.png")).alpha);
    CHECK(folder.read("pendulum_energy.pdf").find("/FontFile2") != std::string::npos);
    CHECK(folder.read("pendulum_energy.tex").find("\\includegraphics{\\pushfactorfolder pendulum_energy.pdf}") !=
          std::string::npos);
}

TEST_CASE("a size on paper that cannot be is refused") {
    check_refused("figures figure_07 --width 85ft", "must be a number of pixels or a length on paper");
    check_refused("figures figure_07 --width 10mm", "--width 10mm at 300 dpi: 118 pixels, must be 400 to 4096");
    check_refused("figures figure_07 --dpi 300", "--dpi 300: must be with a --width on paper, say 85mm");
    check_refused("figures figure_07 --width 85mm --font-size 2pt",
                  "--font-size 2pt: must be a length of 4pt to 24pt");
    check_refused("figures figure_07 --theme blue", "--theme blue: must be light or dark");
    check_refused("figures figure_07 --background red", "--background red: must be plain or none");
}
