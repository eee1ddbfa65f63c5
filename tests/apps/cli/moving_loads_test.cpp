#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/apps/cli/run_cremona.h"
#include "tests/text_of.h"

using cli_test::cremona;
using cli_test::has;
using cli_test::Run;
using nlohmann::json;

namespace {

constexpr const char* beam_of_8_m =
    R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
        "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
        "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [8, 0], "support": "roller"}],
        "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}]})";

} // namespace

TEST_SUITE_BEGIN("cremona");

TEST_CASE("A line is told in sentences, with the extremes of its table and their places")
{
    const Run told = cremona({"influence", "examples/influence.json", "--line", "M at mid-span", "--describe"});
    CHECK(told.status == 0);
    CHECK(has(told.out, "Influence line of M(BC"));
    CHECK(has(told.out, "max 2.106 m at s = 16.25 m"));
    CHECK(has(told.out, "areas"));
    CHECK(has(told.out, "zero at s = 0 m, "));
    CHECK(has(told.out, "kink at s = 16.25 m.\n"));
    CHECK(has(told.out, "of degree 3 on s = 0 m to 10 m, of degree 2 piece by piece on s = 10 m to 22.5 m"));
    const Run portuguese = cremona({"--lang", "pt", "influence", "examples/influence.json", "--describe"});
    CHECK(has(portuguese.out, "Linha de influência de M(BC"));
}

TEST_CASE("A reaction that its support does not hold is not given as zeros alone: it is said why")
{
    const std::vector<std::string> asked{"influence", "examples/influence.json", "--node", "B", "--component", "fx"};
    const Run line = cremona(asked);
    CHECK(line.status == 0);
    CHECK(has(line.err, "warning: the support of node B does not hold fx, so that this reaction is zero wherever the "
                        "load stands; ask for a component that it holds"));
    CHECK(cremona({"influence", "examples/influence.json", "--node", "A", "--component", "fx"}).err.empty());
    std::vector<std::string> in_words = asked;
    in_words.emplace_back("--describe");
    const Run told = cremona(in_words);
    CHECK(told.err.empty());
    CHECK(has(told.out, "The support of node B does not hold fx: this reaction is zero wherever the load stands.\n"));
    CHECK(has(cremona({"train", "examples/bridge.json", "--train", "HS20", "--node", "B", "--component", "fx"}).err,
              "the support of node B does not hold fx"));
}

TEST_CASE("A displacement that a support holds is exactly 0 along the path, and it is said which support holds it")
{
    const std::vector<std::string> asked{"influence", "examples/influence.json", "--node", "B", "--component", "uy"};
    const auto with = [&](const char* option) {
        std::vector<std::string> all = asked;
        all.emplace_back(option);
        return cremona(all);
    };
    const char* const warning = "warning: the support of node B holds uy, so that this displacement is zero wherever "
                                "the load stands; ask for one that it leaves free";
    CHECK(has(cremona(asked).err, warning));
    const Run for_programs = with("--json");
    CHECK(has(for_programs.err, warning));
    const json line = json::parse(for_programs.out).at("lines")[0];
    for (const json& station : line["stations"]) CHECK(station["value"].get<double>() == 0.0);
    for (const json& piece : line["pieces"]) CHECK(piece["polynomial"] == json::parse("[0, 0, 0, 0]"));
    const Run told = with("--describe");
    CHECK(told.err.empty());
    CHECK(has(told.out, "The support of node B holds uy: this displacement is zero wherever the load stands.\n"));
    CHECK(cremona({"influence", "examples/influence.json", "--node", "B", "--component", "ux"}).err.empty());
    CHECK(has(cremona({"train", "examples/bridge.json", "--train", "HS20", "--node", "B", "--component", "uy"}).err,
              warning));
}

