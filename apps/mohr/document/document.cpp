#include "apps/mohr/document/document.h"

namespace mohr {

namespace dimension = femoop::dimension;
using femoop::mohr::Criterion;

namespace {

constexpr std::array<std::string_view, 3> plane_stress{"σx", "σy", "τxy"};
constexpr std::array<std::string_view, 3> strain{"εx", "εy", "γxy"};
constexpr std::array<std::string_view, 6> rosette{"θa", "θb", "θc", "εa", "εb", "εc"};
constexpr std::array<std::string_view, 3> inertia{"Ix", "Iy", "Ixy"};
constexpr std::array<std::string_view, 6> space_stress{"σx", "σy", "σz", "τxy", "τyz", "τzx"};

constexpr std::array<std::string_view, 4> section{"N", "V", "M", "y′"};

constexpr std::array yield{StrengthPlace::fy};
constexpr std::array brittle{StrengthPlace::ft, StrengthPlace::fc};
constexpr std::array friction{StrengthPlace::c, StrengthPlace::phi};
constexpr std::array rock{StrengthPlace::sci, StrengthPlace::m, StrengthPlace::s};
constexpr std::array<std::string_view, n_strengths> strength_names{"fy", "ft", "fc", "c", "φ", "σci", "m", "s"};

} // namespace

Document textbook_state()
{
    Document document;
    document.numbers = {{{"50 MPa", "-10 MPa", "40 MPa"},
                         {"120 MPa", "80 MPa", "30 MPa"},
                         {"-800", "400", "-1200"},
                         {"0", "60", "120", "60", "135", "264"},
                         {"2900 cm^4", "5600 cm^4", "-3000 cm^4"},
                         {"-19 MPa", "4.6 MPa", "-8.3 MPa", "-4.7 MPa", "11.8 MPa", "6.45 MPa"},
                         {"30 kN", "70 kN", "40 kN*m", "90 mm"}}};
    document.section = "IPE 300";
    document.elasticity = {"200 GPa", "0.3"};
    document.strengths = {"250 MPa", "40 MPa", "120 MPa", "60 MPa", "30", "150 MPa", "10", "1"};
    document.angle = 20.0;
    document.normal = {1.0, 1.0, 1.0};
    return document;
}

bool has_path(Subject subject)
{
    return subject == Subject::PlaneStress || subject == Subject::PlaneStrain || subject == Subject::Strain;
}

bool is_in_space(Subject subject) { return subject == Subject::SpaceStress; }

std::span<const std::string_view> names(Subject subject)
{
    switch (subject) {
    case Subject::PlaneStress:
    case Subject::PlaneStrain: return plane_stress;
    case Subject::Strain: return strain;
    case Subject::Rosette: return rosette;
    case Subject::Inertia: return inertia;
    case Subject::SpaceStress: return space_stress;
    case Subject::Section: return section;
    }
    return {};
}

femoop::Dimension dimension_of(Subject subject, std::size_t place)
{
    switch (subject) {
    case Subject::Strain: return dimension::none;
    case Subject::Rosette: return place < 3 ? dimension::angle : dimension::none;
    case Subject::Inertia: return dimension::second_moment;
    case Subject::Section: return place < 2 ? dimension::force : place == 2 ? dimension::moment : dimension::length;
    default: return dimension::stress;
    }
}

std::string_view bare_unit(Subject subject, std::size_t place)
{
    if (subject == Subject::Rosette && place < 3) return "°";
    if (subject == Subject::Strain || subject == Subject::Rosette) return "10⁻⁶";
    return "";
}

std::span<const StrengthPlace> strengths_of(Criterion criterion)
{
    switch (criterion) {
    case Criterion::Tresca:
    case Criterion::VonMises: return yield;
    case Criterion::Rankine: return brittle;
    case Criterion::MohrCoulomb:
    case Criterion::DruckerPrager: return friction;
    case Criterion::HoekBrown: return rock;
    }
    return {};
}

std::string_view name(StrengthPlace strength) { return strength_names[static_cast<std::size_t>(strength)]; }

std::string_view name(Subject subject, NumberId number)
{
    switch (number.group) {
    case Group::Elasticity: return number.place == 0 ? "E" : "ν";
    case Group::Strength: return strength_names.at(number.place);
    case Group::Section: return "section";
    case Group::State: break;
    }
    return names(subject)[number.place];
}

namespace {

/// Of a document, constant or not.
auto& text_in(auto& document, NumberId number)
{
    switch (number.group) {
    case Group::Elasticity: return document.elasticity.at(number.place);
    case Group::Strength: return document.strengths.at(number.place);
    case Group::Section: return document.section;
    case Group::State: break;
    }
    return document.state().at(number.place);
}

} // namespace

const std::string& text_of(const Document& document, NumberId number) { return text_in(document, number); }
std::string& text_of(Document& document, NumberId number) { return text_in(document, number); }

std::size_t memory_footprint(const Document& document)
{
    std::size_t n_texts = 0;
    for (const auto& numbers : document.numbers) n_texts += numbers.size();
    for (const auto& path : document.paths)
        for (const auto& state : path) n_texts += state.size();
    return sizeof(Document) + n_texts * sizeof(std::string);
}

} // namespace mohr
