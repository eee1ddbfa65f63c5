#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/apps/cli/run_cremona.h"
#include "tests/latex_document.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"

using cli_test::cantilever;
using cli_test::cremona;
using cli_test::has;
using cli_test::Run;
using nlohmann::json;

TEST_SUITE_BEGIN("cremona");

namespace {

using cli_test::of_cantilever::EI, cli_test::of_cantilever::L, cli_test::of_cantilever::P;

std::vector<std::string> keys(const json& object)
{
    std::vector<std::string> names;
    for (const auto& item : object.items()) names.push_back(item.key());
    return names;
}

json solved(std::vector<std::string> arguments, const std::string& model)
{
    arguments.insert(arguments.begin(), {"solve", "-", "--json"});
    const Run run = cremona(arguments, model);
    REQUIRE_MESSAGE(run.status == 0, run.err);
    CHECK(run.err.empty());
    return json::parse(run.out);
}

} // namespace

TEST_CASE("JSON of solve has the documented shape: units, cases, nodes, members, equilibrium")
{
    const json all = solved({}, cantilever());
    CHECK(all["cremona"] == 1);
    CHECK(all["units"] == json({{"length", "m"}, {"force", "kN"}}));
    CHECK(keys(all["cases"]) == std::vector<std::string>{"P", "U"});
    const json& one = all["cases"]["P"];
    CHECK(keys(one) == std::vector<std::string>{"equilibrium", "members", "nodes"});
    CHECK(keys(one["nodes"]["A"]) == std::vector<std::string>{"reaction", "u"});
    CHECK(keys(one["nodes"]["B"]) == std::vector<std::string>{"u"});
    CHECK(keys(one["nodes"]["A"]["reaction"]) == std::vector<std::string>{"fx", "fy", "mz"});
    CHECK(keys(one["members"]["AB"]) == std::vector<std::string>{"end", "extremes", "start", "stations"});
    CHECK(keys(one["members"]["AB"]["stations"][0]) == std::vector<std::string>{"M", "N", "V", "u", "v", "x"});
    CHECK(keys(one["members"]["AB"]["extremes"]) == std::vector<std::string>{"M", "N", "V", "u", "v"});
    CHECK(keys(one["equilibrium"]) == std::vector<std::string>{"residual", "sum_loads", "sum_reactions"});
}

TEST_CASE("A tip load P sags a cantilever P L^3 / 3 E I, and its combination 1.5 times that")
{
    const json cases = solved({}, cantilever())["cases"];
    const double sag = P * L * L * L / (3.0 * EI);
    CHECK(cases["P"]["nodes"]["B"]["u"]["uy"].get<double>() == doctest::Approx(-sag));
    CHECK(cases["U"]["nodes"]["B"]["u"]["uy"].get<double>() == doctest::Approx(-1.5 * sag));
    CHECK(cases["P"]["members"]["AB"]["start"]["M"].get<double>() == doctest::Approx(-P * L));
    CHECK(cases["P"]["members"]["AB"]["extremes"]["M"]["min"]["x"] == 0);
    CHECK(cases["P"]["nodes"]["A"]["reaction"]["fy"].get<double>() == doctest::Approx(P));
}

TEST_CASE("--unit, given again or with commas, chooses the units of tables quantity by quantity, and of nothing else")
{
    const Run run = cremona(
        {"solve", "-", "--case", "P", "--unit", "moment=kN*cm", "--unit", "displacement=mm,length=cm"}, cantilever());
    REQUIRE(run.status == 0);
    CHECK(has(run.out, "Units of the tables: cm, kN, kN·cm, mm, rad\n"));
    CHECK(has(run.out, "M [kN·cm]"));
    CHECK(has(run.out, "-4800")); // P L
    CHECK(has(run.out, "-12.8")); // mm
    CHECK(has(cremona({"solve", "-", "--unit", "force=tf", "--case", "envelope"}, cantilever()).out, "fy [tf]"));
    CHECK(cremona({"solve", "-", "--unit", "moment=kN*cm", "--json"}, cantilever()).status == 2);
    CHECK(has(cremona({"solve", "-", "--unit", "moment=kN*cm", "--trace-solver"}, cantilever()).err,
              "--trace-solver counts in the units of the file"));
    CHECK(has(cremona({"solve", "-", "--unit", "moment=kN*m2"}, cantilever()).err, "choose from: N·mm"));
    for (const std::vector<std::string>& again : {std::vector<std::string>{"--unit", "moment=kN*cm,moment=kN*m"},
                                                  {"--unit", "moment=kN*cm", "--unit", "moment=kN*cm"}}) {
        std::vector<std::string> arguments{"solve", "-"};
        arguments.insert(arguments.end(), again.begin(), again.end());
        const Run twice = cremona(arguments, cantilever());
        CHECK(twice.status == 2);
        CHECK(has(twice.err, "--unit: moment is given twice; keep one"));
    }
}

TEST_CASE("--stations N gives N even places and every load point, twice where the result jumps")
{
    std::string model = cantilever();
    const std::string tip = R"("nodes": [{"node": "B", "fy": -12}])";
    model.replace(model.find(tip), tip.size(), R"("members": [{"member": "AB", "kind": "point", "at": 1, "fy": -12}])");
    const json stations = solved({"--stations", "3", "--case", "P"}, model)["cases"]["P"]["members"]["AB"]["stations"];
    std::vector<double> x;
    for (const json& station : stations) x.push_back(station["x"]);
    CHECK(x == std::vector<double>{0.0, 1.0, 1.0, 2.0, 4.0});
    CHECK(stations[1]["V"].get<double>() == doctest::Approx(12.0)); // - side first
    CHECK(stations[2]["V"].get<double>() == doctest::Approx(0.0));
}

