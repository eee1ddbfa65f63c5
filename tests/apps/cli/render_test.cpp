#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/apps/cli/run_cremona.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"

using cli_test::cantilever;
using cli_test::cremona;
using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

namespace {

/// Width and height in the head of a PNG file.
std::pair<unsigned, unsigned> size_of_png(const std::string& bytes)
{
    const auto number = [&](std::size_t at) {
        unsigned n = 0;
        for (std::size_t i = 0; i < 4; ++i) n = n << 8U | static_cast<unsigned char>(bytes.at(at + i));
        return n;
    };
    return {number(16), number(20)};
}

} // namespace

TEST_CASE("A line of thrust that is asked of another kind than a plane frame is said to be missing")
{
    const Folder folder;
    const std::string truss = source_folder() + "/examples/pratt_truss.json";
    const Run run = cremona({"render", truss, "-o", folder.path("a.svg"), "--show", "thrust,labels"});
    CHECK(run.status == 0);
    CHECK(run.err == "--show thrust: a plane truss has no line of thrust, and none is drawn; plane frames have one\n");
    CHECK(cremona({"render", "-", "-o", folder.path("b.svg"), "--show", "thrust"}, cantilever()).err.empty());
}

TEST_CASE("SVG and PDF begin as their kinds do, and the SVG has the title, the load and the reaction")
{
    const Folder folder;
    CHECK(cremona({"render", "-", "-o", folder.path("a.svg")}, cantilever()).status == 0);
    CHECK(cremona({"render", "-", "-o", folder.path("a.pdf")}, cantilever()).status == 0);
    CHECK(has(folder.read("a.svg"), "<svg"));
    CHECK(folder.read("a.pdf").starts_with("%PDF-"));
    for (const char* text : {"Cantilever", "12 kN", "48 kN"}) CHECK_MESSAGE(has(folder.read("a.svg"), text), text);
}

TEST_CASE("What a view file keeps beside its model is drawn; what is wrong with it is told, and the rest is drawn")
{
    const Folder folder;
    const std::string model = "examples/portal.json", copy = folder.path("portal.json"), svg = folder.path("a.svg");
    std::filesystem::copy_file(model, copy);
    const auto drawn_beside = [&](const std::string& line) {
        std::ofstream(folder.path("portal.view.json"))
            << R"({"cremona_view": 1, "dimensions": [)" << line
            << R"({"nodes": ["A", "C"], "direction": "aligned", "offset": 1}]})";
        return cremona({"render", copy, "-o", svg});
    };
    const Run sound = drawn_beside("");
    CHECK(sound.status == 0);
    CHECK(sound.err == "");
    CHECK(has(folder.read("a.svg"), "9.179 m")); // the root of 8^2 + 4.5^2
    const Run dangling = drawn_beside(R"({"nodes": ["A", "Z"], "direction": "aligned", "offset": 1}, )");
    CHECK(dangling.status == 0);
    CHECK(has(dangling.err, "portal.view.json: error: dimensions[0].nodes[1]: no node \"Z\""));
    CHECK(has(folder.read("a.svg"), "9.179 m"));
    CHECK(cremona({"render", copy, "-o", svg, "--show", "loads"}).status == 0);
    CHECK_FALSE(has(folder.read("a.svg"), "9.179 m"));
}

TEST_CASE("A PNG has the pixels of --size times --scale")
{
    const Folder folder;
    const Run run = cremona({"render", "-", "-o", folder.path("a.png"), "--size", "400x300", "--scale", "2"},
                            cantilever());
    CHECK_MESSAGE(run.status == 0, run.err);
    CHECK(size_of_png(folder.read("a.png")) == std::pair{800U, 600U});
}

TEST_CASE("--show, --case, --theme and --lang change the picture")
{
    const Folder folder;
    const auto drawn = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"render", "-", "-o", folder.path("a.svg")});
        const Run run = cremona(options, cantilever());
        CHECK_MESSAGE(run.status == 0, run.err);
        return folder.read("a.svg");
    };
    const std::string plain = drawn({});
    CHECK(drawn({}) == plain); // the same picture each time
    CHECK(drawn({"--case", "P"}) == plain);
    CHECK(has(drawn({"--case", "U"}), "18 kN"));
    CHECK(drawn({"--show", "loads,M,labels"}) != plain);
    CHECK(drawn({"--theme", "dark"}) != plain);
    CHECK(drawn({"--lang", "pt"}) != plain);
}

