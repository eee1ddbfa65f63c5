// Making a section: one gesture, whatever is tried in it.
#include <doctest/doctest.h>

#include "apps/frame/session/section_draft.h"

using namespace frame;
using namespace femoop;

namespace {

struct Making {
    Session session{starting_document()};
    SectionDraft draft;

    explicit Making(const Selection& selection)
    {
        session.selection = selection;
        draft.open(session);
    }
    void run_command(std::string_view verb, std::string_view argument = "")
    {
        CHECK_FALSE(draft.run_command(session, verb, argument));
    }
    double moment() const { return (*session.solution().results)[CaseId(0)].curve(MemberId(1)).forces(3.0).Mz; }
};

const Part a_column = MemberId(0), the_beam = MemberId(1);

} // namespace

TEST_SUITE("frame: making a section")
{
    TEST_CASE("The section of the selected member is changed in one step, while the results follow")
    {
        Making making(the_beam);
        const double before = making.moment();
        making.run_command("shape", "i");
        making.run_command("set", "h 800 mm");
        CHECK(making.moment() > before); // a stiffer beam
        making.run_command("accept");
        CHECK(making.session.history().n_states() == 2);
        CHECK(ui::Catalogue()(*making.session.history().undo_label()) == "Change section beam");
        CHECK(making.session.model().sections[1].shape->h->text() == "800 mm");
        making.session.undo();
        CHECK(making.session.document() == starting_document());
    }

    TEST_CASE("A new section is for the selected members alone")
    {
        Making making(a_column);
        making.run_command("new");
        making.run_command("profile", "HEB 200");
        making.run_command("name", "strong");
        making.run_command("accept");
        const Model& model = making.session.model();
        CHECK(model.sections.size() == 3);
        CHECK(model[*model.members[0].section].id == "strong");
        CHECK(model[*model.members[2].section].id == "column");
    }

    TEST_CASE("Going back from a new section to the old one leaves no section behind")
    {
        Making making(a_column);
        making.run_command("profile", "HEB 200");
        making.run_command("new");
        making.draft.set_target(making.session, SectionTarget::This);
        making.run_command("accept");
        CHECK(making.session.model().sections.size() == 2);
        CHECK(making.session.model().sections[0].profile == "HEB 200");
    }

    TEST_CASE("Without a selection a section is made that no member has yet")
    {
        Making making(Selection{});
        making.run_command("accept");
        REQUIRE(making.session.model().sections.size() == 3);
        CHECK(making.session.model().sections[2].id == "s1");
    }

    TEST_CASE("What cannot be is answered, and leaves the section as it was")
    {
        Making making(the_beam);
        making.run_command("shape", "i");
        const Section before = making.draft.section();
        CHECK(making.draft.run_command(making.session, "set", "tf 40 cm") == "tf must be less than h/2 = 15 cm");
        CHECK(making.draft.run_command(making.session, "set", "d 40 cm") == "no dimension \"d\"");
        CHECK(making.draft.run_command(making.session, "profile", "IPE 301") == "no profile \"IPE 301\"");
        CHECK(making.draft.run_command(making.session, "name", "column") == "there is another one named column");
        CHECK(making.draft.section() == before);
    }

    TEST_CASE("Cancel leaves document, history and selection as they were")
    {
        Making making(Part(SectionId(1)));
        making.run_command("profile", "IPE 300");
        making.run_command("name", "IPE");
        CHECK(making.session.selection == Selection(Part(SectionId(1)))); // though it has another name
        making.run_command("cancel");
        CHECK(making.session.document() == starting_document());
        CHECK(making.session.history().n_states() == 1);
        CHECK(making.session.selection == Selection(Part(SectionId(1))));
    }
}
