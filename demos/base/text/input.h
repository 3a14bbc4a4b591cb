// Files that are read whole: regular files, pipes, and "-", which is standard input.
#pragma once

#include <filesystem>
#include <string>

namespace pushfactor::demos {

// The bytes of the file, without a byte order mark. What can be read only once, such as a pipe, is kept for the
// next call. Throws UsageError that begins with `label` for a file that cannot be read, is larger than 100 MB, or
// is a Git LFS pointer.
std::string read_input(const std::filesystem::path& file, const std::string& label);

}  // namespace pushfactor::demos
