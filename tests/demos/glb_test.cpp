// --glb: glTF files, read by the reader of this file, by assimp and by the validator of Khronos.
#include "demos/options/named_run.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/gltf/tracks.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/scenes/catalogue.h"
#include "demos/text/json.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/program.h"
#include "tests/random.h"

#if PUSHFACTOR_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#endif

#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <set>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;
using engine::Quaternion;
using engine::Vector3;
using pictures::gltf::Segment;

namespace {

// What this machine lacks; ctest then reports the test as skipped.
void skip(const std::string& why) {
    std::cout << "skipped: " << why << "\n";
}

template <typename Number>
Number number_at(const std::string& bytes, std::size_t offset) {
    Number number{};
    REQUIRE(offset + sizeof number <= bytes.size());
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

// A .glb file, taken apart as the specification says (sections 4.4 and 3.6.2).
struct Glb {
    Json json;
    std::string binary;

    explicit Glb(const std::string& file) {
        REQUIRE(file.size() >= 20);
        REQUIRE(file.substr(0, 4) == "glTF");
        REQUIRE(number_at<std::uint32_t>(file, 4) == 2);
        REQUIRE(number_at<std::uint32_t>(file, 8) == file.size());
        const auto length = number_at<std::uint32_t>(file, 12);
        REQUIRE(length % 4 == 0);
        REQUIRE(file.substr(16, 4) == "JSON");
        json = Json::parse(file.substr(20, length));
        const std::size_t at = 20 + length;
        const auto binary_length = number_at<std::uint32_t>(file, at);
        REQUIRE(binary_length % 4 == 0);
        REQUIRE(file.substr(at + 4, 4) == std::string("BIN\0", 4));
        REQUIRE(at + 8 + binary_length == file.size());
        binary = file.substr(at + 8);
    }

    std::size_t count(std::size_t accessor) const { return json["accessors"][accessor]["count"]; }

    // Numbers of an accessor, one after the other.
    std::vector<double> numbers(std::size_t accessor) const {
        const Json& described = json["accessors"][accessor];
        const Json& view = json["bufferViews"][described["bufferView"].get<std::size_t>()];
        const bool is_float = described["componentType"] == 5126;
        REQUIRE((is_float || described["componentType"] == 5123));
        const std::size_t size = is_float ? 4 : 2;
        const std::map<std::string, std::size_t> parts{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
        const std::size_t each = parts.at(described["type"]);
        const std::size_t start = described["byteOffset"].get<std::size_t>();
        CHECK(start % size == 0);
        CHECK(view["byteOffset"].get<std::size_t>() % 4 == 0);
        if (view.contains("byteStride")) CHECK(view["byteStride"] == each * size);
        REQUIRE(start + count(accessor) * each * size <= view["byteLength"].get<std::size_t>());
        std::vector<double> found;
        for (std::size_t i = 0; i < count(accessor) * each; ++i) {
            const std::size_t at = view["byteOffset"].get<std::size_t>() + start + i * size;
            found.push_back(is_float ? number_at<float>(binary, at) : number_at<std::uint16_t>(binary, at));
        }
        return found;
    }

    std::size_t node(const std::string& name) const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
            if (json["nodes"][i]["name"] == name) found.push_back(i);
        }
        INFO(name);
        REQUIRE(found.size() == 1);
        return found.front();
    }

    // The sampler that moves a property of a node; null without.
    const Json* sampler(std::size_t node, const std::string& path) const {
        if (!json.contains("animations")) return nullptr;
        const Json& animation = json["animations"][0];
        for (const Json& channel : animation["channels"]) {
            if (channel["target"]["node"] == node && channel["target"]["path"] == path) {
                return &animation["samplers"][channel["sampler"].get<std::size_t>()];
            }
        }
        return nullptr;
    }

    // A property at a time that is that of a key, or of all keys before it [s].
    std::vector<double> value(std::size_t node, const std::string& path, double time) const {
        const Json* const moved = sampler(node, path);
        if (!moved) {
            const Json& property = json["nodes"][node];
            if (property.contains(path)) return property[path];
            return path == "rotation" ? std::vector<double>{0, 0, 0, 1} : std::vector<double>(3, path == "scale");
        }
        const std::vector<double> times = numbers((*moved)["input"]), all = numbers((*moved)["output"]);
        const std::size_t each = path == "rotation" ? 4 : 3;
        std::size_t key = 0;
        while (key + 1 < times.size() && times[key + 1] < time + 1e-5) ++key;
        return {all.begin() + static_cast<std::ptrdiff_t>(each * key),
                all.begin() + static_cast<std::ptrdiff_t>(each * (key + 1))};
    }

    Vector3 vector(std::size_t node, const std::string& path, double time) const {
        return Vector3(value(node, path, time).data());
    }
    Quaternion rotation(std::size_t node, double time) const {
        return Quaternion(value(node, "rotation", time).data());
    }
};

// The file of a run in this process; `observe` is called with each state that has a key.
Glb recorded(const Choices& choices, const std::function<void(const Simulation&)>& observe = {}) {
    const Folder folder;
    Simulation run(choices);
    const std::vector<ComparedRun> runs{{.label = "", .choices = choices}};
    const long steps = whole_steps(choices.settings);
    pictures::Survey survey;
    if (pictures::needs_survey(choices.frames)) {
        survey = pictures::survey(runs, {plan_frames(choices.frames, choices.settings.dt, steps)});
    }
    const auto record = pictures::glb_record(folder / "a.glb", choices, survey, run);
    if (observe) observe(run);
    while (run.sample().step < steps) {
        run.advance();
        record->observe(run);
        if (observe) observe(run);
    }
    record->finish();
    return Glb(folder.read("a.glb"));
}

// The lines of a trajectory by body and then by key: x, y, z, qw, qx, qy, qz.
using Trajectory = std::map<int, std::vector<std::array<double, 7>>>;
Trajectory trajectory_of(const std::string& csv) {
    Trajectory found;
    const auto table = table_of(csv);
    for (std::size_t line = 1; line < table.size(); ++line) {
        std::array<double, 7> pose{};
        for (std::size_t i = 0; i < 7; ++i) pose[i] = std::stod(table[line][i + 2]);
        found[std::stoi(table[line][1])].push_back(pose);
    }
    return found;
}

// How far two poses are apart: the largest difference of any coordinate, or of any part of the quaternions, whose
// sign has no meaning.
double apart(const std::array<double, 7>& a, const Vector3& position, const Quaternion& rotation) {
    const Eigen::Vector4d q(a[4], a[5], a[6], a[3]);
    const double turned =
        std::min((q - rotation.coeffs()).cwiseAbs().maxCoeff(), (q + rotation.coeffs()).cwiseAbs().maxCoeff());
    return std::max((Vector3(a.data()) - position).cwiseAbs().maxCoeff(), turned);
}

// Half a second of a named scene, run as a user does.
struct Written {
    Folder folder;
    Trajectory trajectory;

