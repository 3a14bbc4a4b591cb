// Files of FCLib keep every bit, and the program `problems` solves them.
#include "tests/catch.h"
#include "tests/skip.h"

#if PUSHFACTOR_FCLIB

#include "demos/reports/error/error.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"
#include "tests/peers/problems/fclib_file.h"
#include "tests/peers/problems/rows_of_contacts.h"

using namespace pushfactor::demos::reports::error;
using namespace pushfactor::tests;
using namespace pushfactor::tests::problems;

namespace {

bool same(const SparseMatrix& a, const SparseMatrix& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && (a.toDense() - b.toDense()).isZero(0.0);
}

}  // namespace

TEST_CASE("a file of FCLib keeps every bit of a problem, global or local") {
    const Folder folder;
    for (const ContactMoment& moment : contact_moments(true)) {
        INFO(moment.name);
        const GlobalProblem global = *global_form(freeze(moment.name, moment.choices, [] {}));
        for (int twice = 0; twice < 2; ++twice)
            write_fclib(global, {}, folder / "problem.hdf5");  // and replaces a file
        const ContactProblem read = read_fclib(folder / "problem.hdf5");
        const GlobalProblem& again = std::get<GlobalProblem>(read);
        CHECK(same(again.mass, global.mass));
        CHECK(same(again.axes, global.axes));
        CHECK(again.force == global.force);
        CHECK(again.given == global.given);
        CHECK(again.mu == global.mu);

        const LocalProblem local = local_form(global);
        write_fclib(local, folder / "local.hdf5");
        const ContactProblem read_local = read_fclib(folder / "local.hdf5");
        CHECK(same(std::get<LocalProblem>(read_local).matrix, local.matrix));
        CHECK(std::get<LocalProblem>(read_local).free == local.free);
        CHECK(std::get<LocalProblem>(read_local).mu == local.mu);
    }
    CHECK(folder.files() == std::vector<std::string>{"local.hdf5", "problem.hdf5"});
}

TEST_CASE("exported problems become files of FCLib, and are solved on a page") {
    const Folder folder;
    require_success(folder, "pushfactor report error --quick --only frozen --export problems --out exported");
    require_success(folder, "'" PUSHFACTOR_PROBLEMS "' write problems");
    require_success(folder, "'" PUSHFACTOR_PROBLEMS "' solve page problems --quick");
    check_page(folder.read("page/index.html"));
    const std::string table = folder.read("page/problems.csv");
    for (const char* const name : {"stack_1", "heap_1", "wall_1", "cards_1", "arch_1"}) {
        INFO(name);
        CHECK(table.find(name) != std::string::npos);
    }
    CHECK(std::filesystem::exists(folder / "page/profile_1e-04.dat"));
}

TEST_CASE("what is no contact problem is refused in one line") {
    const Folder folder;
    folder.write("text.hdf5", "no HDF5");
    std::filesystem::create_directory(folder / "empty");
    const std::string solve = "'" PUSHFACTOR_PROBLEMS "' solve page ";
    check_refused(folder, solve + "empty", "empty: must have files that end in .hdf5");
    check_refused(folder, solve + "text.hdf5", "text.hdf5: must be a file of FCLib (HDF5)");
    check_refused(folder, solve + "none.hdf5", "none.hdf5: must be a file of FCLib (HDF5)");
    check_refused(folder, "'" PUSHFACTOR_PROBLEMS "' read empty", "must be solve OUT FILE|DIR");
}

#else

TEST_CASE("files of FCLib keep every bit of a problem, and are solved on a page") {
    pushfactor::tests::skip("FCLib is not installed (packages libfclib-dev and libhdf5-dev)");
}

#endif