TEST_CASE("An envelope is drawn, and a view that the app has kept beside the model")
{
    const Folder folder;
    const std::string copy = folder.path("portal.json"), svg = folder.path("a.svg");
    std::filesystem::copy_file("examples/portal.json", copy);
    CHECK(cremona({"render", copy, "-o", svg, "--case", "envelope", "--show", "M,labels"}).status == 0);
    CHECK(has(folder.read("a.svg"), "Envelope of all cases"));
    const Run none = cremona({"render", copy, "-o", svg, "--view", "Moments"});
    CHECK(none.status == 2);
    CHECK(has(none.err, "no views are kept beside the model"));
    std::ofstream(folder.path("portal.view.json"))
        << R"({"cremona_view": 1, "views": [{"name": "Moments", "show": "M,legend"},)"
        << R"({"name": "Two", "show": "M,legend", "envelope": ["G", "Q"]},)"
        << R"({"name": "Corner", "show": "loads,nodes", "case": "Q", "region": [0, 4.5, 2]}]})";
    CHECK(cremona({"render", copy, "-o", svg, "--view", "Moments"}).status == 0);
    CHECK(has(folder.read("a.svg"), "Envelope of all cases"));
    CHECK(cremona({"render", copy, "-o", svg, "--view", "Moments", "--case", "G"}).status == 0);
    CHECK(!has(folder.read("a.svg"), "Envelope of all cases"));
    CHECK(cremona({"render", copy, "-o", svg, "--view", "Two"}).status == 0);
    CHECK(has(folder.read("a.svg"), "Envelope of G, Q"));
    CHECK(cremona({"render", copy, "-o", svg, "--view", "Two", "--case", "envelope"}).status == 0);
    CHECK(has(folder.read("a.svg"), "Envelope of G, Q"));
    CHECK(cremona({"render", copy, "-o", svg, "--view", "Corner"}).status == 0);
    CHECK(!has(folder.read("a.svg"), ">D<")); // the foot of the other column is out of sight
    const Run wrong = cremona({"render", copy, "-o", svg, "--view", "corner"});
    CHECK(wrong.status == 2);
    CHECK(has(wrong.err, "Corner"));
}

TEST_CASE("A structure that can move is drawn moving, with status 3 and its motions on stderr")
{
    const Folder folder;
    const Run run = cremona({"render", "-", "-o", folder.path("a.svg"), "--mechanism", "2"}, cli_test::floating());
    CHECK(run.status == 3);
    CHECK(run.out.empty());
    CHECK(cli_test::count(run.err, "the structure can move without strain") == 3);
    CHECK(has(run.err, "a.svg shows the motion 2 of 3"));
    CHECK(has(folder.read("a.svg"), "<svg"));
}

TEST_CASE("A motion that the structure does not have is refused with how many it has, and nothing is drawn")
{
    const Folder folder;
    const Run run = cremona({"render", "-", "-o", folder.path("a.svg"), "--mechanism", "9"}, cli_test::floating());
    CHECK(run.status == 2);
    CHECK(run.err == "cremona render: --mechanism: found 9; wanted at most 3, the number of its motions\n");
    CHECK_FALSE(std::filesystem::exists(folder.path("a.svg")));
}

TEST_CASE("A disk without room is told of, whatever the kind of picture")
{
    if (!std::filesystem::exists("/dev/full")) return;
    const Folder folder;
    for (const char* name : {"a.svg", "a.pdf", "a.png"}) {
        CAPTURE(name);
        std::filesystem::create_symlink("/dev/full", folder.path(name));
        const Run run = cremona({"render", "-", "-o", folder.path(name)}, cantilever());
        CHECK(run.status == 2);
        CHECK(has(run.err, name));
    }
}

