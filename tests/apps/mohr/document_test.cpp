#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <variant>

#include "apps/mohr/document/edit.h"
#include "apps/mohr/document/file.h"
#include "ui/text/catalogue.h"

using namespace mohr;
using doctest::Approx;
namespace fm = femoop::mohr;

TEST_SUITE_BEGIN("mohr");

namespace {

constexpr NumberId state(std::size_t place) { return {Group::State, place}; }

Document of(Subject subject)
{
    Document document = textbook_state();
    document.subject = subject;
    return document;
}

std::string reason(const Edit& edit)
{
    REQUIRE(edit.fault);
    return ui::Catalogue()(edit.fault->reason);
}

constexpr Subject all_subjects[] = {Subject::PlaneStress, Subject::PlaneStrain, Subject::Strain, Subject::Rosette,
                                    Subject::Inertia,     Subject::SpaceStress, Subject::Section};

} // namespace

TEST_CASE("Every textbook state can be solved")
{
    for (const Subject subject : all_subjects) {
        CAPTURE(static_cast<int>(subject));
        CHECK_FALSE(why_not(of(subject)));
    }
    CHECK(solve(of(Subject::PlaneStress)).principal.first == Approx(70.0));
    CHECK(solve(of(Subject::Rosette)).principal.first == Approx(272.1469681));
    CHECK(solve(of(Subject::SpaceStress)).space_principal.values[0] == Approx(11.61780137));
}

TEST_CASE("A number keeps its text and a bare one takes the unit of its place")
{
    const Document d = with_number(of(Subject::PlaneStress), state(0), "17,5").document;
    CHECK(d.state()[0] == "17.5 MPa");
    CHECK(with_number(d, state(1), "2 ksi").document.state()[1] == "2 ksi");
    CHECK(with_number(d, state(1), "2*3").document.state()[1] == "6 MPa");
    CHECK(with_number(of(Subject::Section), state(2), "120,5 kN·m").document.state()[2] == "120.5 kN*m");
    CHECK(with_number(of(Subject::Inertia), state(0), "1140 cm⁴").document.state()[0] == "1140 cm^4");
    CHECK(solve(with_number(d, state(1), "2 ksi").document).unit == "MPa");
    CHECK(with_number(of(Subject::Strain), state(1), "250").document.state()[1] == "250");
}

TEST_CASE("What is no number or no stress is refused and the number is named")
{
    const Edit word = with_number(of(Subject::PlaneStress), state(1), "abc");
    CHECK(reason(word).find("does not begin with a number") != std::string::npos);
    CHECK(word.fault->number == state(1));
    CHECK(reason(with_number(of(Subject::PlaneStress), state(0), "3 kN")).find("measures force") != std::string::npos);
    CHECK(reason(with_number(of(Subject::Strain), {Group::Elasticity, 1}, "0.7")).find("Poisson") == 0);
    CHECK(reason(with_number(of(Subject::Rosette), state(1), "180")) ==
          "gauges a and b measure along one direction; turn one of them");
    Document friction = of(Subject::PlaneStress);
    friction.criterion = fm::Criterion::MohrCoulomb;
    CHECK(reason(with_number(friction, {Group::Strength, 4}, "95")) == "φ must be at least 0 and less than 90 degrees");
    CHECK(with_number(of(Subject::PlaneStress), {Group::Strength, 4}, "95").fault); // no criterion reads it yet
}

TEST_CASE("Principal values and an angle make the state that has them")
{
    const Edit edit = with_principal(of(Subject::PlaneStress), 70.0, -30.0, 26.565051177);
    CHECK_FALSE(edit.fault);
    const Solution s = solve(edit.document);
    CHECK(s.plane.x == Approx(50.0));
    CHECK(s.plane.xy == Approx(40.0));
    CHECK(edit.document.state()[0].ends_with(" MPa"));
}

TEST_CASE("A state that is dragged on a rosette changes its readings alone")
{
    const Document d = with_plane(of(Subject::Rosette), {100.0, 40.0, -30.0}).document;
    CHECK(d.state()[1] == "60");
    const Solution s = solve(d);
    CHECK(s.plane.x == Approx(100.0));
    CHECK(s.plane.xy == Approx(-30.0));
}

TEST_CASE("Second moments of area are written with their own product")
{
    const Document d = with_plane(of(Subject::Inertia), {100.0, 40.0, -30.0}).document;
    CHECK(d.state()[2] == "30 cm^4");
    CHECK(solve(d).rule == fm::ShearRule::TensorDown);
}

TEST_CASE("An angle is taken into one turn")
{
    CHECK(with_angle(textbook_state(), 200.0).document.angle == -160.0);
    CHECK(with_angle(textbook_state(), -180.0).document.angle == 180.0);
    CHECK(with_angle(textbook_state(), std::nan("")).fault);
}

TEST_CASE("A number is rounded to so many digits of the largest")
{
    CHECK(rounded(123.456, 100.0, 3) == 123.0);
    CHECK(rounded(0.01234, 0.1, 2) == 0.01);
    CHECK(rounded(98765.0, 98765.0, 2) == 99000.0);
    CHECK(rounded(5.0, 0.0, 2) == 5.0);
}

