#include "demos/commands/commands.h"
#include "demos/observed_run.h"
#include "demos/output_file.h"
#include "demos/progress.h"

namespace pushfactor::demos::commands {

void run(const Request& request) {
    const Choices choices = understand(request.scenes.front(), request.given);
    ObservedRun observed(choices, request);
    const long steps = whole_steps(choices.settings);
    {
        ProgressBar bar(choices.description.name, steps);
        for (long step = 1; step <= steps; ++step) {
            stop_if_interrupted("no file was written");
            observed.advance();
            bar.show(step);
        }
    }
    const std::string summary = observed.finish();
    const bool data_on_stdout = request.csv == "-" || request.trajectory == "-" || request.rows == "-";
    if (request.summary || !data_on_stdout) write_file(request.summary.value_or("-"), summary);
}

}  // namespace pushfactor::demos::commands
