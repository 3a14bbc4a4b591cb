#include "demos/pages/check_page.h"

#include "demos/base/text/html.h"
#include "demos/pages/page.h"
#include "demos/pictures/checks/worst_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace pushfactor::demos::checks {

namespace {

// A picture with its folder.
struct Entry {
    const FolderVerdict* folder;
    const PictureVerdict* picture;

    std::string name() const { return folder->name + "/" + picture->name; }
};

const char* const unexpected = "unexpected: not a picture of this run";

// Pictures that differ, the worst first, equal ones in the order of their names.
std::vector<Entry> worst_first(std::span<const FolderVerdict> folders) {
    std::vector<Entry> entries;
    for (const FolderVerdict& folder : folders) {
        for (const PictureVerdict& picture : folder.pictures) {
            if (!picture.holds()) entries.push_back({&folder, &picture});
        }
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.picture->badness > b.picture->badness; });
    return entries;
}

std::string folder_table(std::span<const FolderVerdict> folders) {
    TextTable table{{verdict_column, "folder", "pictures", "differ", "run", "pictures are compared"}};
    for (const FolderVerdict& folder : folders) {
        std::string run;
        for (const RunVerdict& one : folder.runs) {
            if (one.holds && one.compared) continue;
            run += fmt::format("{}{}: {}{}", run.empty() ? "" : "; ", one.subject,
                               one.compared ? "" : "not compared: ", one.text);
        }
        if (run.empty()) run = folder.runs.empty() ? "none" : "as expected";
        const Mark mark = folder.failures() > 0                                     ? Mark::fails
                          : folder.not_compared() > 0 || !folder.unexpected.empty() ? Mark::not_compared
                                                                                    : Mark::holds;
        table.push_back({std::string(word_of(mark)), folder.name, std::to_string(folder.pictures.size()),
                         std::to_string(folder.differing()), run, folder.how});
    }
    return "<section>\n<h2>Folders</h2>\n" + table_html(table, "Folders") + "</section>\n";
}

std::string exhibit_html(const Entry& entry) {
    const PictureVerdict& picture = *entry.picture;
    const std::string path = entry.folder->anchor + "/" + picture.name, name = html::escaped(entry.name());
    std::string text = fmt::format("<section class=\"exhibit\">\n<h2>{}</h2>\n<p>{}</p>\n<div class=\"stage\">\n",
                                   name, html::escaped(picture.text));
    const bool has_expected = picture.finding != Finding::missing && picture.finding != Finding::unreadable;
    const bool has_difference = picture.finding == Finding::differs;
    for (const auto& [exhibit, heading, is_there] :
         {std::tuple{"expected", "Expected", has_expected}, std::tuple{"actual", "Actual", true},
          std::tuple{"difference", "Difference", has_difference}}) {
        const std::string content =
            is_there ? fmt::format("<a href=\"{0}\"><img loading=\"lazy\" src=\"{0}\" alt=\"{1} {2}\"></a>",
                                   html::link_to(exhibit_file(path, exhibit)), heading, name)
                     : "<div class=\"absent\">none</div>";
        text +=
            fmt::format("<figure class=\"{}\">{}<figcaption>{}</figcaption></figure>\n", exhibit, content, heading);
    }
    return text +
           "</div>\n<p class=\"what\"></p>\n<input class=\"cut\" type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
           "aria-label=\"Where the expected picture ends\">\n</section>\n";
}

const char* const modes =
    "<div class=\"modes\" role=\"toolbar\" aria-label=\"How to compare\" hidden>\n"
    "<button type=\"button\" value=\"side\">Side by side</button>\n"
    "<button type=\"button\" value=\"swap\">Swap</button>\n"
    "<button type=\"button\" value=\"slider\">Slider</button>\n"
    "<button type=\"button\" value=\"difference\">Difference</button>\n"
    "<span class=\"hint\">Keys 1 to 4; a click or the space bar swaps</span>\n</div>\n";

// Pictures that differ but are not shown, and unexpected ones.
std::string rest_html(std::span<const FolderVerdict> folders, const std::vector<Entry>& entries) {
    TextTable table{{"picture", "finding"}};
    for (const Entry& entry : entries) {
        if (!entry.picture->shown) table.push_back({entry.name(), entry.picture->text});
    }
    for (const FolderVerdict& folder : folders) {
        for (const std::string& name : folder.unexpected) {
            table.push_back({folder.name + "/" + name, unexpected});
        }
    }
    if (table.size() == 1) return "";
    return "<section>\n<h2>Without pictures</h2>\n" + table_html(table, "Without pictures") + "</section>\n";
}