TEST_CASE("In JSON what is 0 by statics is 0, and a jump has both its values at the section")
{
    const auto stations = [](const char* file, const char* path, const char* member, const char* component) {
        const Run run = cremona({"influence", file, "--path", path, "--member", member, "--at", "50%", "--component",
                                 component, "--stations", "2", "--json"});
        const json line = json::parse(run.out).at("lines")[0];
        std::vector<double> values;
        for (const json& station : line["stations"]) values.push_back(station["value"]);
        return values;
    };
    const auto check = [](const std::vector<double>& values, const std::vector<double>& wanted) {
        REQUIRE(values.size() == wanted.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            CAPTURE(i);
            if (wanted[i] == 0.0) CHECK(values[i] == 0.0);
            else CHECK(values[i] == doctest::Approx(wanted[i]).epsilon(1e-12));
        }
    };
    check(stations("examples/gerber_beam.json", "AB", "AB", "V"), {0.0, -0.5, 0.5, 0.0});
    constexpr const char* chord = "L0L1,L1L2,L2L3,L3L4,L4L5,L5L6";
    check(stations("examples/pratt_truss.json", chord, "L1U1", "N"), {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    // panels of 3 m and 4 m: 5/6 of the load on a panel point, times 3/4
    check(stations("examples/pratt_truss.json", chord, "L0L1", "N"), {0.0, 0.625, 0.5, 0.375, 0.25, 0.125, 0.0});
}

TEST_CASE("A train is told in sentences: where it is worst, and what stands where")
{
    const Run told = cremona({"train", "examples/bridge.json", "--train", "HS20", "--member", "BC", "--at", "50%",
                              "--component", "M", "--describe"});
    CHECK(told.status == 0);
    CHECK(has(told.out, "Influence line of M(BC"));
    CHECK(has(told.out, "Train HS20"));
    CHECK(has(told.out, "s = 114 ft"));
    CHECK(cremona({"train", "examples/bridge.json", "--describe"}).status == 0); // the one that `render` draws
    CHECK(cremona({"train", "examples/bridge.json", "--describe", "--json"}).status == 2);
}

TEST_CASE("An envelope is told in sentences: of each component and reaction both ends, where, and under which train")
{
    const std::vector<std::string> asked{"train", "examples/bridge.json", "--envelope", "deck + G", "--describe"};
    const Run told = cremona(asked);
    CHECK(told.status == 0);
    CHECK(has(told.out, "Envelope deck + G: G + 1.35 × (HS20, lane).\n"));
    CHECK(has(told.out, "N is zero wherever the loads stand.\n"));
    CHECK(has(told.out, "V(BC, 0 ft) = 143.8 kip under HS20, its largest value: leading axle at s = 88 ft.\n"));
    CHECK(has(told.out, "fy(A) = 109.1 kip under HS20, its largest value: leading axle at s = 28 ft.\n"));
    CHECK_FALSE(has(told.out, "fx(B)")); // the roller does not hold it
    std::vector<std::string> of_one = asked;
    of_one.insert(of_one.end(), {"--member", "AB", "--at", "12 ft", "--component", "V"});
    const Run one = cremona(of_one);
    CHECK(has(one.out, "V(AB, 12 ft) = −1.583 kip under lane, its least value: uniform load on s = "));
    CHECK(has(one.out, "G alone brings "));
    std::vector<std::string> portuguese = asked;
    portuguese.insert(portuguese.begin(), {"--lang", "pt"});
    CHECK(has(cremona(portuguese).out, "N é nulo onde quer que as cargas estejam.\n"));
}

TEST_CASE("In words the largest and the least value of a train have all that stands where, and a proof is of a train")
{
    const Run lane = cremona({"train", "examples/bridge.json", "--train", "lane", "--describe"});
    // over the supports the ordinates change their sign
    CHECK(has(lane.out, "its largest value: uniform load on s = 60 ft to 140 ft; single force at s = 100 ft.\n"));
    CHECK(has(lane.out,
              "its least value: uniform load on s = 0 ft to 60 ft, s = 140 ft to 200 ft; single force at s = "));
    const Run proof = cremona({"train", "examples/bridge.json", "--envelope", "deck + G", "--proof"});
    CHECK(proof.status == 2);
    CHECK(has(proof.err, "--proof is of one train's positions"));
}

TEST_CASE("What would be looked for for minutes is refused, and a file without lines says that it has none")
{
    const Run many = cremona({"train", "examples/bridge.json", "--stations", "100000"});
    CHECK(many.status == 2);
    CHECK(has(many.err, "Ask for fewer sections"));
    const Run none = cremona({"render", "examples/portal.json", "-o", "unwritten.svg", "--influence", "nope"});
    CHECK(none.status == 2);
    CHECK(has(none.err, "--influence: there is no \"nope\"; the file has none"));
}

TEST_CASE("A proof is told in sentences: how many candidates, the best of them, and the next")
{
    const std::vector<std::string> asked{"train", "examples/bridge.json", "--train", "HS20",   "--member", "BC", "--at",
                                         "50%",   "--component",          "M",       "--proof"};
    std::vector<std::string> in_words = asked;
    in_words.emplace_back("--describe");
    const Run told = cremona(in_words);
    CHECK(told.status == 0);
    CHECK(has(told.out, "How the largest M(BC, 50%) was found.\n"));
    CHECK(has(told.out, "candidates were looked at: "));
    CHECK(has(told.out, "the largest: "));
    CHECK(has(told.out, "leading axle at s = 114 ft"));
    CHECK(has(told.out, "next to it: "));
    // The bridge is symmetrical, and so is the truck but for its direction.
    CHECK(has(told.out, ", its least value: leading axle at s = 185.3 ft.\n"));
    CHECK(has(told.out, "the least: −124.4 kip·ft, leading axle at s = 185.3 ft, root of the derivative.\n"));
    CHECK(has(told.out, "equal to it: −124.4 kip·ft, leading axle at s = 14.69 ft, running backwards, "
                        "root of the derivative.\n"));
}

TEST_CASE("Where the axles are best away the proof says so, and not that a position of theirs is best")
{
    constexpr const char* beam =
        R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
            "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
            "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [8, 0]}],
            "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
            "trains": [{"id": "T", "path": ["AB"], "axles": [1],
                        "uniform": 10, "uniform_extent": "outside", "gap": 2}]})";
    const Run told = cremona({"train", "-", "--node", "A", "--component", "fy", "--describe", "--proof"}, beam);
    CHECK(told.status == 0);
    CHECK(has(told.out, "fy(A) = 80 kN under T, its largest value: no axle on the path"));
    CHECK(has(told.out, "the largest: 0 kN, no axle on the path.\n"));
    CHECK(has(told.out, "next to it: −19 kN, leading axle at s = 0 m, break, + side.\n")); // 1 - 10 · 2
}

