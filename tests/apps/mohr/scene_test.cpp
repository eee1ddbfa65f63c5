// Golden pictures of Mohr's circle: every subject, degenerate states, themes and languages.
#include <doctest/doctest.h>

#include <algorithm>

#include "apps/mohr/document/edit.h"
#include "apps/mohr/view/construction_words.h"
#include "apps/mohr/view/names.h"
#include "apps/mohr/view/scene.h"
#include "tests/apps/cross/strings.h"
#include "tests/golden/scene.h"

using namespace mohr;

TEST_SUITE_BEGIN("pictures");

namespace {

constexpr ui::Size sheet{1000.0, 720.0};

void check(const std::string& name, const Document& document, const Look& look = {},
           std::optional<std::size_t> steps = std::nullopt)
{
    REQUIRE_FALSE(why_not(document));
    const Solution solution = solve(document, look.rule);
    const ui::Theme theme(look.theme);
    ui::OrbitCamera eye;
    eye.look(0.6, 0.45);
    golden::check_scene(name, {.size = sheet, .background = theme.background()}, [&](ui::Painter& painter) {
        draw(painter, {document, solution, look, fitting_frame(document, solution), eye, steps});
    });
}

Document of(Subject subject)
{
    Document document = textbook_state();
    document.subject = subject;
    return document;
}

Document plane_stress(const std::string& x, const std::string& y, const std::string& xy)
{
    Document document = textbook_state();
    document.state() = {x, y, xy};
    return document;
}

} // namespace

TEST_CASE("A plane stress has element and circle and curves side by side")
{
    check("mohr_plane_stress", of(Subject::PlaneStress));
}

TEST_CASE("A plane strain's circle of the third direction is dashed beside its own")
{
    check("mohr_plane_strain", of(Subject::PlaneStrain));
}

TEST_CASE("A strain deforms its element and its circle counts half of gamma")
{
    check("mohr_strain", of(Subject::Strain));
}

TEST_CASE("A rosette is drawn as the strain that it measured") { check("mohr_rosette", of(Subject::Rosette)); }

TEST_CASE("Second moments of area have the axis of the product downwards")
{
    check("mohr_inertia", of(Subject::Inertia));
}

TEST_CASE("A fibre of a section has the stresses over the depth below its circle")
{
    check("mohr_fibre", of(Subject::Section));
}

TEST_CASE("A stress in space has three circles and the plane's point between them")
{
    check("mohr_space", of(Subject::SpaceStress));
}

TEST_CASE("With the shear axis down the same picture has the other signs")
{
    Look look;
    look.rule = femoop::mohr::ShearRule::TensorDown;
    check("mohr_tensor_down", of(Subject::PlaneStress), look);
}

TEST_CASE("Equal normal stresses without shear are a point")
{
    check("mohr_point", plane_stress("35 MPa", "35 MPa", "0"));
}

TEST_CASE("One stress alone touches the shear axis") { check("mohr_uniaxial", plane_stress("0", "84 MPa", "0")); }

TEST_CASE("Pure shear lies about the origin") { check("mohr_pure_shear", plane_stress("0", "0", "-22 MPa")); }

TEST_CASE("Friction's lines touch the circle at failure")
{
    Document document = plane_stress("-20 MPa", "-90 MPa", "30 MPa");
    document.criterion = femoop::mohr::Criterion::MohrCoulomb;
    check("mohr_coulomb", document);
}

TEST_CASE("Von Mises' ellipse bounds the circles of plane stress, in Portuguese on a dark sheet")
{
    Document document = plane_stress("120 MPa", "-40.5 MPa", "60 MPa");
    document.criterion = femoop::mohr::Criterion::VonMises;
    Look look;
    look.theme = ui::ThemeName::Dark;
    look.tr = ui::Catalogue(ui::Language::Portuguese);
    check("mohr_von_mises_pt", document, look);
}

TEST_CASE("On the projector everything is larger and nothing covers another")
{
    Look look;
    look.theme = ui::ThemeName::Projector;
    check("mohr_projector", of(Subject::PlaneStress), look);
}

