// Every option of every command in every combination of two: it is read, or it is refused. Nothing is ignored, and
// nothing runs.
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "demos/commands/command_line.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/families/family.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <map>
#include <optional>
#include <set>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::check_refused;
using tests::Folder;
using tests::shell;

namespace {

using Line = std::vector<std::string>;

// Commands in the combinations that decide what they read.
const std::vector<Line> bases{
    {"list"},
    {"scene", "stack"},
    {"family"},
    {"family", "wall"},
    {"run", "stack"},
    {"run", "pendulum-grid"},
    {"render", "stack"},
    {"render", "stack", "funnel"},
    {"render", "stack", "--at", "0"},
    {"render", "stack", "--compare", "beta=0.1,0.2"},
    {"render", "stack", "--frames", "off", "--replay", "r.html"},
    {"render", "stack", "--from-trajectory", "t.csv"},
    {"render", "--join", "d", "--video", "v.mp4"},
    {"figures"},
    {"figures", "--width", "85mm"},
    {"report", "error"},
    {"report", "stability"},
    {"report", "cost"},
    {"report", "atlas"},
    {"report", "atlas", "--grid", "stack", "--x", "beta=0.1,0.2", "--y", "iterations=1,2"},
    {"report", "merge", "d"},
    {"check", "d"},
    {"check", "d", "--against", "e"},
    {"doctor"},
};

// A value that each option accepts somewhere, and that is not its default.
const std::map<std::string, std::string> values{
    {"preset", "paper"},
    {"seconds", "3"},
    {"dt", "1/120"},
    {"substeps", "2"},
    {"solver", "pgs"},
    {"tolerance", "1e-3"},
    {"scheme", "whole"},
    {"small-steps", "2x2"},
    {"push", "none"},
    {"distance-push", "none"},
    {"warm-start", "off"},
    {"row-order", "creation"},
    {"manifold-points", "8"},
    {"friction-model", "paper"},
    {"restitution-model", "sum"},
    {"start-kick", "off"},
    {"rotation", "paper"},
    {"rest", "on"},
    {"config", "PLACE/config.json"},
    {"csv", "a.csv"},
    {"trajectory", "b.csv"},
    {"rows", "c.csv"},
    {"summary", "s.json"},
    {"replay", "p.html"},
    {"replay-data", "poses"},
    {"glb", "g.glb"},
    {"save-state", "z.json"},
    {"measure", "angle_error_rms_deg"},
    {"size", "64x64"},
    {"fps", "30"},
    {"play-speed", "1/2"},
    {"at", "1"},
    {"ghosts", "0"},
    {"shutter", "0.5"},
    {"camera", "fit"},
    {"caption", "off"},
    {"overlay", "forces"},
    {"compare", "beta=0.3,0.4"},
    {"gl", "egl"},
    {"out", "o.png"},
    {"video", "w.mp4"},
    {"frames", "off"},
    {"shard", "1/2"},
    {"from-trajectory", "u.csv"},
    {"join", "f"},
    {"width", "170mm"},
    {"font-size", "9pt"},
    {"theme", "dark"},
    {"background", "none"},
    {"only", "frozen"},
    {"beside", "h.csv"},
    {"export", "k"},
    {"junit", "j.xml"},
    {"markdown", "m.md"},
    {"grid", "funnel"},
    {"x", "beta=0.5,0.6"},
    {"y", "iterations=3,4"},
    {"set", "beta=0.2"},
    {"replays", "all"},
    {"against", "l"},
    {"flip", "0.1"},
    {"physics", "off"},
    {"dpi", "200"},
    {"samples", "4"},
};

std::vector<Option> all_options() {
    std::vector<Option> all;
    for (const commands::Entry& entry : command_entries()) {
        for (const Option& option : entry.options()) {
            if (std::ranges::find(all, option.name, &Option::name) == all.end()) all.push_back(option);
        }
    }
    return all;
}

Line with(Line line, const Option& option, const std::string& place) {
    line.push_back("--" + option.name);
    if (option.placeholder.empty()) return line;
    const auto found = values.find(option.name);
    std::string value = found == values.end() ? "1" : found->second;
    // A parameter of a family has a range of its own.
    const auto* const family =
        line.front() == "family" && line.size() > 2 ? families::find_family(line[1]) : nullptr;
    for (std::size_t i = 0; family && i < family->parameters.size(); ++i) {
        const Parameter& range = family->parameters[i].range;
        if (range.name == option.name) value = to_text(range.low);
    }
    if (value.starts_with("PLACE")) value.replace(0, 5, place);
    line.push_back(value);
    return line;
}

// None if the program refuses it. Without the text of the command line, which always differs.
std::optional<commands::AnyCommand> read(const Line& line) {
    try {
        auto parsed = parse_command_line(line);
        const auto forget = [](auto& command) {
            if constexpr (requires { command.line; }) command.line.clear();
        };
        std::visit(forget, parsed->command);
        return parsed->command;
    } catch (const UsageError&) {
        return std::nullopt;
    }
}

std::string joined(const Line& line) {
    std::string text;
    for (const std::string& word : line) text += word + " ";
    return text;
}

}  // namespace