TEST_CASE(
    "A number of an envelope goes back to the train that governs, its sum, and an analysis with it standing there")
{
    const std::vector<std::string> asked{"train", "examples/bridge.json",        "--envelope", "deck + G",
                                         "--why", "member=BC,at=50%,component=M"};
    const Run told = cremona(asked);
    REQUIRE(told.status == 0);
    CHECK(has(told.out, "M(BC, 50%) = 1374.32 kip·ft under deck + G: where it comes from\nTrain HS20 governs.\n"));
    CHECK(has(told.out, "  412.222 + 1.35 × (712.667) = 1374.32 kip·ft\n"));
    std::vector<std::string> for_programs = asked;
    for_programs.emplace_back("--json");
    const json why = json::parse(cremona(for_programs).out);
    double sum = 0.0;
    for (const json& force : why["standing"]["forces"])
        sum += force["force"].get<double>() * force["ordinate"].get<double>();
    CHECK(why["why"]["value"].get<double>() == doctest::Approx(sum));
    CHECK(why["permanent"].get<double>() + why["factor"].get<double>() * sum ==
          doctest::Approx(why["value"].get<double>()));
    const Run worst = cremona({"train", "examples/bridge.json", "--train", "lane", "--why", "member=BC,component=V"});
    CHECK(worst.status == 0);
    CHECK(has(cremona({"train", "examples/bridge.json", "--why", "node=B,component=fy"}).err,
              "name it by --train or --envelope"));
}

TEST_CASE("Where a value is nothing but rounding beside the others, the table has 0")
{
    constexpr const char* beam =
        R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
            "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
            "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [7, 0], "support": "roller"}],
            "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
            "trains": [{"id": "T", "path": ["AB"], "axles": [3, 7], "spacings": [1.3]}]})";
    const Run moved = cremona({"train", "-", "--member", "AB", "--component", "M"}, beam);
    CHECK(moved.status == 0);
    CHECK(!has(moved.out, "e-"));
}