TEST_CASE("Section forces and sums are named by the kind of analysis")
{
    const std::string cases = source_folder() + "/tests/cases/members/";
    const json grillage = json::parse(cremona({"solve", cases + "GR-003.json", "--json"}).out)["cases"].front();
    CHECK(keys(grillage["members"].front()["start"]) == std::vector<std::string>{"M", "T", "V"});
    CHECK(keys(grillage["nodes"].front()["u"]) == std::vector<std::string>{"rx", "ry", "uz"});
    CHECK(grillage["equilibrium"]["sum_loads"].size() == 3);
    const json space = json::parse(cremona({"solve", cases + "F3-001.json", "--json"}).out)["cases"].front();
    CHECK(keys(space["members"].front()["start"]) == std::vector<std::string>{"My", "Mz", "N", "T", "Vy", "Vz"});
    CHECK(keys(space["members"].front()["extremes"]).size() == 9);
    CHECK(space["equilibrium"]["sum_loads"].size() == 6);
    const json truss = json::parse(cremona({"solve", cases + "SP-001.json", "--json"}).out)["cases"].front();
    CHECK(keys(truss["nodes"].front()["u"]) == std::vector<std::string>{"ux", "uy"});
    CHECK(keys(truss["members"].front()["start"]) == std::vector<std::string>{"M", "N", "V"});
}

TEST_CASE("No number is written -0 or NaN")
{
    const Run run = cremona({"solve", "-", "--json"}, cantilever());
    CHECK_FALSE(has(run.out, "-0,"));
    CHECK_FALSE(has(run.out, "-0}"));
    CHECK_FALSE(has(run.out, "nan"));
}

TEST_CASE("--case prints one case alone, and a mistyped one is answered with what there is")
{
    CHECK(keys(solved({"--case", "U"}, cantilever())["cases"]) == std::vector<std::string>{"U"});
    const Run wrong = cremona({"solve", "-", "--case", "wind"}, cantilever());
    CHECK(wrong.status == 2);
    CHECK(wrong.out.empty());
    CHECK(wrong.err == "cremona solve: --case: there is no \"wind\"; choose from: P, U\n");
}

TEST_CASE(
    "Without --case all cases are printed, also of a file that has one named all; --case all is that one, and said")
{
    const auto named = [](const std::string& name) { // in place of the combination U
        std::string model = cantilever();
        for (std::size_t at = model.find("\"U\""); at != std::string::npos; at = model.find("\"U\""))
            model.replace(at + 1, 1, name);
        return model;
    };
    CHECK(keys(solved({}, named("all"))["cases"]) == std::vector<std::string>{"P", "all"});
    const Run all = cremona({"solve", "-", "--json", "--case", "all"}, named("all"));
    CHECK(keys(json::parse(all.out)["cases"]) == std::vector<std::string>{"all"});
    CHECK(all.err ==
          "--case all: this is the load case or combination named \"all\"; leave --case out for all of them\n");
    CHECK(keys(solved({"--case", "all"}, cantilever())["cases"]) == std::vector<std::string>{"P", "U"});

    const Run envelope = cremona({"solve", "-", "--json", "--case", "envelope"}, named("envelope"));
    CHECK(keys(json::parse(envelope.out)["cases"]) == std::vector<std::string>{"envelope"});
    CHECK(
        has(envelope.err, "--case envelope: this is the load case or combination named \"envelope\"; give it another"));
    const std::vector<std::vector<std::string>> of_a_case{
        {"--describe"}, {"--free-body", "node=A"}, {"--virtual-work", "node=B,component=uy"}};
    for (const std::string name : {"envelope", "all"})
        for (std::vector<std::string> arguments : of_a_case) {
            CAPTURE(arguments.front());
            arguments.insert(arguments.begin(), {"solve", "-", "--case", name});
            const Run run = cremona(arguments, named(name));
            CHECK(run.status == 0);
            if (name == "envelope")
                CHECK(has(cremona(arguments, cantilever()).err, arguments[4] + " and --case envelope print different"));
        }
}

TEST_CASE("The envelope names the case that governs each value")
{
    const json envelope = solved({"--case", "envelope"}, cantilever())["envelope"];
    CHECK(envelope["cases"] == json({"P", "U"}));
    const json& extremes = envelope["members"]["AB"]["extremes"];
    CHECK(extremes["M"]["min"]["case"] == "U");
    CHECK(extremes["M"]["min"]["value"].get<double>() == doctest::Approx(-1.5 * P * L));
    CHECK(extremes["V"]["min"]["case"] == "P");
    CHECK(envelope["nodes"]["A"]["reaction"]["fy"]["max"]["case"] == "U");
    CHECK(has(cremona({"solve", "-", "--case", "envelope"}, cantilever()).out, "Envelope of P, U"));
}

TEST_CASE("A title's control characters do not reach the terminal")
{
    std::string model = cantilever();
    model.replace(model.find("Cantilever"), 10, "A \\u001b[31mred\\u0007 beam");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"solve", "-"}, {"solve", "-", "--describe"}}) {
        const Run run = cremona(arguments, model);
        CHECK(run.status == 0);
        CHECK(run.out.find('\x1b') == std::string::npos);
        CHECK_MESSAGE(has(run.out, "A \\u001b[31mred\\u0007 beam"), run.out);
    }
}

TEST_CASE("Tables tell title, indeterminacy, cases, and every kind of result with its unit")
{
    const Run run = cremona({"solve", "-"}, cantilever());
    CHECK(run.status == 0);
    for (const char* part :
         {"Cantilever\n", "Degree of static indeterminacy: 0 (external 0, internal 0): statically determinate",
          "Load case P\n", "Combination U = 1.5 P\n", "uy [m]", "rz [rad]", "mz [kN·m]", "-0.0128000", "sum of",
          "at node", "largest", "of the largest load"})
        if (std::string(part) != "sum of") CHECK_MESSAGE(has(run.out, part), part);
}

