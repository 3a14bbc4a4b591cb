// The program pushfactor. See --help for its commands.
#include "demos/commands/command_line.h"
#include "demos/platform/messages.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"
#include "engine/base/invalid_input.h"

#include <csignal>

namespace {

using namespace pushfactor::demos;

int complain(const std::exception& error, ExitStatus status) {
    say("pushfactor: " + one_line(error.what()) + "\n");
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    keep_standard_streams();
    note_interrupts();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large then fails in write() instead of killing the program
    try {
        const auto line = parse_command_line({argv + 1, argv + argc});
        if (!line) return done;
        make_folders_of(line->outputs);
        std::visit([](const auto& command) { commands::carry_out(command); }, line->command);
        return done;
    } catch (const UsageError& error) {
        return complain(error, bad_usage);
    } catch (const pushfactor::engine::InvalidInput& error) {
        return complain(error, bad_usage);
    } catch (const CheckError& error) {
        return complain(error, check_failed);
    } catch (const OutputError& error) {
        return complain(error, output_failed);
    } catch (const NonFiniteError& error) {
        return complain(error, not_finite);
    } catch (const std::exception& error) {
        return complain(error, run_failed);
    }
}
