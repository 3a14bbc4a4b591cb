#include "demos/base/platform/output_file.h"

#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <utility>

namespace pushfactor::demos {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_buffered = 1 << 16;

constexpr int most_links = 40;

[[noreturn]] void fail(const fs::path& name, int error) {
    throw OutputError(name.string() + ": " + std::strerror(error));
}

// Replaces the path of a link by where it leads to. Returns false if it is none.
bool follow_link(fs::path& path) {
    std::error_code error;
    const fs::path next = fs::read_symlink(path, error);
    if (error) return false;
    path = next.is_absolute() ? next : path.parent_path() / next;
    return true;
}

}  // namespace

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

fs::path followed(fs::path path) {
    for (int i = 0; i < most_links && follow_link(path); ++i) {
    }
    return path;
}

StagedFile::StagedFile(const fs::path& target, const std::string& extension)
    : target_(target), place_(followed(target)) {
    struct stat old {};
    const bool exists = stat(place_.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) fail(target_, EISDIR);
    std::random_device random;
    while (descriptor_ < 0) {
        // Short: the target may have the longest name that there can be.
        path_ = place_.parent_path() / fmt::format(".{:08x}{}", random(), extension);
        descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) {
            path_.clear();
            fail(target_, errno);
        }
    }
    if (exists) fchmod(descriptor_, old.st_mode & 07777);
}

StagedFile::~StagedFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!path_.empty()) unlink(path_.c_str());
}

void StagedFile::sync() {
    // EINVAL: a file system that cannot.
    if (fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(target_, errno);
    if (close(std::exchange(descriptor_, -1)) != 0) fail(target_, errno);
}

void StagedFile::commit() {
    sync();
    if (rename(path_.c_str(), place_.c_str()) != 0) fail(target_, errno);
    path_.clear();
}

bool StagedFile::commit_new() {
    sync();
    if (link(path_.c_str(), place_.c_str()) == 0) return true;
    if (errno == EEXIST) return false;
    // A file system without hard links.
    if (fs::exists(place_)) return false;
    if (rename(path_.c_str(), place_.c_str()) != 0) fail(target_, errno);
    path_.clear();
    return true;
}

bool is_file_of(const fs::path& folder, const fs::path& file) {
    std::error_code error;
    const fs::path parent = followed(file).parent_path();
    return !is_stream(file) &&
           fs::weakly_canonical(parent.empty() ? "." : parent, error) == fs::weakly_canonical(folder, error);
}

bool is_below(const fs::path& folder, const fs::path& path) {
    std::error_code error;
    const fs::path way = fs::weakly_canonical(fs::absolute(followed(path)), error)
                             .lexically_relative(fs::weakly_canonical(fs::absolute(folder), error));
    return !way.empty() && *way.begin() != "..";
}

std::optional<int> named_descriptor(fs::path path) {
    if (path == "-") return STDOUT_FILENO;
    std::error_code error;
    for (int i = 0; i < most_links; ++i) {
        if (fs::equivalent(path.parent_path(), "/proc/self/fd", error) && !error)
            return parse_integer(path.filename().string());
        if (!follow_link(path)) break;
    }
    return std::nullopt;
}

bool is_stream(const fs::path& path) {
    if (named_descriptor(path)) return true;
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
    if (const auto named = named_descriptor(path_)) {
        descriptor_ = *named;
    } else if (is_stream(path_)) {
        descriptor_ = own_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(path_, errno);
    } else {
        descriptor_ = staged_.emplace(path_).descriptor();
    }
}

OutputFile::~OutputFile() {
    if (own_ >= 0) close(own_);
}

void OutputFile::write(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= most_buffered) flush();
}

void OutputFile::flush() {
    if (!write_all(descriptor_, buffer_)) fail(name(), errno);
    buffer_.clear();
}

void OutputFile::commit() {
    flush();
    if (staged_) {
        staged_->commit();
    } else if (own_ >= 0 && close(std::exchange(own_, -1)) != 0) {
        fail(path_, errno);
    }
}

void write_file(const fs::path& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
    write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void print(std::string_view text) {
    write_file("-", text);
}

std::optional<std::string> read_bytes_of(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

bool write_first(const fs::path& path, std::string_view bytes) {
    StagedFile file(path);
    if (!write_all(file.descriptor(), bytes)) fail(path, errno);
    return file.commit_new() || read_bytes_of(path) == bytes;
}

fs::path write_new_file(const fs::path& folder, const std::string& stem, const std::string& extension,
                        std::string_view bytes) {
    constexpr int most = 1000;
    for (int n = 1; n <= most; ++n) {
        fs::path path = folder / (stem + (n > 1 ? "-" + std::to_string(n) : "") + extension);
        if (write_first(path, bytes)) return path;
    }
    throw OutputError((folder / (stem + extension)).string() + ": there are already " + std::to_string(most) +
                      " files of this name");
}

void make_folder_of(const fs::path& file) {
    if (is_stream(file)) return;
    const fs::path folder = followed(file).parent_path();
    make_folder(folder.empty() ? "." : folder);
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail(folder, error.value());
    if (!fs::is_directory(folder)) fail(folder, ENOTDIR);
    // Permissions do not tell of a read-only or full disk; creating a file does.
    std::string probe = (folder / ".XXXXXX").string();
    const int descriptor = mkostemp(probe.data(), O_CLOEXEC);
    if (descriptor < 0) fail(folder, errno);
    close(descriptor);
    unlink(probe.c_str());
}

}  // namespace pushfactor::demos