    explicit Written(const std::string& scene) {
        const Ended ended =
            shell(folder, "pushfactor run " + scene +
                              " --seconds 0.5 --fps 60 --glb a.glb --trajectory a.csv --summary /dev/null");
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        trajectory = trajectory_of(folder.read("a.csv"));
        REQUIRE(!trajectory.empty());
    }
};

// Every part of a file that the specification wants, and every number within it.
void check_sound(const Glb& glb) {
    const Json& json = glb.json;
    CHECK(json["asset"]["version"] == "2.0");
    std::size_t end = 0;
    for (const Json& view : json["bufferViews"]) {
        CHECK(view["byteOffset"] == end);
        end += view["byteLength"].get<std::size_t>();
    }
    CHECK(json["buffers"] == Json::array({{{"byteLength", end}}}));
    CHECK(end == glb.binary.size());

    const auto check_bounds = [&](std::size_t accessor, std::size_t each) {
        const std::vector<double> numbers = glb.numbers(accessor);
        for (std::size_t part = 0; part < each; ++part) {
            double low = numbers[part], high = numbers[part];
            for (std::size_t i = part; i < numbers.size(); i += each) {
                low = std::min(low, numbers[i]);
                high = std::max(high, numbers[i]);
            }
            CHECK(static_cast<float>(json["accessors"][accessor]["min"][part].get<double>()) ==
                  static_cast<float>(low));
            CHECK(static_cast<float>(json["accessors"][accessor]["max"][part].get<double>()) ==
                  static_cast<float>(high));
        }
    };
    for (const Json& mesh : json["meshes"]) {
        for (const Json& part : mesh["primitives"]) {
            const std::size_t positions = part["attributes"]["POSITION"], normals = part["attributes"]["NORMAL"];
            check_bounds(positions, 3);
            CHECK(glb.count(positions) == glb.count(normals));
            const std::vector<double> at = glb.numbers(positions), normal = glb.numbers(normals);
            const std::vector<double> corners = glb.numbers(part["indices"]);
            CHECK(corners.size() % 3 == 0);
            CHECK(part["material"] < json["materials"].size());
            bool inside = true, unit = true, outwards = true;
            for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
                std::array<Vector3, 3> corner, up;
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto index = static_cast<std::size_t>(corners[i + c]);
                    inside &= index < glb.count(positions);
                    corner[c] = Vector3(&at[3 * index]);
                    up[c] = Vector3(&normal[3 * index]);
                    unit &= std::abs(up[c].norm() - 1.0) < 1e-5;
                }
                const Vector3 area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
                outwards &= area.dot(up[0] + up[1] + up[2]) >= -1e-9;
            }
            CHECK(inside);
            CHECK(unit);
            CHECK(outwards);
        }
    }
    // Every node once in the tree.
    std::multiset<std::size_t> placed;
    for (const Json& node : json["scenes"][0]["nodes"]) placed.insert(node.get<std::size_t>());
    for (const Json& node : json["nodes"]) {
        if (node.contains("mesh")) CHECK(node["mesh"] < json["meshes"].size());
        if (!node.contains("children")) continue;
        for (const Json& child : node["children"]) placed.insert(child.get<std::size_t>());
    }
    CHECK(placed.size() == json["nodes"].size());
    CHECK(std::set<std::size_t>(placed.begin(), placed.end()).size() == placed.size());

    REQUIRE(json["animations"].size() == 1);
    std::set<std::pair<std::size_t, std::string>> targets;
    for (const Json& channel : json["animations"][0]["channels"]) {
        const std::size_t node = channel["target"]["node"];
        const std::string path = channel["target"]["path"];
        CHECK(node < json["nodes"].size());
        CHECK(targets.insert({node, path}).second);
        const Json& sampler = *glb.sampler(node, path);
        const std::size_t times = sampler["input"], values = sampler["output"];
        check_bounds(times, 1);
        const std::vector<double> seconds = glb.numbers(times);
        CHECK(std::adjacent_find(seconds.begin(), seconds.end(), std::greater_equal<>()) == seconds.end());
        CHECK(glb.count(times) == glb.count(values));
        const std::vector<double> numbers = glb.numbers(values);
        const bool rotation = path == "rotation";
        CHECK(json["accessors"][values]["type"] == (rotation ? "VEC4" : "VEC3"));
        const std::size_t each = rotation ? 4 : 3;
        bool unit = true, near = true, moves = false;
        for (std::size_t i = 0; i < numbers.size(); i += each) {
            for (std::size_t part = 0; part < each; ++part) moves |= numbers[i + part] != numbers[part];
            if (!rotation) continue;
            const Eigen::Vector4d q(&numbers[i]);
            unit &= std::abs(q.norm() - 1.0) < 1e-5;
            if (i > 0) near &= q.dot(Eigen::Vector4d(&numbers[i - 4])) >= 0.0;
        }
        INFO("node " << node << " " << path);
        CHECK(unit);
        CHECK(near);
        CHECK(moves);
    }
}

