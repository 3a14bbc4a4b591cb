// Contact problems, solved here and by Siconos. tests/compare has the commands of users.
//   problems solve OUT FILE|DIR [--quick]   files of FCLib: a page and problems.csv in OUT
//   problems write DIR                      .hdf5 files with our solution, of the JSON files that `pushfactor
//                                           report error --export DIR` has written there
//   problems agree DIR                      our solutions of these against the best of Siconos: errors, velocities,
//                                           and impulses, which differ in the null space of W
#include "demos/base/platform/messages.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "tests/peers/problems/fclib_file.h"
#include "tests/peers/problems/frozen_file.h"
#include "tests/peers/problems/problem_report.h"
#include "tests/peers/problems/siconos.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace pushfactor::demos;
using namespace pushfactor::tests::problems;
using pushfactor::engine::VectorX;

// The file, or all of a folder, by name.
std::vector<fs::path> files_in(const fs::path& given, const char* extension) {
    if (!fs::is_directory(given)) return {given};
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(given)) {
        if (entry.path().extension() == extension) files.push_back(entry.path());
    }
    if (files.empty())
        throw UsageError(fmt::format("{}: must have files that end in {}", given.string(), extension));
    std::sort(files.begin(), files.end());
    return files;
}

void solve(const fs::path& out, const fs::path& given, bool quick) {
    std::vector<ContactProblem> problems;
    for (const fs::path& file : files_in(given, ".hdf5")) problems.push_back(read_fclib(file));
    report_problems(problems, quick, siconos_points, out);
    print((out / "index.html").string() + "\n");
}

// Calls `use` with every exported problem of contacts alone, its file and our solution.
template <typename Use>
void for_each_exported(const fs::path& folder, const Use& use) {
    for (const fs::path& file : files_in(folder, ".json")) {
        stop_if_interrupted(file.string());
        const auto global = global_form(read_frozen(file));
        if (!global) continue;
        use(file, *global, best_impulses(rows_over_bodies(*global), local_form(*global)));
    }
}

void write(const fs::path& folder) {
    for_each_exported(folder, [](fs::path file, const GlobalProblem& problem, const VectorX& impulses) {
        write_fclib(problem, impulses, file.replace_extension(".hdf5"));
        print(file.string() + "\n");
    });
}

void agree(const fs::path& folder) {
    if (!has_siconos()) throw UsageError("agree: must be built where libsiconos-numerics-dev is installed");
    print("problem,our_error,their_error,velocity_difference_m_per_s,impulse_difference\n");
    for_each_exported(folder, [](const fs::path&, const GlobalProblem& problem, const VectorX& ours) {
        const LocalProblem local = local_form(problem);
        const VectorX theirs = best_of_siconos(local), difference = ours - theirs;
        print(fmt::format("{},{:.1e},{:.1e},{:.1e},{:.1e}\n", local.title, contact_errors(local, ours).siconos,
                          contact_errors(local, theirs).siconos,
                          (local.matrix * difference).lpNorm<Eigen::Infinity>(),
                          difference.norm() / std::max(theirs.norm(), 1e-300)));
    });
}

void carry_out(const std::vector<std::string>& words) {
    const std::string what = words.empty() ? "" : words.front();
    const bool quick = words.size() == 4 && words.back() == "--quick";
    if (what == "solve" && (words.size() == 3 || quick)) return solve(words[1], words[2], quick);
    if (what == "write" && words.size() == 2) return write(words[1]);
    if (what == "agree" && words.size() == 2) return agree(words[1]);
    throw UsageError("must be solve OUT FILE|DIR [--quick], write DIR or agree DIR");
}

int complain(const std::exception& error, ExitStatus status) {
    say("problems: " + one_line(error.what()) + "\n");
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    note_interrupts();
    try {
        carry_out({argv + 1, argv + argc});
        return done;
    } catch (const UsageError& error) {
        return complain(error, bad_usage);
    } catch (const std::exception& error) {
        return complain(error, run_failed);
    }
}
