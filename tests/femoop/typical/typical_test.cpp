// Typical structures: sound, solvable, and with the answers that the textbooks give for them.
#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "femoop/model/check/check.h"
#include "femoop/typical/typical.h"

using namespace femoop;

namespace {

void check_is_sound(const Model& model)
{
    CAPTURE(model.title);
    for (const Fault& fault : check(model)) FAIL_CHECK(message(fault));
    const Equilibrium equilibrium = analyse(model).at("G").equilibrium();
    CHECK(equilibrium.residual < 1e-9);
}

double N(const Model& model, const char* member)
{
    return analyse(model).at("G").curve(*model.find_member(member)).forces(0.0).N;
}

} // namespace

TEST_SUITE("typical structures")
{
    TEST_CASE("Every typical structure is sound and stands, small and large")
    {
        check_is_sound(ContinuousBeam{}.model());
        check_is_sound(ContinuousBeam{.spans = 20}.model());
        check_is_sound(StoreyFrame{.bays = 1, .storeys = 1}.model());
        check_is_sound(StoreyFrame{.bays = 20, .storeys = 40, .base = Base::Pinned}.model());
        check_is_sound(GableFrame{}.model());
        check_is_sound(GableFrame{.rise = 0.0, .base = Base::Fixed}.model());
        check_is_sound(VierendeelGirder{.panels = 2}.model());
        check_is_sound(VierendeelGirder{.panels = 40}.model());
        for (const ArchHinges hinges : {ArchHinges::None, ArchHinges::Two, ArchHinges::Three})
            check_is_sound(Arch{.chords = 2, .hinges = hinges}.model());
        check_is_sound(GrillageFloor{.panels_x = 2, .panels_y = 2}.model());
        check_is_sound(GrillageFloor{}.model());
        check_is_sound(SpaceFrame{}.model());
        check_is_sound(SpaceFrame{.bays_x = 5, .bays_y = 7, .storeys = 3, .base = Base::Pinned}.model());
        check_is_sound(Tower{.levels = 1}.model());
        check_is_sound(Tower{.levels = 30}.model());
        for (int panels_x = 1; panels_x < 7; ++panels_x)
            for (int panels_y = 1; panels_y < 6; ++panels_y)
                check_is_sound(SpaceTruss{.panels_x = panels_x, .panels_y = panels_y}.model());
    }

    TEST_CASE("Their steel grows with the temperature and has a weight")
    {
        const Material steel = GableFrame{}.model().materials.front();
        CHECK(steel.alpha->value() == 1.2e-5);
        CHECK(steel.density->value() == 7.85);
        CHECK(steel.density->text() == "7850 kg/m^3");
    }

    TEST_CASE("The feet of a space frame carry its beams' load, and hold its wind")
    {
        const SpaceFrame frame{
            .bays_x = 3, .bays_y = 2, .storeys = 2, .bay_x = 7.0, .bay_y = 4.0, .load = 11.0, .wind = 5.0};
        const Equilibrium equilibrium = analyse(frame.model()).at("G").equilibrium();
        const double beams = 3.0 * 7.0 * 3.0 + 4.0 * 4.0 * 2.0; // m on a floor: three rows along x, four along y
        CHECK(equilibrium.sum_reactions[2] == doctest::Approx(2.0 * 11.0 * beams));
        CHECK(equilibrium.sum_reactions[0] == doctest::Approx(-2.0 * 3.0 * 5.0)); // three joints of the face at x = 0
    }

    TEST_CASE("Plane trusses of every pattern are statically determinate")
    {
        for (const TrussPattern pattern :
             {TrussPattern::Pratt, TrussPattern::Howe, TrussPattern::Warren, TrussPattern::K})
            for (const int panels : {4, 6, 8, 12, 40}) {
                const Model model = PlaneTruss{.pattern = pattern, .panels = panels}.model();
                CAPTURE(model.title);
                CAPTURE(panels);
                check_is_sound(model);
                CHECK(model.members.size() + 3 == 2 * model.nodes.size());
            }
    }

    TEST_CASE(
        "The diagonals of a Pratt truss pull, those of a Howe truss push, P times the panel's shear over the sine")
    {
        const double P = 30.0, h = 3.0, a = 3.0;
        const double shear = 2.5 * P - P; // in the second panel of six
        const double sine = h / std::hypot(h, a);
        CHECK(N(PlaneTruss{.pattern = TrussPattern::Pratt}.model(), "U1L2") == doctest::Approx(shear / sine));
        CHECK(N(PlaneTruss{.pattern = TrussPattern::Howe}.model(), "L1U2") == doctest::Approx(-shear / sine));
    }

    TEST_CASE("In a K-truss the two short diagonals share the panel's shear")
    {
        const Model model = PlaneTruss{.pattern = TrussPattern::K, .height = 4.0}.model();
        const double shear = 2.5 * 30.0 - 30.0, sine = 2.0 / std::hypot(2.0, 3.0);
        CHECK(N(model, "M1L2") == doctest::Approx(0.5 * shear / sine));
        CHECK(N(model, "M1U2") == doctest::Approx(-0.5 * shear / sine));
    }

    TEST_CASE("The diagonals of a Warren truss push and pull in turn")
    {
        const Model model = PlaneTruss{.pattern = TrussPattern::Warren, .panels = 5}.model();
        CHECK(N(model, "L0U1") < 0.0);
        CHECK(N(model, "U1L1") > 0.0);
    }

    TEST_CASE("The thrust of the three-hinged parabola is q L^2 / 8 f")
    {
        const Arch arch{.hinges = ArchHinges::Three};
        const NodeVector reaction = analyse(arch.model()).at("G").reaction(NodeId(0));
        CHECK(reaction[index(Dof::ux)] == doctest::Approx(arch.load * arch.span * arch.span / (8.0 * arch.rise)));
        CHECK(reaction[index(Dof::uy)] == doctest::Approx(0.5 * arch.load * arch.span));
    }

    TEST_CASE("The inner supports of three equal spans carry 1.1 q L")
    {
        const NodeVector reaction = analyse(ContinuousBeam{}.model()).at("G").reaction(NodeId(1));
        CHECK(reaction[index(Dof::uy)] == doctest::Approx(1.1 * 20.0 * 6.0));
    }

    TEST_CASE("A number out of its limits is refused by name")
    {
        CHECK_THROWS_WITH_AS(ContinuousBeam{.spans = 0}.model(), "spans: 0 is not between 1 and 20",
                             std::invalid_argument);
        CHECK_THROWS_AS(PlaneTruss{.panels = 5}.model(), std::invalid_argument);
        CHECK_THROWS_AS(Arch{.chords = 7}.model(), std::invalid_argument);
        CHECK_THROWS_AS(GableFrame{.span = -1.0}.model(), std::invalid_argument);
        CHECK_THROWS_AS(SpaceTruss{.height = std::numeric_limits<double>::quiet_NaN()}.model(), std::invalid_argument);
    }
}