std::vector<std::string> named_scenes() {
    std::vector<std::string> names;
    for (const SceneEntry& entry : catalogue()) names.emplace_back(entry.name);
    return names;
}

}  // namespace

TEST_CASE(
    "a glTF file of every named scene has the parts that the format wants, and its poses are the trajectory's") {
    double worst = 0.0;
    for (const std::string& scene : named_scenes()) {
        INFO(scene);
        const Written written(scene);
        const Glb glb(written.folder.read("a.glb"));
        check_sound(glb);
        const std::vector<BodyDescription> bodies = run_of(scene, {}).description.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            INFO(bodies[i].name);
            const std::size_t node = glb.node(bodies[i].name);
            CHECK(glb.json["nodes"][node].contains("mesh"));
            const auto line = written.trajectory.find(static_cast<int>(i));
            if (line == written.trajectory.end()) {
                CHECK(!glb.sampler(node, "translation"));
                CHECK(!glb.sampler(node, "rotation"));
                continue;
            }
            REQUIRE(line->second.size() == 31);
            for (std::size_t n = 0; n < 31; n += 5) {
                const double time = static_cast<double>(n) / 60.0;
                worst = std::max(
                    worst, apart(line->second[n], glb.vector(node, "translation", time), glb.rotation(node, time)));
            }
        }
    }
    CHECK(worst < 1e-6);
}