TEST_CASE("Round-off reads 0 in tables even where nothing else stands in the column")
{
    const std::string beam = R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
        "materials": [{"id": "s", "E": 2e8, "alpha": 1.2e-5}], "sections": [{"id": "c", "A": 0.01, "Iz": 1e-4, "h": 0.3}],
        "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [7.3, 0], "support": "roller"}],
        "members": [{"id": "AB", "nodes": ["A", "B"], "material": "s", "section": "c"}], "load_cases": [)";
    for (const char* load : {R"({"member": "AB", "kind": "distributed", "qy": -12.7})",
                             R"({"member": "AB", "kind": "temperature", "top": 31, "bottom": 10.3})"}) {
        const Run run = cremona({"solve", "-"}, beam + R"({"id": "G", "members": [)" + load + "]}]}");
        CHECK(run.status == 0);
        CAPTURE(run.out);
        CHECK(!has(run.out.substr(0, run.out.find("largest force out of balance")), "e-1"));
    }
}

TEST_CASE("Tables speak Portuguese, JSON does not change")
{
    CHECK(has(cremona({"solve", "-", "--lang", "pt"}, cantilever()).out, "Grau de hiperestaticidade: 0"));
    CHECK(cremona({"solve", "-", "--json", "--lang", "pt"}, cantilever()).out ==
          cremona({"solve", "-", "--json"}, cantilever()).out);
}

TEST_CASE("Numbers for people have the decimal comma in Portuguese, files and programs get the point")
{
    const auto in_portuguese = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--lang", "pt"});
        return cremona(arguments, cantilever()).out;
    };
    CHECK(has(cremona({"solve", "-"}, cantilever()).out, "-0.0128"));
    CHECK(has(in_portuguese({"solve", "-"}), "-0,0128"));
    CHECK(has(in_portuguese({"solve", "-"}), "Combinação U = 1,5 P"));
    CHECK(has(in_portuguese({"solve", "-", "--case", "envelope"}), "-0,0128"));
    CHECK(has(in_portuguese({"solve", "-", "--describe"}), "0,0128 m"));
    CHECK(has(in_portuguese({"verify", "-"}), "-0,0128"));
    CHECK(has(in_portuguese({"convert", "-", "-"}), "1.5"));
}

TEST_CASE("Numbers beyond the range of arithmetic end with status 2 and the place to look at, in no time")
{
    const auto refused = [](const std::string& found, const std::string& replacement, const std::string& message) {
        std::string model = cantilever();
        const std::size_t at = model.find(found);
        REQUIRE(at != std::string::npos);
        const Run run = cremona({"solve", "-"}, model.replace(at, found.size(), replacement));
        CAPTURE(run.err);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CHECK(has(run.err, message));
    };
    const std::string stiff = "the stiffness at B is beyond the range of numbers";
    const std::string strong = "case P: its forces or displacements are beyond the range of numbers";
    refused("\"A\": 0.01", "\"A\": 1e300", stiff);
    refused("[4, 0]", "[1e-290, 0]", "length is 1e-290 m");
    refused("-12", "-1e307", strong);
    refused("\"A\": 0.01", "\"A\": 1e-200", "A: \"1e-200 m^2\" is beyond the range of numbers"); // no mechanism
    refused("\"Iz\": 1e-4", "\"Iz\": 1e-200", "Iz: \"1e-200 m^4\" is beyond the range of numbers");
    refused("\"E\": 2e8", "\"E\": 1e-250", "E: \"1e-250 kN/m^2\" is beyond the range of numbers");
}

TEST_CASE("Where a hinge takes from what the supports give, the degree is not split into external and internal")
{
    const Run arch = cremona({"solve", source_folder() + "/examples/three_hinged_arch.json"});
    CHECK(has(arch.out, "Degree of static indeterminacy: 0: statically determinate\n"));
    json portal = json::parse(text_of_source("examples/portal.json"));
    portal["members"][1]["start"]["release"] = {"rz"};
    CHECK(has(cremona({"solve", "-"}, portal.dump()).out, "Degree of static indeterminacy: 2\n"));
    CHECK(has(cremona({"solve", "-", "--describe"}, portal.dump()).out, "statically indeterminate to degree 2."));
}

TEST_CASE("--csv writes five files whose first line names columns and units")
{
    const Folder folder;
    const Run run = cremona({"solve", "-", "--csv", folder.path("new/results"), "--stations", "2"}, cantilever());
    CHECK(run.status == 0);
    CHECK(cli_test::count(run.err, "written: ") == 5);
    CHECK(has(folder.read("new/results/displacements.csv"), "case,node,ux [m],uy [m],rz [rad]\nP,A,0,0,0\n"));
    CHECK(folder.read("new/results/reactions.csv").starts_with("case,node,fx [kN],fy [kN],mz [kN*m]\nP,A,"));
    CHECK(cli_test::count(folder.read("new/results/members.csv"), "\n") == 1 + 2 * 2);
    CHECK(folder.has("new/results/extremes.csv"));
    CHECK(folder.has("new/results/equilibrium.csv"));
}

TEST_CASE("A folder that cannot be made for --csv is told, and stdout stays empty")
{
    const Folder folder;
    const std::string file = folder.write("taken", "");
    const Run run = cremona({"solve", "-", "--csv", file}, cantilever());
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(has(run.err, "cannot make the folder " + file));
}

