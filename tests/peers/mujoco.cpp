// MuJoCo. A link is a ball joint of its tree of bodies (generalised coordinates: the length cannot err), at the end
// of an arm that is fixed to the lower body.
#include "tests/peers/engine.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace pushfactor::tests::peers {

namespace {

struct MujocoOptions {
    int substeps = 1;
    std::string options = {};  // attributes of <option>
};

std::string numbers(const Vector3& v) {
    return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

std::string numbers(const Quaternion& q) {
    return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(), q.z());
}

// It has no restitution, but springs with dampers: that part of critical damping with which a spring that is let
// go of once gives the speed back times the restitution.
std::string spring_of(const Body& body) {
    if (body.restitution <= 0.0) return "";
    const double decay = -std::log(body.restitution);
    return fmt::format(R"( solref="0.02 {:.17g}")", decay / std::hypot(std::numbers::pi, decay));
}

std::string geometry(const Body& body, bool collides) {
    std::string shape;
    switch (body.shape) {
        case Shape::plane:
            shape = R"(type="plane" size="0 0 1")";
            break;
        case Shape::box:
            shape = fmt::format(R"(type="box" size="{}")", numbers(0.5 * body.size));
            break;
        case Shape::sphere:
            shape = fmt::format(R"(type="sphere" size="{:.17g}")", body.radius);
            break;
    }
    const std::string mass = body.mass > 0.0 ? fmt::format(R"( mass="{:.17g}")", body.mass) : std::string();
    return shape + mass + fmt::format(R"( friction="{:.17g} 0.005 0.0001")", body.friction) + spring_of(body) +
           (collides ? "" : R"( contype="0" conaffinity="0")");
}

// The model file: free bodies, or a tree of those that hang on links.
class Model {
  public:
    Model(const Scene& scene, const MujocoOptions& options) : scene_(scene), states_(starts(scene)) {
        // It keeps memory for all of them.
        const std::size_t rows = std::min<std::size_t>(6000, 200 * (1 + scene.movable.size()));
        text_ = fmt::format(R"(<mujoco><size njmax="{}" nconmax="{}"/>)"
                            R"(<option timestep="{:.17g}" gravity="{}" {}/><worldbody>)",
                            rows, rows / 4, scene.step / options.substeps, numbers(scene.gravity), options.options);
        const Quaternion up(
            Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vector3::UnitX()));  // its planes look along z
        for (const Body& body : scene.fixed) {
            const Quaternion q = body.shape == Shape::plane ? body.start.orientation * up : body.start.orientation;
            text_ += fmt::format(R"(<geom {} pos="{}" quat="{}"/>)", geometry(body, scene.contacts),
                                 numbers(body.start.position), numbers(q));
        }
        add_hanging(-1);
        for (std::size_t i = 0; i < scene.movable.size(); ++i) {
            if (!hangs(static_cast<int>(i))) open_body(static_cast<int>(i), State{}, "<freejoint/>");
            if (!hangs(static_cast<int>(i))) text_ += "</body>";
        }
        text_ += "</worldbody></mujoco>";
    }

    const std::string& text() const { return text_; }

  private:
    bool hangs(int body) const {
        return std::any_of(scene_.links.begin(), scene_.links.end(), [&](const Link& l) { return l.b == body; });
    }

    void add_hanging(int parent) {
        const State frame = parent < 0 ? State{} : states_[static_cast<std::size_t>(parent)];
        for (const Link& link : scene_.links) {
            if (link.a != parent) continue;
            const State& s = states_[static_cast<std::size_t>(link.b)];
            const Vector3 arm = s.orientation.conjugate() * (end_a(link, states_) - s.position);
            open_body(link.b, frame, fmt::format(R"(<joint type="ball" pos="{}"/>)", numbers(arm)));
            add_hanging(link.b);
            text_ += "</body>";
        }
    }

    void open_body(int place, const State& frame, const std::string& joint) {
        const Body& body = scene_.movable[static_cast<std::size_t>(place)];
        const Quaternion back = frame.orientation.conjugate();
        text_ += fmt::format(R"(<body name="b{}" pos="{}" quat="{}">{}{}<geom {}/>)", place,
                             numbers(back * (body.start.position - frame.position)),
                             numbers(back * body.start.orientation), joint, mass_of(body),
                             geometry(body, scene_.contacts));
    }

    // Instead of what it would compute of the shape.
    static std::string mass_of(const Body& body) {
        if (body.moments.isZero()) return "";
        return fmt::format(R"(<inertial pos="0 0 0" mass="{:.17g}" diaginertia="{}"/>)", body.mass,
                           numbers(body.moments));
    }

    const Scene& scene_;
    std::vector<State> states_;
    std::string text_;
};

mjModel* load(const std::string& text) {
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()));
    std::memcpy(files->filedata[0], text.data(), text.size());
    std::string error(1000, '\0');
    mjModel* model = mj_loadXML("scene.xml", files.get(), error.data(), static_cast<int>(error.size()));
    mj_deleteVFS(files.get());
    if (model == nullptr) throw std::runtime_error("MuJoCo: " + error);
    return model;
}

void quiet(const char*) {}

