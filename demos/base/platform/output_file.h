// A file that is written whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// A new file next to `target`, under a name that no other process uses, until commit() puts it in its place. Links
// are followed, and the mode of an existing file is kept. Members throw OutputError that names the target and the
// reason.
class StagedFile {
  public:
    explicit StagedFile(const std::filesystem::path& target, const std::string& extension = ".partial");
    StagedFile(const StagedFile&) = delete;
    StagedFile& operator=(const StagedFile&) = delete;
    ~StagedFile();  // removes it unless it was committed

    const std::filesystem::path& path() const { return path_; }
    int descriptor() const { return descriptor_; }  // open for writing

    // Syncs the file and renames it; an existing target is replaced.
    void commit();

    // The same unless there is a target; false then.
    bool commit_new();

  private:
    void sync();

    std::filesystem::path target_, place_, path_;  // as given; through links; of the temporary file
    int descriptor_ = -1;
};

// Writes go to a staged file. Without commit() an existing file stays. "-" and the names of open files
// (/dev/stdout, /dev/fd/3) are written to where they stand, and other paths that exist and are no regular files
// (devices, pipes) directly. Every member throws OutputError that names the path and the reason.
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
    void flush();

    std::filesystem::path path_;
    std::optional<StagedFile> staged_;  // none when written to directly
    int descriptor_ = -1, own_ = -1;    // written to; the same if it is to be closed here
    std::string buffer_;
};

// Where a name leads to through links; the file may not exist yet.
std::filesystem::path followed(std::filesystem::path path);

// The open file of this process that "-", /dev/stdout, /dev/fd/3 and links to them name. A file that it goes to is
// neither replaced nor opened again, which would lose what others write to it.
std::optional<int> named_descriptor(std::filesystem::path path);

// An open file, or what exists and is neither file nor folder: a device, a pipe. It is written to directly.
bool is_stream(const std::filesystem::path& path);

// Whether the folder has a file of this name, or would have it.
bool is_file_of(const std::filesystem::path& folder, const std::filesystem::path& file);

// Whether a path is that of the folder or leads into it; neither need exist.
bool is_below(const std::filesystem::path& folder, const std::filesystem::path& path);

// Writes to an open file. False, with errno, for an error.
bool write_all(int descriptor, std::string_view bytes);

// Writes to standard output, at once.
void print(std::string_view text);

// Writes the file `path` with the content `bytes`.
void write_file(const std::filesystem::path& path, std::string_view bytes);
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

// The same without overwriting: `folder`/`stem``extension`, or with -2, -3, ... after the stem if the name is
// taken. An existing file with exactly these bytes is kept. Returns the path.
std::filesystem::path write_new_file(const std::filesystem::path& folder, const std::string& stem,
                                     const std::string& extension, std::string_view bytes);

// Writes the file `path` if there is none. False if there is one with other bytes.
bool write_first(const std::filesystem::path& path, std::string_view bytes);

// The bytes of a regular file; none if there is no such file or it cannot be read.
std::optional<std::string> read_bytes_of(const std::filesystem::path& path);

// Makes the folder of a file. Throws OutputError if files cannot be created in it.
void make_folder_of(const std::filesystem::path& file);

// Creates the folder and its parents. Throws OutputError if files cannot be created in it.
void make_folder(const std::filesystem::path& folder);

}  // namespace pushfactor::demos
