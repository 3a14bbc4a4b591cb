// Reports in shares: whatever the number and order of the shards, and after a kill, merged files are those of one
// process; what `report merge` refuses and lists.
#include "demos/base/text/json.h"
#include "demos/base/text/shard.h"
#include "demos/reports/study.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/program.h"

#include <limits>
#include <map>
#include <random>
#include <set>

using namespace pushfactor::tests;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports;

namespace {

namespace fs = std::filesystem;

// All files of a report but its pieces.
std::map<std::string, std::string> files_of(const Folder& folder, const std::string& report) {
    std::map<std::string, std::string> files;
    for (const std::string& name : folder.files()) {
        const std::string start = report + "/";
        if (!name.starts_with(start) || name.starts_with(start + "pieces/")) continue;
        files[name.substr(start.size())] = folder.read(name);
    }
    return files;
}

std::vector<std::string> pieces_of(const Folder& folder, const std::string& report) {
    std::vector<std::string> pieces;
    for (const std::string& name : folder.files()) {
        if (name.starts_with(report + "/pieces/") && !name.ends_with("/report.json")) pieces.push_back(name);
    }
    return pieces;
}

const std::string quick_map = "pushfactor report atlas --quick --only overlap_beta_persistent ";

}  // namespace

TEST_CASE("an atlas in 2, 7 and 64 shards, in any order, one killed and started again, is that of one process") {
    // tests/cluster does the same with all maps.
    const std::string maps = "height_iterations,overlap_beta_persistent,step_beta_paper";
    const Folder folder;
    require_success(folder, "pushfactor report atlas --quick --only " + maps + " --out whole");
    const auto whole = files_of(folder, "whole");
    REQUIRE(whole.size() == 2 + 3 * 3);
    const std::size_t cells = pieces_of(folder, "whole").size();
    std::mt19937 random(1);
    for (const int count : {2, 7, 64}) {
        INFO(count << " shards");
        const std::string out = "in-" + std::to_string(count);
        const auto shard = [&](int number) {
            return " report atlas --quick --only " + maps + " --out " + out + " --shard " +
                   to_text(Shard{number, count});
        };
        if (count == 2) {
            const Ended killed =
                stopped_when(folder, "ls " + out + "/pieces/*/*/*.json", shard(2) + " --jobs 1", "KILL");
            CHECK(killed.status == 128 + 9);
            CHECK(!pieces_of(folder, out).empty());
            CHECK(pieces_of(folder, out).size() < cells / 2);
        }
        std::vector<int> numbers;
        for (int number = 1; number <= count; ++number) numbers.push_back(number);
        std::shuffle(numbers.begin(), numbers.end(), random);
        std::string commands;
        for (const int number : numbers)
            commands += (commands.empty() ? "" : " && ") + ("pushfactor" + shard(number));
        require_success(folder, commands);
        CHECK(files_of(folder, out).empty());
        require_success(folder, "pushfactor report merge " + out);
        CHECK(files_of(folder, out) == whole);
    }
}

TEST_CASE("pieces of several folders are merged, and no piece is made twice, whatever the number of shards was") {
    const Folder folder;
    require_success(folder, quick_map + "--out whole");
    require_success(folder, quick_map + "--out a --shard 1/2");
    require_success(folder, quick_map + "--out b --shard 2/2");
    const auto a = pieces_of(folder, "a").size(), b = pieces_of(folder, "b").size();
    CHECK(a > 0);
    CHECK(b > 0);
    CHECK(a + b == 9);
    check_refused(folder, "pushfactor report merge b a --out merged --junit v.xml",
                  "--junit v.xml: must be with report stability, which judges");
    require_success(folder, "pushfactor report merge b a --out merged");
    CHECK(files_of(folder, "merged") == files_of(folder, "whole"));

    const Ended again = shell(folder, quick_map + "--out whole --shard 1/1");
    CHECK(again.out == "shard 1/1: 9 pieces, of which 9 were there; in whole\n");
    // With a number that no run gives.
    std::string changed = folder.read(pieces_of(folder, "whole").front());
    const auto value = changed.find("\"value\":") + 8;
    changed.replace(value, changed.find('}', value) - value, "12345");
    folder.write(pieces_of(folder, "whole").front(), changed);
    require_success(folder, quick_map + "--out whole");
    CHECK(folder.read("whole/atlas.csv").find(",12345,") != std::string::npos);
}

