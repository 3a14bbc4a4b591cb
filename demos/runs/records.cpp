#include "demos/runs/records.h"

#include "demos/runs/measured_errors.h"
#include "demos/runs/trajectory.h"
#include "demos/scenes/motions/pose_reader.h"

#include <fmt/format.h>

#include <iterator>

namespace pushfactor::demos {

namespace {

using engine::Body;
using engine::Vector3;

// Lines are buffered.
class CsvRecord : public Record {
  public:
    CsvRecord(const std::filesystem::path& path, std::string_view header) : file_(path) {
        lines_ = std::string(header) + "\n";
    }
    void finish() override {
        flush();
        file_.commit();
    }
    std::string file_name() const override { return file_.name(); }

  protected:
    template <typename... Values>
    void line(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(lines_), format, std::forward<Values>(values)...);
        if (lines_.size() > 65536) flush();
    }

  private:
    void flush() {
        file_.write(lines_);
        lines_.clear();
    }

    OutputFile file_;
    std::string lines_;
};

class StepsRecord : public CsvRecord {
  public:
    StepsRecord(const std::filesystem::path& path, bool timing)
        : CsvRecord(path, std::string("step,time_s,kinetic_energy_j,potential_energy_j,max_speed_m_per_s,"
                                      "max_penetration_m,rms_penetration_m,max_length_error_m,residual_m_per_s,"
                                      "contacts,rows,columns,substeps,sweeps,islands,islands_kept,islands_swept,"
                                      "islands_exact,islands_in_small_steps,islands_unsolved,bodies_at_rest") +
                              (timing ? ",step_us" : "")) {}

    void observe(const Simulation& simulation) override {
        const Sample& s = simulation.sample();
        line("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", s.step, s.time, s.kinetic_energy,
             s.potential_energy, s.max_speed, s.penetration.max, s.penetration.rms, s.max_length_error, s.residual,
             s.count.rows(engine::RowKind::contact), s.count.rows(), s.count.columns, s.substeps, s.count.sweeps,
             s.count.islands, s.count.islands_kept, s.count.islands_swept, s.count.islands_exact,
             s.count.islands_in_small_steps, s.count.islands_unsolved, s.count.at_rest);
        if (s.cpu_us) line(",{}", *s.cpu_us);
        line("\n");
    }
};

class TrajectoryRecord : public CsvRecord {
  public:
    TrajectoryRecord(const std::filesystem::path& path, long every, std::uint32_t hash, const Simulation& start)
        : CsvRecord(path, std::string(pose_columns) +
                              ",vx_m_per_s,vy_m_per_s,vz_m_per_s,wx_rad_per_s,wy_rad_per_s,wz_rad_per_s" +
                              hash_column),
          every_(every),
          hash_(hash) {
        observe(start);
    }

    void observe(const Simulation& simulation) override {
        if (simulation.sample().step % every_ != 0) return;
        const auto& bodies = simulation.scene().world.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!is_recorded(simulation.scene(), i)) continue;
            const Body& body = bodies[i];
            const Vector3 v = velocity(body);
            const Vector3 w = angular_velocity(body);
            line("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", simulation.sample().time, i,
                 body.position.x(), body.position.y(), body.position.z(), body.orientation.w(),
                 body.orientation.x(), body.orientation.y(), body.orientation.z(), v.x(), v.y(), v.z(), w.x(),
                 w.y(), w.z(), hash_);
        }
    }

  private:
    long every_;
    std::uint32_t hash_;
};

std::string_view name_of(engine::RowKind kind) {
    switch (kind) {
        case engine::RowKind::friction:
            return "friction";
        case engine::RowKind::distance:
            return "distance";
        case engine::RowKind::joint:
            return "joint";
        case engine::RowKind::motor:
            return "motor";
        case engine::RowKind::limit:
            return "limit";
        case engine::RowKind::spring:
            return "spring";
        case engine::RowKind::contact:
            break;
    }
    return "contact";
}

class RowsRecord : public CsvRecord {
  public:
    explicit RowsRecord(const std::filesystem::path& path)
        : CsvRecord(path,
                    "step,time_s,kind,body_a,body_b,point,gap_m,push_correcting_m_per_s,push_lasting_m_per_s,"
                    "c_min_n,c_max_n,lambda_first_n,lambda_last_n") {}

    void observe(const Simulation& simulation) override {
        const Sample& sample = simulation.sample();
        const engine::World& world = simulation.scene().world;
        const engine::Columns& lambda = world.lambda();
        const Eigen::Index last = lambda.cols() - 1;
        for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
            const engine::ConstraintRow& row = world.rows()[static_cast<std::size_t>(j)];
            const auto [low, high] = bounds_of(row, lambda, last);
            line("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", sample.step, sample.time, name_of(row.label.kind),
                 row.body_a, row.body_b, row.label.point, row.label.gap, row.push.correcting, row.push.lasting, low,
                 high, lambda(j, 0), lambda(j, last));
        }
    }
};

class ErrorsRecord : public CsvRecord {
  public:
    ErrorsRecord(const std::filesystem::path& path, const Simulation& start)
        : CsvRecord(path, "time_s,body,distance_m,angle_deg"), errors_(start.scene()) {
        observe(start);
    }

    void observe(const Simulation& simulation) override {
        for (const MeasuredError& error : errors_.at(simulation)) {
            line("{},{},{},{}\n", simulation.sample().time, error.body, error.distance, error.angle);
        }
    }

  private:
    MeasuredErrors errors_;
};

}  // namespace

std::unique_ptr<Record> steps_record(const std::filesystem::path& path, bool timing) {
    return std::make_unique<StepsRecord>(path, timing);
}

std::unique_ptr<Record> trajectory_record(const std::filesystem::path& path, long every, std::uint32_t hash,
                                          const Simulation& start) {
    return std::make_unique<TrajectoryRecord>(path, every, hash, start);
}

std::unique_ptr<Record> rows_record(const std::filesystem::path& path) {
    return std::make_unique<RowsRecord>(path);
}

std::unique_ptr<Record> errors_record(const std::filesystem::path& path, const Simulation& start) {
    return std::make_unique<ErrorsRecord>(path, start);
}

}  // namespace pushfactor::demos