TEST_CASE("Strains of steel give stresses in MPa")
{
    Document d = of(Subject::Rosette);
    d.state() = {"0", "45", "90", "520", "360", "-80"};
    const Solution s = solve(d);
    REQUIRE(s.stress);
    CHECK(s.stress->x == Approx(109.01098901));
    CHECK(s.stress_unit == "MPa");
}

TEST_CASE("A fibre of a section has the stresses of Navier and Jourawski and other sections are refused with a remedy")
{
    Document d = of(Subject::Section);
    d.section = "rectangle b=100mm h=200";
    d.state() = {"0 N", "60 kN", "40 kN*m", "-0.05 m"};
    const Solution s = solve(d);
    CHECK(s.plane.x == Approx(30.0)); // M stretches the -y' fibre: 40e6 * 50 / (100 * 200^3 / 12)
    CHECK(s.plane.xy == Approx(-1.5 * 60e3 / 20e3 * 0.75));
    const auto refusal = [&](const std::string& section) {
        return reason(with_number(d, {Group::Section, 0}, section));
    };
    CHECK(refusal("IPE 3000").find("there is no section \"IPE 3000\"; write a profile") == 0);
    CHECK(refusal("rectangle b=100mm") == "the shape cannot be: h is missing");
    CHECK(refusal("tube d=100mm t=60mm") == "the shape cannot be: t must be less than d/2 = 50 mm");
    CHECK(ui::Catalogue(ui::Language::Portuguese)(
              with_number(d, {Group::Section, 0}, "rectangle b=100mm").fault->reason) ==
          "a forma não pode ser: falta h");
    CHECK(refusal("rectangle b=100kN h=3") == "\"b=100kN\" is no dimension; write it like h=210mm");
    CHECK(refusal("l h=100 b=80 t=9").find("a single angle bends out of its plane") == 0);
    CHECK(refusal("L 100x10").find("a single angle bends out of its plane") == 0);
    CHECK(reason(with_number(d, state(3), "101 mm")) ==
          "the fibre lies outside the section, which goes from −100 to 100 mm");
    CHECK(reason(with_number(d, state(0), "3 MPa")).find("measures stress") != std::string::npos);
    CHECK(ui::Catalogue(ui::Language::Portuguese)(with_number(d, state(0), "3 MPa").fault->reason) ==
          "N: \"3 MPa\" mede tensão ou força por área, esperado força, por exemplo em N");
    CHECK(with_plane(d, {1.0, 2.0, 3.0}).fault);
}

TEST_CASE("A fibre that another section does not reach goes to its edge, and one that it reaches stays")
{
    Document d = of(Subject::Section);
    d.section = "IPE 400";
    d.state() = {"0 N", "0 N", "90 kN*m", "-200 mm"};
    const auto fibre_in = [&](const std::string& section) {
        const Edit edit = with_number(d, {Group::Section, 0}, section);
        CHECK_FALSE(edit.fault);
        return edit.document.state()[3];
    };
    CHECK(fibre_in("IPE 360") == "-180 mm");
    CHECK(fibre_in("IPE 450") == "-200 mm");
    d.state()[3] = "20 cm";
    CHECK(fibre_in("IPE 360") == "180 mm");
}

TEST_CASE("A criterion tells how far the state is from failure, in any unit")
{
    Document d = of(Subject::PlaneStress);
    d.criterion = fm::Criterion::Tresca;
    CHECK(*solve(d).safety->factor == Approx(2.5));
    d.strengths[0] = "0.25 GPa";
    CHECK(*solve(d).safety->factor == Approx(2.5));
    d.subject = Subject::Inertia;
    CHECK_FALSE(solve(d).safety);
}

TEST_CASE("States of a loading path count in the unit of the state that is shown")
{
    Document d = with_path_state(of(Subject::PlaneStress)).document;
    d = with_number(d, state(0), "1 ksi").document;
    const Solution s = solve(d);
    CHECK(s.unit == "ksi");
    REQUIRE(s.path.size() == 1);
    CHECK(s.path[0].x == Approx(50.0 / 6.894757293168361));
    CHECK(solve(without_path(d).document).path.empty());
}

TEST_CASE("Special states are told in words")
{
    const auto words = [](const std::vector<std::string>& numbers) {
        Document d = of(Subject::PlaneStress);
        d.state() = numbers;
        std::string all_text;
        for (const ui::Message& message : remarks(d, solve(d))) all_text += ui::Catalogue()(message) + "\n";
        return all_text;
    };
    CHECK(words({"0", "0", "0"}).find("Everything is 0") == 0);
    CHECK(words({"5 MPa", "5 MPa", "0"}).find("The circle is a point") == 0);
    CHECK(words({"0", "0", "7 MPa"}).find("Pure shear") == 0);
    CHECK(words({"0", "7 MPa", "0"}).find("One principal value alone") == 0);
    CHECK(words({"50 MPa", "20 MPa", "0"}).find("The third principal value") == 0);
    CHECK(words({"50 MPa", "-10 MPa", "40 MPa"}).empty());
}

