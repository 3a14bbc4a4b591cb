// Rest in the outputs of the program: summary, CSV, overlay.
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <algorithm>

using namespace pushfactor;
using tests::Ended;
using tests::Folder;
using tests::shell;

namespace {

// 51 movable bodies; at 2 s one of them, a ball in flight, hits a pyramid of 21, and a stack of 5 is pulled.
const std::string woken = "pushfactor run '" PUSHFACTOR_SOURCE_DIR "/assets/scenes/woken.json' ";

std::string last_column(const std::string& csv, int line) {
    std::size_t begin = 0;
    for (int i = 0; i < line; ++i) begin = csv.find('\n', begin) + 1;
    const std::string text = csv.substr(begin, csv.find('\n', begin) - begin);
    return text.substr(text.rfind(',') + 1);
}

// Pixels with much more of one channel than of another.
int pixels_of(const renderer::Image& image, std::size_t more, std::size_t less) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto rgb = image.pixel(x, y);
            count += rgb[more] > rgb[less] + 60;
        }
    }
    return count;
}

renderer::Image read_image(const Folder& folder, const std::string& name) {
    const std::string bytes = folder.read(name);
    return renderer::decode_png(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

}  // namespace

TEST_CASE("the summary and the CSV say how many bodies rest, and since when all do") {
    const Folder folder;
    REQUIRE(shell(folder, woken + "--seconds 2.2 --csv steps.csv --summary one.json").status == 0);
    const std::string csv = folder.read("steps.csv");
    CHECK(last_column(csv, 25) == "0");
    CHECK(last_column(csv, 114) == "50");
    CHECK(last_column(csv, 132) == "24");
    CHECK_THAT(folder.read("one.json"),
               Catch::Contains("\"bodies\": 24") && Catch::Contains("\"all_since_s\": null"));
    shell(folder, "pushfactor run stack --gap 0 --seconds 2 --summary all.json");
    CHECK_THAT(folder.read("all.json"), Catch::Contains("\"all_since_s\": 0.") && Catch::Contains("\"bodies\": 5"));
    shell(folder, "pushfactor run stack --gap 0 --seconds 1 --rest off --summary off.json");
    CHECK_THAT(folder.read("off.json"), !Catch::Contains("at_rest"));
}

TEST_CASE("the overlay of rest is green where bodies rest and red where they move, and needs --rest on") {
    const Folder folder;
    const std::string scene = " '" PUSHFACTOR_SOURCE_DIR "/assets/scenes/woken.json' ";
    REQUIRE(shell(folder, "pushfactor render" + scene +
                              "--overlay rest --caption off --camera scene --size 320x130 --at 1.5,2.2 --out o")
                .status == 0);
    const renderer::Image before = read_image(folder, "o/at_1.5s.png"), after = read_image(folder, "o/at_2.2s.png");
    CHECK(pixels_of(before, 1, 0) > 1500);
    CHECK(pixels_of(before, 0, 1) < 300);  // the ball in flight, if it is in the picture, and the legend
    CHECK(pixels_of(after, 1, 0) < 0.8 * pixels_of(before, 1, 0));
    CHECK(pixels_of(after, 0, 1) > 1000);
    const Ended refused = shell(folder, "pushfactor render stack --rest off --overlay rest --at 0 --out refused");
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Catch::Contains("--overlay rest"));
}