std::string plural(long count, const char* word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

// A run is compared by its physics; that it had the same options says nothing of what it did.
bool says_of_run(const RunVerdict& verdict) {
    return !verdict.holds || (verdict.compared && !verdict.subject.starts_with("options"));
}

}  // namespace

std::vector<std::string> lines_of(const FolderVerdict& folder) {
    std::vector<std::string> lines;
    for (const RunVerdict& run : folder.runs) {
        if (!run.holds) lines.push_back(fmt::format("{}: {}: {}", folder.name, run.subject, run.text));
    }
    for (const RunVerdict& run : folder.runs) {
        if (!run.compared)
            lines.push_back(fmt::format("{}: {}: not compared: {}", folder.name, run.subject, run.text));
    }
    for (const PictureVerdict& picture : folder.pictures) {
        if (!picture.holds()) lines.push_back(fmt::format("{}/{}: {}", folder.name, picture.name, picture.text));
    }
    for (const std::string& name : folder.unexpected) {
        lines.push_back(fmt::format("{}/{}: {}", folder.name, name, unexpected));
    }
    return lines;
}

std::string headline(std::span<const FolderVerdict> folders) {
    long pictures = 0, differ = 0, runs = 0, wrong_runs = 0, skipped = 0, strangers = 0;
    for (const FolderVerdict& folder : folders) {
        pictures += std::ssize(folder.pictures);
        differ += folder.differing();
        skipped += folder.not_compared() > 0 ? 1 : 0;
        strangers += std::ssize(folder.unexpected);
        runs += std::ranges::any_of(folder.runs, says_of_run) ? 1 : 0;
        wrong_runs += std::ranges::any_of(folder.runs, [](const auto& run) { return !run.holds; });
    }
    const auto of = [](long some, long all, const char* word) {
        return fmt::format("{} of {}", some, plural(all, word));
    };
    std::string apart = skipped > 0 ? "; " + plural(skipped, "run") + " not compared, or not wholly" : "";
    if (strangers > 0) apart += "; " + plural(strangers, "picture") + " unexpected";
    if (differ + wrong_runs == 0) {
        const std::string tail = runs > 0 ? " and " + plural(runs, "run") : "";
        return fmt::format("{}{} {} as expected{}", plural(pictures, "picture"), tail,
                           pictures + runs == 1 ? "is" : "are", apart);
    }
    std::string text;
    if (differ > 0) text = of(differ, pictures, "picture");
    if (wrong_runs > 0) text += (text.empty() ? "" : " and ") + of(wrong_runs, runs, "run");
    return text + (differ + wrong_runs == 1 ? " differs" : " differ") + apart;
}

std::string page_of(std::span<const FolderVerdict> folders, const std::string& made_with) {
    const std::vector<Entry> entries = worst_first(folders);
    std::string body = "<main>\n" + folder_table(folders);
    std::string exhibits;
    for (const Entry& entry : entries) {
        if (entry.picture->shown) exhibits += exhibit_html(entry);
    }
    if (!exhibits.empty()) body += modes + exhibits;
    body += rest_html(folders, entries) + "</main>\n";
    const std::string opening = fmt::format(
        "Checked with {}. Up to {} pictures of a folder are shown, the worst first; in the difference dark red is "
        "small and white large.",
        made_with, WorstPictures::most);
    return document(headline(folders), opening, body, {"page.css", "check.css", "page.js", "check.js"});
}

std::vector<SuiteVerdict> suites_of(std::span<const FolderVerdict> folders) {
    std::vector<SuiteVerdict> suites;
    for (const FolderVerdict& folder : folders) {
        SuiteVerdict& suite = suites.emplace_back(SuiteVerdict{.name = folder.name, .seconds = folder.seconds});
        for (const RunVerdict& run : folder.runs) {
            suite.cases.push_back({.name = run.subject,
                                   .failure = run.holds ? "" : run.text,
                                   .skipped = run.compared ? "" : run.text,
                                   .badness = 3.0});
        }
        for (const PictureVerdict& picture : folder.pictures) {
            suite.cases.push_back({.name = picture.name,
                                   .failure = picture.holds() ? "" : picture.text,
                                   .seconds = picture.seconds,
                                   .badness = picture.badness});
        }
        for (const std::string& name : folder.unexpected)
            suite.cases.push_back({.name = name, .skipped = unexpected});
    }
    return suites;
}

}  // namespace pushfactor::demos::checks
