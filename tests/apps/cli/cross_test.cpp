#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"
#include "tests/folder.h"

using cli_test::cremona;
using cli_test::has;
using cli_test::Run;
using nlohmann::json;

TEST_SUITE_BEGIN("cremona");

namespace {

json file_of(const std::string& name)
{
    std::ifstream file(name);
    return json::parse(file);
}

json sheet_of(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "cross");
    arguments.emplace_back("--json");
    const Run run = cremona(arguments);
    CHECK_MESSAGE(run.status == 0, run.err);
    return json::parse(run.out);
}

void check_same(const json& found, const json& wanted, double tolerance)
{
    for (const auto& item : wanted.items()) {
        CAPTURE(item.key());
        const json &other = found.at(item.key()), &value = item.value();
        if (value.is_number()) CHECK(std::abs(other.get<double>() - value.get<double>()) <= tolerance);
        else CHECK(other == value);
    }
}

/// A two-bay beam A-B-C in kN and m with what is changed of it.
std::string beam(const std::string& from = "", const std::string& to = "")
{
    std::string text = R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
        "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4, "J": 1e-4}],
        "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [6, 0], "support": "roller"},
                  {"id": "C", "at": [14, 0], "support": "fixed"}],
        "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"},
                    {"id": "BC", "nodes": ["B", "C"], "material": "m", "section": "s"}],
        "load_cases": [{"id": "q", "members": [{"member": "AB", "kind": "distributed", "qy": -12}]}]})";
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return text;
}

/// Two storeys of 4 and 3 m, pushed from the left.
json two_storeys()
{
    return json::parse(R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
        "materials": [{"id": "m", "E": 2e8}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
        "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [0, 4]}, {"id": "C", "at": [0, 7]},
                  {"id": "D", "at": [5, 7]}, {"id": "E", "at": [5, 4]}, {"id": "F", "at": [5, 0], "support": "fixed"}],
        "members": [{"id": "1", "nodes": ["A", "B"], "material": "m", "section": "s"},
                    {"id": "2", "nodes": ["B", "C"], "material": "m", "section": "s"},
                    {"id": "3", "nodes": ["C", "D"], "material": "m", "section": "s"},
                    {"id": "4", "nodes": ["D", "E"], "material": "m", "section": "s"},
                    {"id": "5", "nodes": ["E", "F"], "material": "m", "section": "s"},
                    {"id": "6", "nodes": ["B", "E"], "material": "m", "section": "s"}],
        "load_cases": [{"id": "w", "nodes": [{"node": "B", "fx": 20}, {"node": "C", "fx": 9}],
                        "members": [{"member": "6", "kind": "distributed", "qy": -12}]}]})");
}

} // namespace

TEST_CASE("The sheet of cross --json is that of the file's block, which gives the defaults")
{
    for (const std::string file : {"tests/cases/cross/MD-001.json", "tests/cases/cross/MD-002.json"}) {
        CAPTURE(file);
        const json wanted = file_of(file)["cross"];
        const json found = sheet_of({file});
        for (const auto& [joint, factors] : wanted["factors"].items())
            check_same(found["factors"][joint], factors, 1e-9);
        check_same(found["fixed_end_moments"], wanted["fixed_end_moments"], 1e-8);
        REQUIRE(found["sheet"].size() == wanted["sheet"].size());
        for (std::size_t i = 0; i < wanted["sheet"].size(); ++i)
            check_same(found["sheet"][i], wanted["sheet"][i], 1e-6);
        check_same(found["final"], wanted["final"], 1e-6);
    }
}

TEST_CASE("Half of Kleinlogel's portal is done by one balance with 2EI/L and has the moments of the whole")
{
    const json half = sheet_of({"examples/portal_kleinlogel.json", "--symmetry"});
    const json whole = sheet_of({"examples/portal_kleinlogel.json", "--tolerance", "1e-9"});
    CHECK(half["symmetry"] == true);
    CHECK(half["balances"] == 1);
    CHECK(half["half"]["kind"] == "symmetric");
    CHECK(half["half"]["axis"] == 3.0);
    CHECK(half["half"]["joints"] == json::array({"B"}));
    CHECK(half["half"]["crossing"]["BC"]["formula"] == "2EI/L");
    CHECK(half["sheet"][0].contains("BC"));
    CHECK(!half["sheet"][0].contains("CB"));
    check_same(half["total"], whole["final"], 1e-7);
    const Run csv = cremona({"cross", "examples/portal_kleinlogel.json", "--symmetry", "--csv"});
    CHECK(csv.out.find("0,FEM,,0,0,60,,,\n") != std::string::npos);
    const Run pt = cremona({"cross", "examples/portal_kleinlogel.json", "--symmetry", "--lang", "pt"});
    CHECK(pt.out.find("Simétrica em torno de x = 3 m: basta equilibrar B;") != std::string::npos);
    CHECK(pt.out.find("Momentos finais da estrutura inteira") != std::string::npos);
}

