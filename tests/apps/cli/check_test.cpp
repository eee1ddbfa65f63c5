#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/cli/run_cremona.h"

using cli_test::cantilever;
using cli_test::cremona;
using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

namespace {

std::string with(const std::string& from, const std::string& to)
{
    std::string model = cantilever();
    return model.replace(model.find(from), from.size(), to);
}

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

} // namespace

TEST_CASE("What is wrong in the blocks of influence lines and trains is told by check, each with its place")
{
    const auto told = [](const std::string& block) {
        std::string model = cantilever();
        model.insert(model.rfind('}'), ", " + block);
        const Run run = cremona({"check", "-"}, model);
        CHECK(run.status == 2);
        return run.err;
    };
    CHECK(has(told(R"("train": {"path": ["AB"], "axles": [8, 32], "spacings": []})"), "train: "));
    CHECK(has(told(R"("train": {"path": ["AB"], "axles": [8], "impact": -1})"),
              "train: impact is -1; give 0 or a positive value"));
    CHECK(has(told(R"("train": [1])"), "error: train: "));
    CHECK(has(told(R"("train": {"path": ["XY"], "axles": [8]})"), "error: train.path"));
    CHECK(has(
        told(R"("influence": {"path": ["AB"], "lines": [{"quantity": "reaction", "node": "X", "component": "fy"}]})"),
        "influence.lines[0]"));
    CHECK(has(
        told(
            R"("trains": [{"id": "t", "path": ["AB"], "axles": [1]}], "moving_envelopes": [{"id": "e", "trains": ["t"], "factor": -2}])"),
        "factor is -2; give 0 or a positive value"));
}

TEST_CASE("A sound file is said to be sound on stdout")
{
    const Run run = cremona({"check", "-"}, cantilever());
    CHECK(run.status == 0);
    CHECK(run.out == "standard input: no errors, warnings: 0\n");
    CHECK(run.err.empty());
}

TEST_CASE("All errors of a file come at once on stderr, with their places, and stdout stays empty")
{
    std::string model = with("\"support\"", "\"suport\"");
    model.replace(model.find("[\"A\", \"B\"]"), 10, "[\"A\", \"D\"]");
    for (const char* option : {"--lang=en", "--json"}) {
        CAPTURE(option);
        const Run run = cremona({"check", "-", option}, model);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CHECK(has(run.err, "did you mean \"support\"?"));
        CHECK(has(run.err, "members[0] \"AB\": no node \"D\""));
        CHECK(has(run.err, "standard input: errors: 2, warnings: 0"));
    }
}

TEST_CASE("The degree of static indeterminacy is counted in words and numbers")
{
    const Run text = cremona({"check", "-", "--count"}, cantilever());
    CHECK(text.status == 0);
    CHECK(has(text.out, "Degree of indeterminacy: 0 rings × 3 + 3 reactions − 1 part × 3 = 0\n"));
    CHECK(has(text.out, "  support A: +3\n"));
    const Run json = cremona({"check", "-", "--count", "--json"}, cantilever());
    const auto counting = nlohmann::json::parse(json.out).at("files").at(0).at("counting");
    CHECK(counting.at("degree").at("total") == 0);
    CHECK(counting.at("reactions").at(0).at("count") == 3);
    CHECK(counting.at("motions") == 0);
}

TEST_CASE("The count is written in Portuguese with --lang pt")
{
    const Run run = cremona({"check", "-", "--count", "--lang", "pt"}, cantilever());
    CHECK(has(run.out, "Grau de hiperestaticidade: 0 anéis × 3 + 3 reações − 1 parte × 3 = 0\n"));
}

TEST_CASE("Faults are told in Portuguese with --lang pt")
{
    const Run run = cremona({"check", "-", "--lang", "pt"}, with("\"support\"", "\"suport\""));
    CHECK(run.status == 2);
    CHECK(has(run.err, "entrada padrão: erro: "));
    CHECK(has(run.err, "\"support\""));
    CHECK_FALSE(has(run.err, "unknown key"));
}

TEST_CASE("A mechanism is no fault of the file: check does not solve")
{
    CHECK(cremona({"check", "-"}, cli_test::floating()).status == 0);
}

TEST_CASE("Of many warnings of one kind the first fifty are told, then how many more and the last")
{
    std::string nodes;
    for (int i = 0; i < 70; ++i)
        nodes += R"({"id": "n)" + std::to_string(i) + R"(", "at": [)" + std::to_string(i) + ", 5]}, ";
    const Run run = cremona({"check", "-"}, with("{\"id\": \"A\"", nodes + "{\"id\": \"A\""));
    CHECK(run.status == 0);
    CHECK(cli_test::count(run.err, "no member is joined to this node") == 51);
    CHECK(has(run.err, "and 20 more like \"nodes[69] \"n69\": no member is joined"));
    CHECK(has(run.out, "warnings: 70"));
}

TEST_CASE("A warning goes to stderr and leaves the status 0")
{
    const std::string unused = with("\"sections\": [",
                                    "\"sections\": [{\"id\": \"spare\", \"A\": 0.02, \"Iz\": 3e-4}, ");
    const Run run = cremona({"check", "-"}, unused);
    CHECK(run.status == 0);
    CHECK(has(run.err, "standard input: warning: "));
    CHECK(has(run.err, "spare"));
    CHECK(run.out == "standard input: no errors, warnings: 1\n");
    const auto report = nlohmann::json::parse(cremona({"check", "-", "--json"}, unused).out);
    CHECK(report["files"][0]["warnings"].size() == 1);
}

TEST_CASE("Of several files each is reported, and one error makes the status 2")
{
    const Folder folder;
    const std::string good = folder.write("good.json", cantilever()), bad = folder.write("bad.json", "[]");
    const Run run = cremona({"check", good, bad});
    CHECK(run.status == 2);
    CHECK(run.out == good + ": no errors, warnings: 0\n");
    CHECK(has(run.err, bad + ": error: "));
}

TEST_CASE("A folder's view files are checked beside their models, and verify passes over them")
{
    const Folder folder;
    const std::string model = folder.path("beam.json"), views = folder.path("beam.view.json");
    write(model, cantilever());
    write(views, R"({"cremona_view": 1, "views": [{"name": "a", "show": "M", "case": "P"}]})");
    CHECK(cremona({"check", model, views}).out ==
          model + ": no errors, warnings: 0\n" + views + ": no errors, warnings: 0\n");
    const Run verified = cremona({"verify", model, views});
    CHECK(verified.status == 0);
    CHECK(has(verified.err, views + ": skipped: a view file"));
    write(views, R"({"cremona_view": 1, "views": [{"name": "a", "show": "momnet"}]})");
    const Run misspelt = cremona({"check", views});
    CHECK(misspelt.status == 2);
    CHECK(has(misspelt.err, views + ": error: views[0].show: \"momnet\" is none of loads, reactions, N"));
    write(views, R"({"cremona_view": 1, "views": [{"name": "a", "show": "M", "case": "Q"}]})");
    const Run checked = cremona({"check", model, views});
    CHECK(checked.status == 2);
    CHECK(has(checked.err, views + ": error: views[0].case: no load case or combination \"Q\""));
}

TEST_CASE("A view file alone cannot be checked: its model is asked for")
{
    const Folder folder;
    write(folder.path("beam.view.json"), R"({"cremona_view": 1})");
    const Run run = cremona({"check", folder.path("beam.view.json")});
    CHECK(run.status == 2);
    CHECK(has(run.err, "cannot read " + folder.path("beam.json") + ": No such file or directory"));
}

TEST_SUITE_END();
