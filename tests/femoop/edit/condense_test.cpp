// Equal materials and sections made one.
#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/condense.h"
#include "femoop/edit/naming.h"
#include "femoop/typical/typical.h"

using namespace femoop;

TEST_SUITE("edit: condensing")
{
    TEST_CASE("Numbers typed with a unit are like the bare ones, and a profile is like itself in other letters")
    {
        const Material typed{.id = "S1", .E = Quantity(210e6, "210 GPa")}, bare{.id = "S2", .E = 210e6};
        CHECK(are_alike(typed, bare));
        CHECK_FALSE(are_alike(typed, Material{.id = "S1", .E = 205e6}));
        CHECK(are_alike(Section{.id = "a", .profile = "IPE 300"}, Section{.id = "b", .profile = "ipe300"}));
        CHECK_FALSE(are_alike(Section{.id = "a", .profile = "IPE 300"}, Section{.id = "a", .profile = "IPE 330"}));
    }

    TEST_CASE("Condensing leaves one of each in use, and every result as it was")
    {
        Model model = StoreyFrame{.bays = 1, .storeys = 2}.model();
        model.add(Section{.id = "unused", .A = 3.0});
        model.add(Section{.id = "twin", .A = 0.01, .Iz = 2e-4, .Iy = 5e-5, .J = 3e-6});
        model.add(Section{.id = "stiff", .A = 0.03, .Iz = 7e-4});
        model.add(Material{.id = "twin", .E = 210e6, .alpha = Quantity(1.2e-5), .density = Quantity(7.85)});
        model.members[1].section = SectionId(2);
        model.members[2].section = SectionId(3);
        model.members[3].material = MaterialId(1);
        const Results before = analyse(model);
        CHECK(condense(model) == Condensed{.n_equal = 2, .n_unused = 1});
        REQUIRE(model.sections.size() == 2);
        CHECK(model[*model.members[2].section].id == "stiff");
        CHECK(model.materials.size() == 1);
        const Results after = analyse(model);
        for (std::size_t i = 0; i < model.nodes.size(); ++i)
            CHECK(after[CaseId(0)].displacement(NodeId(i)) == before[CaseId(0)].displacement(NodeId(i)));
        CHECK(condense(model) == Condensed{});
    }

    TEST_CASE("A taken name counts on: steel, steel2; s1, s2")
    {
        std::vector<Material> materials{{.id = "steel"}, {.id = "steel2"}, {.id = "s9"}};
        CHECK(fresh_id(materials, "wood") == "wood");
        CHECK(fresh_id(materials, "steel") == "steel3");
        CHECK(fresh_id(materials, "s9") == "s10");
    }
}
