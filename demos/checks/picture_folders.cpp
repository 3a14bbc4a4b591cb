#include "demos/checks/picture_folders.h"

#include "demos/checks/comparison.h"
#include "demos/checks/expectation.h"
#include "demos/checks/worst_pictures.h"
#include "demos/pictures/film/frame_queue.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/read_png.h"

#include <fmt/format.h>

#include <memory>
#include <set>

namespace pushfactor::demos::checks {

namespace fs = std::filesystem;
using pictures::FrameQueue;
using pictures::StageWatch;

namespace {

// PNG files below a folder, by their paths in it.
std::set<std::string> pictures_below(const fs::path& folder) {
    std::set<std::string> names;
    if (!fs::is_directory(folder)) throw UsageError(fmt::format("check {}: must be a folder", folder.string()));
    for (const fs::path& file : files_below(folder)) {
        if (is_png(file)) names.insert(file.lexically_relative(folder).generic_string());
    }
    return names;
}

// The images of the second folder, compared with the first by the threads of a queue.
Compared compare_files(const Comparison& comparison, const fs::path& expected, const fs::path& actual) {
    const std::optional<Bytes> before = read_bytes(expected), now = read_bytes(actual);
    Compared compared;
    try {
        const renderer::Image image = renderer::decode_png(now.value_or(Bytes{}));
        if (before == now) return compared;
        return compare(comparison, expected, image, *now);
    } catch (const renderer::RendererError& error) {
        compared.verdict = {.name = {}, .finding = Finding::unreadable, .badness = 2.0, .text = error.what()};
        compared.expected = before.value_or(Bytes{});
        return compared;
    }
}

}  // namespace

FolderVerdict check_pictures(const fs::path& expected, const fs::path& actual, const Tolerance& tolerance,
                             const FolderJob& job) {
    const Stopwatch stopwatch;
    const std::set<std::string> names = pictures_below(expected), others = pictures_below(actual);
    if (names.empty()) {
        throw UsageError(fmt::format("check {}: must have PNG files in it or below", expected.string()));
    }
    FolderVerdict verdict{.name = job.name, .anchor = job.anchor, .how = tolerance.text()};
    for (const std::string& name : others) {
        if (names.count(name) == 0) verdict.unexpected.push_back(name);
    }
    WorstPictures worst(job.pages / job.anchor);
    FrameQueue queue(
        [&](const std::string& name, const renderer::Image&, StageWatch&) -> FrameQueue::End {
            const Stopwatch own;
            auto compared = std::make_shared<Compared>();
            if (others.count(name) == 0) {
                compared->verdict = without(name, "missing");
            } else {
                *compared = compare_files({.tolerance = tolerance}, expected / name, actual / name);
                compared->verdict.name = name;
            }
            compared->verdict.seconds = own.seconds();
            return [&, compared](StageWatch&) {
                worst.offer(*compared);
                verdict.pictures.push_back(compared->verdict);
            };
        },
        nullptr);
    long done = 0;
    for (const std::string& name : names) {
        if (interrupted()) break;
        queue.send(name, {});
        job.progress(++done);
    }
    queue.flush();
    stop_if_interrupted("no file was changed");
    worst.mark(verdict.pictures);
    verdict.seconds = stopwatch.seconds();
    return verdict;
}

}  // namespace pushfactor::demos::checks