#if PUSHFACTOR_ASSIMP
TEST_CASE("assimp reads from a glTF file of every named scene the poses of the trajectory") {
    double worst = 0.0;
    std::size_t compared = 0;
    for (const std::string& scene : named_scenes()) {
        INFO(scene);
        const Written written(scene);
        Assimp::Importer importer;
        const aiScene* const read = importer.ReadFile((written.folder / "a.glb").string(), 0);
        INFO(importer.GetErrorString());
        REQUIRE(read);
        CHECK(read->mNumCameras == 1);
        CHECK(read->mNumLights == 1);
        REQUIRE(read->mNumAnimations == 1);
        std::map<std::string, const aiNodeAnim*> channels;
        for (unsigned i = 0; i < read->mAnimations[0]->mNumChannels; ++i) {
            const aiNodeAnim* const channel = read->mAnimations[0]->mChannels[i];
            channels[channel->mNodeName.C_Str()] = channel;
        }
        const std::vector<BodyDescription> bodies = run_of(scene, {}).description.bodies;
        for (const auto& [body, poses] : written.trajectory) {
            const std::string& name = bodies[static_cast<std::size_t>(body)].name;
            INFO(name);
            const aiNode* const node = read->mRootNode->FindNode(name.c_str());
            REQUIRE(node);
            aiVector3D scale, position;
            aiQuaternion rotation;
            node->mTransformation.Decompose(scale, rotation, position);
            const aiNodeAnim* const channel = channels.contains(name) ? channels[name] : nullptr;
            for (unsigned n = 0; n < poses.size(); ++n) {
                if (channel) {
                    const unsigned p = std::min(n, channel->mNumPositionKeys - 1);
                    const unsigned r = std::min(n, channel->mNumRotationKeys - 1);
                    position = channel->mPositionKeys[p].mValue;
                    rotation = channel->mRotationKeys[r].mValue;
                    const double seconds = channel->mPositionKeys[p].mTime / read->mAnimations[0]->mTicksPerSecond;
                    if (p == n) CHECK(seconds == Approx(n / 60.0).margin(1e-6));
                }
                worst = std::max(worst, apart(poses[n], Vector3(position.x, position.y, position.z),
                                              Quaternion(rotation.w, rotation.x, rotation.y, rotation.z)));
                ++compared;
            }
        }
    }
    CHECK(worst < 1e-6);
    CHECK(compared > 8000);
}
#else
TEST_CASE("assimp reads from a glTF file of every named scene the poses of the trajectory") {
    skip("assimp is not installed (package libassimp-dev)");
}
#endif