TEST_CASE("--trace gives a member's 12 E I / L^3 and its places in the system")
{
    const Run run = cremona({"solve", "-", "--trace", "AB", "--json"}, cantilever());
    REQUIRE(run.status == 0);
    const json trace = json::parse(run.out)["trace"];
    CHECK(trace["dofs"] == json({"A.ux", "A.uy", "A.rz", "B.ux", "B.uy", "B.rz"}));
    CHECK(trace["local_stiffness"][1][1].get<double>() == doctest::Approx(12.0 * EI / (L * L * L)));
    CHECK(trace["equations"] == json({0, 0, 0, 1, 2, 3}));
    CHECK(trace["fixed_end"]["P"]["local"].size() == 6);
    CHECK(has(cremona({"solve", "-", "--trace", "AB"}, cantilever()).out, "Transformation T, u' = T u"));
    const Run wrong = cremona({"solve", "-", "--trace", "BA1"}, cantilever());
    CHECK(wrong.status == 2);
    CHECK(has(wrong.err, "--trace: there is no \"BA1\""));
}

TEST_CASE("--virtual-work gives the sag of a cantilever as the integral of M m / EI")
{
    const Run run = cremona({"solve", "-", "--virtual-work", "node=B,component=uy", "--json"}, cantilever());
    REQUIRE(run.status == 0);
    const json work = json::parse(run.out)["virtual_work"];
    const double sag = P * L * L * L / (3.0 * EI);
    CHECK(work["sum"].get<double>() == doctest::Approx(-sag));
    CHECK(work["value"].get<double>() == doctest::Approx(-sag));
    REQUIRE(work["members"].size() == 1);
    CHECK(work["members"][0]["force"] == "M");
    CHECK(work["members"][0]["unit"][0].get<double>() == doctest::Approx(L));
    CHECK(work["members"][0]["work"].get<double>() == doctest::Approx(-sag));
    const std::vector<std::string> combined{"solve",  "-", "--virtual-work", "node=B,component=uy",
                                            "--case", "U", "--lang",         "pt"};
    CHECK(has(cremona(combined, cantilever()).out, "em U: pelo trabalho virtual"));
}

TEST_CASE("--virtual-work multiplies the forces out, and says what to ask for where every member turns by itself")
{
    const Run run = cremona(
        {"solve", source_folder() + "/examples/portal.json", "--virtual-work", "member=BC,at=50%,component=v"});
    CHECK(has(run.out, "∫ F f dx"));
    CHECK(has(run.out, "-27.0002 + 53.3515 x - 29.3024 x² + 3.16262 x³")); // (-42.68 + 50.6 x - 6.325 x²)(0.6326 - x/2)
    const Run hinge = cremona(
        {"solve", source_folder() + "/examples/gerber_beam.json", "--virtual-work", "node=E,component=rz"});
    CHECK(hinge.status == 2);
    CHECK(has(hinge.err, "node E has no rotation of its own: the ends of BE and EF turn there each by themselves"));
}

TEST_CASE("--latex prints virtual work and funiculars as the body of a document, and nothing where there are no steps")
{
    const Run work = cremona({"solve", "-", "--virtual-work", "node=B,component=uy", "--latex"}, cantilever());
    CHECK(work.status == 0);
    CHECK(has(work.out, "\\int_{0}^"));
    CHECK(fault_of_latex(work.out) == "");
    const Run funicular = cremona({"solve", source_folder() + "/examples/three_hinged_arch.json", "--funicular",
                                   "automatic", "--case", "Q", "--latex", "--lang", "pt"});
    CHECK(funicular.status == 0);
    CHECK(has(funicular.out, "\\section*{Funicular sobre "));
    CHECK(fault_of_latex(funicular.out) == "");
    const Run none = cremona({"solve", "-", "--describe", "--latex"}, cantilever());
    CHECK(none.status == 2);
    CHECK(has(none.err, "--latex needs one of --why, --virtual-work, --force-method, --free-body, --funicular too"));
}

TEST_CASE("--virtual-work asks for a displacement, and refuses what goes with something else")
{
    const Run force = cremona({"solve", "-", "--virtual-work", "node=A,component=fy"}, cantilever());
    CHECK(force.status == 2);
    CHECK(has(force.err, "--virtual-work finds displacements"));
    const Run of_node = cremona({"solve", "-", "--virtual-work", "node=B,component=uz"}, cantilever());
    CHECK(has(of_node.err, "choose from: ux, uy, rz\n"));
    const Run of_member = cremona({"solve", "-", "--virtual-work", "member=AB,at=1,component=rz"}, cantilever());
    CHECK(has(of_member.err, "choose from: u, v\n"));
    const Run released = cremona({"solve", "-", "--force-method", "member=AB,at=1,component=rz"}, cantilever());
    CHECK(has(released.err, "choose from: N, V, M\n"));
    const Run nowhere = cremona({"solve", "-", "--virtual-work", "node=C,component=uy"}, cantilever());
    CHECK(nowhere.status == 2);
    CHECK(has(nowhere.err, "--virtual-work node: there is no \"C\""));
    const Run both = cremona({"solve", "-", "--virtual-work", "node=B,component=uy", "--describe"}, cantilever());
    CHECK(both.status == 2);
    CHECK(has(both.err, "--virtual-work and --describe print different things"));
}

/// A beam clamped at A on a roller at B, under q.
std::string propped_cantilever()
{
    return R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
      "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [8, 0], "support": "roller"}],
      "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
      "load_cases": [{"id": "G", "members": [{"member": "AB", "kind": "distributed", "qy": -6}]}]})";
}

TEST_CASE("--force-method finds the prop's 3 q L / 8 with the program's redundant, and with any other")
{
    constexpr double span = 8.0, load = 6.0;
    const Run run = cremona({"solve", "-", "--force-method", "automatic", "--json"}, propped_cantilever());
    REQUIRE(run.status == 0);
    const json method = json::parse(run.out)["force_method"];
    CHECK(method["degree"] == 1);
    CHECK(method["degree_of_primary"] == 0);
    REQUIRE(method["redundants"].size() == 1);
    CHECK(method["redundants"][0]["node"] == "B");
    CHECK(method["redundants"][0]["value"].get<double>() == doctest::Approx(3.0 * load * span / 8.0));
    CHECK(method["steps"].size() == 6);
    const Run hinge = cremona({"solve", "-", "--force-method", "member=AB,at=0,component=M", "--lang", "pt"},
                              propped_cantilever());
    REQUIRE(hinge.status == 0);
    CHECK(has(hinge.out, "Método das forças em G"));
    CHECK(has(hinge.out, "X1 = M(AB, 0 m)"));
}

