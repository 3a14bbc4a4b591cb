// Videos, with a shell script instead of ffmpeg: tests its input and the handling of its exit.
#include "demos/pictures/film/video.h"

#include "demos/base/text/errors.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;
using namespace pushfactor::tests;

namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

// Sets PATH for the life of the object.
class Path {
  public:
    explicit Path(const std::string& value) : before_(std::getenv("PATH")) { setenv("PATH", value.c_str(), 1); }
    ~Path() { setenv("PATH", before_.c_str(), 1); }
    Path(const Path&) = delete;
    Path& operator=(const Path&) = delete;

  private:
    std::string before_;
};

// A folder with a script of that body as the first ffmpeg on PATH. The body finds the name of the video in
// $video, and its folder in $here, where "arguments" holds one argument per line.
class FakeFfmpeg {
  public:
    explicit FakeFfmpeg(const std::string& body = "cat >\"$video\"")
        : path_(folder_.path().string() + ":/usr/bin:/bin") {
        folder_.write("ffmpeg",
                      "#!/bin/sh\n"
                      "here=$(dirname \"$0\")\n"
                      "for video; do :; done\n"
                      "echo $$ >\"$here/process\"\n"
                      "printf '%s\\n' \"$@\" >\"$here/arguments\"\n" +
                          body + "\n");
        fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
    }

