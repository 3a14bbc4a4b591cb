#include "demos/video.h"

#include "demos/errors.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pushfactor::demos {

namespace {

namespace fs = std::filesystem;

// With the point; of ".mp4" all of it. (That is no extension to std::filesystem, but it is one to ffmpeg.)
std::string extension(const fs::path& file) {
    const std::string name = file.filename();
    return name.substr(std::min(name.rfind('.'), name.size()));
}

// ffmpeg takes the format from the extension, so that stays last. It takes a name that begins with '-' for an
// option, and what stands before a ':' for a protocol; neither happens to a name that begins with a folder.
fs::path temporary_name(const fs::path& file) {
    std::string name = file.filename();
    name.insert(name.size() - extension(file).size(), ".partial");
    const fs::path folder = file.parent_path();
    return (folder.is_absolute() ? folder : "." / folder) / name;
}

// Searched as a shell does: an empty entry is the working folder.
std::optional<fs::path> find_ffmpeg() {
    const char* const path = std::getenv("PATH");
    std::string_view folders = path ? path : "/usr/bin:/bin";
    for (bool more = true; more;) {
        const auto colon = folders.find(':');
        const fs::path candidate = fs::path(folders.substr(0, colon)) / "ffmpeg";
        std::error_code ignored;
        if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0) return candidate;
        more = colon != std::string_view::npos;
        if (more) folders.remove_prefix(colon + 1);
    }
    return std::nullopt;
}

// What follows is options in one line, parted by single spaces.

// One colour for 2 x 2 pixels, which every player can show, needs even sides. An odd side gets its last line of
// pixels twice: scaling would blur every pixel, and a line of black would be seen.
std::string even_sides(int width, int height) {
    if (width % 2 == 0 && height % 2 == 0) return "";
    return fmt::format("format=gbrp,pad={}:{},fillborders=right={}:bottom={}:mode=smear,", width + width % 2,
                       height + height % 2, width % 2, height % 2);
}

// Left to itself ffmpeg converts with the matrix of standard definition and says nothing of it, and players guess
// by the size of the picture. So the conversion is chosen, and the video says which it was.
std::string film(int width, int height, std::string_view codec) {
    return fmt::format(
        "-vf {}scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_inp {} "
        "-pix_fmt yuv420p -colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv",
        even_sides(width, height), codec);
}

// Time in a GIF goes by hundredths of a second, and players slow down what asks for less than two of them. The
// palette is made for what moves.
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

// Without "xerror" a disk that fills up is reported but the status is 0. "bitexact" leaves out what a file would
// say of its making, so that equal frames give equal files.
std::vector<std::string> arguments(const fs::path& target, int width, int height, const Rational& fps) {
    std::istringstream line(fmt::format(
        "ffmpeg -loglevel error -xerror -nostdin -y "
        "-f rawvideo -pixel_format rgb24 -video_size {}x{} -framerate {}/{} -i pipe:0 -fflags +bitexact {}",
        width, height, fps.numerator, fps.denominator, format_options(extension(target), width, height, fps)));
    std::vector<std::string> words{std::istream_iterator<std::string>(line), {}};
    words.push_back(target);
    return words;
}

void close_if_open(int& descriptor) {
    if (descriptor >= 0) close(descriptor);
    descriptor = -1;
}

// What waitpid() says of a child that has ended; -1 when the system kept no record of it.
int wait_for(pid_t child) {
    int status = -1;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return -1;
    }
    return status;
}

std::string describe(int status) {
    if (WIFEXITED(status)) return fmt::format("ffmpeg ended with status {}", WEXITSTATUS(status));
    if (WIFSIGNALED(status)) return fmt::format("ffmpeg was ended by signal {}", WTERMSIG(status));
    return "how ffmpeg ended is not known";
}

// The last three lines of a file, as one.
std::string last_lines(std::FILE* file) {
    std::fseek(file, 0, SEEK_END);
    std::fseek(file, std::max(std::ftell(file) - 4096, 0L), SEEK_SET);
    std::string text(4096, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file));

    std::string lines;
    int count = 0;
    for (std::size_t end = text.size(); end > 0 && count < 3;) {
        const std::size_t newline = text.find_last_of("\r\n", end - 1);
        const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
        if (begin < end) {
            lines = text.substr(begin, end - begin) + (count > 0 ? "; " : "") + lines;
            ++count;
        }
        end = begin > 0 ? begin - 1 : 0;
    }
    return lines;
}

}  // namespace