TEST_CASE("Wrong options of a picture are answered with what is wanted")
{
    const auto message = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"render", "-"});
        const Run run = cremona(options, cantilever());
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        return run.err;
    };
    CHECK(message({}) == "cremona render: no output is given; add -o OUT.png, .svg or .pdf\n");
    CHECK(has(message({"-o", "a.gif"}), "cannot draw the kind \".gif\"; choose from: .png, .svg, .pdf"));
    CHECK(has(message({"-o", "a.svg", "--show", "loads,moment"}), "--show: there is no \"moment\""));
    CHECK(has(message({"-o", "a.svg", "--size", "800"}), "--size: found \"800\"; wanted width and height"));
    CHECK(has(message({"-o", "a.svg", "--size", "800x0"}), "wanted a whole number from 64 to 16384"));
    CHECK(has(message({"-o", "a.svg", "--scale", "-1"}), "--scale: found \"-1\"; wanted a number greater than 0"));
    CHECK(has(message({"-o", "a.png", "--size", "9000x900", "--scale", "2"}), "larger than 16384 pixels a side"));
    CHECK(has(message({"-o", "a.svg", "--theme", "drak"}), "did you mean \"dark\"?"));
    CHECK(has(message({"-o", "/no/such/folder/a.svg"}), "there is no folder /no/such/folder; make it first"));
}

namespace {

/// A beam of 10 m on two supports, a line and a train of two axles 2 m apart.
constexpr const char* crane_runway = R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
  "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [10, 0], "support": "roller"}],
  "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
  "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
  "paths": [{"id": "p", "members": ["AB"]}],
  "influence_lines": [{"id": "M", "path": "p", "quantity": "section_force", "member": "AB", "component": "M", "at": 4}],
  "trains": [{"id": "crane", "path": "p", "axles": [100, 100], "spacings": [2]}]})";

} // namespace

TEST_CASE("An influence line is drawn with its ordinates, its largest one and its area")
{
    const Folder folder;
    const Run run = cremona({"render", "-", "-o", folder.path("a.svg"), "--influence", "M"}, crane_runway);
    CHECK(run.status == 0);
    // a triangle of x (L - x) / L over the section
    for (const char* text : {"Influence line of M(AB, 4 m) [m]", "max 2.4 m at s = 4 m", "areas +12 m²"})
        CHECK_MESSAGE(has(folder.read("a.svg"), text), text);
}

TEST_CASE("A train is drawn where it is worst, with the sum that says so")
{
    const Folder folder;
    CHECK(cremona({"render", "-", "-o", folder.path("a.svg"), "--train", "crane"}, crane_runway).status == 0);
    // Barré: P (L - d / 2)^2 / 2L where axle and resultant are as far from mid-span; of two such sections that is drawn
    // under which the train is the first to stand
    for (const char* text : {"M(AB, 5.5 m) = 405 kN·m under crane, its largest value", "= 100 × 2.475 + 100 × 1.575"})
        CHECK_MESSAGE(has(folder.read("a.svg"), text), text);
    CHECK(cremona({"render", "-", "-o", folder.path("a.svg"), "--train", "crane", "--node", "A", "--component", "fy",
                   "--at-position", "11"},
                  crane_runway)
              .status == 0);
    CHECK(has(folder.read("a.svg"), "fy(A) = 10 kN under crane: leading axle at s = 11 m")); // one axle, 1 m from B
}

TEST_CASE(
    "What an axle brings is 0 where rounding alone is left of it, in the sentence, over the curve and in the diagrams")
{
    struct Standing {
        std::vector<std::string> train;
        std::string zero;
    };
    const Folder folder;
    std::string bridge = text_of_source("examples/bridge.json");
    const std::string list = "\"trains\": [";
    bridge.insert(bridge.find(list) + list.size(), R"({"id": "one", "path": "deck", "axles": [10], "spacings": []},)");
    for (const Standing& asked : std::vector<Standing>{
             {{"one", "--member", "BC", "--at", "52", "--component", "M", "--at-position", "60"}, "M(BC, 52 ft) = 0 "},
             {{"one", "--member", "BC", "--at", "52", "--component", "M", "--at-position", "0"}, "M(BC, 52 ft) = 0 "},
             {{"one", "--member", "BC", "--at", "52", "--component", "V", "--at-position", "60"}, "V(BC, 52 ft) = 0 "},
             {{"one", "--node", "B", "--component", "fy", "--at-position", "200"}, "fy(B) = 0 "},
             {{"one", "--node", "C", "--component", "rz", "--at-position", "60"}, "rz(C) = 0 "},
             {{"HS20", "--member", "BC", "--at", "48", "--component", "M", "--at-position", "228"},
              "M(BC, 48 ft) = 0 "}}) {
        std::vector<std::string> words{"render", "-", "-o", folder.path("a.svg"), "--train"};
        words.insert(words.end(), asked.train.begin(), asked.train.end());
        CHECK(cremona(words, bridge).status == 0);
        const std::string picture = folder.read("a.svg");
        CHECK_MESSAGE(has(picture, asked.zero), asked.zero);
        CHECK_MESSAGE(!has(picture, "e-1"), asked.zero);
    }
}