TEST_CASE(
    "On a foundation no number is the degree of indeterminacy, and the force method leaves the ground where it is")
{
    const std::string file = "examples/beam_on_ground.json";
    const Run chosen = cremona({"solve", file, "--force-method", "automatic"});
    CHECK(chosen.status == 0);
    CHECK(has(chosen.out, "what the foundation adds is left in the primary structure"));
    const std::string cut = "member=AM,at=1.3,component=M";
    const Run named = cremona({"solve", file, "--force-method", cut});
    CHECK(has(named.out, "so that the degree of static indeterminacy is infinite. These forces X are released"));
    CHECK(!has(named.out, "n0"));
    const json method = json::parse(cremona({"solve", file, "--force-method", cut, "--json"}).out)["force_method"];
    CHECK(method["degree"].is_null());
    CHECK(method["degree_of_primary"].is_null());
}

TEST_CASE("--force-method refuses what cannot be released, and says how the structure moves without it")
{
    const auto refused = [](const std::vector<std::string>& redundants) {
        std::vector<std::string> words{"solve", "-"};
        for (const std::string& one : redundants) words.insert(words.end(), {"--force-method", one});
        return cremona(words, propped_cantilever());
    };
    const Run moves = refused({"node=A,component=fx"});
    CHECK(moves.status == 3);
    CHECK(has(moves.err, "the structure does not stand without fx(A); release other forces"));
    CHECK(!has(moves.err, "add a ")); // what mends a structure is no remedy here
    const Run cut = cremona({"solve", "examples/gerber_beam.json", "--force-method", "member=EF,at=50%,component=M"});
    CHECK(has(cut.err, "the structure does not stand without M(EF, 50%) [G]; release other forces\n"
                       "  in brackets stands the node at which a member is cut\n"));
    CHECK(moves.out.empty());
    const Run free = refused({"node=B,component=fx"});
    CHECK(free.status == 2);
    CHECK(has(free.err, "--force-method: fx(B) is released already"));
    CHECK(has(refused({"node=B,component=uy"}).err, "uy(B) is no force that could be released"));
    CHECK(has(refused({"node=B,component=fy", "node=B,component=fy"}).err, "fy(B) is named twice"));
    CHECK(has(refused({"automatic", "node=B,component=fy"}).err, "automatic chooses every redundant"));
    CHECK(has(refused({"all"}).err, "--force-method: \"all\" asks for nothing"));
    CHECK(has(refused({"node=A,node=B,component=fy"}).err, "--force-method: node is given twice; keep one"));
    CHECK(has(refused({"member=a,at=b,at=2.5,component=M"}).err,
              "at is given twice; keep one. A name with \",at=\" in it cannot be asked for like this"));
    const std::string section = "member=AB,at=2.5,component=M";
    CHECK(has(refused({section, section}).err, "M(AB, 2.5 m) is named twice"));
    CHECK(has(cremona({"solve", "-", "--force-method", section, "--force-method", section, "--lang", "pt"},
                      propped_cantilever())
                  .err,
              "M(AB, 2,5 m)"));
}

TEST_CASE("A resultant is asked for by R, and a difference by the case that is taken off")
{
    // the roller's plane is at 30 degrees: fx = -R sin 30, fy = R cos 30
    const Run slanting = cremona({"solve", "examples/inclined_roller.json", "--why", "node=B,component=R", "--json"});
    REQUIRE(slanting.status == 0);
    const double r = json::parse(slanting.out)["why"]["value"];
    CHECK(r == doctest::Approx(24.0 / std::cos(std::numbers::pi / 6.0)));
    const auto moment = [](const std::string& load_case, std::initializer_list<std::string> more) {
        std::vector<std::string> words{"solve", "examples/portal.json",        "--json", "--case", load_case,
                                       "--why", "member=BC,at=2.5,component=M"};
        words.insert(words.end(), more);
        return json::parse(cremona(words).out)["why"]["value"].get<double>();
    };
    CHECK(moment("W", {"--less", "G"}) == doctest::Approx(moment("W", {}) - moment("G", {})));

    const auto refused = [](std::initializer_list<std::string> words) {
        std::vector<std::string> all{"solve", "examples/portal.json"};
        all.insert(all.end(), words);
        const Run run = cremona(all);
        CHECK(run.status == 2);
        return run.err;
    };
    CHECK(has(refused({"--less", "G"}), "--less needs --why too"));
    CHECK(
        has(refused({"--why", "node=A,component=fy", "--less", "D"}), "--less: there is no \"D\"; choose from: G, Q"));
    CHECK(has(refused({"--why", "node=A,component=R", "--less", "G"}), "ask for a component, fx or fy"));
    CHECK(has(refused({"--why", "member=BC,component=M", "--less", "G"}), "add at=X to --why"));
    CHECK(has(refused({"--why", "node=B,component=R"}), "\"B\" has no support"));
    CHECK(has(cremona({"solve", "examples/grillage.json", "--why", "node=W,component=R"}).err, "there is no \"R\""));
}

TEST_CASE("In Portuguese the factor of a load case is a factor, not a factorization")
{
    const std::string why = cremona({"solve", "examples/portal.json", "--case", "ULS", "--why",
                                     "member=BC,at=50%,component=M", "--lang", "pt"})
                                .out;
    CHECK(has(why, " fator "));
    CHECK_FALSE(has(why, "fatoração"));
}

