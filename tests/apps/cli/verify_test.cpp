#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"
#include "tests/text_of.h"

using cli_test::cantilever;
using cli_test::cremona;
using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

namespace {

std::string with_expected(const std::string& expected)
{
    const std::string model = cantilever();
    return model.substr(0, model.find("\"expected\"")) + "\"expected\": [" + expected + "]}";
}

std::string wrong() // P L^3 / 3 E I is 0.0128
{
    return with_expected(
        R"({"case": "P", "quantity": "displacement", "node": "B", "component": "uy", "value": -0.0127})");
}

} // namespace

TEST_CASE("A check is told in Portuguese with --lang pt, in JSON always in English")
{
    const auto in_portuguese = cremona({"verify", "-", "--lang", "pt"}, cantilever()).out;
    CHECK(has(in_portuguese, ": caso P: deslocamento uy do nó B = -0,0128, esperado"));
    CHECK(has(in_portuguese, ": caso P: esforço interno M da barra AB "));
    CHECK(cremona({"verify", "-", "--json", "--lang", "pt"}, cantilever()).err.empty());
    CHECK(has(cremona({"verify", "-", "--json", "--lang", "pt"}, cantilever()).out,
              "\"case P: displacement uy of node B\""));
}

TEST_CASE("Every check has a line with result, value and tolerance, and the count stands last")
{
    const Folder folder;
    const std::string file = folder.write("c.json", cantilever());
    const Run run = cremona({"verify", file});
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    CHECK(has(run.out,
              file + ": case P: displacement uy of node B = -0.0128, expected -0.0128 within 1.28e-08: passed\n"));
    CHECK(has(run.out,
              file + ": case P: section_force M of member AB at 0 = -48, expected -48 within 4.8e-05: passed\n"));
    CHECK(run.out.ends_with("\n3 passed, 0 failed, 0 skipped\n"));
}

TEST_CASE("What is 0 but for rounding is printed as 0")
{
    const Run lines = cremona({"verify", "tests/cases/cross/MD-002.json"});
    CHECK(has(lines.out, "section_force M of member AB at 0 = 0, expected 0 within 1e-09: passed\n"));
    CHECK(has(lines.out, "cross: final: AB = 0, expected 0 within"));
    CHECK(!has(lines.out, "e-1"));
    CHECK(has(cremona({"verify", "--json", "tests/cases/cross/MD-002.json"}).out, "\"result\": 0,"));
}

TEST_CASE("A failed check gives status 1 and is named")
{
    const Run run = cremona({"verify", "-"}, wrong());
    CHECK(run.status == 1);
    CHECK(run.out ==
          "standard input: case P: displacement uy of node B = -0.0128, expected -0.0127 within 1.27e-08: FAILED\n"
          "0 passed, 1 failed, 0 skipped\n");
}

TEST_CASE("A tolerance makes the same check pass")
{
    for (const char* tolerance : {"\"rtol\": 0.01", "\"atol\": 0.0002", "\"atol\": \"0.2 mm\""}) {
        CAPTURE(tolerance);
        std::string model = wrong();
        model.insert(model.find("-0.0127") + 7, std::string(", ") + tolerance);
        CHECK(cremona({"verify", "-"}, model).status == 0);
    }
}

TEST_CASE("At a jump the + side is read, the - side when asked, and at the end there is only the - side")
{
    std::string model = with_expected(
        R"({"case": "P", "quantity": "section_force", "member": "AB", "component": "V", "at": 1, "value": 0, "atol": 1e-9},
           {"case": "P", "quantity": "section_force", "member": "AB", "component": "V", "at": "25%", "side": "-", "value": 12},
           {"case": "P", "quantity": "section_force", "member": "AB", "component": "M", "at": "100%", "value": 0, "atol": 1e-9},
           {"case": "P", "quantity": "extreme", "member": "AB", "component": "V", "which": "max", "value": 12},
           {"case": "P", "quantity": "extreme", "member": "AB", "component": "V", "which": "min", "value": 0, "atol": 1e-9})");
    const std::string tip = R"("nodes": [{"node": "B", "fy": -12}])";
    model.replace(model.find(tip), tip.size(), R"("members": [{"member": "AB", "kind": "point", "at": 1, "fy": -12}])");
    const Run run = cremona({"verify", "-"}, model);
    CHECK_MESSAGE(run.status == 0, run.out);
    CHECK(has(run.out, "5 passed"));
    CHECK(has(run.out, "section_force V of member AB at 25% (- side) = 12"));
    CHECK(has(run.out, "extreme V max of member AB = 12"));
}

TEST_CASE("Checks of analyses that are not built are skipped and named, never passed, and the status is 0")
{
    const Run run = cremona({"verify", "tests/cases/members/MO-003-a.json"});
    CHECK(run.status == 0);
    CHECK(has(run.out, "modal frequency 1: skipped: this analysis is not built yet\n"));
    CHECK(run.out.ends_with("\n0 passed, 0 failed, 3 skipped\n"));
}