TEST_CASE("the validator of Khronos finds nothing in glTF files") {
    const Folder folder;
    const std::string validate =
        "require('gltf-validator').validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1])))"
        ".then(r => process.stdout.write(JSON.stringify(r)))";
    const std::string node = "NODE_PATH=\"$NODE_PATH:$(npm root -g 2>/dev/null)\" node -e";
    std::string command;
    if (shell(folder, "command -v gltf_validator").status == 0) {
        command = "gltf_validator -o ";
    } else if (shell(folder, node + " \"require('gltf-validator')\"").status == 0) {
        command = node + " \"" + validate + "\" ";
    } else {
        return skip("the validator is not installed (npm install -g gltf-validator)");
    }
    const std::string scenes = std::string(PUSHFACTOR_SOURCE_DIR) + "/assets/scenes/";
    for (const std::string& run :
         {std::string("stack --overlay forces,thrust --camera orbit:30"),
          std::string("pendulum-grid --overlay push"), std::string("platonic --overlay contacts,velocities"),
          scenes + "rover.json --overlay forces"}) {
        INFO(run);
        REQUIRE(shell(folder, "pushfactor run " + run + " --seconds 1 --glb a.glb").status == 0);
        const Ended ended = shell(folder, command + "a.glb");
        INFO(ended.out << ended.err);
        REQUIRE(ended.status == 0);
        const Json issues = Json::parse(ended.out)["issues"];
        for (const char* const kind : {"numErrors", "numWarnings", "numInfos", "numHints"})
            CHECK(issues[kind] == 0);
    }
}

TEST_CASE("meshes in a glTF file grow neither with the frames of a run nor with bodies of the same shape") {
    const auto run = [](const std::string& count, const std::string& seconds) {
        return recorded(run_of("funnel", {{"count", count}, {"seconds", seconds}}));
    };
    const Glb few = run("20", "0.1"), longer = run("20", "0.5"), more = run("60", "0.1");
    CHECK(few.json["meshes"] == longer.json["meshes"]);
    CHECK(few.json["bufferViews"][0] == longer.json["bufferViews"][0]);
    CHECK(few.json["bufferViews"][1] == longer.json["bufferViews"][1]);
    // One ball, once in each of the six colours.
    for (const Glb* glb : {&few, &more}) {
        std::set<int> positions;
        std::size_t balls = 0;
        for (const Json& mesh : glb->json["meshes"]) {
            if (mesh["name"] != "ball") continue;
            ++balls;
            for (const Json& part : mesh["primitives"]) positions.insert(part["attributes"]["POSITION"].get<int>());
        }
        CHECK(balls == 6);
        CHECK(positions.size() == 1);
    }
}

TEST_CASE("keys of a glTF file follow the frame rate, and bodies that stay where they are have none") {
    Choices choices = run_of("stack", {{"seconds", "0.5"}});
    choices.frames.fps = Rational{20, 1};
    const Glb glb = recorded(choices);
    const Json* const sampler = glb.sampler(glb.node("cube 2"), "translation");
    REQUIRE(sampler);
    const std::vector<double> times = glb.numbers((*sampler)["input"]);
    REQUIRE(times.size() == 11);
    for (std::size_t n = 0; n < times.size(); ++n)
        CHECK(times[n] == static_cast<float>(static_cast<double>(n) / 20.0));
    CHECK(!sampler->contains("interpolation"));  // LINEAR
    CHECK(!glb.sampler(glb.node("ground"), "translation"));
    CHECK(!glb.sampler(glb.node("cube 2"), "rotation"));  // it falls upright
    CHECK(glb.vector(glb.node("cube 1"), "translation", 0.0) == Vector3(0, 2, 0));

    choices.frames.play_speed = Rational{1, 3};
    const Glb slow = recorded(choices);
    const Json* const slowed = slow.sampler(slow.node("cube 2"), "translation");
    REQUIRE(slowed);
    CHECK(slow.numbers((*slowed)["input"]).size() == 31);
    CHECK(slow.vector(slow.node("cube 2"), "translation", 1.5) ==
          glb.vector(glb.node("cube 2"), "translation", 0.5));
}

