#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"

using cli_test::cantilever;
using cli_test::cremona;
using cli_test::has;
using cli_test::Run;
using nlohmann::json;

TEST_SUITE_BEGIN("cremona");

TEST_CASE("From JSON to JSON the model stays the same, and a second time the file too")
{
    const Folder folder;
    const std::string in = folder.write("in.json", cantilever());
    REQUIRE(cremona({"convert", in, folder.path("a.json")}).status == 0);
    REQUIRE(cremona({"convert", folder.path("a.json"), folder.path("b.json")}).status == 0);
    CHECK(folder.read("a.json") == folder.read("b.json"));
    CHECK(json::parse(folder.read("a.json"))["load_cases"] == json::parse(cantilever())["load_cases"]);
    CHECK(cremona({"convert", "-", "-"}, cantilever()).out == folder.read("a.json"));
}

TEST_CASE("The extension of the output may be in capital letters")
{
    const Folder folder;
    const std::string in = folder.write("in.json", cantilever());
    CHECK(cremona({"convert", in, folder.path("a.JSON")}).status == 0);
    CHECK(cremona({"convert", in, folder.path("a.Csv")}).status == 0);
    CHECK(folder.read("a.Csv").starts_with("case,part,id"));
    CHECK(has(cremona({"convert", in, folder.path("a.OBJ")}).err, "is written as another one only"));
}

TEST_CASE("In other units the structure sags the same, and its checks still pass")
{
    const Folder folder;
    const std::string in = folder.write("in.json", cantilever()), out = folder.path("mm.json");
    REQUIRE(cremona({"convert", in, out, "--units", "mm,N"}).status == 0);
    const json model = json::parse(folder.read("mm.json"));
    CHECK(model["units"] == json({{"length", "mm"}, {"force", "N"}}));
    CHECK(model["nodes"][1]["at"] == json({4000, 0}));
    CHECK(model["materials"][0]["E"] == 2e5); // N/mm^2
    CHECK(cremona({"verify", out}).out.ends_with("3 passed, 0 failed, 0 skipped\n"));
    const json solved = json::parse(cremona({"solve", out, "--json"}).out);
    CHECK(solved["cases"]["P"]["nodes"]["B"]["u"]["uy"].get<double>() == doctest::Approx(-12.8)); // mm
}

TEST_CASE("A bent member is a chain on its curve, and stands on the same reactions under what it bore")
{
    const Folder folder;
    const std::string in = folder.write("in.json", cantilever()), out = folder.path("bent.json");
    const Run run = cremona({"convert", in, out, "--bend", "members=AB,curve=parabola,rise=150 cm,parts=4"});
    REQUIRE_MESSAGE(run.status == 0, run.err);
    CHECK(has(run.err, "AB is bent; its parts are "));
    const json model = json::parse(folder.read("bent.json"));
    REQUIRE(model["members"].size() == 4);
    CHECK(model["nodes"][3]["at"] == json({2, 1.5})); // the crown
    const json solved = json::parse(cremona({"solve", out, "--json", "--case", "P"}).out)["cases"]["P"];
    CHECK(solved["nodes"]["A"]["reaction"]["fy"].get<double>() == doctest::Approx(12.0));
    CHECK(solved["nodes"]["A"]["reaction"]["mz"].get<double>() == doctest::Approx(48.0));
}

TEST_CASE("A curve that is none is refused in words: without a rise, in one part, of a truss, misspelt")
{
    const auto refused = [](const std::string& file, const std::string& bend, const std::string& reason) {
        const Run run = cremona({"convert", file, "-", "--bend", bend}, cantilever());
        CAPTURE(run.err);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CHECK(has(run.err, reason));
    };
    for (const char* none : {"members=AB,rise=0", "members=AB,rise=1e-300", "members=AB,rise=-1e-9"})
        refused("-", none, "such a rise leaves the member straight");
    refused("-", "members=AB,rise=1,parts=1", "wanted a whole number from 2 to 200");
    refused("-", "members=AB,rise=1,parts=201", "wanted a whole number from 2 to 200");
    refused("-", "members=AB,rise=1e300", "--bend rise: found 1e300; wanted lengths up to ");
    refused("-", "members=AB,rise=1,curve=circle", "wanted one of arc, parabola");
    refused("-", "members=AB,rise=1 kN", "--bend rise: ");
    refused("-", "members=BC,rise=1", "there is no \"BC\"");
    refused("-", "AB", "says no curve");
    refused("examples/truss.json", "members=1,rise=1", "the bars of a truss stay straight");
}

TEST_CASE("With the combinations of a code a model has them as ordinary ones, and each is told with its clause")
{
    const Folder folder;
    json two_cases = json::parse(cantilever());
    two_cases["load_cases"].push_back({{"id", "Q"}});
    const std::string in = folder.write("in.json", two_cases.dump()), out = folder.path("out.json");
    const Run run = cremona({"convert", in, out, "--combinations", "EN1990", "--actions", "P=permanent,Q=wind"});
    REQUIRE(run.status == 0);
    CHECK(has(run.err, "ULS 1.35 P + 1.5 Q: EN 1990:2002 + A1:2005, (6.10), Q leads"));
    const json model = json::parse(folder.read("out.json"));
    const json wanted = {{"id", "ULS 1.35 P + 1.5 Q"}, {"factors", {{"P", 1.35}, {"Q", 1.5}}}};
    CHECK(std::ranges::find(model["combinations"], wanted) != model["combinations"].end());
    const auto refused = [&](const char* code, const char* actions) {
        const Run refusal = cremona({"convert", in, out, "--combinations", code, "--actions", actions});
        CHECK(refusal.status == 2);
        return refusal.err;
    };
    CHECK(has(refused("EN1991", "P=permanent"), "EN1990"));
    CHECK(has(refused("EN1990", "P"), "such as G=permanent"));
    CHECK(has(refused("EN1990", "P=rain"), "congregation"));
    CHECK(has(refused("EN1990", "Z=wind"), "--actions"));
    CHECK(has(refused("EN1990", "P=permanent,P=wind"), "--actions: P is named twice"));
    CHECK(has(cremona({"convert", in, out, "--combinations", "EN1990"}).err, "--combinations needs --actions too"));
    const Run alone = cremona({"convert", in, out, "--actions", "P=permanent"});
    CHECK(alone.status == 2);
    CHECK(has(alone.err, "--actions needs --combinations too"));
}

