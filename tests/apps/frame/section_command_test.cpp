// Sections and materials of a document: added, changed, renamed, imported.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "apps/frame/document/section_command.h"
#include "femoop/section/section_properties.h"
#include "femoop/typical/steel.h"
#include "ui/text/catalogue.h"

using namespace frame;
using namespace femoop;

TEST_SUITE("frame: property sets")
{
    TEST_CASE("A section of a usual size is sound in every unit, and the same section")
    {
        for (const SectionShapeKind kind : section_shape_kinds()) {
            CAPTURE(name(kind));
            const SectionShape metric = usual_shape(kind, {}), inches = usual_shape(kind, {.length = LengthUnit::in});
            CHECK_FALSE(why_not(metric));
            const double k = std::pow(0.0254, 2);
            CHECK(shape_properties(inches).A * k == doctest::Approx(shape_properties(metric).A));
            CHECK((metric.h ? metric.h : metric.d)->has_text());
        }
    }

    TEST_CASE("A new section is given to the members that it is for, under a name that is free")
    {
        Document document = starting_document();
        const SectionId id = add_section(document, {.id = "beam", .profile = "IPE 300"}, std::vector{MemberId(0)});
        CHECK(document.model[id].id == "beam2");
        CHECK(members_with(document.model, id) == std::vector{MemberId(0)});
        CHECK(members_with(document.model, SectionId(0)) == std::vector{MemberId(2)});
    }

    TEST_CASE("A member that is not there gets no section, and none is added")
    {
        Document document = starting_document();
        CHECK_THROWS_AS(add_section(document, {.id = "x"}, std::vector{MemberId(9)}), std::out_of_range);
        CHECK(document == starting_document());
    }

    TEST_CASE("A section that is renamed keeps its members; a name that is taken or empty is refused")
    {
        Document document = starting_document();
        CHECK(why_not_rename(document.model, SectionId(0), "beam") ==
              ui::Message("there is another one named {name}", {{"name", "beam"}}));
        CHECK(why_not_rename(document.model, SectionId(0), "  ") == ui::Message("a name is wanted"));
        CHECK_FALSE(why_not_rename(document.model, SectionId(0), "column")); // its own
        rename(document, SectionId(0), "HEB 200");
        CHECK(document.model[*document.model.members[0].section].id == "HEB 200");
        CHECK(members_with(document.model, SectionId(0)).size() == 2);
    }

    TEST_CASE("A section that is changed under a name of another keeps its own")
    {
        Document document = starting_document();
        put_section(document, SectionId(0), {.id = "beam", .profile = "HEA 200"});
        CHECK(document.model.sections[0].id == "column");
        CHECK(document.model.sections[0].profile == "HEA 200");
    }

    TEST_CASE("What is imported comes in the units of the document, and once")
    {
        Document document = starting_document();
        Model other;
        other.units = {.length = LengthUnit::mm, .force = ForceUnit::N};
        other.add(Material{.id = "steel", .E = 70e3});
        other.add(steel(other.units, "205 GPa"));
        other.materials.back().id = "as ours";
        other.add(Section{.id = "beam", .A = 12000, .Iz = 2e8}); // the column's numbers
        other.add(Section{.id = "post", .shape = SectionShape{.kind = SectionShapeKind::Circle, .d = 300}});
        CHECK(import_properties(document, other) == 2);
        REQUIRE(document.model.materials.size() == 2);
        CHECK(document.model.materials[1].id == "steel2");
        CHECK(document.model.materials[1].E == 70e6);
        REQUIRE(document.model.sections.size() == 3);
        CHECK(document.model.sections[2].shape->d->value() == 0.3);
        CHECK(import_properties(document, other) == 0);
    }

    TEST_CASE("A dimension that would fold a shape is answered with what it must stay below")
    {
        SectionShape shape = usual_shape(SectionShapeKind::I, {});
        shape.tf = 0.2;
        const ui::DisplayUnits units(ui::UnitSystem::KnM, {}, {});
        CHECK(ui::Catalogue()(sentence_of(*why_not(shape), units)) == "tf must be less than h/2 = 15 cm");
        shape.tf = -0.01;
        CHECK(ui::Catalogue()(sentence_of(*why_not(shape), units)) == "tf must be a positive length");
    }
}
