#include "demos/base/platform/assets.h"
#include "demos/base/platform/child_process.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/processors.h"
#include "demos/base/platform/version.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/json.h"
#include "demos/commands/commands.h"
#include "demos/pictures/offscreen_renderer.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/png.h"

#include <fmt/format.h>

namespace pushfactor::demos::commands {

namespace {

using pictures::Graphics;
using renderer::ContextKind;

struct Finding {
    std::string name;
    bool good = true;
    std::string text;
};

// A program that only some outputs need.
Finding find_tool(const std::string& name, const std::string& argument, const std::string& use,
                  const std::string& package) {
    const auto program = find_program(name);
    if (!program) {
        return {name, false, fmt::format("not found: needed for {}; on Debian: apt install {}", use, package)};
    }
    try {
        const std::string line = first_line_of(*program, argument);
        return {name, true, fmt::format("{}: {}", program->string(), line.substr(0, line.find(" Copyright")))};
    } catch (const ChildProcessError& error) {
        return {name, false, fmt::format("{}: {}", program->string(), error.what())};
    }
}

Finding find_font() {
    const std::string file = pictures::Lettering::font_file();
    try {
        pictures::Lettering{};
        return {"font", true, file};
    } catch (const renderer::RendererError& error) {
        return {"font", false, fmt::format("{}; on Debian: apt install fonts-dejavu-core", error.what())};
    }
}

Finding find_assets() {
    const std::filesystem::path folder = asset_folder("shaders").parent_path();
    if (std::filesystem::is_directory(folder / "shaders")) return {"assets", true, folder.string()};
    return {"assets", false,
            fmt::format("{}: has no folder shaders; install the program with cmake --install", folder.string())};
}

Finding count_cores() {
    const int cores = usable_cores();
    const auto limit = processor_limit();
    return {"cores", true,
            fmt::format("{} usable{}", cores, limit ? fmt::format(", limited to the time of {:.3g}", *limit) : "")};
}

// Judges the two back ends by the pictures that they gave, and writes one.
Finding show_picture(const Graphics& osmesa, const Graphics& egl, const std::optional<std::string>& out) {
    const renderer::Image& picture = osmesa.picture.rgb.empty() ? egl.picture : osmesa.picture;
    if (picture.rgb.empty()) return {"picture", false, "cannot be drawn by OSMesa, nor by EGL"};
    Finding finding{
        "picture", true,
        fmt::format("OK: {}x{}, hash {:016x}", picture.width, picture.height, pictures::hash_of(picture))};
    if (osmesa.picture.rgb.empty() || egl.picture.rgb.empty()) {
        finding.text += fmt::format(", by {} alone", osmesa.picture.rgb.empty() ? "EGL" : "OSMesa");
    } else {
        finding.text += osmesa.picture == egl.picture ? ", the same bytes from OSMesa and EGL"
                                                      : ", other bytes from EGL than from OSMesa";
    }
    if (out) {
        write_file(*out, renderer::encode_png(picture));
        finding.text += "; written to " + *out;
    }
    return finding;
}

std::string text_of(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) text += fmt::format("{:<12}{}\n", finding.name, finding.text);
    return text;
}

std::string json_text_of(const std::vector<Finding>& findings) {
    Json json;
    for (const Finding& finding : findings) json[finding.name] = {{"ok", finding.good}, {"found", finding.text}};
    return json_text(json);
}

std::vector<Option> doctor_options() {
    return {{"out", "FILE", "write the test picture to this file (.png)", "Options", OptionKind::writes},
            {"json", "", "print JSON"}};
}

AnyCommand read_doctor(Words& words) {
    Doctor command{.out = words.take("out"), .json = words.take_flag("json")};
    if (command.out && !command.out->ends_with(".png")) {
        throw UsageError("--out {}: must end in .png", *command.out);
    }
    return command;
}

}  // namespace

void carry_out(const Doctor& command) {
    const Graphics osmesa = pictures::check_graphics(ContextKind::osmesa);
    const Graphics egl = pictures::check_graphics(ContextKind::egl);
    const Finding picture = show_picture(osmesa, egl, command.out);
    const std::vector<Finding> findings{
        {"pushfactor", true, version_text()},
        {"OSMesa", !osmesa.picture.rgb.empty(), osmesa.found},
        {"EGL", !egl.picture.rgb.empty(), egl.found},
        find_font(),
        find_assets(),
        find_tool("ffmpeg", "-version", "--video", "ffmpeg"),
        find_tool("gnuplot", "--version", "the plots of figures and reports", "gnuplot-nox"),
        count_cores(),
        picture,
    };
    write_file("-", command.json ? json_text_of(findings) : text_of(findings));
    if (!picture.good) throw CheckError("no picture can be drawn here: the list says what to install");
}

const Entry doctor_entry{
    "doctor", "",
    "what is installed: libraries, programs, font; and whether pictures can be rendered (status 3 if not)",
    doctor_options, read_doctor};

}  // namespace pushfactor::demos::commands