TEST_CASE("To CSV every result stands in one long table with its unit")
{
    const Folder folder;
    REQUIRE(cremona({"convert", folder.write("in.json", cantilever()), folder.path("out.csv")}).status == 0);
    const std::string table = folder.read("out.csv");
    CHECK(table.starts_with("case,part,id,x [m],component,value,unit\nP,node,A,,ux,0,m\n"));
    CHECK(has(table, "\nU,member,AB,4,"));
}

TEST_CASE("The one table of a plane model has the values that JSON has")
{
    const std::string model = "tests/cases/plane/PB-001-Q8.json";
    const Folder folder;
    REQUIRE(cremona({"convert", model, folder.path("out.csv")}).status == 0);
    const std::string table = folder.read("out.csv");
    CHECK(table.starts_with("case,part,id,region,x [m],y [m],component,value,unit\nM,point,A,,"));
    const json M = json::parse(cremona({"solve", model, "--json"}).out)["cases"]["M"];
    const auto value_of = [&](const std::string& row) {
        const std::size_t at = table.find("\nM," + row);
        REQUIRE_MESSAGE(at != std::string::npos, row);
        return std::stod(table.substr(at + row.size() + 3));
    };
    const json& C = M["points"]["C"];
    CHECK(value_of("point,C,,10,1,uy,") == doctest::Approx(C["u"]["uy"].get<double>()).epsilon(1e-14));
    CHECK(value_of("point,C,plate,10,1,sx,") ==
          doctest::Approx(C["stress"]["plate"]["sx"].get<double>()).epsilon(1e-14));
    CHECK(has(table, "\nM,largest,,plate,"));
    CHECK(has(table, "\nM,loads,,,,,fx,0,kN\n"));
}

TEST_CASE("What is doubtful about the results is told beside their table, too")
{
    const Folder folder;
    json soft = json::parse(cantilever());
    soft["materials"][0]["E"] = 2e-3;
    const Run run = cremona({"convert", folder.write("soft.json", soft.dump()), folder.path("out.csv")});
    CHECK(run.status == 0);
    CHECK(has(run.err, "warning: node B moves"));
}

TEST_CASE("Kinds that are not written, and models that would become solids, are told")
{
    const Folder folder;
    const std::string in = folder.write("in.json", cantilever());
    CHECK(has(cremona({"convert", in, "out.xls"}).err, "cannot write the kind \".xls\"; choose from: .json"));
    CHECK(has(cremona({"convert", in, "out.obj"}).err,
              "out.obj: a file of solids (.eul, .obj, .off) is written as another one only"));
    CHECK(cremona({"convert", in, "out.obj"}).status == 2);
    CHECK(has(cremona({"convert", "box.off", "out.json"}).err,
              "box.off and out.json: a file of solids (.eul, .obj, .off) is written as another one only"));
    CHECK(cremona({"convert", in}).err ==
          "cremona convert: two files are needed, IN and OUT; see cremona convert --help\n");
}

TEST_CASE("An output that cannot be written is told in a sentence")
{
    const Folder folder;
    const std::string in = folder.write("in.json", cantilever());
    const Run missing = cremona({"convert", in, folder.path("no/such/out.json")});
    CHECK(missing.status == 2);
    CHECK(has(missing.err, "there is no folder " + folder.path("no/such") + "; make it first"));
    std::filesystem::create_directory(folder.path("f.json"));
    CHECK(has(cremona({"convert", in, folder.path("f.json")}).err, "it is a folder; add a file name"));
}

TEST_CASE("A file with an error replaces nothing")
{
    const Folder folder;
    const std::string out = folder.write("out.json", "precious");
    CHECK(cremona({"convert", "-", out}, "{").status == 2);
    CHECK(folder.read("out.json") == "precious");
}

TEST_CASE("Units are two names, and a mistyped one is answered")
{
    CHECK(cremona({"convert", "-", "-", "--units", "mm"}, cantilever()).err ==
          "cremona convert: --units: found mm; wanted a length and a force, such as mm,N\n");
    CHECK(has(cremona({"convert", "-", "-", "--units", "mm,KN"}, cantilever()).err, "did you mean \"kN\"?"));
}

TEST_CASE("What could not be read again in other units is not written")
{
    std::string large = cantilever();
    const std::string place = "[4, 0]";
    REQUIRE(large.find(place) != std::string::npos);
    large.replace(large.find(place), place.size(), "[1e308, 0]");
    const Run run = cremona({"convert", "-", "-", "--units", "mm,N"}, large);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
}

TEST_CASE("A block whose numbers are not understood is not converted to other units")
{
    const Run run = cremona({"convert", "tests/cases/cross/MD-001.json", "-", "--units", "mm,N"});
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(has(run.err, "the block \"cross\" holds numbers that are not converted"));
}

TEST_SUITE_END();