TEST_CASE("Trains and influence lines are printed in chosen units, quantity by quantity, JSON in those of the file")
{
    constexpr const char* beam =
        R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
            "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
            "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [8, 0], "support": "roller"}],
            "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
            "paths": [{"id": "deck", "members": ["AB"]}], "trains": [{"id": "T", "path": "deck", "axles": [7]}]})";
    const auto asked = [&](const char* command, const std::vector<std::string>& words) {
        std::vector<std::string> all{command, "-", "--member", "AB", "--at", "3", "--component", "M"};
        all.insert(all.end(), words.begin(), words.end());
        return cremona(all, beam);
    };
    const Run train = asked("train", {"--unit", "moment=kN*cm,length=mm"});
    CHECK(has(train.out, "max [kN·cm]"));
    CHECK(has(train.out, "1312.5")); // P a b / (a + b)
    CHECK(has(train.out, "leading axle at s = 3000"));
    const Run line = asked("influence", {"--unit", "moment=kN*cm"});
    CHECK(has(line.out, "η [kN·cm/kN]"));
    CHECK(has(line.out, "max  187.5"));
    CHECK(has(line.out, "areas: 750 "));
    CHECK(has(asked("influence", {"--unit", "length=cm", "--describe"}).out, "at s = 300 cm"));
    const Run why = cremona({"train", "-", "--why", "member=AB,at=3,component=M", "--unit", "force=N"}, beam);
    CHECK(has(why.out, "M(AB, 3 m) = 13125 N·m under T"));
    for (const char* const command : {"train", "influence"})
        CHECK(has(asked(command, {"--unit", "length=cm", "--json"}).err, "--json counts in the units of the file"));
    CHECK(has(cremona({"truss", "examples/truss.json", "--unit", "force=N"}).out, "N(AD) = −36055.5"));
}

