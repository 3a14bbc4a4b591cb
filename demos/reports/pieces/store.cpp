#include "demos/reports/pieces/store.h"

#include "demos/platform/output_file.h"
#include "demos/platform/plain_name.h"
#include "demos/platform/version.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::reports {

namespace {

namespace fs = std::filesystem;

constexpr const char* note_name = "report.json";

// Content, because another build of modified sources has the same version.
std::string own_file_hash() {
    const auto text = read_bytes_of("/proc/self/exe");
    return fmt::format("{:016x}", text ? text_hash(*text) : 0);
}

std::string make_version() {
    std::string version = version_text();
    const bool exact = version.find("-dirty") == std::string::npos && version.find("unknown") == std::string::npos;
    return exact ? version : version + ", program " + own_file_hash();
}

fs::path folder_of_version(const fs::path& folder) {
    return folder / "pieces" / PieceStore::version_folder();
}

// With its folder.
void write_into(const fs::path& path, const std::string& text) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) throw OutputError(path.parent_path().string() + ": " + error.message());
    write_file(path, text);
}

}  // namespace

const std::string& version_of_pieces() {
    static const std::string version = make_version();
    return version;
}

PieceStore::PieceStore(std::vector<fs::path> folders, std::string machine)
    : folders_(std::move(folders)), machine_(std::move(machine)) {}

fs::path PieceStore::place_of(const fs::path& folder, const std::string& key) const {
    const std::string name = fmt::format("{:016x}", hash_of_key(key));
    return folder_of_version(folder) / name.substr(0, 2) / (name.substr(2) + ".json");
}

std::optional<StoredPiece> PieceStore::find(const std::string& key) const {
    for (const fs::path& folder : folders_) {
        const auto text = read_bytes_of(place_of(folder, key));
        if (!text) continue;
        Json json = Json::parse(*text, nullptr, false);
        const bool whole = json.is_object() && json.value("key", "") == key && json.contains("result") &&
                           json.value("made_with", "") == version_of_pieces();
        if (whole) return StoredPiece{json.value("machine", ""), std::move(json["result"])};
    }
    return std::nullopt;
}

void PieceStore::put(const std::string& key, const Json& result) const {
    const Json json{{"key", key}, {"made_with", version_of_pieces()}, {"machine", machine_}, {"result", result}};
    write_into(place_of(folders_.front(), key), json_text(json, -1) + "\n");
}

void PieceStore::put_note(const std::string& text) const {
    const fs::path path = folder_of_version(folders_.front()) / note_name;
    if (read_bytes_of(path) != text) write_into(path, text);
}

std::optional<std::string> PieceStore::note_of(const fs::path& folder) {
    return read_bytes_of(folder_of_version(folder) / note_name);
}

std::string PieceStore::version_folder() {
    return plain_name(version_of_pieces(), '-', ".");  // "0.1.0-commit-0123456789ab"
}

std::set<std::string> PieceStore::versions_in(const fs::path& folder) {
    std::set<std::string> versions;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder / "pieces", error)) {
        if (entry.is_directory()) versions.insert(entry.path().filename());
    }
    return versions;
}

}  // namespace pushfactor::demos::reports
