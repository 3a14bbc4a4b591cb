#include "demos/platform/output_file.h"

#include "demos/text/errors.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace pushfactor::demos {

namespace fs = std::filesystem;

namespace {

bool holds(const fs::path& path, std::string_view bytes) {
    std::error_code error;
    if (!fs::is_regular_file(path, error) || fs::file_size(path, error) != bytes.size() || error) return false;
    std::ifstream stream(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {}) == bytes;
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    if (path_ == "-") {
        file_ = stdout;
        return;
    }
    std::error_code ignored;
    const fs::file_status status = fs::status(path_, ignored);
    if (fs::is_directory(status)) fail(EISDIR);
    fs::path target = path_;
    if (!fs::exists(status) || fs::is_regular_file(status)) {
        temporary_ = path_;
        temporary_ += ".partial";
        target = temporary_;
    }
    file_ = std::fopen(target.c_str(), "wb");
    if (!file_) {
        const int error = errno;
        temporary_.clear();
        fail(error);
    }
}

OutputFile::~OutputFile() {
    if (file_ && file_ != stdout) std::fclose(file_);
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void OutputFile::fail(int error) const {
    throw OutputError(name() + ": " + std::strerror(error));
}

void OutputFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(errno);
}

void OutputFile::commit() {
    if (std::fflush(file_) != 0) fail(errno);
    if (file_ == stdout) return;
    std::FILE* const file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) fail(errno);
    if (temporary_.empty()) return;
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) fail(error.value());
    temporary_.clear();
}

void write_file(const fs::path& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

fs::path write_new_file(const fs::path& folder, const std::string& stem, const std::string& extension,
                        std::string_view bytes) {
    constexpr int most = 1000;
    for (int n = 1; n <= most; ++n) {
        fs::path path = folder / (stem + (n > 1 ? "-" + std::to_string(n) : "") + extension);
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(path, ignored))) {
            write_file(path, bytes);
            return path;
        }
        if (holds(path, bytes)) return path;
    }
    throw OutputError((folder / (stem + extension)).string() + ": there are already " + std::to_string(most) +
                      " files of this name");
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw OutputError(folder.string() + ": " + error.message());
    if (!fs::is_directory(folder)) throw OutputError(folder.string() + ": " + std::strerror(ENOTDIR));
    // Permissions do not tell of a read-only or full disk; creating a file does.
    OutputFile probe(folder / ".writable");
    probe.write("?");
}

}  // namespace pushfactor::demos
