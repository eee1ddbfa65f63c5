// Choosing a typical structure: one gesture, whatever is tried in it.
#include <doctest/doctest.h>

#include "apps/frame/session/commands.h"

using namespace frame;

namespace {

struct Choosing {
    Session session{starting_document()};
    TypicalDraft draft;

    Choosing() { draft.open(session); }
    void run_command(std::string_view verb, std::string_view argument = "")
    {
        CHECK_FALSE(draft.run_command(session, verb, argument));
    }
};

} // namespace

TEST_SUITE("frame: choosing a typical structure")
{
    TEST_CASE("Whatever was tried, inserting is one step, named after the structure")
    {
        Choosing choice;
        choice.run_command("choose", "gable");
        choice.run_command("set", "rise 4");
        choice.run_command("choose", "storeys");
        choice.run_command("set", "bays 3");
        choice.run_command("insert");
        CHECK_FALSE(choice.draft.is_open());
        CHECK(choice.session.history().n_states() == 2);
        CHECK(ui::Catalogue()(*choice.session.history().undo_label()) == "Insert: Multi-storey frame");
        CHECK(choice.session.model().nodes.size() == 4 + 16);
        choice.session.undo();
        CHECK(choice.session.document() == starting_document());
    }

    TEST_CASE("The document shows the structure while its numbers change")
    {
        Choosing choice;
        choice.run_command("choose", "beam");
        for (const int n : {2, 5, 3}) {
            choice.run_command("set", "spans " + std::to_string(n));
            CHECK(choice.session.model().members.size() == static_cast<std::size_t>(3 + n));
            CHECK(choice.session.solution().results);
        }
    }

    TEST_CASE("Cancel leaves document, history and what the picture shows as they were")
    {
        Choosing choice;
        const ShowSet shown = choice.session.view.show;
        choice.run_command("choose", "warren");
        CHECK(choice.session.view.show.contains(Show::N));
        choice.run_command("cancel");
        CHECK(choice.session.document() == starting_document());
        CHECK(choice.session.history().n_states() == 1);
        CHECK(choice.session.view.show == shown);
    }

    TEST_CASE("A structure of another analysis takes the place of what is there, and Undo brings that back")
    {
        Choosing choice;
        choice.run_command("choose", "space_truss");
        CHECK(choice.draft.setting() == Setting::InPlace);
        choice.run_command("insert");
        CHECK(choice.session.model().analysis == femoop::AnalysisKind::Truss3d);
        choice.session.undo();
        CHECK(choice.session.document() == starting_document());
    }

    TEST_CASE("A document of another kind than the structure chosen last is offered one of its own kind")
    {
        for (const auto kind : {femoop::AnalysisKind::Truss2d, femoop::AnalysisKind::Grillage,
                                femoop::AnalysisKind::Truss3d, femoop::AnalysisKind::Frame3d}) {
            CAPTURE(kind);
            Document empty;
            empty.model.analysis = kind;
            Session session(empty);
            TypicalDraft draft;
            draft.open(session);
            CHECK(session.model().analysis == kind);
            draft.cancel(session);
            CHECK(session.document() == empty);
        }
    }

    TEST_CASE("The numbers of a structure are kept while another one is tried")
    {
        Choosing choice;
        choice.run_command("choose", "arch");
        choice.run_command("set", "rise 7");
        choice.run_command("choose", "howe");
        choice.run_command("choose", "arch");
        CHECK(choice.draft.numbers()[2] == 7.0);
    }

    TEST_CASE("An order that makes no sense is answered")
    {
        Choosing choice;
        CHECK(choice.draft.run_command(choice.session, "choose", "pyramid") == "no typical structure \"pyramid\"");
        CHECK(choice.draft.run_command(choice.session, "set", "towers 3") == "no number \"towers\"");
        CHECK(choice.draft.run_command(choice.session, "set", "spans 21") == "wanted a whole number from 1 to 20");
        choice.run_command("cancel");
        CHECK(choice.draft.run_command(choice.session, "insert", ""));
    }
}
