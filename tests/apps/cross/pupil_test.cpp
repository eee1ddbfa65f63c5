// A pupil's exercise without a window: what is typed, what is kept, what is hidden.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "apps/cross/document/file.h"
#include "apps/cross/document/pupil_file.h"
#include "apps/cross/session/beam_edit.h"
#include "apps/cross/session/exercise_report.h"
#include "apps/cross/session/session.h"
#include "apps/cross/view/given.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/pupil_words.h"

using namespace cross;
namespace fc = femoop::cross;

namespace {

void fill(Session& session)
{
    for (std::size_t i = 0; i < session.worksheet()->form.blanks.size(); ++i) {
        const fc::BlankId cell(i);
        if (!session.worksheet()->form[cell].may_stay_empty)
            session.write(cell, text_for(*session.worksheet(), cell, units_of(session.document().model, session.tr())));
    }
}

} // namespace

TEST_CASE("Numbers are typed with point or comma or as fractions and know their last digit")
{
    CHECK(entry_typed("12,5") == fc::Entry{12.5, 0.1});
    CHECK(entry_typed("-20") == fc::Entry{-20.0, 1.0});
    CHECK(entry_typed(" +0.430 ").value().unit == doctest::Approx(0.001));
    CHECK(entry_typed("1/3") == fc::Entry{1.0 / 3.0, 0.0});
    CHECK(entry_typed("0.43*36").value().unit == doctest::Approx(0.01548));
    for (const char* const nonsense : {"", "twelve", "1.2.3", "1/0", "1e300", "nan", "inf", "--", "1,2.3"})
        CHECK_FALSE(entry_typed(nonsense).has_value());
    CHECK_FALSE(entry_typed(std::string(10000, '1')).has_value());
}

TEST_CASE("An exercise of every difficulty filled as it should be is solved and shows its moments")
{
    for (int difficulty = 1; difficulty <= n_difficulties; ++difficulty)
        for (std::uint32_t seed = 1; seed <= 8; ++seed) {
            CAPTURE(difficulty);
            CAPTURE(seed);
            Session session;
            session.begin_exercise({static_cast<fc::Difficulty>(difficulty), seed});
            CHECK(session.hides_results());
            CHECK(session.scene().state == nullptr);
            fill(session);
            CHECK(session.worksheet()->is_solved());
            CHECK(session.scene().state != nullptr);
            CHECK(session.points() == session.worksheet()->n_needed());
        }
}

TEST_CASE("Words and tables of an unsolved exercise tell nothing that was not written")
{
    Session session;
    session.begin_exercise({fc::Difficulty::PinnedEnd, 4});
    for (const Topic topic : {Topic::Sheet, Topic::Comparison, Topic::Kani, Topic::Equations})
        CHECK(table_of(session, topic).rows.empty());
    CHECK(description(session) == exercise_description(session));
    CHECK(session.why_no_turn().has_value());
    const Document before = session.document();
    session.set_method({.order = fc::Order::AllAtOnce}, "x");
    session.change({}, "x");
    CHECK(session.document() == before);
}

TEST_CASE("What a pupil needs stands in words however small the picture")
{
    const femoop::Model model = fc::seeded_model(fc::Difficulty::Frame, 9);
    CHECK(given_text(model, femoop::CaseId(0), ui::Catalogue()) ==
          "Lengths: AB 12 m, BC 5 m, DB 3 m. AB: 27 kN at 8 m from A. B: moment 10 kN·m clockwise.");
    CHECK(given_text(model, femoop::CaseId(0), ui::Catalogue(ui::Language::Portuguese))
              .starts_with("Comprimentos: AB 12 m, BC 5 m, DB 3 m. AB: 27 kN a 8 m de A. B: "));
    CHECK(given_text(model, femoop::CaseId(7), ui::Catalogue()) == "Lengths: AB 12 m, BC 5 m, DB 3 m.");
    CHECK(given_text({}, femoop::CaseId(0), ui::Catalogue()).empty());
}

TEST_CASE("A mistake costs its point even where it is undone")
{
    Session session;
    session.begin_exercise({fc::Difficulty::FixedEnds, 1});
    session.write(fc::BlankId(0), "77");
    session.undo();
    fill(session);
    CHECK(session.worksheet()->is_solved());
    CHECK(session.points() + 1 == session.worksheet()->n_needed());
    session.start_over();
    CHECK(session.document().pupil->written.empty());
    for (int i = 0; i < 200; ++i) session.undo();
    for (int i = 0; i < 200; ++i) session.redo();
    CHECK(session.document().pupil->written.empty());
}

