#include "demos/pages/page.h"

#include "demos/base/platform/assets.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/plain_name.h"
#include "demos/base/text/html.h"
#include "demos/pages/short_numbers.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

namespace pushfactor::demos {

namespace {

// A page with more sections than that has a table of contents.
constexpr std::size_t few_sections = 3;

std::string shown(const std::string& text) {
    return html::escaped(with_short_numbers(text));
}

// Unique ids of the sections.
std::vector<std::string> anchors_of(std::span<const Section> sections) {
    std::set<std::string> taken{"contents", "said"};
    std::vector<std::string> anchors;
    for (const Section& section : sections) anchors.push_back(unused_name(html::anchor(section.name), taken));
    return anchors;
}

// "✓ holds: 12 ✗ fails: 1" of the section's table; empty without verdicts.
std::string marks_of(const Section& section) {
    std::string text;
    const auto counts = marks_in(section.content.table);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) text += " " + mark_html(static_cast<Mark>(i), counts[i]);
    }
    return text;
}

std::string file_link(const std::string& file, const std::string& text) {
    return fmt::format(" <a href=\"{}\">{}</a>", html::link_to(file), html::escaped(text));
}

std::string contents(std::span<const Section> sections, const std::vector<std::string>& anchors) {
    std::string text =
        "<nav id=\"contents\" aria-labelledby=\"contents-heading\">\n"
        "<h2 id=\"contents-heading\">Contents</h2>\n<ul>\n";
    for (std::size_t i = 0; i < sections.size(); ++i) {
        text += fmt::format("<li><a href=\"#{}\">{}</a>{}</li>\n", anchors[i], shown(sections[i].heading),
                            marks_of(sections[i]));
    }
    return text + "</ul>\n</nav>\n";
}

std::string figure_of(const Section& section) {
    const SectionContent& content = section.content;
    const std::string caption = content.caption.empty() ? "" : shown(content.caption);
    if (content.pictures.empty()) return caption.empty() ? "" : fmt::format("<p>{}</p>\n", caption);
    std::string text = content.pictures.size() == 2 ? "<figure class=\"pair\">\n" : "<figure>\n";
    for (const std::string& picture : content.pictures) {
        text += fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a>\n", html::link_to(picture),
                            html::escaped(section.heading));
    }
    if (!caption.empty()) text += fmt::format("<figcaption>{}</figcaption>\n", caption);
    return text + "</figure>\n";
}

std::string commands_of(const Section& section) {
    const std::vector<std::string>& commands = section.content.commands;
    if (commands.empty()) return "";
    std::string text =
        fmt::format("<details>\n<summary>{}</summary>\n",
                    commands.size() == 1 ? "Command that shows this"
                                         : fmt::format("{} commands that show this", commands.size()));
    for (const std::string& command : commands) text += command_html(command, section.heading) + "\n";
    return text + "</details>\n";
}

std::string files_of(const Section& section) {
    if (section.content.files.empty()) return "";
    std::string text = "<p class=\"files\">Files:";
    for (const std::string& file : section.content.files) text += file_link(file, file);
    return text + "</p>\n";
}

std::string replays_of(const Section& section) {
    const std::vector<std::string>& replays = section.content.replays;
    if (replays.empty()) return "";
    if (replays.size() == 1) return "<p class=\"files\">" + file_link(replays.front(), "Replay") + "</p>\n";
    std::string text = fmt::format("<details>\n<summary>{} replays</summary>\n<p class=\"files\">", replays.size());
    for (const std::string& replay : replays) text += file_link(replay, std::filesystem::path(replay).stem());
    return text + "</p>\n</details>\n";
}

std::string section_text(const Section& section, const std::string& anchor, bool has_contents) {
    if (!section.content.kept.empty()) return section.content.kept;
    const std::string marks = marks_of(section);
    return fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n<h2 id=\"{0}-heading\">{1}</h2>\n",
                       anchor, shown(section.heading)) +
           (marks.empty() ? "" : fmt::format("<p class=\"verdicts\">{}</p>\n", marks)) + figure_of(section) +
           replays_of(section) + table_html(section.content.table, section.heading) + commands_of(section) +
           files_of(section) + (has_contents ? "<p class=\"up\"><a href=\"#contents\">↑ Contents</a></p>\n" : "") +
           "</section>\n";
}

}  // namespace

std::string section_on(const std::string& page, const std::string& name) {
    const std::string end = "</section>\n";
    const std::size_t from = page.find(fmt::format("<section id=\"{}\"", html::anchor(name)));
    const std::size_t to = page.find(end, from);
    return to == std::string::npos ? "" : page.substr(from, to + end.size() - from);
}

std::string document(const std::string& title, const std::string& opening, const std::string& body,
                     std::initializer_list<const char*> assets) {
    std::string styles, scripts;
    for (const std::string name : assets)
        (name.ends_with(".css") ? styles : scripts) += asset_text(asset_folder("pages") / name);
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{0}</title>\n"
        "<style>\n{1}</style>\n</head>\n<body>\n<header>\n<h1>{0}</h1>\n<p>{2}</p>\n</header>\n{3}"
        "<p id=\"said\" role=\"status\"></p>\n<script>\n{4}</script>\n</body>\n</html>\n",
        html::escaped(title), styles, shown(opening), body, scripts);
}

std::string page_text(const std::string& title, const std::string& opening, std::span<const Section> sections) {
    const std::vector<std::string> anchors = anchors_of(sections);
    const bool has_contents = sections.size() > few_sections;
    std::string body = has_contents ? contents(sections, anchors) : "";
    body += "<main>\n";
    for (std::size_t i = 0; i < sections.size(); ++i) body += section_text(sections[i], anchors[i], has_contents);
    return document(title, opening, body + "</main>\n", {"page.css", "page.js"});
}

void write_index(const std::filesystem::path& folder, const std::string& page) {
    const std::filesystem::path live = live_page();
    if (page.find(fmt::format("href=\"{}#", live.filename().string())) != std::string::npos) {
        write_file(folder / live.filename(), asset_text(live));
    }
    write_file(folder / "index.html", page);
}

}  // namespace pushfactor::demos
