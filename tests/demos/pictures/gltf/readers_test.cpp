// glTF files, read by assimp and by the validator of Khronos.
#include "demos/options/named_run.h"
#include "tests/demos/pictures/gltf/glb_runs.h"
#include "tests/skip.h"

#if PUSHFACTOR_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#endif

#include <iostream>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;

namespace {}  // namespace

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
        // A scene in which nothing moves has no animation.
        const aiAnimation* const animation = read->mNumAnimations == 1 ? read->mAnimations[0] : nullptr;
        std::map<std::string, const aiNodeAnim*> channels;
        for (unsigned i = 0; animation && i < animation->mNumChannels; ++i)
            channels[animation->mChannels[i]->mNodeName.C_Str()] = animation->mChannels[i];
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
                    const double seconds = channel->mPositionKeys[p].mTime / animation->mTicksPerSecond;
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
    for (const std::string run : {"stack --overlay forces,thrust --camera orbit:30", "pendulum-grid --overlay push",
                                  "platonic --overlay contacts,velocities",
                                  PUSHFACTOR_SOURCE_DIR "/assets/scenes/rover.json --overlay forces"}) {
        INFO(run);
        REQUIRE(shell(folder, "pushfactor run " + run + " --seconds 1 --glb a.glb").status == 0);
        const Ended ended = shell(folder, command + "a.glb");
        INFO(ended.out << ended.err);
        REQUIRE(ended.status == 0);
        const Json issues = parse_json(ended.out)["issues"];
        for (const char* const kind : {"numErrors", "numWarnings", "numInfos", "numHints"})
            CHECK(issues[kind] == 0);
    }
}