TEST_CASE("bars in a glTF file join the points that the renderer joins, and turn by the shortest way") {
    for (const char* const scene : {"pendulum-wave", "rover"}) {
        INFO(scene);
        const Choices choices = run_of(scene, {{"seconds", "0.5"}});
        std::vector<std::vector<renderer::Bar>> frames;
        const Glb glb = recorded(choices, [&](const Simulation& run) {
            frames.push_back(pictures::draw_list(run.scene(), run.scene().view).bars);
        });
        REQUIRE(!frames.front().empty());
        double worst = 0.0;
        for (std::size_t i = 0; i < frames.front().size(); ++i) {
            const std::size_t node = glb.node("bar " + std::to_string(i + 1));
            for (const std::size_t n : {std::size_t{0}, frames.size() / 2, frames.size() - 1}) {
                const double time = static_cast<double>(n) * choices.settings.dt.value();
                const renderer::Bar& bar = frames[n][i];
                const Vector3 scale = glb.vector(node, "scale", time);
                const Vector3 half = glb.rotation(node, time) * Vector3(0, scale.y() - bar.radius, 0);
                const Vector3 middle = glb.vector(node, "translation", time);
                const Vector3 from(bar.from.x, bar.from.y, bar.from.z), to(bar.to.x, bar.to.y, bar.to.z);
                worst = std::max({worst, (middle - half - from).norm(), (middle + half - to).norm()});
                CHECK(scale.x() == Approx(bar.radius));
                CHECK(scale.z() == Approx(bar.radius));
            }
        }
        CHECK(worst < 5e-6);
    }
}

TEST_CASE("a stretched mesh ends at its points and does not turn more than its direction") {
    Random random(3);
    std::vector<std::optional<Segment>> keys;
    for (int i = 0; i < 200; ++i) {
        const Vector3 from = random.vector(-1, 1), to = random.vector(-1, 1);
        keys.push_back(i % 7 == 3 ? std::nullopt : std::optional(Segment{from, to}));
    }
    using Stretch = pictures::gltf::Stretch;
    const auto placed = pictures::gltf::stretched(
        keys, {.origin = Stretch::Origin::start, .per_length = Vector3::Ones(), .fixed = Vector3::Zero()});
    REQUIRE(placed.scales.size() == 3 * keys.size());
    Quaternion last = Quaternion::Identity();
    Vector3 along = Vector3::UnitY();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto vector = [&](const std::vector<float>& v) {
            return Vector3(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
        };
        const Quaternion q(Eigen::Vector4f(&placed.rotations[4 * i]).cast<double>());
        if (!keys[i]) {
            CHECK(vector(placed.scales) == Vector3::Zero());
            CHECK(q.angularDistance(last) < 1e-6);
            continue;
        }
        CHECK((vector(placed.translations) - keys[i]->from).norm() < 1e-6);
        const Vector3 tip = vector(placed.translations) + q * Vector3(0, vector(placed.scales).y(), 0);
        CHECK((tip - keys[i]->to).norm() < 2e-6);
        const Vector3 direction = (keys[i]->to - keys[i]->from).normalized();
        CHECK(q.angularDistance(last) ==
              Approx(std::acos(std::clamp(direction.dot(along), -1.0, 1.0))).margin(1e-3));
        last = q;
        along = direction;
    }
}

