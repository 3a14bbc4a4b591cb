// The files of the program: their columns, that equal runs give equal bytes, and that nothing is left half-written.
#include "demos/base/text/json.h"
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <algorithm>
#include <vector>

using namespace pushfactor::tests;
using pushfactor::demos::Json;
using pushfactor::demos::json_text;
using pushfactor::demos::parse_json;

namespace {

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

long lines(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
}

const std::string tiny = " --size 64x36 ";

}  // namespace

TEST_CASE("the CSV files have the columns of the design and one line for each thing that they list") {
    const Folder folder;
    const Ended ended =
        shell(folder,
              "pushfactor run stack --count 2 --gap -0.01 --seconds 0.5 --csv steps.csv --trajectory bodies.csv "
              "--rows rows.csv --summary summary.json");
    REQUIRE(ended.status == 0);
    CHECK(ended.out.empty());
    CHECK(folder.files() == std::vector<std::string>{"bodies.csv", "rows.csv", "steps.csv", "summary.json"});

    const std::string steps = folder.read("steps.csv");
    CHECK(first_line(steps) ==
          "step,time_s,kinetic_energy_j,potential_energy_j,max_speed_m_per_s,max_penetration_m,rms_penetration_m,"
          "max_length_error_m,residual_m_per_s,contacts,rows,columns,substeps,sweeps,islands,islands_kept,"
          "islands_swept,islands_exact,islands_in_small_steps,islands_unsolved,bodies_at_rest");
    CHECK(lines(steps) == 1 + 30);
    const std::string bodies = folder.read("bodies.csv");
    CHECK(first_line(bodies) ==
          "time_s,body,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_per_s,vy_m_per_s,vz_m_per_s,wx_rad_per_s,"
          "wy_rad_per_s,wz_rad_per_s,motion_hash");
    CHECK(lines(bodies) == 1 + 31 * 2);
    const std::string rows = folder.read("rows.csv");
    CHECK(first_line(rows) ==
          "step,time_s,kind,body_a,body_b,point,gap_m,push_correcting_m_per_s,"
          "push_lasting_m_per_s,c_min_n,c_max_n,lambda_first_n,lambda_last_n");
    CHECK(lines(rows) == 1 + 30 * 2 * 4 * 3);
}

TEST_CASE("the option --timing adds one column and --fps thins the trajectory") {
    const Folder folder;
    shell(folder, "pushfactor run stack --seconds 1 --timing --csv steps.csv --fps 10 --trajectory bodies.csv");
    CHECK(first_line(folder.read("steps.csv")).ends_with(",bodies_at_rest,step_us"));
    CHECK(lines(folder.read("bodies.csv")) == 1 + 11 * 5);
}

TEST_CASE("two runs give equal files, and a config file gives the run that wrote it") {
    const Folder folder;
    const std::string options = " --count 3 --jitter 0.02 --seed 5 --beta 0.3 --dt 0.01 --seconds 2 ";
    shell(folder, "pushfactor run stack" + options + "--csv a.csv --summary a.json");
    shell(folder, "pushfactor run stack" + options + "--csv b.csv --summary b.json");
    CHECK(folder.read("a.csv") == folder.read("b.csv"));
    CHECK(folder.read("a.json") == folder.read("b.json"));

    shell(folder, "pushfactor render stack" + options + "--at 0" + tiny + "--out frames");
    REQUIRE(shell(folder, "pushfactor run --config frames/config.json --summary c.json").status == 0);
    CHECK(folder.read("c.json") == folder.read("a.json"));
    // The command line takes precedence over the config.
    shell(folder, "pushfactor run stack --config frames/config.json --seed 6 --summary d.json");
    CHECK_THAT(folder.read("d.json"), Catch::Contains("\"seed\": 6") && Catch::Contains("\"beta\": 0.3"));
}

TEST_CASE("the pictures of a scene from a pipe are made again with their config, wherever the folder is") {
    const Folder folder;
    require_success(folder,
                    "pushfactor scene stack --count 2 | sed 's/\"stack\"/\"two\"/' | pushfactor render - --at 0.5" +
                        tiny + "--out a/b");
    const std::string picture = folder.read("a/b/at_0.5s.png");
    require_success(folder, "mv a/b moved && rm -r a && pushfactor check moved </dev/null");
    require_success(folder, "pushfactor render --config moved/config.json --out again </dev/null");
    CHECK(folder.read("again/at_0.5s.png") == picture);
    check_refused(folder, "pushfactor scene stack | pushfactor render - --at 0 --out r --csv r/config.scene.json",
                  "r/config.scene.json: must have another name");
}