    // Spaces before, between and after.
    std::string arguments() const {
        std::string text = " " + folder_.read("arguments");
        std::replace(text.begin(), text.end(), '\n', ' ');
        return text;
    }
    // Waits until the script has written it, 10 s at most.
    pid_t process() const {
        for (int i = 0; i < 1000 && !folder_.read("process").ends_with('\n'); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return std::stoi(folder_.read("process"));
    }

  private:
    Folder folder_;
    Path path_;
};

constexpr int width = 64, height = 36;  // pixels

// No two rows of it are equal, nor two images of different seeds.
renderer::Image picture(int seed, int columns = width, int rows = height) {
    renderer::Image image{columns, rows, {}};
    for (int i = 0; i < 3 * columns * rows; ++i) {
        image.rgb.push_back(static_cast<std::uint8_t>((i * 7 + i / 251 + seed * 31) % 256));
    }
    return image;
}

std::string bytes(const renderer::Image& image) {
    return {image.rgb.begin(), image.rgb.end()};
}

void make_video(const fs::path& file, const Rational& fps = {30, 1}, int columns = width, int rows = height) {
    Video video(file, columns, rows, fps);
    video.add(picture(0, columns, rows));
    video.finish();
}

// The arguments for a file of that name.
std::string arguments_for(const std::string& name, const Rational& fps, int columns, int rows) {
    const FakeFfmpeg ffmpeg;
    const Folder folder;
    make_video(folder / name, fps, columns, rows);
    return ffmpeg.arguments();
}

// The text of the OutputError that `act` must throw.
std::string error_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const OutputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("the frames of a video arrive in order, byte for byte, and the file has its name when it is whole") {
    const FakeFfmpeg ffmpeg;
    const Folder folder;
    std::string expected;
    Video video(folder / "film.mp4", width, height, {30, 1});
    for (int i = 0; i < 200; ++i) {
        video.add(picture(i));
        expected += bytes(picture(i));
    }
    CHECK(folder.files().size() == 1);
    CHECK(folder.files().front() != "film.mp4");
    video.finish();
    CHECK(folder.files() == Names{"film.mp4"});
    CHECK((folder.read("film.mp4") == expected));
}

TEST_CASE("ffmpeg is told the size, the rate and the codec of each kind of video, and how colours are coded") {
    const std::string mp4 = arguments_for("film.mp4", {30000, 1001}, 64, 36);
    CHECK_THAT(mp4,
               Catch::Contains(" -f rawvideo -pixel_format rgb24 -video_size 64x36 -framerate 30000/1001 -i "));
    // Otherwise a full disk would not be a failure.
    CHECK_THAT(mp4, Catch::Contains(" -xerror "));
    CHECK_THAT(mp4, Catch::Contains(" -c:v libx264 ") && Catch::Contains(" -pix_fmt yuv420p ") &&
                        Catch::Contains(" -movflags +faststart "));
    const std::string webm = arguments_for("film.webm", {60, 1}, 64, 36);
    CHECK_THAT(webm, Catch::Contains(" -framerate 60/1 ") && Catch::Contains(" -c:v libvpx-vp9 "));
    for (const std::string& words : {mp4, webm}) {
        CHECK_THAT(words, Catch::Contains("out_color_matrix=bt709:out_range=tv") &&
                              Catch::Contains(" -colorspace bt709 -color_primaries bt709 -color_trc bt709 "
                                              "-color_range tv ") &&
                              !Catch::Contains("pad="));
    }
    CHECK_THAT(arguments_for("film.gif", {30, 1}, 64, 36),
               Catch::Contains("palettegen") && Catch::Contains("paletteuse") && !Catch::Contains("fps=") &&
                   !Catch::Contains("scale="));
}

TEST_CASE("odd sides are made even, and a GIF is neither too fast nor too wide") {
    for (const char* name : {"film.mp4", "film.webm"}) {
        CHECK_THAT(arguments_for(name, {30, 1}, 321, 181), Catch::Contains(" -video_size 321x181 ") &&
                                                               Catch::Contains("pad=322:182,") &&
                                                               Catch::Contains("right=1:bottom=1:mode=smear"));
        CHECK_THAT(arguments_for(name, {30, 1}, 320, 181),
                   Catch::Contains("pad=320:182,") && Catch::Contains("right=0:bottom=1"));
    }
    CHECK_THAT(arguments_for("film.gif", {60, 1}, 64, 36), Catch::Contains(" fps=50,split"));
    CHECK_THAT(arguments_for("film.gif", {50, 1}, 641, 36), Catch::Contains(" scale=640:-1"));
}

TEST_CASE("what ffmpeg says when it fails is in the error, and nothing is left") {
    const std::string unknown_encoder = "echo \"Unknown encoder 'libx264'\" >&2; exit 1";
    const Folder folder;
    const auto film = [&] { make_video(folder / "film.mp4"); };
    SECTION("after the last frame") {
        const FakeFfmpeg ffmpeg("cat >/dev/null; " + unknown_encoder);
        CHECK(error_of(film) ==
              (folder / "film.mp4").string() + ": ffmpeg ended with status 1: Unknown encoder 'libx264'");
    }
    SECTION("only the last lines of it, in one line") {
        const FakeFfmpeg ffmpeg("cat >/dev/null; for i in 1 2 3 4; do echo line $i >&2; echo >&2; done; exit 3");
        CHECK_THAT(error_of(film), Catch::Contains("ended with status 3: line 2; line 3; line 4"));
    }
    SECTION("when it was ended") {
        const FakeFfmpeg ffmpeg("kill -KILL $$");
        CHECK_THAT(error_of(film), Catch::Contains("ffmpeg was ended by signal 9"));
    }
    // Nobody reads the frames then, which must not kill the program.
    SECTION("before the first frame") {
        const FakeFfmpeg ffmpeg(unknown_encoder);
        CHECK_THAT(error_of([&] {
                       Video video(folder / "film.mp4", 640, 360, {30, 1});
                       for (int i = 0; i < 100; ++i) video.add(picture(i, 640, 360));
                   }),
                   Catch::Contains("ended with status 1: Unknown encoder 'libx264'"));
    }
    CHECK(folder.files().empty());
}

TEST_CASE("ffmpeg may say more than a pipe holds") {
    const FakeFfmpeg ffmpeg("yes | head -c 1000000 >&2; cat >\"$video\"");
    const Folder folder;
    make_video(folder / "film.mp4");
    CHECK(folder.read("film.mp4") == bytes(picture(0)));
}

TEST_CASE("without ffmpeg the error says what to install, and nothing is left") {
    const Folder folder, empty;
    {
        const Path path(empty.path().string());
        CHECK(!find_program("ffmpeg"));
        CHECK_THAT(error_of([&] { make_video(folder / "film.mp4"); }),
                   Catch::Contains("film.mp4: ffmpeg is not installed; on Debian: apt install ffmpeg"));
    }
    CHECK(folder.files().empty());
    const FakeFfmpeg ffmpeg;
    CHECK(find_program("ffmpeg"));
}

TEST_CASE("an ffmpeg that cannot be started is no video either") {
    const Folder folder;
    folder.write("ffmpeg", "#!/nowhere/sh\n");
    fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
    const Path path(folder.path().string());
    CHECK_THAT(error_of([&] { make_video(folder / "film.mp4"); }), Catch::Contains("does not start"));
    CHECK(folder.files() == Names{"ffmpeg"});
}

TEST_CASE("an older video of the name survives a failure and a video that is dropped") {
    const Folder folder;
    folder.write("film.mp4", "precious");
    SECTION("a failure") {
        const FakeFfmpeg ffmpeg("cat >\"$video\"; exit 1");
        CHECK_THAT(error_of([&] { make_video(folder / "film.mp4"); }), Catch::Contains("ended with status 1"));
    }
    SECTION("a video that is dropped, with the process that made it") {
        const FakeFfmpeg ffmpeg;
        pid_t process = 0;
        {
            Video video(folder / "film.mp4", width, height, {30, 1});
            video.add(picture(0));
            process = ffmpeg.process();
            CHECK(kill(process, 0) == 0);
        }
        CHECK(kill(process, 0) != 0);
    }
    CHECK(folder.files() == Names{"film.mp4"});
    CHECK(folder.read("film.mp4") == "precious");
}

TEST_CASE("Ctrl-C, which goes to the program's process group, does not reach ffmpeg") {
    const FakeFfmpeg ffmpeg;
    const Folder folder;
    Video video(folder / "film.mp4", width, height, {30, 1});
    CHECK(getpgid(ffmpeg.process()) != getpgrp());
    video.finish();
}

TEST_CASE("two videos at once do not keep each other from ending") {
    const FakeFfmpeg ffmpeg;
    const Folder folder;
    Video first(folder / "first.mp4", width, height, {30, 1});
    Video second(folder / "second.gif", width, height, {30, 1});
    first.add(picture(1));
    second.add(picture(2));
    first.finish();  // would hang if the second ffmpeg held the first one's input open
    second.finish();
    CHECK(folder.read("first.mp4") == bytes(picture(1)));
    CHECK(folder.read("second.gif") == bytes(picture(2)));
}

TEST_CASE("a video may have an odd name") {
    const FakeFfmpeg ffmpeg;
    const Folder folder;
    make_video(folder / "two words; $(date) 'n'.mp4");
    CHECK(folder.files() == Names{"two words; $(date) 'n'.mp4"});

    // A name without a folder must not be an option or a protocol.
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    for (const char* name : {"-y.mp4", "http:x.webm", ".gif"}) {
        make_video(name);
        CHECK_THAT(ffmpeg.arguments(), Catch::Contains(" ./"));
        CHECK(folder.read(name) == bytes(picture(0)));
    }
    fs::current_path(before);
    CHECK(folder.files().size() == 4);
}

TEST_CASE("a video that cannot be written is refused before the first frame") {
    const FakeFfmpeg ffmpeg;
    const Folder folder;
    CHECK_THAT(error_of([&] {
                   Video(folder / "none/film.mp4", width, height, {30, 1});
               }),
               Catch::Contains("none/film.mp4: No such file or directory"));
    fs::create_directory(folder / "film.mp4");
    CHECK_THAT(error_of([&] {
                   Video(folder / "film.mp4", width, height, {30, 1});
               }),
               Catch::Contains("film.mp4: is there already and is no regular file"));
    CHECK(folder.files().empty());
}

TEST_CASE("only names of videos that can be made are taken") {
    for (const char* name : {"x.mp4", "folder.avi/x.webm", "x.y.gif"}) CHECK_NOTHROW(check_video_name(name));
    CHECK_THROWS_WITH(check_video_name("x.avi"), "--video x.avi: must end in .mp4, .webm or .gif");
    for (const char* name : {"", "x", "mp4", "x.mp4/", "x.mp4.png", "x.mp4 ", "folder.mp4/x"}) {
        INFO(name);
        CHECK_THROWS_AS(check_video_name(name), UsageError);
        CHECK_THROWS_AS(Video(name, width, height, {30, 1}), UsageError);
    }
}
