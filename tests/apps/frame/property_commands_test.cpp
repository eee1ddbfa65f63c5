// Materials and sections as named sets: added, renamed, imported, condensed, each as one step.
#include <doctest/doctest.h>

#include "apps/frame/session/property_commands.h"
#include "tests/source_folder.h"

using namespace frame;
using namespace femoop;

namespace {

const Part column_section = SectionId(0);

std::string undo_label(const Session& session) { return ui::Catalogue()(*session.history().undo_label()); }

} // namespace

TEST_SUITE("frame: commands on property sets")
{
    TEST_CASE("A new material is like that of the selected members, is theirs, and is what the panel shows")
    {
        Session session(starting_document());
        session.selection = Part(MemberId(1));
        new_material(session);
        REQUIRE(session.model().materials.size() == 2);
        CHECK(session.model().materials[1].E.text() == "205 GPa");
        CHECK(session.model().members[1].material == MaterialId(1));
        CHECK(session.model().members[0].material == MaterialId(0));
        CHECK(session.selection == Selection(Part(MaterialId(1))));
        CHECK(undo_label(session) == "New material");
    }

    TEST_CASE("Without members a new material is steel, whatever the units")
    {
        Document empty;
        empty.model.units = {.length = LengthUnit::mm, .force = ForceUnit::N};
        Session session(empty);
        new_material(session);
        CHECK(session.model().materials[0].E.value() == 210e3);
        CHECK(session.model().materials[0].E.text() == "210 GPa");
        CHECK(session.model().materials[0].alpha->text() == "1.2e-5 1/K");
        CHECK(session.model().materials[0].density->value() == doctest::Approx(7.85e-9));
    }

    TEST_CASE("A section that is renamed stays the selection; a name that is taken changes nothing")
    {
        Session session(starting_document());
        session.selection = column_section;
        CHECK_FALSE(rename(session, column_section, "HEB 200"));
        CHECK(session.selection == Selection(column_section));
        CHECK(undo_label(session) == "Rename: Section column");
        CHECK(rename(session, column_section, "beam"));
        CHECK(session.model().sections[0].id == "HEB 200");
        CHECK(session.history().n_states() == 2);
    }

    TEST_CASE("The members of a section are selected together")
    {
        Session session(starting_document());
        select_members_with(session, column_section);
        CHECK(session.selection.size() == 2);
        CHECK(session.selection.contains(MemberId(2)));
    }

    TEST_CASE("A section that was duplicated and not changed is condensed away, and the reader is told")
    {
        Session session(starting_document());
        duplicate(session, column_section);
        CHECK(session.model().sections[2].id == "column2");
        CHECK(session.selection == Selection(Part(SectionId(2))));
        condense_properties(session);
        CHECK(session.document() == starting_document());
        CHECK(ui::Catalogue()(session.notice->sentence) == "Property sets: 1 were like others, 0 nobody used");
    }

    TEST_CASE("Materials and sections of a file are imported in one step, a broken file imports nothing")
    {
        Session session(starting_document());
        CHECK(import_properties(session, source_folder() + "/examples/truss.json"));
        CHECK(session.history().n_states() == 2);
        CHECK(session.model().sections.size() > 2);
        CHECK(session.solution().results);
        const Document before = session.document();
        CHECK_FALSE(import_properties(session, source_folder() + "/tests/fuzz/corpus/model_reader/faults.json"));
        CHECK_FALSE(session.notice->faults.empty());
        CHECK_FALSE(import_properties(session, source_folder() + "/there is none.json"));
        CHECK(session.document() == before);
    }
}
