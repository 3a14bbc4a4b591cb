#include "tests/peers/problems/fclib_file.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"

#include <fmt/format.h>

// Its header is for C.
extern "C" {
#include <fclib.h>
}
#include <hdf5.h>

#include <list>
#include <memory>
#include <vector>

namespace pushfactor::tests::problems {

namespace {

namespace fs = std::filesystem;
using demos::OutputError, demos::StagedFile, demos::UsageError;
using engine::VectorX;

// HDF5 prints a trace of its calls for each error; messages of ours say what is wrong.
class QuietHdf5 {
  public:
    QuietHdf5() {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

// Whether the file has this group; the library ends the program where it has not.
bool has_group(const fs::path& file, const char* group) {
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (id < 0) throw UsageError(fmt::format("{}: must be a file of FCLib (HDF5)", file.string()));
    const bool has = H5Lexists(id, group, H5P_DEFAULT) > 0;
    H5Fclose(id);
    return has;
}

void require(bool holds, const fs::path& file, const std::string& what) {
    if (!holds) throw UsageError(fmt::format("{}: {}", file.string(), what));
}

// In all forms of storage. The library's header says that in triplets p are rows and i columns; in its files, which
// Siconos writes, i are rows.
SparseMatrix matrix_of(const fclib_matrix& stored, const char* name, const fs::path& file) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int column, double value) {
        require(row >= 0 && row < stored.m && column >= 0 && column < stored.n, file,
                fmt::format("{}: entry ({}, {}) must be within {} x {}", name, row, column, stored.m, stored.n));
        entries.emplace_back(row, column, value);
    };
    if (stored.nz >= 0) {
        for (int k = 0; k < stored.nz; ++k) add(stored.i[k], stored.p[k], stored.x[k]);
    } else {
        const bool by_column = stored.nz == -1;
        for (int outer = 0; outer < (by_column ? stored.n : stored.m); ++outer) {
            for (int k = stored.p[outer]; k < stored.p[outer + 1]; ++k) {
                add(by_column ? stored.i[k] : outer, by_column ? outer : stored.i[k], stored.x[k]);
            }
        }
    }
    SparseMatrix matrix(stored.m, stored.n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

VectorX vector_of(const double* numbers, int count) {
    if (numbers == nullptr) return VectorX::Zero(count);
    return Eigen::Map<const VectorX>(numbers, count);
}

std::string title_of(const fclib_info* info, const fs::path& file) {
    const std::string title = info != nullptr && info->title != nullptr ? info->title : "";
    const std::string stem = file.stem().string();
    if (title.find(stem) != std::string::npos) return title;
    return title.empty() ? stem : title + ", " + stem;
}

GlobalProblem read_global(const fs::path& file) {
    const std::unique_ptr<fclib_global, void (*)(fclib_global*)> stored(fclib_read_global(file.c_str()),
                                                                        fclib_delete_global);
    require(stored != nullptr && stored->M != nullptr && stored->H != nullptr, file, "M and H must be there");
    require(stored->spacedim == 3, file, "spacedim must be 3");
    require(stored->G == nullptr, file, "G must be absent: equations are not supported");
    const int n = stored->M->m, rows = stored->H->n;
    require(
        stored->M->n == n && stored->H->m == n && rows % 3 == 0, file,
        fmt::format("M must be n x n and H n x 3c, not {} x {} and {} x {}", n, stored->M->n, stored->H->m, rows));
    return {.title = title_of(stored->info, file),
            .mass = matrix_of(*stored->M, "M", file),
            .axes = matrix_of(*stored->H, "H", file),
            .force = vector_of(stored->f, n),
            .given = vector_of(stored->w, rows),
            .mu = vector_of(stored->mu, rows / 3)};
}

LocalProblem read_local(const fs::path& file) {
    const std::unique_ptr<fclib_local, void (*)(fclib_local*)> stored(fclib_read_local(file.c_str()),
                                                                      fclib_delete_local);
    require(stored != nullptr && stored->W != nullptr, file, "W must be there");
    require(stored->spacedim == 3, file, "spacedim must be 3");
    require(stored->V == nullptr && stored->R == nullptr, file,
            "V and R must be absent: equations are not supported");
    const int rows = stored->W->m;
    require(stored->W->n == rows && rows % 3 == 0, file,
            fmt::format("W must be 3c x 3c, not {} x {}", rows, stored->W->n));
    return {.title = title_of(stored->info, file),
            .matrix = matrix_of(*stored->W, "W", file),
            .free = vector_of(stored->q, rows),
            .mu = vector_of(stored->mu, rows / 3)};
}

// Memory of a problem that is written; the library takes plain pointers.
class Stored {
  public:
    explicit Stored(const std::string& title) : title_(title) {
        info_.title = title_.data();
        info_.description = description_.data();
        info_.math_info = none_.data();
    }

    fclib_info* info() { return &info_; }

    // As triplets, as Siconos writes and reads them.
    fclib_matrix* matrix(const SparseMatrix& matrix) {
        Triplets& own = matrices_.emplace_back();
        for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
            for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
                own.rows.push_back(static_cast<int>(entry.row()));
                own.columns.push_back(static_cast<int>(entry.col()));
                own.values.push_back(entry.value());
            }
        }
        const int count = static_cast<int>(own.values.size());
        own.matrix = {.nzmax = count,
                      .m = static_cast<int>(matrix.rows()),
                      .n = static_cast<int>(matrix.cols()),
                      .p = own.columns.data(),
                      .i = own.rows.data(),
                      .x = own.values.data(),
                      .nz = count,
                      .info = nullptr};
        return &own.matrix;
    }

