#include "demos/figures/printing/latex.h"

#include "demos/base/platform/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <string_view>
#include <utility>

namespace pushfactor::demos {

namespace {

constexpr double column_mm = 120.0;  // wider figures take both columns

constexpr std::string_view with_backslash = "&%$#_{}";
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> replacements{{{"\\", "\\textbackslash{}"},
                                                                                      {"~", "\\textasciitilde{}"},
                                                                                      {"^", "\\textasciicircum{}"},
                                                                                      {"<", "$<$"},
                                                                                      {">", "$>$"},
                                                                                      {"β", "$\\beta$"},
                                                                                      {"λ", "$\\lambda$"},
                                                                                      {"μ", "$\\mu$"},
                                                                                      {"²", "$^2$"},
                                                                                      {"ᵀ", "$^T$"},
                                                                                      {"₁", "$_1$"},
                                                                                      {"₂", "$_2$"},
                                                                                      {"…", "\\dots{}"},
                                                                                      {"·", "$\\cdot$"}}};

std::string escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto found = std::ranges::find_if(
            replacements, [&text](const auto& replacement) { return text.starts_with(replacement.first); });
        const bool replaced = found != replacements.end();
        if (with_backslash.find(text.front()) != std::string_view::npos) result += '\\';
        result += replaced ? found->second : text.substr(0, 1);
        text.remove_prefix(replaced ? found->first.size() : 1);
    }
    return result;
}

}  // namespace

std::string latex_text(const std::string& text) {
    // 1.2e-09 and s^2, which escaping would break.
    static const std::regex special(R"((\d(?:\.\d+)?)e([+-]?)0*(\d+)\b|\^(-?\d+))");
    std::string result;
    std::size_t at = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), special), end; i != end; ++i) {
        const std::smatch& match = *i;
        const auto begin = static_cast<std::size_t>(match.position());
        result += escaped(std::string_view(text).substr(at, begin - at));
        at = begin + static_cast<std::size_t>(match.length());
        result += match[4].matched ? fmt::format("$^{{{}}}$", match[4].str())
                                   : fmt::format("${}\\cdot10^{{{}{}}}$", match[1].str(),
                                                 match[2].str() == "-" ? "-" : "", match[3].str());
    }
    return result + escaped(std::string_view(text).substr(at));
}

std::string latex_figure(const std::string& name, const std::string& file, const Print& print,
                         const std::string& caption) {
    const std::string environment = print.width_mm > column_mm ? "figure*" : "figure";
    return fmt::format(
        "% \\usepackage{{graphicx}} above, \\bibliography{{pushfactor}} below; in a document of another folder "
        "also\n"
        "% \\newcommand{{\\pushfactorfolder}}{{THIS FOLDER/}} above\n"
        "\\providecommand{{\\pushfactorfolder}}{{}}\n"
        "\\begin{{{0}}}\n  \\centering\n  \\includegraphics{{\\pushfactorfolder {1}}}\n"
        "  \\caption{{{2} Made with Pushfactor~\\cite{{pushfactor}}, after~\\cite{{tamis2015constraint}}.}}\n"
        "  \\label{{fig:{3}}}\n\\end{{{0}}}\n",
        environment, file, latex_text(caption), name);
}

std::string bibliography() {
    return fmt::format(
        "@misc{{tamis2015constraint,\n  author = {{Marijn Tamis and Giuseppe Maggiore}},\n  year = {{2015}},\n"
        "  note = {{v1.02}},\n  title = {{Constraint based physics solver}}\n}}\n"
        "@misc{{pushfactor,\n  key = {{Pushfactor}},\n  title = {{Pushfactor}},\n  note = {{version {}}}\n}}\n",
        latex_text(version_text()));
}

}  // namespace pushfactor::demos
