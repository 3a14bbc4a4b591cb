// Child processes: ffmpeg for videos, gnuplot for plots, looked for only when needed.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pushfactor::demos {

// A tool that is missing, does not start or fails. The message is one line and ends with the last lines of the
// tool's standard error.
struct ChildProcessError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Path of a program in PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);
// The same; throws ChildProcessError that names the package to install.
std::filesystem::path require_program(const std::string& name, const std::string& package);

// First line of what a program prints with this argument, such as "--version". Throws ChildProcessError.
std::string first_line_of(const std::filesystem::path& program, const std::string& argument);

// End of a tool: its exit status, 128 + n for signal n, and the last lines of its standard error.
struct Ending {
    int status = 0;
    std::string words;
};

// A running tool. Ctrl-C in a terminal does not reach it: the program decides whether its work is finished or
// dropped. Several may run at once, each used by one thread at a time. Members throw ChildProcessError; after that
// only the destructor may be called.
class ChildProcess {
  public:
    // `package` is the Debian package to install if it is missing; `folder` is the tool's working folder, by
    // default that of this process.
    ChildProcess(const std::string& name, const std::string& package, std::vector<std::string> arguments,
                 const std::filesystem::path& folder = {});
    ~ChildProcess();  // without finish() the tool is stopped
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // Writes to its standard input. Blocks while the tool is behind.
    void feed(std::span<const std::uint8_t> bytes);

    // Closes its input and waits for its end; throws unless the exit status is 0.
    void finish();

    // For callers to whom a failure is a valid result: whether it has ended, and how; the latter waits for its end.
    bool has_ended() const;
    Ending ending();

  private:
    void start(const std::filesystem::path& program, std::vector<std::string> words,
               const std::filesystem::path& folder);
    int wait_for_end();
    [[noreturn]] void fail(int status) const;

    std::string name_;
    int input_ = -1;  // our end of its standard input, -1 when closed
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, CloseFile> said_;  // its standard error, a file without a name
    pid_t process_ = 0;                           // 0 when none runs
};

}  // namespace pushfactor::demos