TEST_CASE("every option alone and in pairs, with every command, changes what is read or is refused") {
    const Folder folder;
    folder.write("config.json", R"({"scene": "stack", "beta": 0.15})");
    const std::string place = folder.path().string();
    const std::vector<Option> options = all_options();
    std::map<std::string, int> accepted;
    std::vector<std::string> ignored;
    std::vector<Line> all_bases = bases;
    for (const SceneEntry& scene : catalogue()) all_bases.push_back({"scene", std::string(scene.name)});
    for (const families::Family& family : families::families())
        all_bases.push_back({"family", std::string(family.name)});
    std::set<std::string> seen;  // commands
    std::vector<std::string> other_in_order;
    for (const Line& base : all_bases) {
        for (const std::string& word : base) ++accepted[word.substr(std::min<std::size_t>(2, word.size()))];
        const auto alone = read(base);
        REQUIRE(alone);
        const bool is_first = seen.insert(base.front()).second;
        std::vector<std::optional<commands::AnyCommand>> ones;
        for (const Option& option : options) ones.push_back(read(with(base, option, place)));
        for (std::size_t i = 0; i < options.size(); ++i) {
            const Line one = with(base, options[i], place);
            if (ones[i] && *ones[i] == *alone) ignored.push_back(joined(one));
            if (ones[i]) ++accepted[options[i].name];
            for (std::size_t k = i + 1; k < options.size(); ++k) {
                const Line line = with(one, options[k], place);
                const auto both = read(line);
                // Either order is accepted, or none: tried once for each command.
                if (is_first &&
                    both.has_value() != read(with(with(base, options[k], place), options[i], place)).has_value())
                    other_in_order.push_back(joined(line));
                if (!both) continue;
                ++accepted[options[k].name];
                ++accepted[options[i].name];
                for (const std::size_t own : {i, k}) {
                    if (ones[own] && *both == *ones[own]) ignored.push_back(joined(line));
                }
            }
        }
    }
    INFO((ignored.empty() ? "" : ignored.front()) << " and " << ignored.size() << " in all");
    CHECK(ignored.empty());
    CHECK(other_in_order.empty());
    for (const Option& option : options) {
        INFO(option.name);
        CHECK(accepted[option.name] > 0);
    }
}

