#include "demos/checks/verdict.h"

#include <fmt/format.h>

namespace pushfactor::demos::checks {

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
        lines.push_back(fmt::format("{}/{}: unexpected: not a picture of this run", folder.name, name));
    }
    return lines;
}

}  // namespace pushfactor::demos::checks
