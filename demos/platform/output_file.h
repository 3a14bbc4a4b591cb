// A file that is either written whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// Writes go to a temporary file beside `path`; commit() gives it its name. Without commit() nothing is left and
// what was there before stays. "-" is standard output, and a path that exists and is no regular file (a device,
// a pipe) is written to directly. Every member throws OutputError that names the path and the reason.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path path);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    void write(std::string_view text);
    void commit();

    // What messages call it.
    std::string name() const { return path_ == "-" ? "standard output" : path_.string(); }

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;  // empty when written to directly
    std::FILE* file_ = nullptr;
};

// The whole of `bytes` as the file `path`.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// The same as a file of its own: `folder`/`stem``extension`, or with -2, -3, ... after the stem where another file
// has that name. One that holds just these bytes is taken as it is. Returns its path.
std::filesystem::path write_new_file(const std::filesystem::path& folder, const std::string& stem,
                                     const std::string& extension, std::string_view bytes);

// Makes the folder and those above it, and finds out whether files can be made in it.
void make_folder(const std::filesystem::path& folder);

}  // namespace pushfactor::demos