void check_video_name(const fs::path& file) {
    const std::string format = extension(file);
    if (format == ".mp4" || format == ".webm" || format == ".gif") return;
    throw UsageError(fmt::format("--video {}: must end in .mp4, .webm or .gif", file.string()));
}

bool ffmpeg_is_there() {
    return find_ffmpeg().has_value();
}

Video::Video(fs::path file, int width, int height) : file_(std::move(file)), width_(width), height_(height) {}

// The other constructor has made an object when this one begins its work, so the destructor cleans up after what
// is thrown here.
Video::Video(fs::path file, int width, int height, const Rational& fps) : Video(std::move(file), width, height) {
    check_video_name(file_);
    make_temporary();
    start(fps);
}

Video::~Video() {
    close_if_open(frames_in_);
    if (ffmpeg_ != 0) {
        // All of its group: some systems wrap ffmpeg in a script.
        kill(-ffmpeg_, SIGKILL);
        wait_for(ffmpeg_);
    }
    if (said_) std::fclose(said_);
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void Video::fail(const std::string& why) const {
    throw OutputError(file_.string() + ": " + why);
}

// Made here and not by ffmpeg, so that a folder that is not there or not ours is heard of before the first frame.
void Video::make_temporary() {
    std::error_code ignored;
    const fs::file_status status = fs::status(file_, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) fail("is there already and is no regular file");
    const fs::path name = temporary_name(file_);
    std::FILE* const made = std::fopen(name.c_str(), "wb");
    if (!made) fail(std::strerror(errno));
    std::fclose(made);
    temporary_ = name;
}

void Video::start(const Rational& fps) {
    const auto program = find_ffmpeg();
    if (!program) fail("ffmpeg is not installed; on Debian: apt install ffmpeg");

    // What ffmpeg says goes to a file: a pipe that nobody reads would fill up, and both would wait for ever.
    said_ = std::tmpfile();
    if (!said_) fail(fmt::format("no temporary file: {}", std::strerror(errno)));

    // A socket and not a pipe, because send() can be told not to raise SIGPIPE. Close-on-exec, or an ffmpeg that
    // is started later would hold it open and this one would never see its end.
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail(std::strerror(errno));
    frames_in_ = ends[0];

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, fileno(said_), STDERR_FILENO);
    // A process group of its own, which the terminal's Ctrl-C does not reach.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);

    std::vector<std::string> words = arguments(temporary_, width_, height_, fps);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t started = 0;
    const int error = posix_spawn(&started, program->c_str(), &files, &attributes, pointers.data(), environ);

    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    if (error != 0) fail(fmt::format("{} does not start: {}", program->string(), std::strerror(error)));
    ffmpeg_ = started;
}

// Also tells ffmpeg that there are no more frames.
int Video::wait_for_end() {
    close_if_open(frames_in_);
    return wait_for(std::exchange(ffmpeg_, 0));
}

void Video::fail_as_ffmpeg_did(int status) const {
    const std::string words = last_lines(said_);
    fail(describe(status) + (words.empty() ? "" : ": " + words));
}

void Video::add(const renderer::Image& image) {
    assert(image.width == width_ && image.height == height_ && frames_in_ >= 0);
    const std::uint8_t* next = image.rgb.data();
    for (std::size_t left = image.rgb.size(); left > 0;) {
        const ssize_t sent = send(frames_in_, next, left, MSG_NOSIGNAL);
        if (sent >= 0) {
            next += sent;
            left -= static_cast<std::size_t>(sent);
        } else if (errno == EPIPE || errno == ECONNRESET) {
            fail_as_ffmpeg_did(wait_for_end());
        } else if (errno != EINTR) {
            fail(std::strerror(errno));
        }
    }
}

void Video::finish() {
    assert(ffmpeg_ != 0);
    const int status = wait_for_end();
    if (status != 0) fail_as_ffmpeg_did(status);
    std::error_code error;
    fs::rename(temporary_, file_, error);
    if (error) fail(error.message());
    temporary_.clear();
}

}  // namespace pushfactor::demos
