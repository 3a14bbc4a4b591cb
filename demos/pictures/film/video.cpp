#include "demos/pictures/film/video.h"

#include "demos/base/platform/shell_words.h"
#include "demos/base/text/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace pushfactor::demos::pictures {

namespace {

namespace fs = std::filesystem;

// With the point. A file named ".mp4" has an extension for ffmpeg, but not for std::filesystem.
std::string extension(const fs::path& file) {
    const std::string name = file.filename();
    return name.substr(std::min(name.rfind('.'), name.size()));
}

// ffmpeg reads a name that begins with '-' as an option and text before a ':' as a protocol; a leading folder
// prevents both.
fs::path for_ffmpeg(const fs::path& file) {
    return file.is_absolute() ? file : "." / file;
}

// The functions below return ffmpeg options separated by spaces.

// yuv420p, which every player supports, needs even sides. An odd side repeats its last line of pixels: scaling
// would blur the picture, and a black line would be visible.
std::string even_sides(int width, int height) {
    if (width % 2 == 0 && height % 2 == 0) return "";
    return fmt::format("format=gbrp,pad={}:{},fillborders=right={}:bottom={}:mode=smear,", width + width % 2,
                       height + height % 2, width % 2, height % 2);
}

// By default ffmpeg converts with the matrix of standard definition and does not record it, and players guess from
// the size of the picture. So the matrix is set and recorded in the video.
std::string film(int width, int height, std::string_view codec) {
    return fmt::format(
        "-vf {}scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_inp {} -pix_fmt "
        "yuv420p -colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv",
        even_sides(width, height), codec);
}

// GIF delays are hundredths of a second, and players slow down delays below two. The palette is chosen from moving
// pixels (stats_mode=diff).
std::string gif(int width, const Rational& fps) {
    return fmt::format("-filter_complex {}{}split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse",
                       fps.value() > 50.0 ? "fps=50," : "", width > 640 ? "scale=640:-1:flags=area," : "");
}

std::string format_options(const std::string& format, int width, int height, const Rational& fps) {
    if (format == ".gif") return gif(width, fps);
    if (format == ".webm") {
        return film(width, height, "-c:v libvpx-vp9 -deadline realtime -cpu-used 6 -row-mt 1 -crf 30 -b:v 0");
    }
    return film(width, height, "-c:v libx264 -preset veryfast -crf 18 -movflags +faststart");
}

// Without "xerror" a full disk is reported but the status is 0. "bitexact" omits encoder metadata, so that equal
// frames give equal files.
std::vector<std::string> arguments(const fs::path& target, int width, int height, const Rational& fps) {
    std::vector<std::string> words = words_of(fmt::format(
        "-loglevel error -xerror -nostdin -y -f rawvideo -pixel_format rgb24 -video_size {}x{} -framerate {}/{} -i "
        "pipe:0 -fflags +bitexact {}",
        width, height, fps.numerator, fps.denominator, format_options(extension(target), width, height, fps)));
    words.push_back(target);
    return words;
}

// Errors of ffmpeg are those of the file.
template <typename Work>
void in_name_of(const fs::path& file, const Work& work) {
    try {
        work();
    } catch (const ChildProcessError& error) {
        throw OutputError("{}: {}", file.string(), error.what());
    }
}

}  // namespace

void check_video_name(const fs::path& file) {
    const std::string format = extension(file);
    if (format == ".mp4" || format == ".webm" || format == ".gif") return;
    throw UsageError("--video {}: must end in .mp4, .webm or .gif", file.string());
}

void require_ffmpeg(const fs::path& file) {
    in_name_of(file, [] { require_program("ffmpeg", "ffmpeg"); });
}

Video::Video(fs::path file, int width, int height, const Rational& fps)
    : file_(std::move(file)), width_(width), height_(height) {
    check_video_name(file_);
    std::error_code ignored;
    const fs::file_status status = fs::status(file_, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) fail("is there already and is no regular file");
    // Created here and not by ffmpeg, which takes the format from the extension, so that a missing or read-only
    // folder is reported before the first frame.
    staged_.emplace(file_, extension(file_));
    in_name_of(file_, [&] {
        ffmpeg_.emplace("ffmpeg", "ffmpeg", arguments(for_ffmpeg(staged_->path()), width, height, fps));
    });
}

void Video::fail(const std::string& why) const {
    throw OutputError(file_.string() + ": " + why);
}

void Video::add(const renderer::Image& image) {
    if (image.width != width_ || image.height != height_) fail("the frames of a video must be of one size");
    in_name_of(file_, [&] { ffmpeg_->feed(image.rgb); });
}

void Video::finish() {
    in_name_of(file_, [&] { ffmpeg_->finish(); });
    staged_->commit();
}

}  // namespace pushfactor::demos::pictures