TEST_CASE("A train whose worst sections would be looked for too long is refused by name; one section of it is found")
{
    std::string axles = "1", spacings, ranges;
    for (int i = 1; i <= 120; ++i) {
        axles += ", 1";
        spacings += std::string(i > 1 ? ", " : "") + "0.1";
        ranges += std::string(i > 1 ? ", " : "") + "\"" + std::to_string(i) + "\": [0.1, 0.2]";
    }
    const std::string beam =
        R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
            "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
            "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [8, 0], "support": "roller"}],
            "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
            "trains": [{"id": "Convoy", "path": ["AB"], "axles": [)" +
        axles + R"(], "spacings": [)" + spacings + R"(], "spacing_ranges": {)" + ranges + "}}]}";
    const Run all = cremona({"train", "-"}, beam);
    CHECK(all.status == 2);
    CHECK(has(all.err, "Convoy: 120 spacings vary; with 1 members on its path"));
    CHECK(cremona({"train", "-", "--member", "AB", "--at", "3", "--component", "M"}, beam).status == 0);
}

TEST_CASE("A train of very many axles on a long path is refused before it is searched, one section of it is found")
{
    json model = json::parse(beam_of_8_m);
    json path = json::array();
    for (int i = 0; i < 12; ++i) {
        const std::string from = std::to_string(i), to = std::to_string(i + 1);
        if (i == 0) model["nodes"] = json::array({{{"id", "0"}, {"at", {0, 0}}, {"support", "pin"}}});
        model["nodes"].push_back({{"id", to}, {"at", {7 * (i + 1), 0}}, {"support", "roller"}});
        if (i == 0) model["members"] = json::array();
        model["members"].push_back({{"id", "m" + to}, {"nodes", {from, to}}, {"material", "m"}, {"section", "s"}});
        path.push_back("m" + to);
    }
    model["trains"] = json::array({{{"id", "Long"},
                                    {"path", path},
                                    {"axles", std::vector<double>(500, 2.0)},
                                    {"spacings", std::vector<double>(499, 0.3)}}});
    const Run all = cremona({"train", "-"}, model.dump());
    CHECK(all.status == 2);
    CHECK(has(all.err,
              "Long: with 500 axles and 12 members on its path the worst sections would be looked for too long"));
    CHECK(cremona({"train", "-", "--member", "m3", "--at", "3", "--component", "M"}, model.dump()).status == 0);
}

TEST_CASE("Of a train of 500 axles the first and the last are told, and how many there are between")
{
    json model = json::parse(beam_of_8_m);
    json& train = model["trains"][0];
    train = {{"id", "Long"}, {"path", {"AB"}}, {"axles", json::array()}, {"spacings", json::array()}};
    for (int i = 0; i < 500; ++i) train["axles"].push_back(2.0 + 0.001 * i);
    for (int i = 1; i < 500; ++i) train["spacings"].push_back(0.01 + 1e-5 * i);
    std::vector<std::string> asked{"train", "-", "--member", "AB", "--at", "3", "--component", "M"};
    const Run told = cremona(asked, model.dump());
    REQUIRE(told.status == 0);
    CHECK(has(told.out, "; 498 more; "));
    CHECK(has(told.out, "spacings 0.01001; 497 more; 0.01499"));
    CHECK(told.out.size() < 1000);
    asked.emplace_back("--describe");
    const Run in_words = cremona(asked, model.dump());
    CHECK(has(in_words.out, "498 more between them."));
    CHECK(in_words.out.size() < 2000);
}

TEST_CASE(
    "A path of the file stands alone: in a list it is named as what it is, and what is unknown is told of members")
{
    const auto complaint = [](const char* path) {
        return cremona({"influence", "examples/influence.json", "--path", path}).err;
    };
    CHECK(has(complaint("deck,nope"), "--path: \"deck\" is a path of the file and stands alone"));
    CHECK(!has(complaint("deck,nope"), "did you mean"));
    CHECK(has(complaint("AB,decq"), "--path: there is no \"decq\""));
    CHECK(!has(complaint("AB,decq"), "deck\""));
    CHECK(has(complaint("decq"), "did you mean \"deck\"?"));
}

TEST_CASE("Where a line cannot be computed that is said of the line, with its path")
{
    constexpr const char* beam =
        R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
            "materials": [{"id": "m", "E": 2.1e8}], "sections": [{"id": "s", "A": 0.05, "Iz": 0.001}],
            "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [4.99999999, 0]},
                      {"id": "C", "at": [5, 0]}, {"id": "D", "at": [12, 0], "support": "roller"}],
            "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"},
                        {"id": "CB", "nodes": ["C", "B"], "material": "m", "section": "s"},
                        {"id": "CD", "nodes": ["C", "D"], "material": "m", "section": "s"}],
            "trains": [{"id": "T", "path": ["CD", "CB", "AB"], "axles": [7]}]})";
    const std::vector<std::string> asked{"--member", "CD", "--at", "50%", "--component", "M"};
    for (std::vector<std::string> words :
         {std::vector<std::string>{"influence", "-", "--path", "AB,CB,CD"}, std::vector<std::string>{"train", "-"}}) {
        const std::string path = words.front() == "train" ? "from D to A" : "from A to D";
        words.insert(words.end(), asked.begin(), asked.end());
        const Run run = cremona(words, beam);
        CHECK(run.status == 3);
        CHECK_MESSAGE(has(run.err, "M(CD, 50%): its influence line along the path " + path + " cannot be computed: "),
                      run.err);
        CHECK(!has(run.err, "case path"));
    }
}

TEST_CASE("An answer that stands off its path is refused with the units of both lengths")
{
    json model = json::parse(beam_of_8_m);
    model["influence"] = json::parse(
        R"({"path": ["AB"], "positions": [9.5], "lines": [{"quantity": "reaction", "node": "A", "component": "fy"}]})");
    CHECK(
        has(cremona({"verify", "-"}, model.dump()).err, "position 9.5 m is off the path; give a length from 0 to 8 m"));
}

TEST_CASE("Of a truss under a train nothing is written that is but rounding")
{
    json model = json::parse(text_of_source("examples/pratt_truss.json"));
    for (auto& node : model.at("nodes")) {
        const double x = node.at("at")[0].get<double>(), y = node.at("at")[1].get<double>();
        node["at"] = {1.0371 * x + 0.113 * y, 0.977 * y + 0.0731 * x}; // no zero comes out as 0
    }
    model.erase("expected");
    model["paths"] = json::parse(R"([{"id": "deck", "members": ["L0L1", "L1L2", "L2L3", "L3L4", "L4L5", "L5L6"]}])");
    model["trains"] = json::parse(
        R"([{"id": "T", "path": "deck", "axles": [8, 32, 32], "spacings": [1.4, 1.7], "both_directions": true}])");
    const Run run = cremona({"train", "-"}, model.dump());
    CHECK(run.status == 0);
    CHECK(run.out.find("e-") == std::string::npos);
}

TEST_SUITE_END();