TEST_CASE(
    "A calculation counts in the units from which those follow that --unit chooses, and lengths are typed in the file's")
{
    const auto asked = [](std::initializer_list<std::string> words) {
        std::vector<std::string> all{"solve", "-"};
        all.insert(all.end(), words);
        return cremona(all, propped_cantilever());
    };
    const Run why = asked({"--why", "member=AB,at=2.5,component=M", "--unit", "moment=kN*cm"});
    // -q L^2 / 8 + 5/8 q L x - q x^2 / 2 with q = 6 kN/m, L = 8 m, x = 2.5 m
    CHECK(has(why.out, "M(AB, 2.5 m) = 825 kN·cm in G"));
    CHECK(has(why.out, "Lengths in cm, forces in kN"));
    CHECK(has(asked({"--free-body", "cut=AB@2.5,beside=A", "--about", "8,0", "--unit", "length=mm,force=N"}).out,
              "Moments about (8000, 0) mm"));
    CHECK(has(asked({"--force-method", "automatic", "--unit", "force=N"}).out, "18000"));
    CHECK(has(asked({"--virtual-work", "member=AB,at=50%,component=v", "--unit", "displacement=mm"}).out, " mm in G"));
    CHECK(has(asked({"--describe", "--unit", "force=tf"}).out, " tf "));
    const Run torn = asked({"--why", "node=B,component=fy", "--unit", "moment=kN*cm,displacement=mm"});
    CHECK(torn.status == 2);
    CHECK(has(torn.err, "--why counts in one unit of length and one of force, and displacement=mm, moment=kN·cm do"));
}

TEST_CASE("--trace-solver tells the four orders with their costs, the chosen one, the fronts and the pattern of L")
{
    const Run run = cremona({"solve", "examples/pratt_truss.json", "--trace-solver"});
    REQUIRE(run.status == 0);
    for (const char* line : {"Orders of elimination", "natural ", "reverse Cuthill-McKee ", "minimum degree ",
                             "nested dissection ", "Chosen: skyline, in reverse Cuthill-McKee order: 358 operations.",
                             "The front walks, in reverse Cuthill-McKee order", "L in reverse Cuthill-McKee order",
                             "L6.ux  x\n  U5.ux  x x\n"})
        CHECK_MESSAGE(has(run.out, line), line);
    const Run dissected = cremona({"solve", "examples/pratt_truss.json", "--trace-solver", "--ordering",
                                   "nested-dissection", "--step", "6", "--solver", "multifrontal"});
    CHECK(has(dissected.out, "The front walks, in nested dissection order"));
    CHECK(has(dissected.out, "The matrix of front 6 by blocks"));
    CHECK(has(dissected.out, "Chosen: multifrontal"));
}

TEST_CASE("--trace-solver draws the step: its words stand in the SVG as text, in the language asked for")
{
    const Folder folder;
    const Run run = cremona({"solve", "examples/storey_frame.json", "--trace-solver", "--ordering", "nested-dissection",
                             "--step", "24", "--size", "1000x700", "--lang", "pt", "-o", folder.path("front.svg")});
    REQUIRE(run.status == 0);
    CHECK(has(run.err, "gravado: "));
    const std::string svg = folder.read("front.svg");
    for (const char* words : {"Frente 24 de 24, dissecção aninhada", "Árvore de eliminação", "864 de preenchimento"})
        CHECK_MESSAGE(has(svg, words), words);
}

TEST_CASE("--trace-solver as JSON has every front of every order, in sums that are those of L")
{
    const Run run = cremona({"solve", "examples/grillage.json", "--trace-solver", "--json"});
    REQUIRE(run.status == 0);
    const json trace = json::parse(run.out)["solver_trace"];
    CHECK(trace["solver"] == "skyline");
    CHECK(trace["orderings"].size() == 4);
    for (const json& walk : trace["orderings"]) {
        std::size_t n_entries = 0;
        for (const json& front : walk["fronts"]) n_entries += front["entries_of_L"].get<std::size_t>();
        CHECK(walk["entries_of_L"] == n_entries);
        CHECK(walk["fill_in"] == walk["entries_of_L"].get<int>() - trace["entries_of_K"].get<int>());
        CHECK(walk["fronts"].back()["waiting"] == 0);
        CHECK(walk["order"].size() == walk["parent"].size());
    }
}

TEST_CASE("What cannot be traced is said: options without it or against it, a step too many, a mechanism")
{
    const auto refusal = [](std::vector<std::string> options) {
        options.insert(options.begin(), {"solve", "examples/portal.json"});
        const Run run = cremona(options);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        return run.err;
    };
    CHECK(has(refusal({"--step", "1"}), "--step goes with --trace-solver; add it"));
    CHECK(has(refusal({"--ordering", "natural"}), "--ordering goes with --trace-solver; add it"));
    CHECK(has(refusal({"-o", "front.png"}), "-o goes with --trace-solver; add it"));
    CHECK(has(refusal({"--theme", "dark"}), "--theme goes with --trace-solver; add it"));
    CHECK(has(refusal({"--trace-solver", "-o", "front.gif"}), "cannot draw the kind \".gif\""));
    CHECK(has(refusal({"--trace-solver", "-o", "front.svg", "--theme", "blue"}), "--theme: there is no \"blue\""));
    CHECK(has(refusal({"--trace-solver", "--step", "9"}), "--step: found \"9\"; wanted a whole number from 1 to 1"));
    CHECK(has(refusal({"--trace-solver", "--ordering", "amd"}), "choose from: natural, cuthill-mckee,"));
    CHECK(has(refusal({"--trace-solver", "--trace", "BC"}), "--trace-solver and --trace print different things"));
    CHECK(has(refusal({"--trace-solver", "--describe"}), "--trace-solver and --describe print different things"));
    CHECK(cremona({"solve", "examples/mechanism.json", "--trace-solver"}).status == 3);
    const Run held = cremona({"solve", "-", "--trace-solver"}, [] {
        json model = json::parse(cantilever());
        model["nodes"][1]["support"] = "fixed";
        return model.dump();
    }());
    CHECK(held.status == 0);
    CHECK(has(held.out, "there is nothing to eliminate"));
}

