#include "demos/base/platform/messages.h"

#include "demos/base/platform/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace pushfactor::demos {

void say(std::string_view text) {
    write_all(STDERR_FILENO, text);
}

void note(std::string_view text) {
    say(fmt::format("pushfactor: note: {}\n", one_line(text)));
}

std::string one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        line += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
    }
    return line;
}

void keep_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        // Only for reading: writing then fails, as it did.
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", O_RDONLY);
    }
}

}  // namespace pushfactor::demos
