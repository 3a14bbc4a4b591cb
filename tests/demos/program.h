// Runs the program as a user would, in a folder of its own.
#pragma once

#include "tests/texts.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pushfactor::tests {

// A temporary folder, removed with the object.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "pushfactor-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::string read(const std::string& name) const { return read_file(path_ / name); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

    // Names of all files below, "a/b.png", without the page that runs the program in a browser: it is put beside
    // others only where it has been made (demos/pictures/live/links.h).
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
            if (entry.is_regular_file() && entry.path().filename() != "live.html")
                names.push_back(std::filesystem::relative(entry.path(), path_).string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

  private:
    std::filesystem::path path_;
};

struct Ended {
    int status = -1;  // exit status
    std::string out, err;
};

// The program for a command that ends in "&": a shell starts those with SIGINT ignored, which the program respects.
#define PUSHFACTOR_IN_BACKGROUND "env --default-signal=INT '" PUSHFACTOR_PROGRAM "'"

// Runs a shell command with `pushfactor` as the program, in `folder`.
inline Ended shell(const Folder& folder, const std::string& command) {
    const Folder streams;
    const std::string line = "cd '" + folder.path().string() +
                             "' && pushfactor() { '" PUSHFACTOR_PROGRAM "' \"$@\"; }; { " + command + "; } >'" +
                             (streams / "out").string() + "' 2>'" + (streams / "err").string() + "'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, streams.read("out"), streams.read("err")};
}

inline Ended run_program(const std::string& arguments) {
    return shell(Folder(), "pushfactor " + arguments);
}

inline void require_success(const Folder& folder, const std::string& command) {
    const Ended ended = shell(folder, command);
    INFO(command << ": " << ended.err);
    REQUIRE(ended.status == 0);
}

// Checks that the program refuses this command, in one line with these words.
inline void check_refused(const Folder& folder, const std::string& command, const std::string& words) {
    const Ended ended = shell(folder, command);
    INFO(ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.err.find(words) != std::string::npos);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
}

// The same for arguments, in an empty folder.
inline void check_refused(const std::string& arguments, const std::string& words) {
    check_refused(Folder(), "pushfactor " + arguments, words);
}

// Runs the program with these arguments, and sends it the signal as soon as the shell command `seen` succeeds, or
// after a minute.
inline Ended stopped_when(const Folder& folder, const std::string& seen, const std::string& arguments,
                          const std::string& signal = "INT") {
    return shell(folder, PUSHFACTOR_IN_BACKGROUND " " + arguments + " & for look in $(seq 3000); do if " + seen +
                             " 2>/dev/null >&2; then break; fi; sleep 0.02; done; kill -" + signal +
                             " $!; wait $!");
}

// Checks that a report that is interrupted after its first file ends with status 1 and leaves only complete files.
inline void check_interrupted(const std::string& report, const std::string& first_file) {
    const Folder folder;
    const Ended ended = stopped_when(folder, "ls " + first_file, "report " + report + " --out .");
    CHECK(ended.status == 1);
    CHECK(ended.err.find("interrupted: ") != std::string::npos);
    for (const std::string& file : folder.files()) CHECK(file.find(".partial") == std::string::npos);
}

}  // namespace pushfactor::tests