TEST_CASE("What is written is read back the same")
{
    for (const Subject subject : all_subjects) {
        CAPTURE(static_cast<int>(subject));
        Document d = of(subject);
        d.criterion = fm::Criterion::HoekBrown;
        d.angle = -12.25;
        d.strengths[5] = "99 MPa";
        if (has_path(subject)) d = with_path_state(with_path_state(d).document).document;
        const auto read = read_file_text(file_text(d));
        REQUIRE(std::holds_alternative<Document>(read));
        CHECK(std::get<Document>(read) == d);
    }
}

TEST_CASE("A file that is none of Mohr's circle is refused with the place")
{
    const auto refusal = [](std::string_view text) {
        const auto read = read_file_text(text);
        const auto* reasons = std::get_if<std::vector<ui::Message>>(&read);
        return reasons != nullptr ? ui::Catalogue()(reasons->front()) : "";
    };
    CHECK(refusal("{").find("line 1") != std::string::npos);
    CHECK(refusal("[]").find("it is no file of Mohr's circle") == 0);
    CHECK(refusal(R"({"cremona": 2, "mohr": "strain"})").find("cremona: found format 2, wanted 1") == 0);
    CHECK(refusal(R"({"cremona": 1, "mohr": "plane"})").find("\"mohr\": found \"plane\", wanted one of plane_stress") ==
          0);
    CHECK(refusal(R"({"cremona": 1, "mohr": "strain", "state": [1, 2]})")
              .find("\"state\": found [1, 2], wanted a list") == 0);
    CHECK(refusal(R"({"cremona": 1, "mohr": "inertia", "path": []})")
              .find("\"path\": found [], wanted a list of states") == 0);
    CHECK(refusal(R"({"cremona": 1, "mohr": "strain", "angel": 3})") == "there is no key \"angel\"");
    CHECK(refusal(R"({"cremona": 1, "mohr": "strain", "state": [1, 2, "3 kN"]})").find("measures force") !=
          std::string::npos);
    CHECK(refusal(R"({"cremona": 1, "mohr": "strain", "normal": [0, 0, 0]})") ==
          "the normal of the plane has no direction");
}

TEST_CASE("Everything that is wrong with a file is told at once, each thing once")
{
    const auto refusals = [](std::string_view text) {
        const auto read = read_file_text(text);
        const auto* reasons = std::get_if<std::vector<ui::Message>>(&read);
        std::vector<std::string> told;
        if (reasons != nullptr)
            for (const ui::Message& reason : *reasons) told.push_back(ui::Catalogue()(reason));
        return told;
    };
    const auto many = refusals(
        R"({"cremona": 1, "mohr": "strain", "state": ["1 kN", 2, true], "angel": 3, "E": "-2 GPa",
        "nu": 0.7, "normal": [1, "x", 0], "criterion": "trezca", "strength": {"fy": [], "fz": "3 MPa"}})");
    const std::vector<std::string> begins{"\"state\": found true",   "there is no key \"angel\"",
                                          "\"normal\": found \"x\"", "\"criterion\": found \"trezca\"",
                                          "\"fy\": found []",        "there is no key \"fz\""};
    REQUIRE(many.size() == begins.size() + 3); // 1 kN, nu and E
    for (std::size_t i = 0; i < begins.size(); ++i) CHECK(many[i].find(begins[i]) == 0);
    CHECK(
        refusals(R"({"cremona": 1, "mohr": "section", "section": "IPE 301", "state": ["1", "2 kN", "3 kN*m", "4 kN"]})")
            .size() == 3);
    CHECK(refusals(
              R"({"cremona": 1, "mohr": "plane_stress", "criterion": "rankine", "strength": {"ft": "0", "fc": "x"}})")
              .size() == 2);
    const auto parts = refusals(
        R"({"cremona": 1, "mohr": "plane_stress", "state": ["1 MPa", "x", "y"], "path": [["1", "2", "z"]]})");
    REQUIRE(parts.size() == 3);
    CHECK(parts[0].starts_with("σy: \"x\" does not begin with a number"));
    CHECK(parts[2].starts_with("loading path: τxy: \"z\" does not begin with a number"));
    const auto section = refusals(
        R"({"cremona": 1, "mohr": "section", "state": ["1 kN", "2 kN", "3 kN", "4 mm"], "criterion": "tresca",
        "strength": {"fy": "250 kN"}})");
    REQUIRE(section.size() == 2);
    CHECK(section[0].starts_with("M: \"3 kN\" measures force"));
    CHECK(section[1].starts_with("fy: \"250 kN\" measures force"));
    CHECK(refusals(R"({"cremona": 1, "mohr": "what", "nu": true})").size() == 2);
    const auto unused = refusals(
        R"({"cremona": 1, "mohr": "inertia", "nu": 0.9, "E": "-1 GPa", "section": "IPE 301",
        "strength": {"fy": "-250 MPa", "ft": "0", "phi": 90, "s": 2, "m": "x"}})");
    REQUIRE(unused.size() == 8);
    CHECK(unused[2] == "fy must be greater than 0");
    CHECK(unused[7].starts_with("there is no section \"IPE 301\""));
}

TEST_SUITE_END();