TEST_CASE("arrows in a glTF file are the forces of each frame, and have no size in frames that have fewer") {
    Choices choices = run_of("intersecting-stack", {{"seconds", "1"}});
    choices.frames.overlay = {{OverlayKind::forces, 50.0}};  // N per metre
    std::vector<std::vector<pictures::Quantity>> frames;
    const Glb glb = recorded(choices, [&](const Simulation& run) {
        frames.push_back(pictures::quantities(run.scene(), OverlayKind::forces));
    });
    check_sound(glb);
    std::vector<std::size_t> arrows;
    for (const Json& child : glb.json["nodes"][glb.node("contact force")]["children"]) arrows.push_back(child);
    std::size_t most = 0, least = 1000;
    for (std::size_t n = 0; n < frames.size(); ++n) {
        const double time = static_cast<double>(n) / 60.0;
        Vector3 forces = Vector3::Zero(), drawn = Vector3::Zero(), moment = Vector3::Zero(), drawn_moment = moment;
        std::size_t acting = 0, shown = 0;
        for (const pictures::Quantity& quantity : frames[n]) {
            acting += quantity.value.norm() > 1e-4;
            forces += quantity.value;
            moment += quantity.place.cross(quantity.value);
        }
        for (const std::size_t arrow : arrows) {
            const Vector3 scale = glb.vector(arrow, "scale", time);
            CHECK((scale.x() == scale.y() && scale.y() == scale.z()));
            const Vector3 force = 50.0 * (glb.rotation(arrow, time) * Vector3(0, scale.y(), 0));
            shown += force.norm() > 1e-4;
            drawn += force;
            drawn_moment += glb.vector(arrow, "translation", time).cross(force);
        }
        INFO("frame " << n);
        CHECK(shown == acting);
        CHECK((drawn - forces).norm() < 1e-3);
        CHECK((drawn_moment - moment).norm() < 1e-2);
        most = std::max(most, acting);
        least = std::min(least, acting);
    }
    CHECK(least == 0);
    CHECK(arrows.size() == most);
    for (const std::size_t arrow : arrows) {
        for (const char* const path : {"translation", "rotation", "scale"}) {
            const Json* const sampler = glb.sampler(arrow, path);
            if (sampler) CHECK((*sampler)["interpolation"] == "STEP");
        }
    }
}

TEST_CASE("lines of overlays are in a glTF file as long as in the picture") {
    Choices choices = run_of("rover", {{"seconds", "0.1"}});
    choices.frames.overlay = {{.kind = OverlayKind::no_contacts}};
    std::vector<pictures::Quantity> lines;
    const Glb glb = recorded(choices, [&](const Simulation& run) {
        lines = pictures::quantities(run.scene(), OverlayKind::no_contacts);
    });
    REQUIRE(!lines.empty());
    double lengths = 0.0, drawn = 0.0;
    for (const pictures::Quantity& line : lines) lengths += line.value.norm();
    for (const Json& node : glb.json["nodes"]) {
        const std::string name = node.value("name", "");
        if (!node.contains("mesh") || glb.json["meshes"][node["mesh"].get<std::size_t>()]["name"] == "bar")
            continue;
        if (!name.starts_with("do not touch") && !name.starts_with("one group")) continue;
        const Vector3 scale = glb.vector(glb.node(name), "scale", 0.1);
        drawn += 2.0 * (scale.y() - scale.x());
    }
    CHECK(drawn == Approx(lengths).epsilon(1e-4));
}