TEST_CASE("A train is compared with its block: values, and the sections of extremes")
{
    const Run run = cremona({"verify", "tests/cases/influence/ML-001-60.json"});
    CHECK(run.status == 0);
    CHECK(has(run.out, "train HS20-44: max M(AB)"));
    CHECK(has(run.out, "train HS20-44: max M(AB): section"));
    CHECK(run.out.ends_with("\n4 passed, 0 failed, 0 skipped\n"));
}

TEST_CASE("The lines of an influence block are compared value by value, extreme by extreme, place by place")
{
    const Run run = cremona({"verify", "tests/cases/influence/IL-001.json"});
    CHECK(run.status == 0);
    CHECK(has(run.out, ": line 1: "));
    CHECK(has(run.out, " at s = 0 = "));
    CHECK(has(run.out, " passed, 0 failed, 0 skipped\n"));
}

TEST_CASE("The sheet of a cross block is worked in its order and compared row by row")
{
    const Run run = cremona({"verify", "tests/cases/cross/MD-001.json"});
    CHECK(run.status == 0);
    CHECK(has(run.out, "cross: factors of C: CB = 0.4, expected 0.4 within 1e-06: passed\n"));
    CHECK(has(run.out, "cross: row 13 TOTAL: "));
    CHECK(has(run.out, "cross: final: CD = 281.5789474, expected 281.5789474 within 0.000282: passed\n"));
    CHECK(run.out.ends_with("28 passed, 0 failed, 0 skipped\n"));
}

TEST_CASE("A wrong number anywhere in a cross block fails the row that it stands in")
{
    const std::string text = text_of("tests/cases/cross/MD-001.json");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        const auto at = changed.find(from, changed.find("\"cross\""));
        REQUIRE(at != std::string::npos);
        return cremona({"verify", "-", "--quiet"}, changed.replace(at, from.size(), to));
    };
    const auto fails = [&](const std::string& from, const std::string& to, const std::string& line) {
        const Run run = with(from, to);
        CAPTURE(from);
        CHECK(run.status == 1);
        CHECK_MESSAGE(has(run.out, line), run.out);
    };
    fails("\"CB\": 0.4", "\"CB\": 0.41", "cross: factors of C: CB = 0.4, expected 0.41");
    fails("\"BC\": 240", "\"BC\": 241", "cross: fixed-end moments: BC = 240, expected 241");
    fails("\"CD\": 36", "\"CD\": 36.5", "cross: row 4 BAL: CD = 36, expected 36.5");
    fails("\"CB\": -281.5789474", "\"CB\": -281.6", "cross: final: CB = -281.5789474, expected -281.6");
    const Run end = with("\"CD\": 36", "\"CX\": 36");
    CHECK(end.status == 2);
    CHECK(has(end.err, "there is no member end \"CX\"; choose from AB, BA, BC, CB, CD and DC"));
    const Run joint = with("\"all-at-once\"", "\"B,A\"");
    CHECK(joint.status == 2);
    CHECK(has(joint.err, "\"A\" is no joint that can be balanced; choose from B and C"));
    CHECK(with("\"balances\": 6", "\"balances\": 5").status == 2);
    CHECK(with("\"balances\": 6", "\"balances\": 0.5").status == 2);
}

TEST_CASE("A file without checks is status 0")
{
    const Run run = cremona({"verify", "-"}, with_expected(""));
    CHECK(run.status == 0);
    CHECK(run.out == "0 passed, 0 failed, 0 skipped\n");
}

TEST_CASE("--quiet prints failed checks and the count alone")
{
    const Folder folder;
    const Run run = cremona(
        {"verify", "--quiet", folder.write("good.json", cantilever()), folder.write("bad.json", wrong())});
    CHECK(run.status == 1);
    CHECK(cli_test::count(run.out, "\n") == 2);
    CHECK(has(run.out, "bad.json: case P"));
    CHECK(run.out.ends_with("\n3 passed, 1 failed, 0 skipped\n"));
}

TEST_CASE("Of several files the status is 2 before 3 before 1")
{
    const Folder folder;
    const std::string failed = folder.write("failed.json", wrong());
    std::string text = wrong();
    const std::string support = R"(, "support": "fixed")";
    text.erase(text.find(support), support.size());
    const std::string mechanism = folder.write("mechanism.json", text);
    const std::string broken = folder.write("broken.json", "{");
    CHECK(cremona({"verify", failed}).status == 1);
    CHECK(cremona({"verify", failed, mechanism}).status == 3);
    CHECK(cremona({"verify", broken, failed, mechanism}).status == 2);
    CHECK(cremona({"verify", mechanism, broken}).status == 2);
}

TEST_CASE("A mechanism or a broken file leaves stdout empty when there is nothing else")
{
    const Run run = cremona({"verify", "-"}, "{\"cremona\": 1");
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(has(run.err, "standard input: error: "));
}

TEST_CASE("--json gives the checks and the counts")
{
    const Run run = cremona({"verify", "-", "--json"}, wrong());
    CHECK(run.status == 1);
    const auto report = nlohmann::json::parse(run.out);
    CHECK(report["failed"] == 1);
    CHECK(report["checks"][0]["verdict"] == "failed");
    CHECK(report["checks"][0]["expected"] == -0.0127);
}

TEST_SUITE_END();
