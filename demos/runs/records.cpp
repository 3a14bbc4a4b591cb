#include "demos/runs/records.h"

#include "demos/base/text/errors.h"
#include "demos/runs/measured_errors.h"
#include "demos/runs/trajectory.h"
#include "demos/scenes/motions/pose_reader.h"

#include <fmt/format.h>

#include <array>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

// What a file has of a simulation as it is now.
using LinesOf = std::function<std::string(const Simulation& simulation)>;

class CsvRecord : public Record {
  public:
    CsvRecord(const std::filesystem::path& path, std::string_view header, LinesOf lines_of)
        : file_(path), lines_of_(std::move(lines_of)) {
        file_.write(std::string(header) + "\n");
    }

    void observe(const Simulation& simulation) override { file_.write(lines_of_(simulation)); }
    void finish() override { file_.commit(); }
    std::string file_name() const override { return file_.name(); }

  private:
    OutputFile file_;
    LinesOf lines_of_;
};

std::unique_ptr<Record> from_start(std::unique_ptr<Record> record, const Simulation& start) {
    record->observe(start);
    return record;
}

}  // namespace

std::string kept(const std::string& file, const std::string& until, const std::function<void()>& finish) {
    try {
        finish();
        return fmt::format("pushfactor: note: {} holds the run up to {}, where it stopped\n", file, until);
    } catch (const OutputError& error) {
        return fmt::format("pushfactor: note: {}\n", error.what());
    }
}

std::string_view name_of(engine::RowKind kind) {
    constexpr std::array<std::string_view, engine::row_kind_count> names{"contact", "friction", "distance", "joint",
                                                                         "motor",   "limit",    "spring"};
    return names[static_cast<std::size_t>(kind)];
}

std::unique_ptr<Record> steps_record(const std::filesystem::path& path, bool timing) {
    const std::string columns =
        "step,time_s,kinetic_energy_j,potential_energy_j,max_speed_m_per_s,max_penetration_m,rms_penetration_m,"
        "max_length_error_m,residual_m_per_s,contacts,rows,columns,substeps,sweeps,islands,islands_kept,"
        "islands_swept,islands_exact,islands_in_small_steps,islands_unsolved,bodies_at_rest";
    return std::make_unique<CsvRecord>(path, columns + (timing ? ",step_us" : ""), [](const Simulation& now) {
        const Sample& s = now.sample();
        return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}\n", s.step, s.time,
                           s.kinetic_energy, s.potential_energy, s.max_speed, s.penetration.max, s.penetration.rms,
                           s.max_length_error, s.residual, s.count.rows(engine::RowKind::contact), s.count.rows(),
                           s.count.columns, s.substeps, s.count.sweeps, s.count.islands, s.count.islands_kept,
                           s.count.islands_swept, s.count.islands_exact, s.count.islands_in_small_steps,
                           s.count.islands_unsolved, s.count.at_rest,
                           s.cpu_us ? fmt::format(",{}", *s.cpu_us) : "");
    });
}

std::unique_ptr<Record> trajectory_record(const std::filesystem::path& path, long every, std::uint32_t hash,
                                          const Simulation& start) {
    const std::string columns =
        std::string(pose_columns) + ",vx_m_per_s,vy_m_per_s,vz_m_per_s,wx_rad_per_s,wy_rad_per_s,wz_rad_per_s";
    const auto lines_of = [every, hash](const Simulation& now) {
        std::string lines;
        if (now.sample().step % every != 0) return lines;
        const auto& bodies = now.scene().world.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!is_recorded(now.scene(), i)) continue;
            const Vector3 &x = bodies[i].position, v = velocity(bodies[i]), w = angular_velocity(bodies[i]);
            const engine::Quaternion& q = bodies[i].orientation;
            lines +=
                fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", now.sample().time, i, x.x(), x.y(),
                            x.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z(), hash);
        }
        return lines;
    };
    return from_start(std::make_unique<CsvRecord>(path, columns + hash_column, lines_of), start);
}

std::unique_ptr<Record> rows_record(const std::filesystem::path& path) {
    const char* const columns =
        "step,time_s,kind,body_a,body_b,point,gap_m,push_correcting_m_per_s,push_lasting_m_per_s,"
        "c_min_n,c_max_n,lambda_first_n,lambda_last_n";
    return std::make_unique<CsvRecord>(path, columns, [](const Simulation& now) {
        std::string lines;
        const engine::Columns& lambda = now.scene().world.lambda();
        const Eigen::Index last = lambda.cols() - 1;
        for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
            const engine::ConstraintRow& row = now.scene().world.rows()[static_cast<std::size_t>(j)];
            const auto [low, high] = bounds_of(row, lambda, last);
            lines += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", now.sample().step, now.sample().time,
                                 name_of(row.label.kind), row.body_a, row.body_b, row.label.point, row.label.gap,
                                 row.push.correcting, row.push.lasting, low, high, lambda(j, 0), lambda(j, last));
        }
        return lines;
    });
}

std::unique_ptr<Record> errors_record(const std::filesystem::path& path, const Simulation& start) {
    const auto lines_of = [errors = MeasuredErrors(start.scene())](const Simulation& now) {
        std::string lines;
        for (const MeasuredError& error : errors.at(now)) {
            lines += fmt::format("{},{},{},{}\n", now.sample().time, error.body, error.distance, error.angle);
        }
        return lines;
    };
    return from_start(std::make_unique<CsvRecord>(path, "time_s,body,distance_m,angle_deg", lines_of), start);
}

}  // namespace pushfactor::demos
