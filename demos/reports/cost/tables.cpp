#include "demos/reports/cost/tables.h"

#include "demos/reports/cost/allocations.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pushfactor::demos::reports::cost {

namespace {

using Lines = std::vector<std::vector<std::string>>;

constexpr const char* columns_before_islands =
    "scene,start_s,made,bodies,force_sources,constraint_sources,contact_rules,step_rules,pairs,touches,contact_"
    "rows,"
    "friction_rows,distance_rows,columns,substeps";
constexpr const char* columns_after_islands =
    "bodies_at_rest,sweeps,row_updates,multiply_adds,allocations,allocated_bytes,step_us";

std::string joined(const std::vector<std::string>& names, const char* none) {
    return names.empty() ? none : fmt::format("{}", fmt::join(names, " + "));
}

std::string memory(double value) {
    return allocations_are_counted() ? to_text(value) : "";
}

std::string quoted(const std::string& text) {
    return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

std::string csv_line(const Entry& entry, const char* made, const Entry::Made& which) {
    const auto& [parts, bodies, counts, times] = which.ledger;
    std::vector<std::string> fields{
        quoted(entry.name),         to_text(entry.start),        made,
        std::to_string(bodies),     joined(parts.forces, ""),    joined(parts.constraints, ""),
        joined(parts.contacts, ""), joined(parts.step_rules, "")};
    for (const double value : {counts.pairs, counts.touches, counts.contact_rows, counts.friction_rows,
                               counts.distance_rows, counts.columns, counts.substeps}) {
        fields.push_back(to_text(value));
    }
    for (const IslandCounts& kind : counts.islands) {
        for (const double value : {kind.kept, kind.swept, kind.exact, kind.small_steps})
            fields.push_back(to_text(value));
    }
    for (const double value : {counts.at_rest, counts.sweeps, counts.row_updates, counts.multiply_adds}) {
        fields.push_back(to_text(value));
    }
    fields.push_back(memory(counts.allocations));
    fields.push_back(memory(counts.allocated_bytes));
    fields.push_back(fmt::format("{:.3f}", times.step));
    for (const double us : times.stages) fields.push_back(fmt::format("{:.3f}", us));
    fields.push_back(quoted(which.command));
    return fmt::format("{}\n", fmt::join(fields, ","));
}

std::string ratio(double everything, double as_it_is) {
    if (everything == as_it_is) return "1";
    return as_it_is > 0.0 ? fmt::format("{:.2f}", everything / as_it_is) : "from 0";
}

Lines parts_table(std::span<const Entry> entries) {
    Lines lines{{"scene", "bodies", "force sources", "constraint sources", "of contacts", "command"}};
    for (const Entry& entry : entries) {
        const Ledger& ledger = entry.as_it_is.ledger;
        lines.push_back({entry.name, std::to_string(ledger.bodies), joined(ledger.parts.forces, "none"),
                         joined(ledger.parts.constraints, "none"), joined(ledger.parts.contacts, "none"),
                         entry.as_it_is.command});
    }
    return lines;
}

Lines counts_table(std::span<const Entry> entries) {
    Lines lines{{"scene", "pairs", "touches", "contact rows", "friction rows", "distance rows", "columns",
                 "at rest", "sweeps", "multiply-adds", "allocations", "bytes"}};
    for (const Entry& entry : entries) {
        const Counts& counts = entry.as_it_is.ledger.counts;
        std::vector<std::string> line{entry.name};
        for (const double value :
             {counts.pairs, counts.touches, counts.contact_rows, counts.friction_rows, counts.distance_rows,
              counts.columns, counts.at_rest, counts.sweeps, counts.multiply_adds}) {
            line.push_back(three_digits(value));
        }
        for (const double value : {counts.allocations, counts.allocated_bytes}) {
            line.push_back(allocations_are_counted() ? three_digits(value) : "not counted");
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

// A line for each kind of islands that a scene has.
Lines islands_table(std::span<const Entry> entries) {
    Lines lines{{"scene", "kind", "islands", "kept", "swept", "exact", "small steps"}};
    for (const Entry& entry : entries) {
        const Counts& counts = entry.as_it_is.ledger.counts;
        for (std::size_t k = 0; k < island_kinds.size(); ++k) {
            const IslandCounts& kind = counts.islands[k];
            if (kind.all() == 0.0) continue;
            lines.push_back({entry.name, std::string(island_kinds[k]), three_digits(kind.all()),
                             three_digits(kind.kept), three_digits(kind.swept), three_digits(kind.exact),
                             three_digits(kind.small_steps)});
        }
    }
    return lines;
}

Lines times_table(std::span<const Entry> entries) {
    Lines lines{{"scene", "step"}};
    lines.front().insert(lines.front().end(), phase_names.begin(), phase_names.end());
    for (const Entry& entry : entries) {
        const Times& times = entry.as_it_is.ledger.times;
        std::vector<std::string> line{entry.name, three_digits(times.step)};
        for (const double us : times.stages) line.push_back(fmt::format("{:.2f}", us));
        lines.push_back(std::move(line));
    }
    return lines;
}

Lines comparison_table(std::span<const Entry> entries) {
    Lines lines{{"scene", "rows", "with everything", "columns", "with everything", "multiply-adds",
                 "with everything", "times", "us a step", "with everything", "times"}};
    for (const Entry& entry : entries) {
        const Ledger& own = entry.as_it_is.ledger;
        const Ledger& all = entry.with_everything.ledger;
        lines.push_back({entry.name, three_digits(own.counts.rows()), three_digits(all.counts.rows()),
                         three_digits(own.counts.columns), three_digits(all.counts.columns),
                         three_digits(own.counts.multiply_adds), three_digits(all.counts.multiply_adds),
                         ratio(all.counts.multiply_adds, own.counts.multiply_adds), three_digits(own.times.step),
                         three_digits(all.times.step), ratio(all.times.step, own.times.step)});
    }
    return lines;
}

Section section_of(const char* name, const char* heading, const char* caption, Lines table) {
    Plate plate;
    plate.caption = caption;
    plate.table = std::move(table);
    return {name, heading, plate};
}

}  // namespace

std::string three_digits(double value) {
    if (value == 0.0) return "0";
    return value >= 100.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string csv_text(std::span<const Entry> entries) {
    std::string text = columns_before_islands;
    for (const std::string_view kind : island_kinds) {
        text += fmt::format(",{0}_kept,{0}_swept,{0}_exact,{0}_small_steps", kind);
    }
    text += fmt::format(",{}", columns_after_islands);
    for (const std::string_view stage : phase_names) text += fmt::format(",{}_us", stage);
    text += ",command\n";
    for (const Entry& entry : entries) {
        text += csv_line(entry, "as it is", entry.as_it_is);
        text += csv_line(entry, "everything", entry.with_everything);
    }
    return text;
}

std::vector<Section> table_sections(std::span<const Entry> entries) {
    return {
        section_of("parts", "What each scene is made of", "What is not named here was not constructed.",
                   parts_table(entries)),
        section_of(
            "counts", "What a step does",
            "Means over 120 steps of 1/60 s, as each scene is. Sweeps are those of the island with the most of "
            "them: where the last forces are good enough there is none.",
            counts_table(entries)),
        section_of(
            "islands", "How the islands are solved",
            "Bodies that rows join are an island, and each is solved by itself. Mean number per step of islands "
            "of one body, of at most 1.5 pairs per body (threads) and of more (heaps); of these, how many keep "
            "their last forces, are swept, and are solved exactly.",
            islands_table(entries)),
        section_of("times", "Where the time goes",
                   "CPU time in us a step, as each scene is; the stages without what reading the clock takes.",
                   times_table(entries)),
        section_of("everything", "What leaving out saves",
                   "The same scene with every part there is: a poke, a distance, contacts with friction, "
                   "restitution, sweep and cache, two columns in each step, and rules that may divide it.",
                   comparison_table(entries))};
}

}  // namespace pushfactor::demos::reports::cost