TEST_CASE("what is missing is listed with the commands that make it, a damaged piece too, and no page is made") {
    const Folder folder;
    for (const char* const shard : {"1/3", "2/3", "3/3"}) {
        require_success(folder, quick_map + "--out out --shard " + shard);
    }
    std::vector<std::string> pieces = pieces_of(folder, "out");
    const std::string damaged = folder.read(pieces[0]);
    folder.write(pieces[0], damaged.substr(0, damaged.size() / 2));
    fs::remove(folder / pieces[1]);
    const Ended ended = shell(folder, "pushfactor report merge out");
    CHECK(ended.status == 1);
    CHECK(ended.err == "pushfactor: 2 of 9 pieces are missing\n");
    CHECK(files_of(folder, "out").empty());
    const auto lines = lines_of(ended.out);
    REQUIRE(lines.size() >= 4);
    CHECK(lines[0].starts_with("missing: atlas: max_upward_speed_m_per_s of pushfactor run stack "));
    CHECK(lines[1].starts_with("missing: atlas: "));
    CHECK(lines[2] == "made by:");
    for (std::size_t i = 3; i < lines.size(); ++i) {
        CHECK(lines[i].starts_with("pushfactor report atlas --quick --only overlap_beta_persistent --shard "));
        require_success(folder, lines[i].substr(0, lines[i].find(" #")));
    }
    require_success(folder, "pushfactor report merge out");
    CHECK(folder.read(pieces[0]) == damaged);
}

TEST_CASE("pieces of several versions, of another one or of several reports are refused in one line") {
    const Folder folder;
    require_success(folder, quick_map + "--out a --shard 1/2");
    require_success(folder, quick_map + "--out b --shard 2/2");
    fs::copy(folder / "b", folder / "c", fs::copy_options::recursive);
    const fs::path version = fs::directory_iterator(folder / "c/pieces")->path();
    CHECK(version.filename().string().starts_with("0.1.0-commit-"));
    fs::rename(version, folder / "c/pieces/0.0.1-commit-1");
    check_refused(folder, "pushfactor report merge a c", "pieces must be of one version, not of 0.0.1-commit-1 (");
    check_refused(folder, "pushfactor report merge c", "must be of the version of this program, ");
    check_refused(folder, "pushfactor report merge nowhere", "merge nowhere: must have pieces");
    check_refused(folder, "pushfactor report merge", "must have the folders of shards");
    check_refused(folder, "pushfactor report merge a --quick", "--quick: must not be with report merge");
    require_success(folder, "pushfactor report atlas --quick --only height_iterations --out d --shard 1/2");
    check_refused(folder, "pushfactor report merge a d",
                  "merge: must be of one report, not `pushfactor report atlas");
    for (const char* const note : {R"({"words": ["report", "atlas"], "shards": 0})",
                                   R"({"words": ["report", 5], "shards": 1})", "nonsense"}) {
        require_success(folder, std::string("find d -name report.json -exec sh -c 'echo \"$1\" > \"$0\"' {} '") +
                                    note + "' ';'");
        check_refused(folder, "pushfactor report merge d",
                      "merge d: must have the report.json that `report` leaves");
    }
    // Pieces of another version are not used: all are made again.
    fs::remove_all(folder / "a/pieces");
    fs::create_directories(folder / "a/pieces");
    fs::rename(folder / "c/pieces/0.0.1-commit-1", folder / "a/pieces/0.0.1-commit-1");
    CHECK(shell(folder, quick_map + "--out a --shard 1/1").out.find("of which 0 were there") != std::string::npos);
}

