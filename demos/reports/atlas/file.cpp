#include "demos/reports/atlas/file.h"

#include "demos/platform/output_file.h"
#include "demos/platform/version.h"
#include "demos/reports/atlas/outcomes.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace pushfactor::demos::reports::atlas {

namespace {

namespace fs = std::filesystem;

std::string header() {
    return "# pushfactor " + version_number() +
           ": stability atlas\nmap,x_name,x,y_name,y,outcome,measure,value,command\n";
}

// Start of a cell's line, unique per cell.
std::string key_of(const AtlasCell& cell) {
    const AtlasMap& map = *cell.map;
    return fmt::format("{},{},{},{},{}", map.name, map.x.option, cell.x, map.y.option, cell.y);
}

std::string line_of(const AtlasCell& cell, const CellResult& result) {
    return fmt::format("{},{},{},{},{}", key_of(cell), result.outcome, cell.map->measure.key, to_text(result.value),
                       command_of(cell));
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    return fields;
}

}  // namespace

AtlasFile::AtlasFile(fs::path path, const std::vector<AtlasMap>& atlas) : path_(std::move(path)) {
    for (const AtlasMap& map : atlas) {
        for (const AtlasCell& cell : cells_of(map)) cells_.push_back(cell);
    }
    std::error_code ignored;
    if (!fs::exists(path_, ignored)) write_file(path_, header());
    if (!fs::is_regular_file(path_, ignored)) refuse("is not a file");
    std::ifstream stream(path_, std::ios::binary);
    if (!stream) fail(errno);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const std::string whole = text.substr(0, text.rfind('\n') + 1);
    take_over(whole);

    file_.reset(std::fopen(path_.c_str(), "ab"));
    if (!file_) fail(errno);
    std::error_code error;
    if (whole.size() < text.size()) fs::resize_file(path_, whole.size(), error);
    if (error) fail(error.value());
}

void AtlasFile::refuse(const std::string& what) const {
    throw UsageError(
        fmt::format("{}: {}: must be an atlas of this version to be resumed; remove it or name another --out",
                    path_.string(), what));
}

void AtlasFile::fail(int error) const {
    throw OutputError(path_.string() + ": " + std::strerror(error));
}

void AtlasFile::take_over(const std::string& text) {
    if (!text.starts_with(header())) refuse("unknown header");
    std::istringstream stream(text.substr(header().size()));
    long number = 2;
    for (std::string line; std::getline(stream, line);) take_line(line, ++number);
}

void AtlasFile::take_line(const std::string& line, long number) {
    const std::vector<std::string> fields = fields_of(line);
    const auto value = fields.size() == 9 ? parse_number(fields[7]) : std::nullopt;
    for (const AtlasCell& cell : cells_) {
        if (!value || !line.starts_with(key_of(cell) + ",")) continue;
        // Exactly as this version writes it, and no duplicate.
        const CellResult result{fields[5], *value};
        const bool known = find_look(result.outcome) && line_of(cell, result) == line;
        if (known && results_.emplace(key_of(cell), result).second) return;
    }
    refuse(fmt::format("line {}: {}", number, line));
}

const CellResult* AtlasFile::find(const AtlasCell& cell) const {
    const auto found = results_.find(key_of(cell));
    return found == results_.end() ? nullptr : &found->second;
}

void AtlasFile::add(const AtlasCell& cell, const CellResult& result) {
    const std::string line = line_of(cell, result) + "\n";
    if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0) {
        fail(errno);
    }
    results_.emplace(key_of(cell), result);
}

void AtlasFile::sort() {
    file_.reset();
    std::string text = header();
    for (const AtlasCell& cell : cells_) {
        if (const CellResult* result = find(cell)) text += line_of(cell, *result) + "\n";
    }
    write_file(path_, text);
}

}  // namespace pushfactor::demos::reports::atlas
