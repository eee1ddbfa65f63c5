#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "apps/mohr/session/export.h"
#include "apps/mohr/session/report.h"
#include "femoop/io/json/table_json.h"
#include "femoop/tabular/separated.h"

using namespace mohr;

TEST_SUITE_BEGIN("mohr");

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("Results as CSV have a line each with every digit and a decimal point in every language")
{
    Session session;
    session.look.tr = ui::Catalogue(ui::Language::Portuguese);
    session.set_number({Group::State, 2}, "33,3 MPa");
    const std::string text = tabular::separated(result_list(session));
    CHECK(has(text, "group,name,value,unit\n"));
    CHECK(has(text, ",raio,44.82"));
    CHECK_FALSE(has(text, "44,81"));
    CHECK(has(text, "\"(50; 33,3)\""));
}

TEST_CASE("Results as JSON are rows of numbers, as Markdown a table for each group")
{
    const Session session;
    const std::string json = femoop::table_json(result_list(session));
    CHECK(has(json, "\"columns\": [\"group\", \"name\", \"value\", \"unit\"]"));
    CHECK(has(json, "\"radius\", "));
    CHECK(has(markdown(session), "### Circle\n\n|  |  |\n|---|---|\n| centre | "));
}

TEST_CASE("A LaTeX sheet closes what it opens and writes Greek letters as commands")
{
    for (const Subject subject : {Subject::PlaneStress, Subject::Inertia, Subject::Rosette, Subject::SpaceStress}) {
        Session session;
        session.set_subject(subject);
        const std::string text = latex(session);
        CAPTURE(text);
        CHECK(std::ranges::count(text, '{') == std::ranges::count(text, '}'));
        CHECK(has(text, "\\end{tikzpicture}"));
        CHECK(has(text, "\\end{document}"));
        CHECK_FALSE(has(text, "σ"));
        CHECK_FALSE(has(text, "cm^4"));
        CHECK_FALSE(has(text, "nan"));
    }
}

TEST_CASE("A LaTeX sheet has no sign beyond ASCII but the accents of the language")
{
    for (const ui::Language language : ui::all_languages)
        for (std::size_t i = 0; i < n_subjects; ++i) {
            Session session;
            session.look.tr = ui::Catalogue(language);
            session.set_subject(static_cast<Subject>(i));
            if (i != static_cast<std::size_t>(Subject::Inertia))
                session.set_criterion(femoop::mohr::Criterion::VonMises);
            const std::string text = latex(session);
            for (std::size_t at = 0; at < text.size(); ++at) {
                const auto byte = static_cast<unsigned char>(text[at]);
                CAPTURE(text.substr(at > 20 ? at - 20 : 0, 40));
                CHECK((byte < 0x80 || byte == 0xC3 || (at > 0 && static_cast<unsigned char>(text[at - 1]) == 0xC3)));
            }
        }
}

TEST_CASE("Indices of Greek letters stand below them in LaTeX")
{
    Session session;
    const std::string text = latex(session);
    CHECK(has(text, "\\ensuremath{\\sigma_{1}}"));
    CHECK(has(text, "\\ensuremath{\\tau_{x'y'}}"));
}

TEST_CASE("A description begins with all that is given, as it is printed")
{
    const auto given = [](Subject subject, ui::Language language) {
        Session session;
        session.look.tr = ui::Catalogue(language);
        session.set_subject(subject);
        const std::string text = description(session);
        return text.substr(0, text.find('\n'));
    };
    CHECK(given(Subject::Section, ui::Language::English) ==
          "Fibre of a section: IPE 300, N = 30 kN, V = 70 kN, M = 40 kN·m, y′ = 90 mm");
    CHECK(given(Subject::Strain, ui::Language::English) == "Strain: εx = −800 10⁻⁶, εy = 400 10⁻⁶, γxy = −1200 10⁻⁶");
    CHECK(given(Subject::SpaceStress, ui::Language::Portuguese) ==
          "Estado triplo de tensões: σx = −19 MPa, σy = 4,6 MPa, σz = −8,3 MPa, τxy = −4,7 MPa, τyz = 11,8 MPa, "
          "τzx = 6,45 MPa");
}

TEST_CASE("An exercise tells its answers neither in words nor in a sheet nor by turning its plane")
{
    Session session;
    session.begin_exercise(ExerciseTopic::PlaneStress, Difficulty::Medium, 5);
    CHECK(session.is_concealing());
    CHECK_FALSE(has(description(session), "\n  "));
    const auto exported = export_results(session, "answers.csv");
    REQUIRE(exported);
    CHECK(exported->reason);
    CHECK(session.set_angle(30.0));
    CHECK(session.document().angle == 0.0);
    session.give_up_exercise();
    CHECK_FALSE(session.set_angle(30.0));
    CHECK(has(description(session), "\n  "));
}

TEST_SUITE_END();