TEST_CASE("a preset of the command line wins over files that spell out their options, a single option over both") {
    const Folder folder;
    const std::string run = "pushfactor run stack --count 2 --seconds 1 --dt 1/120 ";
    REQUIRE(shell(folder, "pushfactor scene stack --count 2 --seconds 1 --dt 1/120 >scene.json").status == 0);
    REQUIRE(shell(folder, "pushfactor render stack --count 2 --seconds 1 --dt 1/120 --at 0 --out frames" + tiny)
                .status == 0);
    for (const std::string given : {"--preset exact", "--preset paper", "--preset exact --slop 0.01 --beta 0.5"}) {
        INFO(given);
        const std::string wanted = shell(folder, run + given).out;
        CHECK(shell(folder, "pushfactor run --config frames/config.json " + given).out == wanted);
        Json of_catalogue = parse_json(wanted);
        Json of_file = parse_json(shell(folder, "pushfactor run scene.json " + given).out);
        CHECK(of_file["state_hash"] == of_catalogue["state_hash"]);
        for (const char* parameter : {"count", "gap", "jitter", "seed"}) of_catalogue["options"].erase(parameter);
        CHECK(of_file["options"] == of_catalogue["options"]);
        CHECK(of_file["preset"] == of_catalogue["preset"]);
    }
    // Without one on the command line the file's options hold.
    REQUIRE(shell(folder, "pushfactor scene stack --preset paper --beta 0.7 >paper.json").status == 0);
    const Json kept = parse_json(shell(folder, "pushfactor run paper.json --seconds 0.1").out);
    CHECK(kept["preset"] == "paper");
    CHECK(kept["options"]["beta"] == 0.7);
}

TEST_CASE("a saved run that goes on under another preset is not started again") {
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor run pendulum-wave --seconds 1 --save-state saved.json --summary -").status ==
            0);
    const Json on = parse_json(shell(folder, "pushfactor run saved.json --seconds 0.1 --preset exact").out);
    CHECK(on["options"]["solver"] == "direct");
    CHECK(on["options"]["start-kick"] == "off");
}

TEST_CASE("what names an open file is written to where that stands, and nothing is lost") {
    const Folder folder;
    folder.write("log", "precious\n");
    for (const char* const name : {"/dev/stdout", "/dev/fd/1", "link"}) {
        INFO(name);
        REQUIRE(shell(folder,
                      "ln -sf /dev/stdout link; echo header >both; { pushfactor run stack --seconds 0.1 --csv " +
                          std::string(name) + "; echo footer; } >>both; pushfactor run stack --seconds 0.1 --csv " +
                          name + " >>log")
                    .status == 0);
        const std::string both = folder.read("both");
        CHECK(both.starts_with("header\nstep,"));
        CHECK(both.ends_with("\nfooter\n"));
        CHECK(folder.read("log").starts_with("precious\nstep,"));
        CHECK_THAT(
            shell(folder, std::string("pushfactor run stack --seconds 0.1 --trajectory - --csv ") + name).err,
            Catch::Contains("must not be the file of --csv"));
    }
}

TEST_CASE("a bad config file is refused by file, key and value") {
    const Folder folder;
    const auto said = [&](const std::string& config) {
        folder.write("my.json", config);
        const Ended ended = shell(folder, "pushfactor run stack --config my.json");
        CHECK(ended.status == 2);
        return ended.err;
    };
    CHECK_THAT(said("{\"betta\": 0.1}"),
               Catch::Contains("betta in my.json") && Catch::Contains("did you mean beta?"));
    CHECK_THAT(said("{\"beta\": 7}"), Catch::Contains("beta in my.json 7") && Catch::Contains("from 0 to 1"));
    CHECK_THAT(said("{\"beta\": [1]}"), Catch::Contains("must be a string or a number"));
    CHECK_THAT(said("{\"beta\": "), Catch::Contains("is not JSON"));
    CHECK_THAT(said("[1]"), Catch::Contains("must be an object"));
    CHECK(shell(folder, "pushfactor run stack --config none.json").status == 2);
    check_refused(folder, "pushfactor run " + std::string(5000, 'x') + ".json", "File name too long");
    CHECK_THAT(said("{\"solver\": \"p\\u0000\"}"), Catch::Contains("solver: must be without \\u0000"));
}

