#include <doctest/doctest.h>

#include <fstream>
#include <regex>

#include "apps/frame/document/companion/companion_file.h"
#include "apps/frame/document/dimensioning.h"
#include "apps/frame/document/document.h"
#include "apps/frame/session/commands.h"
#include "apps/frame/session/view_commands.h"
#include "femoop/io/model_file.h"
#include "tests/folder.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"
#include "ui/files/view_file.h"

namespace fs = std::filesystem;

using frame::Companion;
using frame::CompanionReading;
using frame::DimensionDirection;
using frame::Document;
using frame::read_companion;
using frame::Session;
using frame::write_companion;

namespace {

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

const Companion example{{{.nodes = {"A", "D"}, .direction = DimensionDirection::Horizontal, .offset = -0.1 - 0.7},
                         {.nodes = {"B", "C", "D"}, .direction = DimensionDirection::Aligned, .offset = 1.25}},
                        {}};

femoop::Model portal() { return frame::starting_document().model; }

/// The fault of a text, in words; "" where it has none.
std::string fault_of(const std::string& text)
{
    const CompanionReading reading = read_companion(text, portal());
    return reading.faults.empty() ? "" : femoop::message(reading.faults.front());
}

/// What the session tells; "" where it tells nothing.
std::string said(const Session& session) { return session.notice ? ui::Catalogue()(session.notice->sentence) : ""; }

/// The portal with a companion, saved.
fs::path saved_in(const Folder& folder)
{
    Session session(frame::starting_document());
    session.change({"Draw", [](Document& document) { document.companion = example; }});
    REQUIRE(session.save(folder.path() / "portal.json"));
    return folder.path() / "portal.json";
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("A companion written and read back is the same bit for bit")
    {
        const CompanionReading reading = read_companion(write_companion(example, portal()), portal());
        CHECK(reading.faults.empty());
        CHECK(reading.companion == example);
        CHECK(read_companion(write_companion({}, {}), {}).companion.is_empty());
    }

    TEST_CASE("Named supports and loads of every kind are written and read back, in the units of the model")
    {
        femoop::DistributedLoad floor{.values = {{femoop::Dof::uy, femoop::Quantity(-12.0, "-12 kN/m"), std::nullopt}}};
        Companion companion;
        companion.sets = {{"spring", femoop::Support{.springs = {{femoop::Dof::rz, femoop::Quantity(4500.0)}}}},
                          {"floor", frame::MemberLoadValue(floor)},
                          {"wind", std::vector<femoop::Component>{{femoop::Dof::ux, femoop::Quantity(7.5)}}}};
        const std::string text = write_companion(companion, portal());
        const CompanionReading reading = read_companion(text, portal());
        CHECK(reading.faults.empty());
        CHECK(reading.companion == companion);
        femoop::Model in_newtons = portal();
        in_newtons.units.force = femoop::ForceUnit::N;
        const auto wind = read_companion(text, in_newtons).companion.sets[2];
        CHECK(std::get<std::vector<femoop::Component>>(wind.value)[0].value.value() == 7500.0);
    }

    TEST_CASE("A named set that cannot be read is told, and the rest is read")
    {
        const CompanionReading reading = read_companion(
            R"({"cremona_view": 1, "dimensions": [{"nodes": ["A", "B"], "direction": "vertical", "offset": 1}],
                "sets": {"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
                "nodes": [{"id": "base", "at": [0, 0], "support": "fxed"}], "members": []}})",
            portal());
        REQUIRE(reading.faults.size() == 1);
        CHECK(femoop::message(reading.faults[0]).find("fxed") != std::string::npos);
        CHECK(reading.companion.sets.empty());
        CHECK(reading.companion.dimensions.size() == 1);
    }

    TEST_CASE("The example of the reference page is read as it is written")
    {
        const std::string page = text_of(source_folder() + "/courseware/reference/view-file.md");
        const std::size_t begin = page.find("```json\n");
        REQUIRE(begin != std::string::npos);
        const std::string text = page.substr(begin + 8, page.find("```", begin + 8) - begin - 8);
        const CompanionReading reading = read_companion(text, portal());
        CHECK(reading.faults.empty());
        CHECK(write_companion(reading.companion, portal()) == text);
    }

    TEST_CASE("What a companion file cannot mean is said with its place")
    {
        const auto with = [](const std::string& line) {
            return fault_of(R"({"cremona_view": 1, "dimensions": [)" + line + "]}");
        };
        CHECK(with(R"({"nodes": ["A", "B"], "direction": "vertical", "offset": 1})") == "");
        CHECK(fault_of("{}") == "file: \"cremona_view\" is missing; add it");
        CHECK(fault_of(R"({"cremona_view": 2})") == R"(cremona_view: "2" is none of 1; choose one of them)");
        CHECK(fault_of(R"({"cremona_view": 1, "dimension": []})") ==
              R"(dimension: unknown key; did you mean "dimensions"?)");
        CHECK(with(R"({"nodes": ["A", "Z"], "direction": "vertical", "offset": 1})") ==
              R"(dimensions[0].nodes[1]: no node "Z"; add the node or name another)");
        CHECK(with(R"({"nodes": ["A", "A"], "direction": "vertical", "offset": 1})") ==
              R"(dimensions[0].nodes[1]: goes from node "A" to itself; name two different nodes)");
        CHECK(with(R"({"nodes": ["A"], "direction": "vertical", "offset": 1})") ==
              "dimensions[0].nodes: found a list of 1, wanted the names of 2 nodes; name the first and the second");
        CHECK(with(R"({"nodes": ["A", "B"], "direction": "upright", "offset": 1})") ==
              R"(dimensions[0].direction: "upright" is none of aligned, horizontal, vertical; choose one of them)");
        CHECK(with(R"({"nodes": ["A", "B"], "direction": "vertical", "offset": "1 m"})") ==
              R"(dimensions[0].offset: found a text "1 m", wanted a number; write it like 1.5)");
        CHECK(with("7") == R"(dimensions[0]: found a number, wanted an object; write it like {"...": ...})");
        CHECK(fault_of("{") != "");
        CHECK(fault_of("") == "file: \"cremona_view\" is missing; add it");
    }

    TEST_CASE("What a view cannot mean is said with its place, and the view is left out")
    {
        const auto with = [](const std::string& more) {
            const CompanionReading reading = read_companion(
                R"({"cremona_view": 1, "views": [{"name": "a", )" + more + "}]}", portal());
            CHECK(reading.companion.views.size() == (reading.faults.empty() ? 1 : 0));
            return reading.faults.empty() ? "" : femoop::message(reading.faults.front());
        };
        CHECK(with(R"("show": "loads, m", "case": "G")") == "");
        CHECK(with(R"("show": "loads", "case": "Live")") ==
              R"(views[0].case: no load case or combination "Live"; add it or name another)");
        CHECK(
            with(R"("show": "loads,momnet,M")") ==
            R"(views[0].show: "momnet" is none of loads, reactions, N, V, M, T, Vy, Vz, My, Mz, deformed, thrust, )"
            R"(values, steps, nodes, members, dimensions, drawn, axes, counting, legend, labels; choose one of them)");
        CHECK(with(R"("show": "M", "envelope": ["G"])") == "");
        CHECK(with(R"("show": "M", "envelope": ["G", "Live"])") ==
              R"(views[0].envelope[1]: no load case or combination "Live"; add it or name another)");
        CHECK(with(R"("show": "M", "envelope": [1])") ==
              R"(views[0].envelope[0]: found a number, wanted a text; write it like "...")");
        CHECK(with(R"("show": "M", "diagrams": -2)") == "views[0]: diagrams is -2; give a value greater than 0");
        CHECK(with(R"("show": "M", "region": [1, 2, 0])") ==
              "views[0].region: height is 0; give a value greater than 0");
        CHECK(with(R"("show": "M", "region": [1, 2])") ==
              "views[0].region: found a list of 2, wanted 3 lengths in m; give one per coordinate");
        CHECK(with(R"("show": "M", "region": [1, "2", 3])") ==
              R"(views[0].region[1]: found a text "2", wanted a number; write it like 1.5)");
    }

    TEST_CASE("Two views of one name are told and the later one is left out")
    {
        const CompanionReading reading = read_companion(R"({"cremona_view": 1, "views": [{"name": "a", "show": "N"},
            {"name": "b", "show": "M"}, {"name": "a", "show": "V"}]})",
                                                        portal());
        REQUIRE(reading.faults.size() == 1);
        CHECK(femoop::message(reading.faults.front()) ==
              "views[2].name: the id is taken by views[0] already; choose another");
        REQUIRE(reading.companion.views.size() == 2);
        CHECK(reading.companion.views[0].show == frame::ShowSet{frame::Show::N});
    }

    TEST_CASE("What is wrong in the sets is said with its place in the view file")
    {
        const auto with = [](const std::string& sets) {
            return fault_of(R"({"cremona_view": 1, "sets": )" + sets + "}");
        };
        const std::string head = R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"}, )";
        const std::string lost = ": found something else, wanted the support of a node, or a load case of one load; "
                                 "write it like \"support\": \"fixed\"";
        CHECK(with("{}") == R"(sets: "cremona" is missing; add it)");
        CHECK(with(head + R"("nodes": [{"id": "b", "at": [0, 0], "support": "fxed"}], "members": []})")
                  .starts_with(R"(sets.nodes[0].support: "fxed" is none of)"));
        CHECK(with(head + R"("nodes": [{"id": "b", "at": [0, 0], "support": "fixed"}], "members": []})") == "");
        CHECK(with(head + R"("nodes": [{"id": "b", "at": [0, 0]}], "members": []})") == "sets.nodes[0]" + lost);
        CHECK(with(head + R"("materials": [{"id": "s", "E": 1}], "nodes": [], "members": []})") ==
              "sets.materials[0]" + lost);
        const std::string bearer =
            R"("materials": [{"id": "s", "E": 1, "density": 1}], "sections": [{"id": "c", "A": 1, "Iz": 1}],
            "nodes": [{"id": "b", "at": [0, 0]}, {"id": "e", "at": [9, 0]}],
            "members": [{"id": "be", "nodes": ["b", "e"], "material": "s", "section": "c"}], "load_cases": [{"id": "w", )";
        const std::string load = R"({"node": "b", "fx": 1})";
        CHECK(with(head + bearer + R"("nodes": [)" + load + "]}]}") == "");
        CHECK(with(head + bearer + R"("nodes": [)" + load + ", " + load + "]}]}") == "sets.load_cases[0]" + lost);
        CHECK(with(head + bearer + R"("self_weight": 1, "nodes": [)" + load + "]}]}") == "sets.load_cases[0]" + lost);
    }

    TEST_CASE("A document is saved with its companion, and opens with it; without one there is no file")
    {
        const Folder folder;
        const fs::path path = saved_in(folder);
        Session again{Document{}};
        REQUIRE(again.open(path));
        CHECK(!again.notice);
        CHECK(again.document().companion == example);
        CHECK(!again.is_dirty());
        again.change({"Wipe out", [](Document& document) { document.companion = {}; }});
        CHECK(again.is_dirty());
        REQUIRE(again.save(path));
        CHECK(!fs::exists(folder.path() / "portal.view.json"));
    }

    TEST_CASE("A companion file with a fault leaves the model open, is told, and is kept when another takes its place")
    {
        const Folder folder;
        const fs::path path = saved_in(folder), beside = folder.path() / "portal.view.json";
        write(beside, R"({"cremona_view": 1, "dimensoins": []})");
        Session session{Document{}};
        REQUIRE(session.open(path));
        CHECK(said(session) == "portal.view.json was not understood in full");
        CHECK(session.notice->faults.size() == 1);
        session.change({"Draw", [](Document& document) { document.companion = example; }});
        REQUIRE(session.save(path));
        CHECK(session.notice);
        CHECK(text_of(folder.path() / "portal.view.json.old") == R"({"cremona_view": 1, "dimensoins": []})");
        CHECK(text_of(beside) == write_companion(example, portal()));
        REQUIRE(session.save(path));
        CHECK(said(session) == "portal.json was saved");
    }

    TEST_CASE("A view file with one bad entry is kept when the document is saved, each time under a name of its own")
    {
        const Folder folder;
        const fs::path path = saved_in(folder), beside = folder.path() / "portal.view.json";
        for (const std::string aside : {"portal.view.json.old", "portal.view.json.old2"}) {
            const std::string text =
                R"({"cremona_view": 1, "dimensions": [{"nodes": ["A", "Z"], "direction": "vertical",
                "offset": 1}], "views": [{"name": ")" +
                aside + R"(", "show": "M"}]})";
            write(beside, text);
            Session session{Document{}};
            REQUIRE(session.open(path));
            REQUIRE(session.save(path));
            CHECK(said(session) == "portal.view.json was not understood; it is kept as " + aside);
            CHECK(text_of(folder.path() / aside) == text);
        }
    }

    TEST_CASE("A view file is judged beside the model that it was written for")
    {
        const Folder folder;
        const fs::path path = saved_in(folder);
        Session session{Document{}};
        REQUIRE(session.open(path));
        session.change({"Rename", [](Document& document) { document.model.nodes[3].id = "foot"; }});
        REQUIRE(session.save(path));
        CHECK(said(session) == "portal.json was saved");
        CHECK(session.document().companion.dimensions[0].nodes[1] == "foot");
    }

    TEST_CASE("No two models share a view file, and none is written over one")
    {
        const Folder folder;
        const fs::path path = saved_in(folder);
        Session session(frame::starting_document());
        for (const char* name : {"portal", "portal.txt"}) {
            REQUIRE(session.save(folder.path() / name));
            CHECK(said(session) == name + std::string(" was saved"));
        }
        CHECK(text_of(folder.path() / "portal.view.json") == write_companion(example, portal()));
        for (const char* name : {"portal.view.json", "portal.view"}) {
            CHECK(!session.save(folder.path() / name));
            CHECK(session.notice);
        }
        CHECK(text_of(folder.path() / "portal.view.json") == write_companion(example, portal()));
        CHECK(ui::view_path("a/q.txt") == "a/q.txt.view");
        CHECK(ui::model_of_view("a/q.txt.view") == "a/q.txt");
        CHECK(ui::model_of_view("a/q.view.json") == "a/q.json");
        CHECK(!ui::model_of_view("a/q.json"));
    }

    TEST_CASE("Through a link to the model its view file is found, and written")
    {
        const Folder folder;
        const fs::path path = saved_in(folder), link = folder.path() / "link.json";
        fs::create_symlink(path, link);
        Session session{Document{}};
        REQUIRE(session.open(link));
        CHECK(session.document().companion == example);
        session.change({"Wipe out", [](Document& document) { document.companion = {}; }});
        REQUIRE(session.save(link));
        CHECK(!fs::exists(folder.path() / "portal.view.json"));
    }

    TEST_CASE("A line to a node that the model does not have is told and left out, the others stay")
    {
        const Folder folder;
        const fs::path path = saved_in(folder);
        femoop::Model model = femoop::read_model_file(path);
        model.nodes[0].id = "foot";
        femoop::write_model_file(model, path);
        Session session{Document{}};
        REQUIRE(session.open(path));
        REQUIRE(session.notice);
        REQUIRE(session.document().companion.dimensions.size() == 1);
        CHECK(session.document().companion.dimensions[0] == example.dimensions[1]);
    }

    TEST_CASE("A companion that cannot be written is told, and the document stays one with changes")
    {
        const Folder folder;
        const fs::path path = folder.path() / (std::string(240, 'p') + ".json"); // a longer name is too long
        Session session(frame::starting_document());
        session.change({"Draw", [](Document& document) { document.companion = example; }});
        CHECK(!session.save(path));
        CHECK(session.notice);
        CHECK(session.is_dirty());
    }

    TEST_CASE("A draft keeps the companion too, and it goes with the draft")
    {
        const Folder folder;
        Document document = frame::starting_document();
        document.companion = example;
        frame::Workspace workspace{Session{frame::starting_document()}};
        workspace.session.change({"Draw", [&](Document& to) { to = document; }});
        const ui::DraftFolder drafts{folder.path(), ".json"};
        {
            ui::Draft draft(drafts);
            REQUIRE(!draft.keep(workspace.unsaved().at(0).copy(), std::nullopt));
        }
        const auto recoverable_files = ui::recoverable_files(drafts);
        REQUIRE(recoverable_files.size() == 1);
        Session session{Document{}};
        REQUIRE(session.recover(recoverable_files[0].draft, std::nullopt));
        CHECK(session.document() == document);
        ui::Draft::taken_over(drafts, recoverable_files[0])->forget();
        CHECK(fs::is_empty(folder.path()));
    }

    TEST_CASE("A view follows its load case or combination to a new name, and undo takes it back")
    {
        Session session(frame::starting_document());
        session.change(
            {"Keep", [](Document& document) {
                 document.model.combinations.push_back({.id = "ULS", .terms = {{femoop::CaseId(0), 1.35}}});
                 document.companion.views = {
                     {.name = "a", .show = {frame::Show::M}, .load_case = "G"},
                     {.name = "b", .show = {frame::Show::M}, .load_case = "ULS"},
                     {.name = "c", .show = {frame::Show::M}, .load_case = std::nullopt, .envelope = {"G", "ULS"}}};
             }});
        session.change({"Rename", [](Document& document) { document.model.load_cases[0].id = "Dead"; }});
        session.change({"Rename", [](Document& document) { document.model.combinations[0].id = "Q"; }});
        const auto case_of = [&](std::size_t i) { return session.document().companion.views[i].load_case; };
        CHECK(case_of(0) == "Dead");
        CHECK(case_of(1) == "Q");
        CHECK(!case_of(2));
        CHECK(session.document().companion.views[2].envelope == std::vector<std::string>{"Dead", "Q"});
        session.undo();
        CHECK(case_of(1) == "ULS");
        session.undo();
        CHECK(case_of(0) == "G");
    }

    TEST_CASE("A view whose load case is gone says so when it is shown")
    {
        Session session(frame::starting_document());
        session.change({"Keep", [](Document& document) {
                            document.model.combinations.push_back({.id = "ULS", .terms = {{femoop::CaseId(0), 1.35}}});
                            document.companion.views = {{.name = "a", .show = {frame::Show::M}, .load_case = "ULS"}};
                        }});
        session.change({"Delete", [](Document& document) { document.model.combinations.clear(); }});
        CHECK(session.document().companion.views[0].load_case == "ULS");
        frame::show_view(session, 0);
        REQUIRE(session.notice);
        CHECK(ui::Catalogue()(session.notice->sentence) ==
              "a: the model has no load case or combination ULS any more; another is shown");
    }

    TEST_CASE("A view of an envelope keeps which cases that is of, and brings them back")
    {
        Session session(frame::starting_document());
        session.change({"Cases", [](Document& document) {
                            for (const char* id : {"Q", "W"}) document.model.load_cases.push_back({.id = id});
                        }});
        session.view.is_envelope = true;
        frame::keep_view(session, std::nullopt);
        CHECK(session.document().companion.views[0].envelope.empty()); // of all
        session.view.left_out = {"Q"};
        frame::keep_view(session, std::nullopt);
        CHECK(session.document().companion.views[1].envelope == std::vector<std::string>{"G", "W"});
        frame::show_view(session, 0);
        CHECK(session.view.left_out.empty());
        frame::show_view(session, 1);
        CHECK(session.view.left_out == std::set<std::string>{"Q"});
        session.change({"Delete", [](Document& document) { document.model.load_cases.pop_back(); }});
        frame::show_view(session, 1);
        REQUIRE(session.notice);
        CHECK(ui::Catalogue()(session.notice->sentence) ==
              "View 2: the model has no load case or combination W any more; the envelope is without it");
    }

    TEST_CASE("Undo brings a dimension line back with its node, and forgets one that was drawn")
    {
        Session session(frame::starting_document());
        session.change({"Draw", [](Document& document) { document.companion = example; }});
        session.change({"Rename", [](Document& document) { document.model.nodes[3].id = "foot"; }});
        CHECK(session.document().companion.dimensions[0].nodes[1] == "foot");
        session.undo();
        CHECK(session.document().companion == example);
        session.undo();
        CHECK(session.document().companion.is_empty());
    }
}
