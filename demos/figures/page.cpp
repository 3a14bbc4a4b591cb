#include "demos/figures/page.h"

#include <fmt/format.h>

namespace pushfactor::demos::figures {

namespace {

const char* const head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Pushfactor: figures</title>
<style>
body { font: 17px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
figure { margin: 2.5rem 0; }
img { width: 100%; height: auto; border: 1px solid #ddd; box-sizing: border-box; }
figcaption { margin-top: 0.5rem; }
h2 { font-size: 1.15rem; margin-bottom: 0.6rem; }
code { font: 0.85em/1.4 "DejaVu Sans Mono", monospace; background: #f3f3f3; padding: 0.15em 0.3em; }
p.more { font-size: 0.85em; margin: 0.4rem 0; }
</style>
</head>
<body>
<h1>Pushfactor: figures</h1>
<p>Figures 5 to 11 of Tamis &amp; Maggiore, <i>Constraint based physics solver</i> (2015), and some of our own. All numbers
were measured in the runs that are shown.</p>
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

}  // namespace

std::string page_text(const std::vector<std::pair<Figure, Plate>>& plates) {
    std::string text = head;
    for (const auto& [figure, plate] : plates) {
        text += fmt::format("<figure id=\"{}\">\n<h2>{}</h2>\n", figure.name, escaped(std::string(figure.title)));
        for (const std::string& picture : plate.pictures) {
            text += fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a>\n", picture,
                                escaped(std::string(figure.title)));
        }
        text += fmt::format("<figcaption>{}\n", escaped(plate.caption));
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

}  // namespace pushfactor::demos::figures