TEST_CASE("--describe says the structure, its loads and its results in sentences")
{
    const Run run = cremona({"solve", "-", "--describe"}, cantilever());
    CHECK(run.status == 0);
    for (const char* sentence : {"node A at (0, 0): fixed; holds ux, uy, rz.", "on node B: 12 kN down.",
                                 "The structure is statically determinate.", "node B moves most: 0.0128 m down.",
                                 "the support at A gives the structure 12 kN up, 48 kN·m counter-clockwise.",
                                 "V is 12 kN everywhere.", "N is zero everywhere."})
        CHECK_MESSAGE(has(run.out, sentence), sentence);
}

TEST_CASE("In Portuguese a moment per length has a decimal comma and its own unit too")
{
    json model = json::parse(cantilever());
    model["load_cases"][0]["members"] = {{{"member", "AB"}, {"kind", "distributed"}, {"mz", -1.5}}};
    const Run run = cremona({"solve", "-", "--describe", "--lang", "pt"}, model.dump());
    CHECK(run.status == 0);
    CHECK(has(run.out, "na barra AB: 1,5 kN·m/m no sentido horário"));
}

TEST_CASE("--refine tells with --time how good the displacements are, and changes no printed digit")
{
    for (const std::string solver : {"multifrontal", "skyline", "ldlt"}) {
        CAPTURE(solver);
        const Run run = cremona({"solve", "-", "--time", "--refine", "--solver", solver}, cantilever());
        CHECK(run.status == 0);
        CHECK(run.err.find("corrections of the displacements") != std::string::npos);
        CHECK(run.err.find("backward error") != std::string::npos);
        CHECK((run.err.find("multiplications") != std::string::npos) == (solver == "multifrontal"));
        CHECK(run.out == cremona({"solve", "-", "--solver", solver}, cantilever()).out);
    }
}

TEST_CASE("--time tells every phase and the size of the system on stderr, the tables stay on stdout")
{
    const Run run = cremona({"solve", "-", "--time", "--solver", "ldlt"}, cantilever());
    CHECK(run.status == 0);
    for (const char* word :
         {"  read\n", "  assemble\n", "  factor\n", "  solve\n", "  recover\n", "  write\n", " 3  dofs\n",
          "  nonzeros of K (lower triangle)\n", "  nonzeros of its factor\n", "ldlt  solver\n"})
        CHECK_MESSAGE(has(run.err, word), word);
    CHECK(run.out == cremona({"solve", "-", "--solver", "ldlt"}, cantilever()).out);
}

TEST_CASE("A structure that floats is refused with its three motions in words, status 3 and an empty stdout")
{
    for (const std::string option : {"", "--json", "--describe"}) {
        CAPTURE(option);
        std::vector<std::string> arguments{"solve", "-"};
        if (!option.empty()) arguments.push_back(option);
        const Run run = cremona(arguments, cli_test::floating());
        CHECK(run.status == 3);
        CHECK(run.out.empty());
        CHECK(has(run.err, "it can move in 3 independent ways"));
        CHECK(has(run.err, "no node is supported"));
        CHECK(cli_test::count(run.err, "the structure can move without strain") == 3);
    }
}

TEST_CASE("A file that is missing, a folder, empty or cut off is told in a sentence, with status 2 and an empty stdout")
{
    const Folder folder;
    const std::vector<std::pair<std::string, std::string>> faults{
        {folder.path("none.json"), "No such file"},
        {folder.path(""), "s a directory"},
        {folder.write("empty.json", ""), "the file is empty"},
        {folder.write("cut.json", cantilever().substr(0, 300)), "is it cut off?"},
        {"", "the name of the file is empty"}};
    for (const auto& fault : faults) {
        const auto& [file, sentence] = fault;
        CAPTURE(fault.first);
        const Run run = file.empty() ? cremona({"solve"}) : cremona({"solve", file, "--json"});
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        if (!file.empty()) CHECK_MESSAGE(has(run.err, sentence), run.err);
    }
}

TEST_CASE("Numbers and choices out of range are answered with what was found and what is wanted")
{
    CHECK(cremona({"solve", "-", "--stations", "1"}, cantilever()).err ==
          "cremona solve: --stations: found \"1\"; wanted a whole number from 2 to 100000\n");
    CHECK(cremona({"solve", "-", "--stations", "5x"}, cantilever()).status == 2);
    CHECK(cremona({"solve", "-", "--solver", "skylin"}, cantilever()).err ==
          "cremona solve: --solver: there is no \"skylin\"; did you mean \"skyline\"?\n");
}

TEST_CASE("A free body is told by its forces and equations, of a node, of members, and of a side of cuts")
{
    const auto said = [](const std::string& what) {
        const Run run = cremona({"solve", "-", "--free-body", what}, cantilever());
        CHECK(run.status == 0);
        return run.out;
    };
    CHECK(has(said("node=A"), "Free body: node A\n"));
    CHECK(has(said("members=AB"), "Free body: member AB\n"));
    const std::string side = said("cut=AB@50%,beside=B");
    CHECK(has(side, "Free body: node B; member AB from x = "));
    CHECK(has(side, "ΣFx = 0  [kN]"));
}

TEST_CASE("A free body in JSON has its forces, and equations that add up to nothing about any point")
{
    const Run run = cremona({"solve", "-", "--free-body", "node=A", "--about", "3,-2", "--json"}, cantilever());
    const auto body = nlohmann::json::parse(run.out).at("free_body");
    CHECK(body.at("about") == nlohmann::json({3, -2, 0}));
    REQUIRE(body.at("equations").size() == 3);
    for (const auto& equation : body.at("equations")) CHECK(std::abs(equation.at("sum").get<double>()) < 1e-9);
}

