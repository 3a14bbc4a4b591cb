#include "demos/base/platform/child_process.h"

#include "demos/base/text/numbers.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

namespace pushfactor::demos {

namespace {

namespace fs = std::filesystem;

void close_if_open(int& descriptor) {
    if (descriptor >= 0) close(descriptor);
    descriptor = -1;
}

// Status of waitpid() for a child that has ended; -1 if the system has no record of it.
int wait_for(pid_t child) {
    int status = -1;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return -1;
    }
    return status;
}

std::string describe(int status) {
    if (WIFEXITED(status)) return fmt::format("ended with status {}", WEXITSTATUS(status));
    if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
    return "ended in an unknown way";
}

// The last three lines of a file that are not empty, joined.
std::string last_lines(std::FILE* file) {
    std::fseek(file, 0, SEEK_END);
    std::fseek(file, std::max(std::ftell(file) - 4096, 0L), SEEK_SET);
    std::string text(4096, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file));

    std::replace(text.begin(), text.end(), '\r', '\n');
    std::vector<std::string_view> lines = parts_of(text, '\n');
    std::erase(lines, "");
    if (lines.size() > 3) lines.erase(lines.begin(), lines.end() - 3);
    return fmt::format("{}", fmt::join(lines, "; "));
}

}  // namespace

// Searches as a shell does: an empty entry of PATH is the working folder.
std::optional<fs::path> find_program(const std::string& name) {
    const char* const path = std::getenv("PATH");
    for (const std::string_view folder : parts_of(path ? path : "/usr/bin:/bin", ':')) {
        const fs::path candidate = fs::path(folder) / name;
        std::error_code ignored;
        if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    return std::nullopt;
}

fs::path require_program(const std::string& name, const std::string& package) {
    if (const auto program = find_program(name)) return *program;
    throw ChildProcessError(fmt::format("{} is not installed; on Debian: apt install {}", name, package));
}

// A shell, because a ChildProcess keeps only standard error, and of that only the end.
std::string first_line_of(const fs::path& program, const std::string& argument) {
    ChildProcess shell("sh", "dash", {"-c", "\"$0\" \"$1\" 2>&1 | head -n 1 >&2", program.string(), argument});
    return shell.ending().words;
}

ChildProcess::ChildProcess(const std::string& name, const std::string& package, std::vector<std::string> arguments,
                           const fs::path& folder)
    : name_(name) {
    const fs::path program = require_program(name, package);

    // Standard error goes to a file: an unread pipe would fill up and block both processes.
    // In TMPDIR, which std::tmpfile() does not know.
    std::error_code no_folder;
    const fs::path place = fs::temp_directory_path(no_folder) / "pushfactor-XXXXXX";
    std::string file = place.string();
    const int descriptor = no_folder ? -1 : mkostemp(file.data(), O_CLOEXEC);
    if (descriptor >= 0) unlink(file.c_str());
    if (descriptor >= 0) said_.reset(fdopen(descriptor, "w+b"));
    if (!said_) {
        const std::string why = no_folder ? no_folder.message() : std::strerror(errno);
        const char* const given = std::getenv("TMPDIR");
        throw ChildProcessError(
            fmt::format("no temporary file in {} (TMPDIR): {}", given ? given : place.parent_path().string(), why));
    }
    arguments.insert(arguments.begin(), name);
    start(program, std::move(arguments), folder);
}

ChildProcess::~ChildProcess() {
    close_if_open(input_);
    if (process_ != 0) {
        // The whole process group: some systems wrap a tool in a script.
        kill(-process_, SIGKILL);
        wait_for(process_);
    }
}

void ChildProcess::start(const fs::path& program, std::vector<std::string> words, const fs::path& folder) {
    // A socket, not a pipe, because send() can suppress SIGPIPE. Close-on-exec, or a tool started later would hold
    // it open and this one would never see end of file.
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw ChildProcessError(std::strerror(errno));
    input_ = ends[0];

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, fileno(said_.get()), STDERR_FILENO);
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
    // A process group of its own, which the terminal's Ctrl-C does not reach.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);

    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t started = 0;
    const int error = posix_spawn(&started, program.c_str(), &files, &attributes, pointers.data(), environ);

    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    if (error != 0) {
        close_if_open(input_);
        throw ChildProcessError(fmt::format("{} does not start: {}", program.string(), std::strerror(error)));
    }
    process_ = started;
}

int ChildProcess::wait_for_end() {
    close_if_open(input_);
    return wait_for(std::exchange(process_, 0));
}

void ChildProcess::fail(int status) const {
    const std::string words = last_lines(said_.get());
    throw ChildProcessError(fmt::format("{} {}{}{}", name_, describe(status), words.empty() ? "" : ": ", words));
}

void ChildProcess::feed(std::span<const std::uint8_t> bytes) {
    assert(input_ >= 0);
    while (!bytes.empty()) {
        const ssize_t sent = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(sent));
        } else if (errno == EPIPE || errno == ECONNRESET) {
            fail(wait_for_end());
        } else if (errno != EINTR) {
            throw ChildProcessError(std::strerror(errno));
        }
    }
}

void ChildProcess::finish() {
    assert(process_ != 0);
    const int status = wait_for_end();
    if (status != 0) fail(status);
}

bool ChildProcess::has_ended() const {
    assert(process_ != 0);
    siginfo_t info{};
    const int flags = WEXITED | WNOHANG | WNOWAIT;
    return waitid(P_PID, static_cast<id_t>(process_), &info, flags) != 0 || info.si_pid == process_;
}

Ending ChildProcess::ending() {
    assert(process_ != 0);
    const int status = wait_for_end();
    const int reported =
        WIFEXITED(status) ? WEXITSTATUS(status) : 128 + (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    return {reported, last_lines(said_.get())};
}

}  // namespace pushfactor::demos
