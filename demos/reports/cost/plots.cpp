#include "demos/reports/cost/plots.h"

#include "demos/pages/plot.h"
#include "demos/platform/output_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace pushfactor::demos::reports::cost {

namespace {

// Bars from the top down, in the order of the tables.
std::string stages_data(std::span<const Entry> entries) {
    std::string text = "# scene";
    for (const std::string_view stage : phase_names) text += fmt::format(",end of {} in %", stage);
    text += "\n";
    for (const Entry& entry : entries) {
        const Times& times = entry.as_it_is.ledger.times;
        const double all = std::accumulate(times.stages.begin(), times.stages.end(), 0.0);
        text += fmt::format("\"{}: {} us\"", entry.name, three_digits(times.step));
        double end = 0.0;
        for (const double us : times.stages)
            text += fmt::format(",{:.4f}", 100.0 * (end += us) / std::max(all, 1e-9));
        text += "\n";
    }
    return text;
}

std::string comparison_data(std::span<const Entry> entries) {
    std::string text = "# scene,us a step as it is,with everything\n";
    for (const Entry& entry : entries) {
        text += fmt::format("\"{}\",{:.4g},{:.4g}\n", entry.name, entry.as_it_is.ledger.times.step,
                            entry.with_everything.ledger.times.step);
    }
    return text;
}

void add_plot(const char* script, const std::string& data, std::size_t bars, const std::string& made_on,
              const std::filesystem::path& folder, Section& section) {
    const std::string file = std::string(script) + ".dat";
    write_file(folder / file, data);
    section.plate.files.push_back(file);
    if (!plots_can_be_drawn()) {
        section.plate.caption += std::string(" ") + what_plots_need;
        return;
    }
    const double aspect = 1600.0 / (260.0 + 52.0 * static_cast<double>(bars));
    const Plot plot{.script = script,
                    .data = folder / file,
                    .name = script,
                    .aspect = aspect,
                    .variables = {{"bars", static_cast<double>(bars)}, {"made_on", made_on}}};
    const std::vector<std::string> made = draw_plot(plot, folder);
    section.plate.pictures.push_back(made.front());
    section.plate.files.insert(section.plate.files.end(), made.begin(), made.end());
}

}  // namespace

void add_plots(std::span<const Entry> entries, const std::string& made_on, const std::filesystem::path& folder,
               std::vector<Section>& sections) {
    for (Section& section : sections) {
        if (section.name == "times") {
            add_plot("cost_stages", stages_data(entries), entries.size(), made_on, folder, section);
        } else if (section.name == "everything") {
            add_plot("cost_everything", comparison_data(entries), entries.size(), made_on, folder, section);
        }
    }
}

}  // namespace pushfactor::demos::reports::cost