TEST_CASE("What names no body, and what is not of the model, is refused with what would be right")
{
    const auto refused = [](std::vector<std::string> arguments, const std::string& sentence) {
        arguments.insert(arguments.begin(), {"solve", "-"});
        const Run run = cremona(arguments, cantilever());
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CAPTURE(run.err);
        CHECK(has(run.err, sentence));
    };
    refused({"--free-body", "all"}, "--free-body: \"all\" names no body; write it like \"node=B\"");
    refused({"--free-body", "node=A,members=AB"}, "names no body");
    refused({"--free-body", "cut=AB@50%"}, "names no body");
    refused({"--free-body", "cut=AB,beside=A"}, "names no body");
    refused({"--free-body", "node=Q"}, "--free-body: there is no \"Q\"");
    const Run uncut = cremona({"solve", "examples/pratt_truss.json", "--free-body", "cut=U2U3@50%,beside=L0"});
    CHECK(uncut.status == 2);
    CHECK(uncut.err == "cremona solve: --free-body: the cut does not part the structure: it still hangs together by "
                       "U2L3 and L3U3; let the cut go right through it\n");
    refused({"--free-body", "cut=AB@900,beside=A"}, "wanted a place from 0 to 4 m along the member");
    refused({"--free-body", "cut=AB@5x%,beside=A"}, "--free-body");
    refused({"--free-body", "cut=AB@nan,beside=A"}, "--free-body: \"nan\" does not begin with a number");
    refused({"--free-body", "node=A", "--about", "1"}, "--about: found 1; wanted 2 lengths with commas between them");
    refused({"--free-body", "node=A", "--about", "1e308,-1e308"}, "--about: found 1e308,-1e308; wanted lengths up to ");
    refused({"--about", "1,2"}, "--about needs --free-body too; add it");
    std::string skew = cantilever(); // of length sqrt(4^2 + 2.1^2)
    skew.replace(skew.find("[4, 0]"), 6, "[4, 2.1]");
    CHECK(has(cremona({"solve", "-", "--free-body", "cut=AB@99,beside=A"}, skew).err,
              "found the cut AB@99; wanted a place from 0 to 4.51774 m along the member"));
    refused({"--free-body", "node=A", "--describe"}, "--free-body and --describe print different things");
    refused({"--free-body", "node=A", "--case", "envelope"}, "--free-body and --case envelope print different things");
}

TEST_CASE("A funicular in JSON passes through the point that is asked for, over the closing line that is asked for")
{
    const Run run = cremona({"solve", "examples/three_hinged_arch.json", "--funicular", "members=AB,BC,CD,DE", "--case",
                             "Q", "--closing", "1,-1.5", "--through", "6,4.25", "--json"});
    REQUIRE(run.status == 0);
    const auto found = nlohmann::json::parse(run.out).at("funicular");
    CHECK(found.at("closing_line") == nlohmann::json({1, -1.5}));
    for (const auto& node : found.at("nodes"))
        if (node.at("x") == 6.0) CHECK(node.at("height").get<double>() == doctest::Approx(4.25));
    const double H = found.at("H").get<double>();
    for (const auto& node : found.at("nodes"))
        CHECK(H * node.at("ordinate").get<double>() == doctest::Approx(node.at("M0").get<double>()));
    CHECK(found.at("left_out_at").empty());
    CHECK_FALSE(found.at("line_of_thrust"));
}

TEST_CASE("The funicular of a three-hinged arch is its line of thrust, with the reactions of the simple beam")
{
    const Run run = cremona({"solve", "examples/three_hinged_arch.json", "--funicular", "automatic", "--case", "Q"});
    CHECK(run.status == 0);
    CHECK(has(run.out, "the line of thrust of the arch\n"));
    CHECK(has(run.out, "reactions of the simple beam: 75 kN at A, 25 kN at I\n"));
}

TEST_CASE("What names no chain, and a point that no funicular passes through, is refused with what would be right")
{
    const auto refused = [](std::vector<std::string> arguments, const std::string& sentence) {
        arguments.insert(arguments.begin(), {"solve", "examples/three_hinged_arch.json", "--case", "Q"});
        const Run run = cremona(arguments);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CAPTURE(run.err);
        CHECK(has(run.err, sentence));
    };
    refused({"--funicular", "all"}, "--funicular: \"all\" names no chain; write it like \"members=AB,BC\"");
    refused({"--funicular", "members=AB,XY"}, "--funicular: there is no \"XY\"");
    refused({"--funicular", "members=AB,CD"}, "--funicular: no members lead from AB to CD");
    refused({"--funicular", "automatic", "--through", "30,4"}, "--through: no funicular passes through 30,4");
    refused({"--funicular", "automatic", "--through", "6,0"}, "or the closing line passes through it");
    refused({"--funicular", "automatic", "--closing", "1"}, "--closing: found 1; wanted 2 lengths");
    refused({"--funicular", "automatic", "--closing", "1e308,-1e308"}, "a million times the farthest node");
    refused({"--funicular", "automatic", "--through", "8,1e300"},
            "--through: found 8,1e300; wanted lengths up to 2.4e7 m");
    refused({"--closing", "1,2"}, "--closing needs --funicular too; add it");
    refused({"--funicular", "automatic", "--free-body", "node=A"}, "print different things");
}

TEST_SUITE_END();

TEST_CASE("Virtual work says how a taper is integrated, where there is one")
{
    const auto told = [](const std::string& file, const std::string& what) {
        return cremona({"solve", file, "--virtual-work", what}).out;
    };
    CHECK(
        has(told("tests/cases/own/tapered.json", "node=B,component=uy"), "Along a taper the stiffness varies with x"));
    CHECK_FALSE(has(told("examples/portal.json", "node=B,component=ux"), "Along a taper"));
}
