#include "demos/base/text/input.h"

#include "demos/base/text/errors.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>

namespace pushfactor::demos {

namespace {

constexpr std::size_t most_bytes = 100'000'000;

struct Descriptor {
    int number = -1;

    explicit Descriptor(const std::filesystem::path& file)
        : number(file == "-" ? STDIN_FILENO : open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number > STDIN_FILENO) close(number);
    }
};

}  // namespace

std::string read_input(const std::filesystem::path& file, const std::string& label) {
    static std::mutex mutex;
    static std::map<std::filesystem::path, std::string> kept;
    const std::lock_guard lock(mutex);
    if (const auto found = kept.find(file); found != kept.end()) return found->second;

    const auto refuse_error = [&label] { throw UsageError("{}: cannot be read: {}", label, std::strerror(errno)); };
    const Descriptor descriptor(file);
    struct stat about {};
    if (descriptor.number < 0 || fstat(descriptor.number, &about) != 0) refuse_error();
    std::string text;
    std::array<char, 1 << 16> buffer{};
    for (ssize_t count = 1; count != 0;) {
        count = read(descriptor.number, buffer.data(), buffer.size());
        if (count < 0 && errno != EINTR) refuse_error();
        if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
        if (text.size() > most_bytes) throw UsageError("{}: must be at most {} bytes long", label, most_bytes);
    }
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    if (text.starts_with("version https://git-lfs")) {
        throw UsageError("{}: is a Git LFS pointer and not the file, which `git lfs pull` brings", label);
    }
    if (!S_ISREG(about.st_mode)) kept.emplace(file, text);
    return text;
}

}  // namespace pushfactor::demos