TEST_CASE("The curves of the components have their numbers in every window of the projector")
{
    const ui::Fonts fonts;
    Look look;
    look.theme = ui::ThemeName::Projector;
    for (const ui::Size size : {ui::Size{405.0, 480.0}, ui::Size{405.0, 540.0}, ui::Size{560.0, 480.0},
                                ui::Size{632.0, 560.0}, ui::Size{632.0, 640.0}, ui::Size{632.0, 738.0}})
        for (const double angle : {-80.0, -35.0, 20.0, 26.6, 75.0}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(angle);
            Document document = of(Subject::PlaneStress);
            document.angle = angle;
            const Solution solution = solve(document, look.rule);
            ui::Painter painter(size, fonts);
            const Drawn drawn = draw(painter, {document, solution, look, fitting_frame(document, solution)});
            Strings strings(fonts);
            painter.picture().draw_on(strings);
            for (const char* const name : {"σ = ", "τ = "})
                CHECK(std::ranges::any_of(strings.all, [&](const Strings::String& string) {
                    return string.words.starts_with(name) && string.box.min.x >= drawn.curves.left - 100.0 &&
                           string.box.max.y > 0.6 * size.height;
                }));
        }
}

TEST_CASE("In print a stress in space is black and white")
{
    Look look;
    look.theme = ui::ThemeName::Print;
    Document document = of(Subject::SpaceStress);
    document.criterion = femoop::mohr::Criterion::Tresca;
    document.strengths[0] = "60 MPa";
    check("mohr_space_print", document, look);
}

TEST_CASE("The construction stands on the sheet as far as its steps are done")
{
    check("mohr_steps_circle", of(Subject::PlaneStress), {}, 5);
    Look look;
    look.tr = ui::Catalogue(ui::Language::Portuguese);
    check("mohr_steps_plane_pt", of(Subject::PlaneStress), look, 10);
}

TEST_CASE("In space the three circles stand and the lines from the principal values lead to the plane's point")
{
    const Document document = of(Subject::SpaceStress);
    check("mohr_space_steps_line", document, {}, 7);
    Look look;
    look.tr = ui::Catalogue(ui::Language::Portuguese);
    check("mohr_space_steps_pt", document, look, 9);
}

TEST_CASE("Both rules of the shear's sign stand side by side")
{
    Look look;
    look.both_rules = true;
    check("mohr_both_rules", of(Subject::PlaneStress), look);
}

TEST_CASE("In plane strain von Mises bounds circle and principal stresses with the stress across the plane")
{
    Document document = of(Subject::PlaneStrain);
    document.criterion = femoop::mohr::Criterion::VonMises;
    check("mohr_plane_strain_von_mises", document);
}

TEST_CASE("In space Drucker and Prager's cone is seen in the deviatoric plane")
{
    Document document = of(Subject::SpaceStress);
    document.criterion = femoop::mohr::Criterion::DruckerPrager;
    Look look;
    look.tr = ui::Catalogue(ui::Language::Portuguese);
    check("mohr_space_deviatoric_pt", document, look);
    document.criterion = femoop::mohr::Criterion::MohrCoulomb;
    document.strengths[3] = "12 MPa";
    check("mohr_space_coulomb", document);
}

TEST_CASE("A strain's stresses stand among the principal stresses that Tresca allows")
{
    Document document = of(Subject::Rosette);
    document.criterion = femoop::mohr::Criterion::Tresca;
    check("mohr_rosette_tresca", document);
}

TEST_CASE("The circle of second moments is constructed of axes and a product, not of faces and a shear")
{
    const Document document = of(Subject::Inertia);
    const Look look;
    const Solution solution = solve(document, look.rule);
    for (const auto& step : construction_of(document, solution)) {
        const std::string words = caption(step.stage, document, solution, look);
        CAPTURE(words);
        for (const char* const strange : {"shear", "face", "plane", "normal"})
            CHECK(words.find(strange) == std::string::npos);
    }
}

TEST_CASE("An angle has its sign right behind it, any other number a blank before its unit")
{
    CHECK(with_unit("−70.66", "°") == "−70.66°");
    CHECK(with_unit("33.85", "10⁻⁶") == "33.85 10⁻⁶");
    CHECK(with_unit("1140", "cm^4") == "1140 cm⁴");
}

TEST_SUITE_END();
