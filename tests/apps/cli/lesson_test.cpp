// The lessons that show commands: these run and print what the lesson shows, its pictures are those that they draw, and
// numbers that no command prints are true.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "femoop/analysis/solver_trace.h"
#include "femoop/io/model_file.h"
#include "tests/apps/cli/run_cremona.h"
#include "tests/apps/cli/shown_commands.h"
#include "tests/frame_maker.h"
#include "tests/golden/comparison.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"
#include "ui/context/pixels.h"

using namespace femoop;
using cli_test::has;
using nlohmann::json;

TEST_SUITE_BEGIN("lesson");

namespace {

constexpr const char* the_front_walks = "courseware/02-the-front-walks.md";
constexpr const char* influence_lines = "courseware/03-influence-lines.md";
constexpr const char* a_truss_by_three_methods = "courseware/04-a-truss-by-three-methods.md";

constexpr const char* where_beam_theory_ends = "courseware/05-where-beam-theory-ends.md";
constexpr const char* a_hole = "courseware/06-a-hole.md";
constexpr const char* why_q4_locks = "courseware/07-why-q4-locks.md";

/// The files that a page shows as ![..](pictures/FILE).
std::set<std::string> shown_pictures(const std::string& page)
{
    const std::string opening = "](pictures/";
    std::set<std::string> names;
    for (std::size_t begin = page.find(opening); begin != std::string::npos; begin = page.find(opening, begin)) {
        begin += opening.size();
        names.insert(page.substr(begin, page.find(')', begin) - begin));
    }
    return names;
}

/// Runs the commands of a lesson, and compares each picture that it shows with what they draw under its name.
void check_lesson(const std::string& path, std::size_t n_commands, const std::set<std::string>& pictures)
{
    const std::string page = text_of_source(path);
    const Folder folder;
    CHECK(cli_test::run_shown_commands(page, folder) == n_commands);
    CHECK(shown_pictures(page) == pictures);
    for (const std::string& name : pictures) {
        CAPTURE(name);
        REQUIRE(folder.has(name));
        const ui::Pixels drawn = ui::read_png(folder.path(name));
        const ui::Pixels shown = ui::read_png(source_folder() + "/courseware/pictures/" + name);
        CHECK_MESSAGE(golden::compare(drawn, shown).is_same(), "draw it anew with the command that the lesson shows");
    }
}

/// "18 522" for 18522.
std::string in_groups(std::size_t n)
{
    std::string text = std::to_string(n);
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ' ');
    return text;
}

json trace_of(const json& model)
{
    return json::parse(cli_test::cremona({"solve", "-", "--trace-solver", "--json"}, model.dump()).out)["solver_trace"];
}

} // namespace

TEST_CASE("Every command of the lesson on the front runs, prints what it shows and draws its pictures")
{
    check_lesson(the_front_walks, 6, {"front_band.png", "front_dissection.png"});
}

TEST_CASE("Every command of the lesson on influence lines runs, prints what it shows and draws its picture")
{
    check_lesson(influence_lines, 13, {"train_on_a_line.png"});
}

TEST_CASE("Every command of the lesson on a truss runs, prints what it shows and draws its picture")
{
    check_lesson(a_truss_by_three_methods, 12, {"cremona_diagram.png"});
}

TEST_CASE("Every command of the lessons on plates runs, prints what it shows and draws its picture")
{
    check_lesson(where_beam_theory_ends, 9, {"beam_cut.png"});
    check_lesson(a_hole, 7, {"hole.png"});
    check_lesson(why_q4_locks, 8, {"q4_bent.png"});
}

TEST_CASE("Every lesson that shows commands is run here")
{
    std::set<std::string> with_commands;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/courseware")) {
        const std::string name = entry.path().filename().string();
        const bool is_lesson = entry.path().extension() == ".md" && name.find_first_of("0123456789") == 0;
        if (is_lesson && has(text_of(entry.path()), "```console")) with_commands.insert("courseware/" + name);
    }
    CHECK(with_commands == std::set<std::string>{the_front_walks, influence_lines, a_truss_by_three_methods,
                                                 where_beam_theory_ends, a_hole, why_q4_locks});
}

TEST_CASE("The table of operations of the lesson on the front is that of frames of k columns and k storeys")
{
    const std::string text = text_of_source(the_front_walks);
    for (const std::size_t k : {6, 12, 24, 48, 96}) {
        const SolverTrace trace = trace_solver(storey_frame(k - 1, k));
        std::string line = "| " + std::to_string(k) + " | " + in_groups(trace.n_unknowns()) + " |";
        for (const EliminationWalk& walk : trace.walks)
            line += " " + in_groups(static_cast<std::size_t>(walk.counts.n_operations)) + " |";
        CHECK_MESSAGE(has(text, line), line);
    }
}

TEST_CASE(
    "The answers of the lesson on the front are right: the hub first fills L, and node F3 saves most when it is fixed")
{
    json grillage = json::parse(text_of_source("examples/grillage.json"));
    std::stable_partition(grillage["nodes"].begin(), grillage["nodes"].end(),
                          [](const json& node) { return node["id"] == "X"; });
    const json walks = trace_of(grillage)["orderings"];
    CHECK(walks["natural"]["entries_of_L"] == 11 * 12 / 2);
    for (const char* other : {"cuthill-mckee", "minimum-degree", "nested-dissection"})
        CHECK(walks[other]["fill_in"] == 0);

    const Model storeys = read_model(text_of_source("examples/storey_frame.json"));
    for (std::size_t i = 0; i < storeys.nodes.size(); ++i) {
        Model model = storeys;
        CAPTURE(model.nodes[i].id);
        if (model.nodes[i].support) continue;
        model.nodes[i].support = Support{.kind = SupportKind::Fixed};
        const std::size_t n = trace_solver(model).walk(Ordering::NestedDissection).counts.n_entries;
        CHECK((n == 1380) == (model.nodes[i].id == "F3"));
        CHECK(n >= 1380);
    }
}

TEST_SUITE_END();