TEST_CASE("the camera of a glTF file looks as the film's does, and the sun shines as the renderer's") {
    Choices choices = run_of("stack", {{"seconds", "1"}});
    choices.frames.camera.degrees_a_second = 90.0;
    const Glb glb = recorded(choices);
    const std::size_t camera = glb.node("camera");
    const View& view = choices.description.view;
    for (const double time : {0.0, 0.5, 1.0}) {
        const View at = turned(choices.frames.camera, view, time);
        const Vector3 eye = glb.vector(camera, "translation", time);
        const Vector3 forward = glb.rotation(camera, time) * Vector3(0, 0, -1);
        const Vector3 right = glb.rotation(camera, time) * Vector3(1, 0, 0);
        CHECK((eye - at.eye).norm() < 1e-5);
        CHECK((forward - (at.target - at.eye).normalized()).norm() < 1e-6);
        CHECK(std::abs(right.y()) < 1e-6);
    }
    const Json& lens = glb.json["cameras"][0]["perspective"];
    CHECK(lens["yfov"].get<double>() == Approx(view.field_of_view * 3.14159265358979 / 180.0));
    CHECK(lens["aspectRatio"].get<double>() == Approx(1280.0 / 720.0));
    const Vector3 shines = glb.rotation(glb.node("sun"), 0.0) * Vector3(0, 0, -1);
    const glm::vec3 sun = renderer::Picture{}.towards_sun;
    CHECK((shines + Vector3(sun.x, sun.y, sun.z).normalized()).norm() < 1e-6);
    CHECK(glb.json["extensionsUsed"] == Json::array({"KHR_lights_punctual"}));
}

TEST_CASE("run and render write the same glTF file, whatever the threads, and a picture does not change it") {
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor run stack --seconds 0.5 --overlay forces --glb a.glb --threads 1").status ==
            0);
    REQUIRE(shell(folder, "pushfactor run stack --seconds 0.5 --overlay forces --glb b.glb --threads 2").status ==
            0);
    REQUIRE(
        shell(folder, "pushfactor render stack --seconds 0.5 --overlay forces --glb c.glb --size 64x36 --threads 1")
            .status == 0);
    Glb a(folder.read("a.glb")), b(folder.read("b.glb"));
    CHECK(folder.read("a.glb") == folder.read("c.glb"));
    CHECK(a.binary == b.binary);
}

TEST_CASE("a run that stops early leaves a glTF file of the frames so far, and a failed one none") {
    const Folder folder;
    folder.write("bad.json", R"({"version": 1, "contacts": false, "bodies": [
        {"name": "ball", "shape": "sphere", "radius_m": 1, "mass_kg": 1, "velocity_m_per_s": [1, 0, 0]}],
        "forces": [{"body": "ball", "force_n": [1e308, 0, 0], "from_s": 0.1}]})");
    const Ended ended = shell(folder, "pushfactor run bad.json --seconds 1 --glb a.glb");
    INFO(ended.err);
    CHECK(ended.status == 5);
    CHECK_THAT(ended.err, Catch::Contains("a.glb holds the run up to step"));
    const Glb glb(folder.read("a.glb"));
    check_sound(glb);
    const std::size_t keys = glb.count((*glb.sampler(glb.node("ball"), "translation"))["input"]);
    CHECK(keys > 3);
    CHECK(keys < 60);
    CHECK(shell(folder, "pushfactor run stack --seconds 0.1 --glb no/such/a.glb").status == 4);
    for (const std::string& file : folder.files()) CHECK(file.find(".partial") == std::string::npos);
}

TEST_CASE("what a glTF file cannot hold is refused in one line") {
    check_refused("run stack --glb a.gltf", "--glb a.gltf: must end in .glb");
    check_refused("run stack --glb -", "--glb -: must end in .glb");
    check_refused("run stack --glb a.glb --overlay islands", "--glb a.glb: must be without --overlay islands");
    check_refused("run pendulum-wave --glb a.glb --overlay contacts", "--overlay contacts: scene pendulum-wave");
    check_refused("run stack --glb a.glb --fps 7", "--fps 7: a frame must be a whole number of steps");
    check_refused("run stack --glb a.glb --seconds 1e6", "must have at most 4194304 frames, not 60000001");
    check_refused("run funnel --count 1000 --glb a.glb --seconds 5000", "must be at most 4.29 GB");
    check_refused("render stack --glb a.glb --at 1", "--glb a.glb: must be of a sequence, not of stills (--at)");
    check_refused("render stack --glb a.glb --compare push=none,persistent",
                  "--glb a.glb: must be for one run, not with --compare");
    check_refused("render stack chain --glb a.glb", "--glb a.glb: must be for one scene at a time");
}