TEST_CASE(
    "an option without effect in the scene or beside another one is noted, unless a panel or a file needs it") {
    const Folder folder;
    const auto said = [&](const std::string& command) {
        const tests::Ended ended = tests::shell(folder, "pushfactor " + command);
        CHECK(ended.status == 0);
        return ended.err;
    };
    const std::string note = "pushfactor: note: ", still = " --at 0 --size 64x64 --out s";
    const std::string small_steps =
        "--small-steps 4x4: has no effect without --scheme small-steps, or --scheme auto "
        "with --solver auto and a --tolerance above 0\n";
    CHECK(said("run stack --seconds 0 --push none --beta 0.3") ==
          note + "--beta 0.3: has no effect with --push none\n");
    CHECK(said("run stack --seconds 0 --push none --max-push-speed 2") ==
          note + "--max-push-speed 2: has no effect with --push none\n");
    CHECK(said("run chain --seconds 0 --distance-push none --distance-beta 0.3") ==
          note + "--distance-beta 0.3: has no effect with --distance-push none\n");
    CHECK(said("run chain --seconds 0 --scheme rattle4 --distance-push none") ==
          note + "--distance-push none: has no effect in RATTLE steps\n");
    CHECK(said("run stack --seconds 0 --scheme whole --small-steps 4x4") == note + small_steps);
    CHECK(said("run stack --seconds 0 --solver pgs --small-steps 4x4") == note + small_steps);
    CHECK(
        said("run stack --seconds 0 --preset paper --scheme small-steps") ==
        note +
            "--scheme small-steps: has no effect with --push persistent, whose momentum small steps cannot give\n");
    CHECK(said("run stack --seconds 0 --tolerance 0 --scheme small-steps").empty());
    CHECK(said("run stack --seconds 0 --friction 0 --friction-model cone") ==
          note + "--friction-model cone: has no effect where all friction is 0\n");
    CHECK(said("render stack --push none --compare beta=0.1,0.2" + still) ==
          note + "--compare beta=0.1,0.2: has no effect with --push none\n");
    CHECK(said("render stack --compare push=none,persistent --beta 0.3" + still).empty());
    CHECK(said("scene stack > my.json && pushfactor run my.json --push none --seconds 0").empty());

    CHECK(said("run pendulum-wave --seconds 0 --friction 0.3 --row-order reverse") ==
          note + "--row-order reverse: has no effect without contacts\n" + note +
              "--friction 0.3: has no effect without contacts\n");
    CHECK(said("run stack --seconds 0 --distance-beta 0.3") ==
          note + "--distance-beta 0.3: has no effect without bars and joints\n");
    CHECK(said("run stack --seconds 0 --restitution-model sum") ==
          note + "--restitution-model sum: has no effect where all restitution is 0\n");
    CHECK(said("run stack --seconds 0 --restitution-model sum --restitution 0.5").empty());
    CHECK(said("run stack --seconds 0 --seed 3") == note + "--seed 3: has no effect with --jitter 0\n");
    CHECK(said("run stack --seconds 0 --seed 3 --jitter 0.1").empty());
    CHECK(said("run funnel --seconds 0 --seed 3").empty());
    CHECK(said("scene pendulum-grid --poke-at 3") == note + "--poke-at 3: has no effect with --poke 0\n");
    CHECK(said("run chain --seconds 0 --scheme rattle4 --rest on") ==
          note + "--rest on: has no effect in RATTLE steps\n");
    folder.write("free.json",
                 R"({"version": 1, "bodies": [{"name": "b", "shape": "sphere", "radius_m": 1, "mass_kg": 1}]})");
    CHECK(said("run free.json --seconds 0 --solver pgs") ==
          note + "--solver pgs: has no effect without contacts, bars and joints\n");
    CHECK(said("run stack --seconds 1e-320").find("1e-320: cut to 0 steps of 1/60 s, 0 s") != std::string::npos);
    // One of several scenes needs it, and those of files are not typed.
    CHECK(said("render stack chain --beta 0.3" + still).empty());
    folder.write("c.json", R"({"friction": 0.3, "distance-beta": 0.3, "seed": 3})");
    CHECK(said("run stack --config c.json --seconds 0").empty());
    CHECK(said("render stack --seconds 5 --save-state end.json" + still) ==
          note + "--seconds 5: the run ends with the last of --at, after 0 s\n");
}

