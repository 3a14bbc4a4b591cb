#include "demos/pages/page.h"

#include <fmt/format.h>

namespace pushfactor::demos {

namespace {

const char* const style = R"(<style>
body { font: 17px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
figure { margin: 2.5rem 0; }
img { width: 100%; height: auto; border: 1px solid #ddd; box-sizing: border-box; }
figcaption { margin-top: 0.5rem; }
h2 { font-size: 1.15rem; margin-bottom: 0.6rem; }
code { font: 0.85em/1.4 "DejaVu Sans Mono", monospace; background: #f3f3f3; padding: 0.15em 0.3em; }
table { border-collapse: collapse; font-size: 0.75em; margin: 0.6rem 0; overflow-wrap: anywhere; }
th, td { border-bottom: 1px solid #ddd; padding: 0.2em 0.5em; text-align: left; vertical-align: top; }
p.more { font-size: 0.85em; margin: 0.4rem 0; }
</style>
)";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string table_text(const std::vector<std::vector<std::string>>& table) {
    std::string text = "<table>\n";
    for (std::size_t i = 0; i < table.size(); ++i) {
        text += "<tr>";
        for (const std::string& field : table[i])
            text += fmt::format("<{0}>{1}</{0}>", i == 0 ? "th" : "td", escaped(field));
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

}  // namespace

std::string page_text(const std::string& title, const std::string& opening, std::span<const Section> sections) {
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n{1}</head>\n<body>\n"
        "<h1>{0}</h1>\n<p>{2}</p>\n",
        escaped(title), style, escaped(opening));
    for (const auto& [name, heading, plate] : sections) {
        text += fmt::format("<figure id=\"{}\">\n<h2>{}</h2>\n", name, escaped(heading));
        for (const std::string& picture : plate.pictures) {
            text += fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a>\n", picture, escaped(heading));
        }
        text += fmt::format("<figcaption>{}\n", escaped(plate.caption));
        if (!plate.table.empty()) text += table_text(plate.table);
        for (const std::string& command : plate.commands) {
            text += fmt::format("<p class=\"more\"><code>{}</code></p>\n", escaped(command));
        }
        if (!plate.files.empty()) text += "<p class=\"more\">";
        for (const std::string& file : plate.files) text += fmt::format("<a href=\"{0}\">{0}</a> ", file);
        if (!plate.files.empty()) text += "</p>\n";
        text += "</figcaption>\n</figure>\n";
    }
    return text + "</body>\n</html>\n";
}

}  // namespace pushfactor::demos