TEST_CASE(
    "Where a train is put, distances that may vary are those that are worst there, as far as any axle reaches the path")
{
    const Folder folder;
    std::string runway = crane_runway;
    const std::string spacings = "\"spacings\": [2]";
    runway.insert(runway.find(spacings) + spacings.size(), R"(, "spacing_ranges": {"1": [2, 8]})");
    const auto put = [&](const std::string& s) {
        return cremona({"render", "-", "-o", folder.path("a.svg"), "--train", "crane", "--member", "AB", "--at", "4",
                        "--component", "M", "--at-position", s},
                       runway);
    };
    CHECK(put("10.5").status == 0); // the leading axle has left the beam, the other one stands at the section
    CHECK(has(folder.read("a.svg"), "M(AB, 4 m) = 240 kN·m under crane: leading axle at s = 10.5 m"));
    CHECK(put("18").status == 0);
    CHECK(has(put("18.5").err, "found 18.5 m; wanted 0 to 18 m"));
}

TEST_CASE("A train's name stands in the head as it is written")
{
    const Folder folder;
    CHECK(cremona({"render", "-", "-o", folder.path("a.svg"), "--train", "crane"}, crane_runway).status == 0);
    CHECK(has(folder.read("a.svg"), "crane on the path"));
    CHECK(!has(folder.read("a.svg"), "Crane on the path"));
    CHECK(cremona({"render", "-", "-o", folder.path("a.svg")}, cantilever()).status == 0);
    CHECK(has(folder.read("a.svg"), "Load case P"));
}

TEST_CASE("What goes wrong with moving loads is told by the option")
{
    const auto message = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"render", "-", "-o", "a.svg"});
        const Run run = cremona(options, crane_runway);
        CHECK(run.status == 2);
        return run.err;
    };
    CHECK(has(message({"--influence", "N"}), "--influence: there is no \"N\"; choose from: M"));
    CHECK(has(message({"--train", "cran"}), "did you mean \"crane\"?"));
    CHECK(has(message({"--train", "crane", "--influence", "M"}), "--influence and --train ask for different things"));
    CHECK(has(message({"--at-position", "2"}), "--at-position needs --train too"));
    CHECK(has(message({"--member", "AB", "--component", "M"}), "--member needs --train too"));
    CHECK(has(message({"--train", "crane", "--at-position", "12.5"}), "found 12.5 m; wanted 0 to 12 m"));
    CHECK(has(message({"--train", "crane", "--at-position", "-1"}), "found -1 m; wanted 0 to 12 m"));
    CHECK(has(message({"--train", "crane", "--at-position", "1250 cm", "--unit", "length=mm"}),
              "found 1250 cm; wanted 0 to 12000 mm"));
    CHECK(has(message({"--train", "crane", "--at-position", "nan"}), "--at-position"));
    CHECK(has(message({"--train", "crane", "--member", "AB", "--component", "M", "--at", "11"}),
              "\"at\" is 11 m, beyond the end of member \"AB\"; give a length from 0 to 10 m"));
}

TEST_CASE("A broken file draws nothing and leaves an old picture as it was")
{
    const Folder folder;
    const std::string old = folder.write("a.svg", "old");
    CHECK(cremona({"render", "-", "-o", old}, "{").status == 2);
    CHECK(folder.read("a.svg") == "old");
}

TEST_SUITE_END();