TEST_CASE("options before the command are refused, -- ends the options, and a value is never an option") {
    check_refused("--seconds 1 run stack", "--seconds: must come after the command");
    check_refused("--junit x.xml check g", "--junit: must come after the command");
    check_refused("run stack --dt --seconds 1", "--dt: must have a value");
    check_refused("run stack --dt 1/60 --dt 1/30", "--dt 1/30: must be given once");
    check_refused("run stack --timing=yes", "--timing=yes: must be without a value");
    check_refused("list --names --names", "--names: must be given once");
    check_refused("run stack --csv ''", "--csv: must have a value, FILE");
    check_refused("render stack --out=", "--out: must have a value, DIR");
    check_refused("render stack --at 0 --out x.png", "--out x.png: must be the name of a folder");
    check_refused("run -- --seconds", "scene --seconds: must be one of");
    check_refused("family --seed 3", "--seed 3: must not be with family");
    check_refused("run stack --replay r.html --replay-data poses --overlay forces",
                  "--overlay forces: must be of pictures; a replay with --replay-data poses does not show it");
    check_refused("run stack --timing --threads 2", "--threads 2: must be without --timing");
    CHECK(shell(Folder(), "pushfactor run --seconds=0 -- stack").status == 0);
}

TEST_CASE("two outputs with one file, and an output that is read, are refused before the run") {
    const Folder folder;
    folder.write("in.json", R"({"version": 1, "bodies": []})");
    std::filesystem::create_symlink("a.csv", folder / "link.csv");
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        check_refused(folder, "pushfactor run " + arguments, words);
    };
    refused("stack --csv a.csv --trajectory a.csv", "--trajectory a.csv: must not be the file of --csv a.csv");
    refused("stack --csv a.csv --trajectory ./b/../a.csv", "must not be the file of --csv a.csv");
    refused("stack --csv a.csv --rows link.csv", "must not be the file of --csv a.csv");
    refused("stack --csv - --trajectory -", "--trajectory -: must not be the file of --csv -");
    refused("stack --csv s --summary s", "--summary s: must not be the file of --csv s");
    refused("in.json --csv in.json", "--csv in.json: must not be a file that is read");
    CHECK(folder.files() == std::vector<std::string>{"in.json"});
    CHECK(shell(folder, "pushfactor run stack --seconds 0 --csv /dev/null --rows /dev/null").status == 0);
}

TEST_CASE("the help of run shows the parameters of each scene in its own words, and a full disk is status 4") {
    const std::string help = shell(Folder(), "pushfactor run --help").out;
    for (const char* const text :
         {"number of cubes [5]", "number of balls, above 20", "number of pendulums [50]"}) {
        INFO(text);
        CHECK(help.find(text) != std::string::npos);
    }
    for (const char* const command : {"list", "--help", "--version", "run --help", "doctor", "family"}) {
        INFO(command);
        CHECK(shell(Folder(), std::string("pushfactor ") + command + " >/dev/full").status == 4);
    }
}

TEST_CASE("standard error that is closed or full changes neither status nor outputs") {
    const Folder folder;
    const std::string still = "pushfactor render stack --at 0 --size 64x64 --out r";
    CHECK(shell(folder, "mkdir r; touch r/other.png; " + still + " 2>/dev/full").status == 0);
    CHECK(std::filesystem::exists(folder / "r/at_0s.png"));
    CHECK(shell(folder, "pushfactor render nosuch 2>/dev/full").status == 2);
    CHECK(shell(folder, "pushfactor render nosuch 2>&-").status == 2);
    CHECK(shell(folder, "pushfactor run stack --seconds 0 --csv a.csv 2>&- <&-").status == 0);
    CHECK(shell(folder, "pushfactor run stack --seconds 0 --csv b.csv --summary s >&- 2>&-").status == 0);
    CHECK(folder.read("a.csv") == folder.read("b.csv"));
    CHECK(shell(folder, "pushfactor run stack --seconds 0 >&-").status == 4);
}
