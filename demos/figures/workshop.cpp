#include "demos/figures/workshop.h"

#include "demos/errors.h"
#include "demos/figures/figure.h"
#include "demos/output_file.h"
#include "demos/palette.h"
#include "demos/tool.h"
#include "renderer/png.h"

#include <fmt/format.h>

namespace pushfactor::demos::figures {

namespace {

namespace fs = std::filesystem;

// A string of gnuplot: in single quotes, where only the quote itself is special and doubled.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

std::string hexadecimal(const Colour& colour) {
    const auto byte = [](float part) { return static_cast<int>(part * 255.0f + 0.5f); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green), byte(colour.blue));
}

// The frames' colours under their names, so that plots have the same.
std::string colours() {
    std::string text;
    for (const Colour& colour : palette) {
        text += fmt::format("{} = {}; ", colour.name, quoted(hexadecimal(colour)));
    }
    return text;
}

void draw_plot(const std::vector<std::string>& arguments) {
    try {
        Tool("gnuplot", "gnuplot-nox", arguments).finish();
    } catch (const ToolError& error) {
        throw OutputError(error.what());
    }
}

}  // namespace

Choices run_of(const std::string& scene, const Options& options) {
    GivenOptions given;
    for (const auto& [name, text] : options) given.add(name, text, "--" + name);
    if (find_scene(scene)) return understand(scene, given);
    return understand((fs::path(PUSHFACTOR_ASSET_DIR) / "scenes" / (scene + ".json")).string(), given);
}

std::string command_text(const std::string& command, const std::string& scene, const Options& options) {
    std::string text = "pushfactor " + command + " " + scene;
    for (const auto& [name, value] : options) text += " --" + name + " " + value;
    return text;
}

Workshop::Workshop(fs::path folder, int width, int samples)
    : folder_(std::move(folder)), width_(width), samples_(samples) {}

std::string Workshop::save(const renderer::Image& image, const std::string& name) const {
    const std::vector<std::uint8_t> bytes = renderer::encode_png(image);
    write_file(folder_ / (name + ".png"), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return name + ".png";
}

void Workshop::plot(const Table& table, const std::string& name, double aspect, Plate& plate) const {
    const fs::path csv = folder_ / (name + ".csv");
    write_file(csv, csv_text(table));
    plate.files.push_back(name + ".csv");
    if (!find_tool("gnuplot")) {
        plate.caption +=
            " The plot needs gnuplot, which is not installed (Debian: apt install gnuplot-nox); its data "
            "are here.";
        return;
    }
    const fs::path scripts = fs::path(PUSHFACTOR_ASSET_DIR) / "plots";
    const int height = static_cast<int>(width_ / aspect);
    for (const std::string format : {"png", "svg"}) {
        const fs::path made = folder_ / (name + "." + format);
        const std::string settings =
            fmt::format("{}data = {}; made = {}; format = {}; width = {}; height = {}; style = {}", colours(),
                        quoted(csv.string()), quoted(made.string()), quoted(format), width_, height,
                        quoted((scripts / "style.gp").string()));
        draw_plot({"-e", settings, (scripts / (name + ".gp")).string()});
        (format == "png" ? plate.pictures : plate.files).push_back(name + "." + format);
    }
}

}  // namespace pushfactor::demos::figures