    double* vector(const VectorX& numbers) { return vectors_.emplace_back(numbers).data(); }

  private:
    struct Triplets {
        std::vector<int> rows, columns;
        std::vector<double> values;
        fclib_matrix matrix{};
    };

    std::string title_, description_ = "a step of pushfactor, impulses in N s", none_;
    fclib_info info_{};
    std::list<Triplets> matrices_;
    std::list<VectorX> vectors_;
};

// The library adds to a file that is there, so it gets a new one, which then replaces the other.
template <typename Write>
void write_whole(const fs::path& file, const Write& write) {
    const QuietHdf5 quiet;
    StagedFile staged(file, ".hdf5");
    std::error_code ignored;
    fs::remove(staged.path(), ignored);
    if (write(staged.path().c_str()) == 0) {
        throw OutputError(fmt::format("{}: HDF5 cannot write it", file.string()));
    }
    staged.commit();
}

}  // namespace

ContactProblem read_fclib(const fs::path& file) {
    const QuietHdf5 quiet;
    if (has_group(file, "/fclib_global")) return read_global(file);
    if (has_group(file, "/fclib_local")) return read_local(file);
    throw UsageError(fmt::format("{}: must have a group fclib_global or fclib_local", file.string()));
}

void write_fclib(const GlobalProblem& problem, const VectorX& impulses, const fs::path& file) {
    Stored stored(problem.title);
    fclib_global global{};
    global.M = stored.matrix(problem.mass);
    global.H = stored.matrix(problem.axes);
    global.f = stored.vector(problem.force);
    global.w = stored.vector(problem.given);
    global.mu = stored.vector(problem.mu);
    global.spacedim = 3;
    global.info = stored.info();
    fclib_solution solution{};
    if (impulses.size() > 0) {
        const VectorX velocity = velocities_of(problem, impulses);
        solution.v = stored.vector(velocity);
        solution.u = stored.vector(problem.axes.transpose() * velocity + problem.given);
        solution.r = stored.vector(impulses);
    }
    write_whole(file, [&](const char* path) {
        if (fclib_write_global(&global, path) == 0) return 0;
        return impulses.size() > 0 ? fclib_write_solution(&solution, path) : 1;
    });
}

void write_fclib(const LocalProblem& problem, const fs::path& file) {
    Stored stored(problem.title);
    fclib_local local{};
    local.W = stored.matrix(problem.matrix);
    local.q = stored.vector(problem.free);
    local.mu = stored.vector(problem.mu);
    local.spacedim = 3;
    local.info = stored.info();
    write_whole(file, [&](const char* path) { return fclib_write_local(&local, path); });
}

}  // namespace pushfactor::tests::problems