TEST_CASE("Whoever looks at the solution by leaving the exercise gets no points for it")
{
    Session session;
    session.begin_own_exercise();
    const std::size_t n = session.worksheet()->n_needed();
    session.end_exercise();
    REQUIRE(session.worksheet() == nullptr);
    session.undo();
    REQUIRE(session.worksheet() != nullptr);
    fill(session);
    CHECK(session.worksheet()->is_solved());
    CHECK(session.worksheet()->n_needed() == n);
    CHECK(session.points() == 0);
}

TEST_CASE("Undo does not leave an exercise whose solution was not seen")
{
    Session session;
    session.begin_own_exercise();
    session.write(fc::BlankId(0), "77");
    for (int i = 0; i < 3; ++i) session.undo();
    REQUIRE(session.worksheet() != nullptr);
    CHECK(session.document().pupil->written.empty());
    REQUIRE(session.notice);
    CHECK(session.tr()(session.notice->sentence) ==
          "an exercise is being done; end it first: Exercise, End the exercise");
    session.end_exercise();
    for (int i = 0; i < 3; ++i) session.undo();
    CHECK(session.worksheet() == nullptr);
    CHECK_FALSE(session.history().can_undo());
}

TEST_CASE("Undo goes over two exercises on different structures, and each keeps its own score")
{
    Session session;
    const femoop::Model three_spans = session.document().model;
    session.begin_own_exercise();
    const std::size_t n_first = session.worksheet()->form.blanks.size();
    session.write(fc::BlankId(0), "77");
    session.write(fc::BlankId(0), text_for(*session.worksheet(), fc::BlankId(0), units_of(three_spans, session.tr())));
    fill(session);
    REQUIRE(session.worksheet()->is_solved());
    const std::size_t score = session.points();
    CHECK(score + 1 == session.worksheet()->n_needed());
    session.end_exercise();
    session.change(*with_span_added(three_spans), "Add a span");
    session.begin_own_exercise();
    REQUIRE(session.worksheet() != nullptr);
    CHECK(session.worksheet()->form.blanks.size() > n_first);
    fill(session);
    CHECK(session.points() == session.worksheet()->n_needed());
    while (session.document().model != three_spans) session.undo();
    CHECK(session.worksheet() == nullptr); // after the first exercise's end
    session.undo();
    REQUIRE(session.worksheet() != nullptr);
    CHECK(session.worksheet()->form.blanks.size() == n_first);
    CHECK(session.points() == score);
    for (int i = 0; i < 500; ++i) session.redo();
    REQUIRE(session.worksheet() != nullptr);
    CHECK(session.worksheet()->is_solved());
    CHECK(session.points() == 0); // all was seen when its beginning was undone
}

TEST_CASE("A beam on elastic ground is no exercise, since no hand finds its factors, and it is said so")
{
    Session session;
    REQUIRE(session.open("examples/beam_on_ground.json"));
    REQUIRE(session.solution().task.has_value());
    REQUIRE(!session.solution().task->problem.joints.empty());
    const auto reason = session.why_no_own_exercise();
    REQUIRE(reason.has_value());
    CHECK(ui::Catalogue()(*reason) == "on an elastic foundation and along a taper no hand finds the stiffness factors");
}

TEST_CASE("The table of a sheet that is right has every balance that was filled in")
{
    for (const fc::Difficulty difficulty : {fc::Difficulty::PinnedEnd, fc::Difficulty::SwayFrame}) {
        Session session;
        session.begin_exercise({difficulty, 4});
        fill(session);
        REQUIRE(session.worksheet()->is_solved());
        const std::size_t n_turns = session.worksheet()->form.turns.front().size();
        REQUIRE(session.sheet() != nullptr);
        CHECK(session.sheet()->steps.size() == n_turns);
        CHECK(table_of(session, Topic::Sheet).rows.size() > n_turns);
        const auto sum = session.worksheet()->form.find(fc::Asked::Sum, 0, 0, 1);
        REQUIRE(sum.has_value());
        CHECK(session.sheet()->end.moments[1] == doctest::Approx(session.worksheet()->form.right[sum->index]));
    }
}

