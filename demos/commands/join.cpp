#include "demos/commands/join.h"

#include "demos/pictures/film/sequence.h"
#include "demos/pictures/film/video.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/read_png.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <iterator>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

// The film that all folders have frames of.
pictures::Sequence film_of(const std::vector<std::string>& folders) {
    const fs::path first = fs::path(folders.front()) / "config.json";
    for (const std::string& folder : folders) {
        const fs::path config = fs::path(folder) / "config.json";
        if (!fs::exists(config)) {
            throw UsageError(fmt::format("--join {}: must have a config.json, as `render` writes it", folder));
        }
        if (bytes_of(config) != bytes_of(first)) {
            throw UsageError(
                fmt::format("--join: must be of one film: {} differs from {}", config.string(), first.string()));
        }
    }
    GivenOptions given;
    add_config(first, given);
    const auto* const scene = given.find("scene");
    if (!scene) throw UsageError(fmt::format("{}: scene: must be given", first.string()));
    if (given.find("at"))
        throw UsageError(fmt::format("--join {}: must be a sequence, not stills", folders.front()));
    return pictures::plan_sequence(scene->text, given);
}

// Where each frame is.
std::vector<fs::path> files_of(const pictures::Sequence& film, const std::vector<std::string>& folders) {
    std::vector<fs::path> files;
    std::vector<std::string> missing;
    for (const Frame& frame : film.frames.front()) {
        const auto found = std::ranges::find_if(
            folders, [&](const std::string& folder) { return fs::exists(fs::path(folder) / frame.name); });
        if (found == folders.end()) {
            missing.push_back(frame.name);
        } else {
            files.push_back(fs::path(*found) / frame.name);
        }
    }
    if (missing.empty()) return files;
    constexpr std::size_t most = 10;
    const std::size_t all = missing.size();
    missing.resize(std::min(all, most));
    throw RunError(fmt::format("--join: {} of {} frames are missing: {}{}", all, film.frame_count(),
                               fmt::join(missing, ", "), all > most ? ", ..." : ""));
}

renderer::Image picture_in(const fs::path& file) {
    const std::string bytes = bytes_of(file);
    try {
        return renderer::decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    } catch (const renderer::RendererError& error) {
        throw RunError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}  // namespace

void join(const Request& request) {
    if (!request.video) throw UsageError("--join: must be with --video FILE");
    if (!request.scenes.empty()) {
        throw UsageError(
            fmt::format("scene {}: must not be with --join, whose config.json has it", request.scenes.front()));
    }
    pictures::check_video_name(*request.video);
    pictures::require_ffmpeg(*request.video);
    const pictures::Sequence film = film_of(request.joined);
    const std::vector<fs::path> files = files_of(film, request.joined);
    const FrameChoices& frames = film.panels.front().choices.frames;
    pictures::Video video(*request.video, frames.width, frames.height, frames.film_rate());
    ProgressBar bar("join", static_cast<long>(files.size()));
    for (std::size_t i = 0; i < files.size(); ++i) {
        stop_if_interrupted(fmt::format("{} of {} frames were read", i, files.size()));
        const renderer::Image image = picture_in(files[i]);
        if (image.width != frames.width || image.height != frames.height) {
            throw RunError(fmt::format("{}: must be {}x{} pixels, not {}x{}", files[i].string(), frames.width,
                                       frames.height, image.width, image.height));
        }
        video.add(image);
        bar.show(static_cast<long>(i + 1));
    }
    video.finish();
    fmt::print("{}\n", *request.video);
}

}  // namespace pushfactor::demos::commands