TEST_CASE("the scene of a config file is noted where the command names another one") {
    const Folder folder;
    folder.write("my.json", R"({"scene": "chain", "seconds": 0})");
    CHECK(shell(folder, "pushfactor run stack --config my.json").err ==
          "pushfactor: note: scene in my.json chain: has no effect, the command names stack\n");
    CHECK(shell(folder, "pushfactor run chain --config my.json").err.empty());
    CHECK(shell(folder, "pushfactor run --config my.json").err.empty());
}

TEST_CASE("the integrator in files of earlier versions is the scheme, and euler has no meaning any more") {
    const Folder folder;
    const std::string start = "pushfactor run chain --seconds 0.5";
    const std::string scheme = shell(folder, start + " --scheme rattle4").out;
    const std::string plain = shell(folder, start).out;
    const auto hash = [](const std::string& summary) { return std::string(parse_json(summary)["state_hash"]); };
    REQUIRE(hash(scheme) != hash(plain));
    REQUIRE(shell(folder, "pushfactor scene chain > chain.json").status == 0);
    for (const std::string name : {"rattle4", "euler"}) {
        const bool has_meaning = name == "rattle4";
        const std::string wanted = hash(has_meaning ? scheme : plain);
        folder.write("old.json", R"({"integrator": ")" + name + "\"}");
        Json own = parse_json(folder.read("chain.json"));
        own["options"]["integrator"] = name;
        folder.write("own.json", json_text(own, -1));
        for (const std::string& command :
             {start + " --config old.json", std::string("pushfactor run own.json --seconds 0.5")}) {
            const Ended ended = shell(folder, command);
            INFO(command << "\n" << ended.err);
            CHECK(ended.status == 0);
            CHECK(hash(ended.out) == wanted);
            const auto words = ended.err.find("euler: has no meaning any more\n");
            CHECK((words != std::string::npos) != has_meaning);
            CHECK((words == std::string::npos || ended.err.find("no meaning", words + 20) == std::string::npos));
        }
    }
    folder.write("old.json", R"({"integrator": "leapfrog"})");
    const Ended wrong = shell(folder, start + " --config old.json");
    CHECK(wrong.status == 2);
    CHECK(wrong.err.find("integrator in old.json leapfrog: must be one of") != std::string::npos);
}

TEST_CASE("frames show t = n / fps from zero, in one folder or in one a scene, and are the same bytes every time") {
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor render stack --seconds 0.1 --fps 30 --out one" + tiny).status == 0);
    REQUIRE(
        shell(folder,
              "pushfactor render stack intersecting-stack --seconds 0.1 --at 0,0.1 --camera scene --out two" + tiny)
            .status == 0);
    const std::vector<std::string> expected{"one/config.json",
                                            "one/frame_000000.png",
                                            "one/frame_000001.png",
                                            "one/frame_000002.png",
                                            "one/frame_000003.png",
                                            "one/summary.json",
                                            "two/intersecting-stack/at_0.1s.png",
                                            "two/intersecting-stack/at_0s.png",
                                            "two/intersecting-stack/config.json",
                                            "two/intersecting-stack/summary.json",
                                            "two/stack/at_0.1s.png",
                                            "two/stack/at_0s.png",
                                            "two/stack/config.json",
                                            "two/stack/summary.json"};
    CHECK(folder.files() == expected);
    const auto image = [&](const std::string& name) {
        const std::string bytes = folder.read(name);
        return pushfactor::renderer::decode_png(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    };
    CHECK(image("one/frame_000003.png") == image("two/stack/at_0.1s.png"));
    CHECK(folder.read("one/frame_000000.png") != folder.read("one/frame_000003.png"));
    CHECK(folder.read("one/frame_000000.png").starts_with("\x89PNG"));
}

TEST_CASE("a disk that is full ends with status 4, leaves no half file and keeps what was there") {
    const Folder folder;
    folder.write("steps.csv", "precious");
    // A file size limit of 4 blocks simulates a full disk: the write fails in the middle of the file.
    const Ended run = shell(folder, "ulimit -f 4; pushfactor run stack --seconds 60 --csv steps.csv");
    CHECK(run.status == 4);
    CHECK_THAT(run.err, Catch::Contains("steps.csv"));
    CHECK(folder.read("steps.csv") == "precious");
    CHECK(folder.files() == std::vector<std::string>{"steps.csv"});

    const Ended render = shell(folder, "ulimit -f 4; pushfactor render stack --at 0 --size 640x360 --out frames");
    INFO(render.err);
    CHECK(render.status == 4);
    CHECK_THAT(render.err, Catch::Contains("frames/at_0s.png"));
    for (const std::string& name : folder.files()) {
        CHECK_THAT(name, !Catch::Contains(".png") && !Catch::Contains(".partial"));
    }
}

TEST_CASE("two scenes never write into one folder") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor render stack stack --at 0 --out frames");
    CHECK(ended.status == 2);
    CHECK_THAT(ended.err, Catch::Contains("must not share its folder frames/stack"));
    CHECK(folder.files().empty());
}

