// The program pushfactor. See --help for its commands.
#include "demos/commands/command_line.h"
#include "demos/commands/commands.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"
#include "engine/base/invalid_input.h"

#include <fmt/format.h>

#include <csignal>

namespace {

using namespace pushfactor::demos;

int complain(const std::exception& error, ExitStatus status) {
    fmt::print(stderr, "pushfactor: {}\n", error.what());
    return status;
}

int carry_out(const Request& request) {
    switch (request.command) {
        case Request::Command::list:
            commands::list(request);
            break;
        case Request::Command::scene:
            commands::scene(request);
            break;
        case Request::Command::family:
            commands::family(request);
            break;
        case Request::Command::run:
            commands::run(request);
            break;
        case Request::Command::render:
            commands::render(request);
            break;
        case Request::Command::figures:
            commands::figures(request);
            break;
        case Request::Command::report:
            commands::report(request);
            break;
        case Request::Command::check:
            commands::check(request);
            break;
    }
    return done;
}

}  // namespace

int main(int argc, char** argv) {
    note_interrupts();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large then fails in write() instead of killing the program
    try {
        const auto request = parse_command_line(argc, argv);
        return request ? carry_out(*request) : done;
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