TEST_CASE("A file asks for half by symmetry, and verify works its sheet")
{
    json model = two_storeys();
    model["load_cases"][0].erase("nodes");
    model["cross"] = {{"order", "largest"}, {"modified_stiffness", true}, {"symmetry", true}, {"tolerance", 1e-6}};
    const json found = json::parse(cremona({"cross", "-", "--json"}, model.dump()).out);
    CHECK(found["half"]["joints"] == json::array({"B", "C"}));
    CHECK(!found.contains("stages"));
    const json whole = json::parse(cremona({"cross", "-", "--whole", "--json"}, model.dump()).out);
    CHECK(!whole.contains("half"));
    CHECK(whole["stages"].size() == 3);
    model["cross"].update(found);
    model["cross"].erase("balances");
    const Run verified = cremona({"verify", "-"}, model.dump());
    CHECK_MESSAGE(verified.status == 0, verified.out);
    model["cross"]["sheet"][1]["BE"] = 1.0;
    CHECK(cremona({"verify", "-"}, model.dump()).status == 1);
}

TEST_CASE("What is not symmetric is named, and half of it is asked for once")
{
    const Run uneven = cremona({"cross", "-", "--symmetry"}, beam());
    CHECK(uneven.status == 2);
    CHECK(uneven.out.empty());
    CHECK(uneven.err.find("about x = 7 m: node B has no mirror image at (8, 0) m; move a node") != std::string::npos);
    const Run skew = cremona({"cross", "examples/portal_kleinlogel.json", "--symmetry", "--case", "W"});
    CHECK(skew.status == 2);
    CHECK(skew.err.find("are 4 kN·m at AB and 0 kN·m at DC, wanted opposite ones everywhere") != std::string::npos);
    CHECK(cremona({"cross", "-", "--symmetry", "--whole"}, beam()).status == 2);
    CHECK(cremona({"cross", "-", "--symmetry", "--method", "kani"}, beam()).status == 2);
    const Run other_side = cremona({"cross", "examples/portal_kleinlogel.json", "--symmetry", "--order", "C"});
    CHECK(other_side.status == 2);
    CHECK(other_side.err.find("\"C\" is no joint that can be balanced; choose from B") != std::string::npos);
}

TEST_CASE("A pinned far end takes 3EI/L, and with --unmodified it is locked and balanced with factor 1")
{
    const Run modified = cremona({"cross", "-", "--json"}, beam());
    const json found = json::parse(modified.out);
    CHECK(found["factors"]["B"]["BA"].get<double>() == doctest::Approx(0.5)); // 3/6 to 4/8
    CHECK(found["fractions"]["B"]["BA"] == "1/2");
    CHECK(found["fixed_end_moments"]["AB"] == 0.0);
    CHECK(found["fixed_end_moments"]["BA"].get<double>() == doctest::Approx(-12.0 * 36.0 / 8.0));
    const json plain = json::parse(
        cremona({"cross", "-", "--json", "--unmodified", "--tolerance", "1e-9"}, beam()).out);
    CHECK(plain["factors"]["A"]["AB"] == 1.0);
    CHECK(plain["factors"]["B"]["BA"].get<double>() == doctest::Approx(4.0 / 7.0));
    CHECK(plain["fixed_end_moments"]["AB"].get<double>() == doctest::Approx(12.0 * 36.0 / 12.0));
    CHECK(plain["total"]["BC"].get<double>() == doctest::Approx(27.0));
    CHECK(found["final"]["BC"].get<double>() == doctest::Approx(27.0));
}

TEST_CASE("Each balance of one joint names it, in the order that is asked for")
{
    const std::string file = "examples/continuous_beam.json";
    const auto joints = [&](const std::string& order) {
        std::string names;
        const json found = sheet_of({file, "--order", order});
        for (const json& row : found["sheet"])
            if (row["step"] == "BAL") names += row.value("joint", "*");
        return names;
    };
    CHECK(joints("left-to-right").starts_with("BC"));
    CHECK(joints("C,B,B").starts_with("CBBC"));
    CHECK(joints("all-at-once").starts_with("**"));
}

TEST_CASE("Every number has the digits that are asked for, and the sheet tells what that costs")
{
    const json found = sheet_of({"examples/continuous_beam.json", "--digits", "2", "--order", "all-at-once"});
    for (const json& row : found["sheet"]) {
        if (row["step"] == "TOTAL") continue;
        for (const auto& [key, value] : row.items()) {
            if (!value.is_number() || value == 0.0) continue;
            const double v = std::abs(value.get<double>());
            const double unit = std::pow(10.0, std::floor(std::log10(v)) - 1.0);
            CHECK(std::abs(v / unit - std::round(v / unit)) < 1e-9);
        }
    }
    CHECK(found["drift"].size() == found["final"].size());
}

