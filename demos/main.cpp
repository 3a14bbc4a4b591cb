// The program pushfactor. See --help for its commands.
#include "demos/base/platform/messages.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/commands/command_line.h"
#include "engine/base/invalid_input.h"

#include <csignal>
#include <filesystem>

namespace {

using namespace pushfactor::demos;

int complain(const std::exception& error, ExitStatus status) {
    say("pushfactor: " + one_line(error.what()) + "\n");
    return status;
}

// An error of a file names the option that gave it.
std::string with_option(const std::string& message, const std::optional<CommandLine>& line) {
    if (!line) return message;
    for (const auto& [field, name] : line->outputs) {
        if (message.starts_with(name + ": ")) return field + message.substr(name.size());
        const std::string folder = std::filesystem::path(name).parent_path();
        if (message.starts_with((folder.empty() ? "." : folder) + ": ")) return field + ": " + message;
    }
    for (const auto& [field, name] : line->folders) {
        if (message.starts_with(name + ": ")) return field + message.substr(name.size());
        if (message.starts_with(name + "/")) return field + ": " + message;
    }
    return message;
}

}  // namespace

int main(int argc, char** argv) {
    keep_standard_streams();
    note_interrupts();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large then fails in write() instead of killing the program
    std::optional<CommandLine> line;
    try {
        line = parse_command_line({argv + 1, argv + argc});
        if (!line) return done;
        for (const NamedFile& file : line->outputs) make_folder_of(file.name);
        std::visit([](const auto& command) { commands::carry_out(command); }, line->command);
        return done;
    } catch (const UsageError& error) {
        return complain(error, bad_usage);
    } catch (const pushfactor::engine::InvalidInput& error) {
        return complain(error, bad_usage);
    } catch (const CheckError& error) {
        return complain(error, check_failed);
    } catch (const OutputError& error) {
        return complain(std::runtime_error(with_option(error.what(), line)), output_failed);
    } catch (const NonFiniteError& error) {
        return complain(error, not_finite);
    } catch (const std::exception& error) {
        return complain(error, run_failed);
    }
}