TEST_CASE("the stability report in shards has the files of one process, verdicts and replays included") {
    const Folder folder;
    const std::string report = "pushfactor report stability --quick --only bounces ";
    require_success(folder, report + "--out out && mv out whole");
    require_success(folder, report + "--out b --shard 2/2 && " + report + "--out a --shard 1/2");
    require_success(folder, "pushfactor report merge a b --out out --junit out.xml");
    const auto whole = files_of(folder, "whole");
    CHECK(whole.contains("runs/bouncing-ball-default.html"));
    CHECK(files_of(folder, "out") == whole);
    CHECK(folder.read("out.xml").find("failures=\"0\"") != std::string::npos);
}

TEST_CASE("measured times are those of the pieces: an error report is merged twice to the same files") {
    const Folder folder;
    const std::string report = "pushfactor report error --quick --only sphere_column ";
    require_success(folder, report + "--out whole");
    require_success(folder, report + "--out a --shard 1/2 && " + report + "--out b --shard 2/2");
    require_success(folder, "pushfactor report merge a b --out first && pushfactor report merge b a --out second");
    const auto merged = files_of(folder, "first");
    CHECK(files_of(folder, "second") == merged);
    // All but the times are those of one process.
    const auto whole = files_of(folder, "whole");
    for (const char* const file : {"error_sphere_column.dat", "error_sphere_column.png", "about.json"}) {
        CHECK(merged.at(file) == whole.at(file));
    }
    // And one process that has all pieces makes them again, to the byte.
    fs::copy(folder / "b/pieces", folder / "a/pieces",
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    require_success(folder, report + "--out a");
    CHECK(files_of(folder, "a") == merged);
}

TEST_CASE("what a report cannot do in shares is refused in one line") {
    check_refused("report atlas --shard 0/4", "--shard 0/4: must be K/N with 1 <= K <= N");
    check_refused("report atlas --shard 5/4", "--shard 5/4: must be K/N");
    check_refused("report atlas --shard 1", "--shard 1: must be K/N");
    check_refused("report cost --shard 1/2", "--shard 1/2: must be with report error, stability or atlas");
    check_refused("report error --shard 1/2 --export x", "--export x: must be without --shard");
    check_refused("report stability --shard 1/2 --junit x",
                  "--junit x: must be with report merge, not with --shard");
}

TEST_CASE("shards of a million pieces are even to one percent, and so are the folders that pieces are in") {
    std::map<std::uint64_t, long> of_shard, of_folder;
    std::set<std::uint64_t> hashes;
    for (int i = 0; i < 1000000; ++i) {
        const std::uint64_t hash = text_hash("atlas: x of pushfactor run stack --count " + std::to_string(i));
        hashes.insert(hash);
        ++of_folder[hash >> 56];
        for (int shard = 1; shard <= 7; ++shard)
            of_shard[static_cast<std::uint64_t>(shard)] += Shard{shard, 7}.takes(hash);
    }
    CHECK(hashes.size() == 1000000);
    REQUIRE(of_folder.size() == 256);
    for (const auto& [folder, count] : of_folder) CHECK(std::abs(count - 3906) < 390);
    long sum = 0;
    for (const auto& [shard, count] : of_shard) {
        CHECK(std::abs(count - 142857) < 1428);
        sum += count;
    }
    CHECK(sum == 1000000);
}

TEST_CASE("numbers that JSON lacks come back from a piece as they were") {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double> values{0.1, -1e-300, 1.0 / 3.0, infinity, -infinity};
    CHECK(numbers_in(parse_json(json_text(json_numbers(values), -1))) == values);
    CHECK(std::isnan(number_in(parse_json(json_text(json_number(std::nan("")), -1)))));
}