TEST_CASE("A symmetric portal worked as a whole has no force in its prop, and it is told that nothing sways")
{
    const json whole = sheet_of({"examples/portal_kleinlogel.json"});
    CHECK(whole["stages"][0]["prop"]["reaction"] == 0.0);
    CHECK(whole["equations"]["solution"][0] == 0.0);
    CHECK(has(cremona({"cross", "examples/portal_kleinlogel.json"}).out, "the loads cause no sway at B\n"));
    const Run pt = cremona({"cross", "examples/portal_kleinlogel.json", "--lang", "pt"});
    CHECK(has(pt.out, "as cargas não causam deslocabilidade em B\n"));
    CHECK_FALSE(has(cremona({"cross", "examples/portal_kleinlogel.json", "--case", "W"}).out, "cause no sway"));
}

TEST_CASE("A frame that sways has a sheet with a prop, one of the sway, and their equation")
{
    const json found = sheet_of({"examples/portal.json", "--tolerance", "1e-7", "--case", "W"});
    REQUIRE(found["stages"].size() == 2);
    CHECK(found["stages"][0]["prop"]["node"] == "B");
    CHECK(found["stages"][1]["fixed_end_moments"]["AB"].get<double>() == doctest::Approx(100.0));
    const double R = found["equations"]["coefficients"][0][0], r = found["equations"]["right_hand_side"][0];
    CHECK(found["equations"]["solution"][0].get<double>() * R == doctest::Approx(r));
    CHECK(found["stages"][0]["prop"]["reaction"].get<double>() == doctest::Approx(-r));
    check_same(found["total"], found["inextensible"], 1e-5);
}

TEST_CASE("A block of a frame that sways is compared stage by stage, each as far as its own sheet goes")
{
    const json found = sheet_of({"examples/portal.json", "--case", "W", "--order", "all-at-once"});
    json model = file_of("examples/portal.json");
    model.erase("expected");
    json stages = json::array();
    for (const json& stage : found["stages"]) {
        stages.push_back({{"fixed_end_moments", stage["fixed_end_moments"]}, {"sheet", stage["sheet"]}});
        if (stage.contains("prop")) stages.back()["prop"] = stage["prop"];
        else // the file may move it twice as far
            for (json& row : stages.back()["sheet"])
                for (json& value : row)
                    if (value.is_number()) value = 2.0 * value.get<double>();
    }
    stages[1].erase("fixed_end_moments");
    model["cross"] = {{"case", "W"}, {"order", "all-at-once"}, {"stages", stages}, {"final", found["final"]}};
    const Run good = cremona({"verify", "-"}, model.dump());
    CHECK_MESSAGE(good.status == 0, good.out << good.err);
    CHECK(has(good.out, "cross: stage 1: force of the prop"));
    CHECK(has(good.out, "cross: stage 2: row 1 FEM: "));
    model["cross"]["stages"][0]["prop"]["reaction"] = 0.1234;
    CHECK(cremona({"verify", "-"}, model.dump()).status == 1);
}

TEST_CASE("A frame of several sways is compared stage by stage too, by the nodes that its props hold")
{
    json model = two_storeys();
    const Run run = cremona({"cross", "-", "--json", "--order", "all-at-once"}, model.dump());
    CHECK_MESSAGE(run.status == 0, run.err);
    const json found = json::parse(run.out);
    REQUIRE(found["stages"].size() == 3);
    json stages = json::array();
    for (const std::size_t i : {0U, 2U, 1U}) { // in another order
        const json& stage = found["stages"][i];
        stages.push_back({{"fixed_end_moments", stage["fixed_end_moments"]}, {"sheet", stage["sheet"]}});
        for (const char* key : {"props", "sway"})
            if (stage.contains(key)) stages.back()[key] = stage[key];
    }
    model["cross"] = {{"order", "all-at-once"}, {"stages", stages}, {"final", found["final"]}};
    const Run good = cremona({"verify", "-"}, model.dump());
    CHECK_MESSAGE(good.status == 0, good.out << good.err);
    CHECK(has(good.out, "cross: stage 1: force of the prop"));
    CHECK(has(good.out, "cross: stage 3: row 2 BAL: "));
    CHECK(has(good.out, " 0 skipped"));
    std::swap(model["cross"]["stages"][1]["sway"], model["cross"]["stages"][2]["sway"]);
    CHECK(cremona({"verify", "-"}, model.dump()).status == 1);
    std::swap(model["cross"]["stages"][1]["sway"], model["cross"]["stages"][2]["sway"]);
    model["cross"]["stages"][0]["props"][1]["reaction"] = 0.1234;
    CHECK(cremona({"verify", "-"}, model.dump()).status == 1);
}