TEST_CASE("An exercise in a file whose structure has no cells to fill is left out and said so")
{
    Document document{.model = fc::seeded_model(fc::Difficulty::FixedEnds, 1)};
    document.model.members.pop_back();
    document.model.nodes.pop_back();
    document.model.load_cases[0].members.clear();
    document.model.nodes[1].support = femoop::Support{.kind = femoop::SupportKind::Fixed};
    document.pupil = Pupil{.written = {"1"}};
    const auto path = std::filesystem::temp_directory_path() / "cremona_unfit_exercise.json";
    std::ofstream(path) << write_document(document);
    Session session;
    CHECK(session.open(path));
    CHECK_FALSE(session.document().pupil.has_value());
    REQUIRE(session.notice.has_value());
    CHECK(ui::Catalogue()(session.notice->sentence) ==
          "the exercise that is saved here does not fit this structure and was left out");
    std::filesystem::remove(path);
}

TEST_CASE("A sheet that is judged at the end says nothing before")
{
    Session session;
    session.begin_exercise({fc::Difficulty::FixedEnds, 2});
    session.judge_at_once(false);
    fill(session);
    CHECK_FALSE(session.worksheet()->shows_judgement);
    CHECK(session.hides_results());
    session.judge_now();
    CHECK_FALSE(session.hides_results());
}

TEST_CASE("An exercise is kept in the file with the method and everything else of the block")
{
    Document document = starting_document();
    document.pupil = Pupil{.seeded = Seeded{fc::Difficulty::Frame, 4294967295U},
                           .written = {"1/2", "", "12,5", "\"\\"},
                           .helped = {false, true, false, false},
                           .judges_at_once = false,
                           .is_judged = true};
    const Document again = read_document(write_document(document));
    CHECK(again == document);
    CHECK(read_document(write_document(starting_document())) == starting_document());
    Document own = document;
    own.pupil->seeded.reset();
    own.method.digits = 4;
    CHECK(read_document(write_document(own)).pupil == own.pupil);
    CHECK(read_document(write_document(own)).method == own.method);
    CHECK(with_pupil("{\"order\": \"largest\", \"exercise\": {\"seed\": 3}}", std::nullopt) ==
          "{\"order\": \"largest\"}");
}

TEST_CASE("A broken exercise in a file is told with its place and what was wanted")
{
    const auto told = [](const std::string& exercise) {
        try {
            static_cast<void>(pupil_in("{\"exercise\": " + exercise + "}"));
        } catch (const femoop::ModelError& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    CHECK_FALSE(pupil_in("{}").has_value());
    CHECK(told("{}") == "nothing");
    CHECK(told("3").starts_with("cross.exercise: "));
    CHECK(told("null").starts_with("cross.exercise: "));
    CHECK(told("{\"difficulty\": 9, \"seed\": 1}").find("a whole number from 1 to 6") != std::string::npos);
    CHECK(told("{\"difficulty\": 3, \"seed\": -1}").starts_with("cross.exercise.seed: "));
    CHECK(told("{\"difficulty\": 3, \"seed\": 4294967296}").starts_with("cross.exercise.seed: "));
    CHECK(told("{\"difficulty\": 3}").find("seed") != std::string::npos);
    CHECK(told("{\"cells\": 3}").starts_with("cross.exercise.cells: "));
    CHECK(told("{\"cells\": [\"1\", null]}").starts_with("cross.exercise.cells[1]: "));
    CHECK(told("{\"cells\": [\"" + std::string(61, '1') + "\"]}").starts_with("cross.exercise.cells[0]: "));
    CHECK(told("{\"helped\": [1e9]}").starts_with("cross.exercise.helped"));
    CHECK(told("{\"judges_at_once\": \"no\"}").starts_with("cross.exercise.judges_at_once: "));
}

TEST_CASE("Cells of a file that hold no number are open")
{
    Document document = starting_document();
    document.pupil = Pupil{.written = std::vector<std::string>(4000, "abc")};
    const auto worksheet = worksheet_of(document);
    REQUIRE(worksheet.has_value());
    for (const fc::Judgement& judgement : worksheet->judgements) CHECK(judgement.verdict == fc::Verdict::Open);
}

TEST_CASE("Every mistake and every hint has words of its own")
{
    for (int i = 0; i <= static_cast<int>(fc::Slip::SwayNotScaled); ++i)
        CHECK_FALSE(words_of(static_cast<fc::Slip>(i)).sentence.empty());
    for (int i = 0; i <= static_cast<int>(fc::Hint::LoadsPlusSways); ++i)
        CHECK_FALSE(words_of(static_cast<fc::Hint>(i)).sentence.empty());
}
