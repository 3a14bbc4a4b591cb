// Other programs, which are looked for only when they are wanted: ffmpeg for videos, gnuplot for plots.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pushfactor::demos {

// A tool that is not there, does not start or fails. The message is one line and ends with the tool's own last
// words.
class ChildProcessError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Where PATH has it.
std::optional<std::filesystem::path> find_program(const std::string& name);
// The same; throws ChildProcessError that names the package to install.
std::filesystem::path require_program(const std::string& name, const std::string& package);

// How a tool ended: its exit status, 128 and more for a signal, and its last words.
struct Ending {
    int status = 0;
    std::string words;
};

// A tool at work. Ctrl-C in a terminal does not reach it: whether its work is finished or dropped is for the
// program to decide. Any number may be at work at once, each used by one thread at a time. Members throw
// ChildProcessError; after that only the destructor may be called.
class ChildProcess {
  public:
    // `package` is what to install where it is missing.
    ChildProcess(const std::string& name, const std::string& package, std::vector<std::string> arguments);
    ~ChildProcess();  // without finish() the tool is stopped
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // To its standard input. Waits while the tool is behind.
    void feed(std::span<const std::uint8_t> bytes);

    // Tells the tool that there is no more, and waits until it has ended well.
    void finish();

    // For whom other endings than a good one are answers: whether it has ended, and how; the latter waits for it.
    bool has_ended() const;
    Ending ending();

  private:
    void start(const std::filesystem::path& program, std::vector<std::string> words);
    int wait_for_end();
    [[noreturn]] void fail(int status) const;

    std::string name_;
    int input_ = -1;             // our end of its standard input, -1 when closed
    std::FILE* said_ = nullptr;  // its standard error, a file without a name
    pid_t process_ = 0;          // 0 when none runs
};

}  // namespace pushfactor::demos