TEST_CASE("a render that is far from its next frame can be interrupted too") {
    const Folder folder;
    const Ended ended = stopped_when(folder, "test -e frames/at_0s.png",
                                     "render stack --seconds 20000 --at 0,20000 --out frames" + tiny);
    CHECK(ended.status == 1);
    CHECK_THAT(ended.err, Catch::Contains("1 of 2 frames were drawn, into frames"));
}

TEST_CASE("an interrupted run keeps whole lines in its CSV files and says up to where") {
    for (const std::string signal : {"INT", "TERM", "HUP"}) {
        for (const std::string command : {"run stack", "render stack --fps 1 --size 64x36 --out frames"}) {
            const Folder folder;
            folder.write("steps.csv", "of an earlier run");
            const Ended ended = stopped_when(folder, "cat .*.partial | grep -q .",
                                             command +
                                                 " --seconds 100000 --csv steps.csv --trajectory bodies.csv "
                                                 "--summary summary.json --save-state state.json",
                                             signal);
            INFO(signal << " " << command << ": " << ended.err);
            CHECK(ended.status == 1);
            CHECK_THAT(ended.err, Catch::Contains("pushfactor: interrupted: "));
            const std::string steps = folder.read("steps.csv");
            const long last = lines(steps) - 1;
            CHECK(last > 100);
            CHECK(steps.ends_with("\n"));
            const std::string last_line = lines_of(steps).back();
            CHECK(last_line.starts_with(std::to_string(last) + ","));
            CHECK(std::count(last_line.begin(), last_line.end(), ',') ==
                  std::count(steps.begin(), steps.begin() + static_cast<long>(steps.find('\n')), ','));
            const long every = command.starts_with("render") ? 60 : 1;  // one line per body and frame
            CHECK(lines(folder.read("bodies.csv")) == 1 + 5 * (last / every + 1));
            CHECK_THAT(ended.err, Catch::Contains("pushfactor: note: steps.csv holds the run up to step " +
                                                  std::to_string(last) + ", where it stopped\n"));
            for (const std::string& name : folder.files()) {
                CHECK_THAT(
                    name, !Catch::Contains(".partial") && !Catch::Contains("summary") && !Catch::Contains("state"));
            }
        }
    }
}

TEST_CASE("an interrupted render leaves whole frames only and says how many") {
    const Folder folder;
    const Ended ended =
        stopped_when(folder, "test -e frames/frame_000003.png", "render stack --seconds 1000 --out frames" + tiny);
    CHECK(ended.status == 1);
    CHECK_THAT(ended.err, Catch::Contains("interrupted") && Catch::Contains("frames were drawn, into frames"));
    long frames = 0;
    for (const std::string& name : folder.files()) {
        CHECK_THAT(name, !Catch::Contains(".partial") && !Catch::Contains("summary"));
        if (!name.ends_with(".png")) continue;
        ++frames;
        // A whole PNG ends with its IEND chunk.
        CHECK(folder.read(name).substr(folder.read(name).size() - 8, 4) == "IEND");
    }
    CHECK(frames >= 4);
}