TEST_CASE("--csv prints a row a line, and tables speak Portuguese with --lang pt")
{
    const Run csv = cremona({"cross", "tests/cases/cross/MD-001.json", "--csv"});
    CHECK(csv.out.starts_with("stage,step,joint,AB,BA,BC,CB,CD,DC\n0,FEM,,0,0,240,-240,250,-250\n"));
    const Run table = cremona({"cross", "tests/cases/cross/MD-001.json", "--lang", "pt"});
    CHECK(has(table.out, "Momentos finais"));
    CHECK(has(table.out, "-125,2"));
}

TEST_CASE("Kani's method and the slope-deflection equations come to the moments that the sheet tends to")
{
    const json limit = sheet_of({"examples/portal.json", "--case", "W"})["limit"];
    for (const char* method : {"kani", "slope-deflection"}) {
        const json other = sheet_of({"examples/portal.json", "--case", "W", "--method", method});
        CAPTURE(method);
        for (const auto& [end, moment] : limit.items()) CHECK(other["total"][end] == doctest::Approx(double(moment)));
        const Run told = cremona({"cross", "examples/portal.json", "--method", method});
        CHECK(told.status == 0);
        CHECK(has(told.out, "TOTAL"));
    }
    CHECK(sheet_of({"examples/portal.json", "--method", "slope-deflection"})["unknowns"] ==
          json::array({"th_B", "th_C", "d_B"}));
    CHECK(has(cremona({"cross", "examples/portal.json", "--method", "guess"}).err, "wanted one of cross, kani"));
    CHECK(has(cremona({"cross", "examples/portal.json", "--order", ""}).err, "wanted one of largest"));
}

TEST_CASE("--report writes the whole calculation with its pictures in one file")
{
    const Folder folder;
    const Run run = cremona({"cross", "examples/portal.json", "--report", folder.path("portal.html")});
    CHECK(run.status == 0);
    CHECK(run.out.empty());
    CHECK(has(run.err, "written: "));
    CHECK(has(folder.read("portal.html"), "<svg"));
    CHECK(has(folder.read("portal.html"), "Sheet of the sway at B"));
    CHECK(cremona({"cross", "examples/portal.json", "--report", folder.path("portal.report.pdf")}).status == 0);
    CHECK(folder.read("portal.report.pdf").starts_with("%PDF"));
    CHECK(has(cremona({"cross", "examples/portal.json", "--report", folder.path("portal.txt")}).err, ".report.pdf"));
    CHECK(cremona({"cross", "examples/truss.json", "--report", folder.path("truss.html")}).status == 2);
    CHECK(!folder.has("truss.html"));
}

TEST_CASE("What the method cannot do is refused with the part and the reason")
{
    const auto refused = [](const std::string& text, int status, const std::string& words,
                            const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"cross", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Run run = cremona(arguments, text);
        CAPTURE(words);
        CHECK(run.status == status);
        CHECK(run.out.empty());
        CHECK_MESSAGE(has(run.err, words), run.err);
    };
    const std::string AB = R"("nodes": ["A", "B"],)";
    refused(beam(AB, AB + R"("rigid": true,)"), 2, "member AB is rigid");
    refused(beam(AB, AB + R"("start": {"offset": [0, 0.5]},)"), 2, "member AB has an offset across its axis");
    refused(beam(AB, AB + R"("start": {"spring": {"ux": 100}},)"), 2, "member AB has a spring along its axis");
    refused(beam(R"("load_cases": [{"id": "q", "members": [{"member": "AB", "kind": "distributed", "qy": -12}]}])",
                 R"("load_cases": [])"),
            2, "no load case");
    const Run grillage = cremona({"cross", "examples/grillage.json"});
    CHECK(grillage.status == 2);
    CHECK(has(grillage.err, "moment distribution works on continuous beams and plane frames, not on a grillage"));
    const Run mechanism = cremona({"cross", "examples/mechanism.json"});
    CHECK(mechanism.status == 3);
    CHECK(has(mechanism.err, "nodes B and C sway to the right together"));
    refused(beam(), 2, "choose from B", {"--order", "B,Z"});
    refused(beam(), 2, "wanted a number greater than 0", {"--tolerance", "-1"});
    refused(beam(), 2, "wanted a whole number from 1 to 16", {"--digits", "x"});
    refused(beam(), 2, "there is no \"p\"", {"--case", "p"});
}

TEST_SUITE_END();