class MujocoWorld : public World {
  public:
    MujocoWorld(const Scene& scene, const MujocoOptions& options)
        : substeps_(options.substeps), model_(load(Model(scene, options).text())), data_(mj_makeData(model_)) {
        mju_user_warning = quiet;  // else it writes a log file
        for (std::size_t i = 0; i < scene.movable.size(); ++i) {
            const int id = mj_name2id(model_, mjOBJ_BODY, fmt::format("b{}", i).c_str());
            ids_.push_back(id);
            const int joint = model_->body_jntadr[id];
            if (model_->jnt_type[joint] == mjJNT_FREE)
                set_velocity(model_->jnt_dofadr[joint], scene.movable[i].start);
        }
        refresh();
    }

    ~MujocoWorld() override {
        mj_deleteData(data_);
        mj_deleteModel(model_);
    }

    MujocoWorld(const MujocoWorld&) = delete;
    MujocoWorld& operator=(const MujocoWorld&) = delete;

    void step() override {
        for (int i = 0; i < substeps_; ++i) mj_step(model_, data_);
    }

    std::vector<State> states() const override {
        refresh();
        std::vector<State> result;
        for (const int id : ids_) {
            State s;
            std::array<mjtNum, 6> rates{};  // turning, then moving
            mj_objectVelocity(model_, data_, mjOBJ_BODY, id, rates.data(), 0);
            s.position = Eigen::Map<const Vector3>(data_->xipos + 3 * id);
            const mjtNum* q = data_->xquat + 4 * id;
            s.orientation = Quaternion(q[0], q[1], q[2], q[3]);
            s.angular_velocity = {rates[0], rates[1], rates[2]};
            s.velocity = {rates[3], rates[4], rates[5]};
            // It starts again from the beginning after a bad step.
            if (gave_up()) s.position.setConstant(std::numeric_limits<double>::quiet_NaN());
            result.push_back(s);
        }
        return result;
    }

  private:
    // After a step the body poses and velocities are those before it; this updates them without touching forces or
    // caches.
    void refresh() const {
        mj_kinematics(model_, data_);
        mj_comPos(model_, data_);
        mj_comVel(model_, data_);
    }

    bool gave_up() const {
        return data_->warning[mjWARN_BADQPOS].number > 0 || data_->warning[mjWARN_BADQVEL].number > 0 ||
               data_->warning[mjWARN_BADQACC].number > 0;
    }

    void set_velocity(int address, const State& s) {
        const Vector3 turning = s.orientation.conjugate() * s.angular_velocity;  // of a free joint: body frame
        for (int k = 0; k < 3; ++k) {
            data_->qvel[address + k] = s.velocity[k];
            data_->qvel[address + 3 + k] = turning[k];
        }
    }

    int substeps_;
    mjModel* model_;
    mjData* data_;
    std::vector<int> ids_;
};

Setting setting(const std::string& name, const std::vector<std::string>& cases, const MujocoOptions& options) {
    Setting result;
    result.engine = std::string("MuJoCo ") + mj_versionString();
    result.name = name;
    result.cases = cases;
    result.joint = Joint::rigid_arm;
    result.substeps = options.substeps;
    if (options.options.find("RK4") != std::string::npos) result.velocity_lag = 0.0;
    result.build = [options](const Scene& scene) { return std::make_unique<MujocoWorld>(scene, options); };
    return result;
}

}  // namespace

std::vector<Setting> mujoco_settings() {
    return {
        setting("as shipped, but 60 Hz", {}, {}),
        setting("4 substeps", {"tosses"}, {.substeps = 4}),
        setting("4 substeps, elliptic cones, impratio 10", {"tosses"},
                {.substeps = 4, .options = R"(cone="elliptic" impratio="10")"}),
        // Its own default is 500 Hz: contacts as stiff as it ships them.
        setting("8 substeps", {}, {.substeps = 8}),
        setting("8 substeps, elliptic cones, impratio 10", {"stack", "tower", "heavy", "funnel"},
                {.substeps = 8, .options = R"(cone="elliptic" impratio="10")"}),
        setting("implicit", {"chain", "chain-light", "wave", "free-box", "free-rod"},
                {.options = R"(integrator="implicit")"}),
        setting("RK4", {"chain", "chain-light", "wave", "free-box", "free-rod"},
                {.options = R"(integrator="RK4")"}),
    };
}

std::vector<Series> mujoco_series() {
    const auto over = [](const std::string& name, const std::string& knob, const std::vector<int>& values,
                         const std::vector<std::string>& cases, auto options_at) {
        return Series{"MuJoCo, " + name, knob, values, cases,
                      [options_at](int value) { return setting("", {}, options_at(value)); }};
    };
    const std::vector<std::string> contacts{"stack", "brick_wall", "pile_of_cubes"},
        links{"pendulum-wave", "chain"};
    return {
        over("Newton", "substeps", {1, 2, 4, 8, 16}, contacts,
             [](int value) { return MujocoOptions{.substeps = value}; }),
        over("PGS, 8 small steps", "sweeps", {1, 5, 25, 100}, contacts,
             [](int value) {
                 return MujocoOptions{.substeps = 8,
                                      .options = fmt::format(R"(solver="PGS" iterations="{}")", value)};
             }),
        over("as shipped", "substeps", {1, 2, 4, 8, 16, 32, 64}, links,
             [](int value) { return MujocoOptions{.substeps = value}; }),
        over("RK4", "substeps", {1, 2, 4, 8, 16, 32, 64}, links,
             [](int value) { return MujocoOptions{.substeps = value, .options = R"(integrator="RK4")"}; }),
    };
}

}  // namespace pushfactor::tests::peers
