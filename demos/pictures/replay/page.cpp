#include "demos/pictures/replay/page.h"

#include "demos/base/platform/assets.h"
#include "demos/base/text/errors.h"
#include "demos/pictures/replay/stage.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <sstream>

namespace pushfactor::demos::pictures::replay {

namespace {

namespace fs = std::filesystem;

// Without indentation, blank lines and comments, which are a third of a file and of no use in the page. A comment
// begins with "// " at the start of a line or after a space, which no string of these files contains.
std::string compact(const std::string& text) {
    std::string result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        const std::size_t comment = line.starts_with("// ") ? 0 : line.find(" // ");
        line.resize(std::min(comment, line.size()));
        const std::size_t start = line.find_first_not_of(' ');
        if (start == std::string::npos) continue;
        result += line.substr(start, line.find_last_not_of(' ') + 1 - start) + "\n";
    }
    return result;
}

std::string asset(const char* name) {
    return asset_text(asset_folder("replay") / name);
}

// In the order in which they need each other.
std::string script() {
    constexpr std::array files{"page.js", "space.js", "bytes.js",  "decode.js", "camera.js", "scene.js",
                               "draw.js", "marks.js", "arrows.js", "plots.js",  "viewer.js"};
    std::string text;
    for (const char* const file : files) text += compact(asset(file));
    return text;
}

// The renderer's shaders and those of the viewer, by name.
Json shaders() {
    std::vector<fs::path> files;
    for (const char* const folder : {"shaders", "replay"}) {
        for (const auto& entry : fs::directory_iterator(asset_folder(folder))) {
            const fs::path& path = entry.path();
            if (path.extension() == ".vert" || path.extension() == ".frag") files.push_back(path);
        }
    }
    std::ranges::sort(files);
    Json texts = Json::object();
    for (const fs::path& file : files) texts[file.filename().string()] = compact(asset_text(file));
    return texts;
}

// For a script element, which ends at the first "</".
std::string inline_json(const Json& json) {
    std::string text = json_text(json, -1, true);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
        text.replace(at, 1, "\\u003c");
    }
    return text;
}

std::size_t place_of(std::string_view mark, const std::string& text) {
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) throw OutputError("page.html of the replays has no {}", mark);
    return at;
}

void fill_in(std::string& text, std::string_view mark, const std::string& content) {
    text.replace(place_of(mark, text), mark.size(), content);
}

}  // namespace

std::string deflated(std::string_view bytes) {
    constexpr int level = 9;  // 12 is three times as slow for two parts in a hundred
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    std::string result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    result.resize(
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), result.data(), result.size()));
    return result;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t i) -> std::uint32_t {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
    };
    std::string text;
    text.reserve(4 * (bytes.size() / 3 + 1));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
        for (const unsigned shift : {18U, 12U, 6U, 0U}) text.push_back(digits[three >> shift & 63U]);
    }
    const std::size_t surplus = (3 - bytes.size() % 3) % 3;
    text.replace(text.size() - surplus, surplus, surplus, '=');
    return text;
}

Page page_about(const Json& about) {
    const std::string text = asset("page.html");
    constexpr std::string_view data = "@data@";
    const std::size_t at = place_of(data, text);
    Page page{.before = text.substr(0, at), .after = text.substr(at + data.size())};
    fill_in(page.before, "@style@",
            compact(asset_text(asset_folder("pages") / "page.css")) + compact(asset("replay.css")));
    fill_in(page.before, "@about@", inline_json(about));
    fill_in(page.after, "@meshes@", base64(deflated(common_meshes())));
    fill_in(page.after, "@shaders@", inline_json(shaders()));
    fill_in(page.after, "@script@", script());
    return page;
}

std::string data_block(std::string_view attributes, std::string_view bytes) {
    return fmt::format("<script type=\"application/octet-stream\" {}>{}</script>\n", attributes,
                       base64(deflated(bytes)));
}

std::string end_block(const Json& end) {
    return fmt::format("<script type=\"application/json\" id=\"end\">{}</script>\n", inline_json(end));
}

}  // namespace pushfactor::demos::pictures::replay
