// A file that is written whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// Writes go to a temporary file next to `path`, which commit() renames. Without commit() it is removed, and an
// existing file stays. "-" is standard output; an existing path that is not a regular file (a device, a pipe) is
// written to directly. Every member throws OutputError that names the path and the reason.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path path);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    void write(std::string_view text);
    void commit();

    // Name in messages.
    std::string name() const { return path_ == "-" ? "standard output" : path_.string(); }

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;  // empty when written to directly
    std::FILE* file_ = nullptr;
};

// Writes the file `path` with the content `bytes`.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The same without overwriting: `folder`/`stem``extension`, or with -2, -3, ... after the stem if the name is
// taken. An existing file with exactly these bytes is kept. Returns the path.
std::filesystem::path write_new_file(const std::filesystem::path& folder, const std::string& stem,
                                     const std::string& extension, std::string_view bytes);

// Creates the folder and its parents. Throws OutputError if files cannot be created in it.
void make_folder(const std::filesystem::path& folder);

}  // namespace pushfactor::demos
