// Results beside those of another case or file, as the real program prints them.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"
#include "tests/folder.h"

using cli_test::cantilever;
using cli_test::cremona;
using cli_test::has;
using cli_test::Run;
using nlohmann::json;

TEST_SUITE_BEGIN("cremona");

namespace {

// The cantilever of run_cremona.h: P in case P, 1.5 P in combination U.
using cli_test::of_cantilever::EI, cli_test::of_cantilever::L, cli_test::of_cantilever::P;
constexpr double sag = P * L * L * L / (3.0 * EI);

/// The one that differs in this part, where it stands at a node, and the section of a member.
json entry(const json& list, const std::string& part, const std::string& component)
{
    for (const json& one : list)
        if (one["component"] == component && (one.value("node", "") == part || one.value("member", "") == part))
            return one;
    FAIL("not compared: ", part, " ", component);
    return {};
}

json comparison(const Run& run)
{
    REQUIRE_MESSAGE(run.status == 0, run.err);
    return json::parse(run.out)["comparisons"][0];
}

} // namespace

TEST_CASE("A combination of 1.5 P beside P has half of P's results more")
{
    const json one = comparison(cremona({"compare", "-", "--case", "U", "--with", "P", "--json"}, cantilever()));
    CHECK(one["case"] == "U");
    CHECK(one["with"] == "P");
    const json M = entry(one["section_forces"], "AB", "M"), R = entry(one["reactions"], "A", "fy");
    CHECK(M["x"] == 0);
    CHECK(M["now"].get<double>() == doctest::Approx(-1.5 * P * L));
    CHECK(M["before"].get<double>() == doctest::Approx(-P * L));
    CHECK(M["change"].get<double>() == doctest::Approx(-0.5 * P * L));
    CHECK(R["change"].get<double>() == doctest::Approx(0.5 * P));
    CHECK(entry(one["displacements"], "B", "uy")["change"].get<double>() == doctest::Approx(-0.5 * sag));
}

TEST_CASE("A picture refuses a file to compare with that has no case of the name, and says which it has")
{
    const Folder folder;
    std::string renamed = cantilever();
    for (std::size_t at = renamed.find("\"P\""); at != std::string::npos; at = renamed.find("\"P\""))
        renamed[at + 1] = 'S';
    const std::string now = folder.write("now.json", cantilever()), other = folder.write("other.json", renamed);
    const std::string picture = folder.path("picture.svg");
    const Run run = cremona({"render", now, "-o", picture, "--show", "M", "--case", "P", "--compare", other});
    CHECK(run.status == 2);
    CHECK(cli_test::has(run.err, "P: there is none of this name in " + other));
    CHECK(cli_test::has(run.err, "with --with (S, U)"));
    CHECK(cremona({"render", now, "-o", picture, "--case", "P", "--compare", other, "--with", "S"}).status == 0);
    CHECK(cremona({"render", now, "-o", picture, "--case", "U", "--compare", other}).status == 0);
}

TEST_CASE("A file in other units is the same structure: nothing changes, whatever it counts in")
{
    const Folder folder;
    const std::string metres = folder.write("m.json", cantilever()), inches = folder.path("in.json");
    REQUIRE(cremona({"convert", metres, inches, "--units", "in,kip"}).status == 0);
    const Run run = cremona({"compare", metres, inches, "--describe"});
    CHECK(run.status == 0);
    CHECK(cli_test::count(run.out, "No change: N, V, M, fx, fy, mz, ux, uy, rz.\n") == 2); // P and U
    CHECK(cremona({"compare", inches, metres, "--describe"}).out.find("changes most") == std::string::npos);
}

TEST_CASE("What only one of two files has is told: nodes, members, supports, cases")
{
    const Folder folder;
    json longer = json::parse(cantilever());
    longer["nodes"].push_back({{"id", "C"}, {"at", {6, 0}}});
    longer["nodes"][1]["support"] = "roller";
    json member = longer["members"][0];
    member["id"] = "BC";
    member["nodes"] = {"B", "C"};
    longer["members"].push_back(member);
    longer["load_cases"].push_back({{"id", "wind"}});
    const std::string now = folder.write("now.json", longer.dump()), before = folder.write("old.json", cantilever());
    const Run run = cremona({"compare", now, before});
    CHECK(run.status == 0);
    CHECK(has(run.out, "Only now: nodes C; members BC; supports at B\n"));
    CHECK(has(run.err, "wind: there is none of this name in "));
    CHECK(has(cremona({"compare", before, now}).out, "Only before: nodes C; members BC; supports at B\n"));
    const json one = comparison(cremona({"compare", before, now, "--json"}));
    CHECK(one["only_before"] == json({{"nodes", {"C"}}, {"members", {"BC"}}, {"supports", {"B"}}}));
}

TEST_CASE("The tables of a comparison have chosen units, and numbers of one kind as many decimals")
{
    const Run run = cremona(
        {"compare", "-", "--case", "U", "--with", "P", "--unit", "moment=kN*cm,displacement=mm", "--lang", "pt"},
        cantilever());
    CHECK(has(run.out, "U comparado com P\n"));
    CHECK(has(run.out, "M [kN·cm]         0  -7200,00    -4800,00    -2400,00"));
    CHECK(has(run.out, "uy [mm]"));
}

TEST_CASE("What cannot be compared is refused in words")
{
    const auto refused = [](std::vector<std::string> arguments, const std::string& reason) {
        arguments.insert(arguments.begin(), "compare");
        const Run run = cremona(arguments, cantilever());
        CAPTURE(run.err);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CHECK(has(run.err, reason));
    };
    refused({"-"}, "give a second file, or --with for two load cases of one file");
    refused({"-", "--with", "Q"}, "--with: there is no \"Q\"");
    refused({"-", "examples/truss.json"}, "found a plane truss; wanted a plane frame");
    refused({"-", "-"}, "standard input is one file");
    refused({"-", "--with", "P", "--json", "--unit", "moment=kN*cm"}, "--json counts in the units of the file");
}
