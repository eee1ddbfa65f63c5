#include "apps/mohr/document/solution.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "apps/mohr/document/degree.h"
#include "apps/mohr/document/section_text.h"
#include "femoop/methods/mohr/space_construction.h"
#include "femoop/methods/mohr/typed_components.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"

namespace mohr {

namespace fm = femoop::mohr;
using femoop::mohr::Components;
using ui::Message;
using ui::translatable;

namespace {

constexpr double micro = 1e-6; // what strains count in

/// Collects what the document's numbers say, and every fault, one a number.
class Reader {
public:
    explicit Reader(const Document& document) : document_(document) {}

    std::vector<Fault> faults;

    Components read(std::size_t first, std::size_t count)
    {
        const std::span<const std::string> texts = std::span(document_.state()).subspan(first, count);
        const auto parts = names(document_.subject).subspan(first, count);
        const auto dimension = dimension_of(document_.subject, first);
        const bool is_angle = dimension == femoop::dimension::angle;
        return read(texts, parts, is_angle ? femoop::dimension::none : dimension, {Group::State, first});
    }

    Components read(std::span<const std::string> texts, std::span<const std::string_view> parts,
                    femoop::Dimension dimension, NumberId first)
    {
        const std::size_t n_before = faults.size();
        for (std::size_t i = 0; i < texts.size(); ++i) { // one by one, so that a fault names its number
            const auto one = fm::parse_components(texts.subspan(i, 1), parts.subspan(i, 1), "", dimension);
            if (const auto* bad = std::get_if<femoop::Fault>(&one)) refuse(*bad, {first.group, first.place + i});
        }
        const auto all = fm::parse_components(texts, parts, "", dimension);
        if (const auto* components = std::get_if<Components>(&all)) return *components;
        if (n_before == faults.size()) refuse(std::get<femoop::Fault>(all), first);
        return {std::vector<double>(texts.size(), 0.0), ""};
    }

    /// A number of another group, counted in a unit.
    double read_in(const std::string& text, const std::string& unit, femoop::Dimension dimension, NumberId number)
    {
        const std::array<std::string_view, 2> parts{"", ""};
        const std::array<std::string, 2> texts{unit.empty() ? "0" : "1 " + unit, text};
        const Components both = read(texts, parts, dimension, {number.group, number.place - 1});
        return both.values.back();
    }

    void refuse(femoop::Fault bad, NumberId number)
    {
        if (bad.arguments.front().empty()) bad.arguments.front() = name(document_.subject, number);
        refuse(sentence(bad), number);
    }
    void refuse(const Message& reason, NumberId number)
    {
        if (std::ranges::find(faults, number, &Fault::number) == faults.end()) faults.push_back({reason, number});
    }

private:
    const Document& document_;
};

fm::Kind kind_of(Subject subject)
{
    switch (subject) {
    case Subject::PlaneStress:
    case Subject::Section: return fm::Kind::PlaneStress;
    case Subject::PlaneStrain: return fm::Kind::PlaneStrain;
    case Subject::Strain:
    case Subject::Rosette: return fm::Kind::Strain;
    case Subject::Inertia: return fm::Kind::Inertia;
    case Subject::SpaceStress: return fm::Kind::SpaceStress;
    }
    return fm::Kind::PlaneStress;
}

/// The states of the path, counted in the unit of the state.
void read_path(const Document& document, Reader& reader, Solution& solution)
{
    if (!has_path(document.subject)) return;
    std::vector<std::string_view> parts{""};
    parts.insert(parts.end(), names(document.subject).begin(), names(document.subject).end());
    for (const std::vector<std::string>& state : document.path()) {
        std::vector<std::string> texts{solution.unit.empty() ? "0" : "1 " + solution.unit};
        texts.insert(texts.end(), state.begin(), state.end());
        if (texts.size() != parts.size())
            return reader.refuse(translatable("a number of the state is missing"), {Group::State, 0});
        Reader one(document); // its numbers have no fields
        const auto v = one.read(texts, parts, dimension_of(document.subject, 0), {Group::State, 0}).values;
        for (Fault& fault : one.faults)
            reader.faults.push_back(
                {Message(translatable("loading path: {reason}"), {{"reason", std::move(fault.reason)}})});
        solution.path.push_back(fm::plane(fm::plane_state(kind_of(document.subject), v[1], v[2], v[3])));
    }
}

void read_rosette(const Document&, Reader& reader, Solution& solution)
{
    const auto t = reader.read(0, 3).values, e = reader.read(3, 3).values;
    solution.rosette = fm::Rosette{{t[0] * degree, t[1] * degree, t[2] * degree}, {e[0], e[1], e[2]}};
    solution.state.kind = fm::Kind::Strain;
    if (!reader.faults.empty()) return;
    if (const auto same = why_not(*solution.rosette)) {
        constexpr std::array<const char*, 3> gauges{"a", "b", "c"};
        reader.refuse(Message(translatable("gauges {first} and {second} measure along one direction; turn one of them"),
                              {{"first", gauges[same->first]}, {"second", gauges[same->second]}}),
                      {Group::State, same->second});
        return;
    }
    const fm::PlaneState found = fm::strain(*solution.rosette);
    solution.state.components = {.x = found.x, .y = found.y, .xy = found.xy};
}

void read_section(const Document& document, Reader& reader, Solution& solution)
{
    auto figure = section_figure(document.section);
    if (auto* reason = std::get_if<Message>(&figure)) reader.refuse(*reason, {Group::Section, 0});
    std::array<double, 4> v{};
    for (std::size_t i = 0; i < v.size(); ++i) {
        const auto value = femoop::parse_quantity(document.state()[i], dimension_of(Subject::Section, i),
                                                  newtons_and_mm);
        if (const auto* fault = std::get_if<femoop::Fault>(&value)) reader.refuse(*fault, {Group::State, i});
        else v[i] = std::get<double>(value);
    }
    if (!reader.faults.empty()) return;
    const fm::SectionFigure& section = std::get<fm::SectionFigure>(figure);
    const double rounding = 1e-9 * (section.top() - section.bottom());
    if (!(v[3] >= section.bottom() - rounding && v[3] <= section.top() + rounding))
        return reader.refuse({translatable("the fibre lies outside the section, which goes from {bottom} to {top} mm"),
                              {{"bottom", ui::number_text(section.bottom())}, {"top", ui::number_text(section.top())}}},
                             {Group::State, 3});
    const fm::SectionForces forces{v[0], v[1], v[2]};
    solution.section = SectionState{section, forces, fm::stress(section, forces, v[3]),
                                    fm::distribution(section, forces, 61)};
    const fm::PlaneState state = solution.section->fibre.state();
    solution.state.components = {.x = state.x, .xy = state.xy};
    solution.unit = "MPa";
}

void read_state(const Document& document, Reader& reader, Solution& solution)
{
    if (document.subject == Subject::Section) return read_section(document, reader, solution);
    if (document.subject == Subject::Rosette) return read_rosette(document, reader, solution);
    const Components given = reader.read(0, document.state().size());
    const auto& v = given.values;
    solution.unit = given.unit;
    if (is_in_space(document.subject))
        solution.state = {.kind = fm::Kind::SpaceStress, .components = {v[0], v[1], v[2], v[3], v[4], v[5]}};
    else solution.state = fm::plane_state(kind_of(document.subject), v[0], v[1], v[2]);
}

/// Also where it is not needed: another subject may need it.
void read_elasticity(const Document& document, Reader& reader, Solution& solution)
{
    constexpr std::array<std::string_view, 1> E_name{"E"}, nu_name{"ν"};
    const double nu = reader
                          .read(std::span(document.elasticity).subspan(1, 1), nu_name, femoop::dimension::none,
                                {Group::Elasticity, 1})
                          .values.front();
    if (!(nu > -1.0 && nu <= 0.5))
        reader.refuse(translatable("Poisson's ratio must be greater than −1 and at most 0.5"), {Group::Elasticity, 1});
    const Components E = reader.read(std::span(document.elasticity).subspan(0, 1), E_name, femoop::dimension::stress,
                                     {Group::Elasticity, 0});
    if (!(E.values.front() > 0.0))
        reader.refuse(translatable("Young's modulus must be greater than 0"), {Group::Elasticity, 0});
    const fm::Kind kind = solution.state.kind;
    if (fm::is_strain(kind) || kind == fm::Kind::PlaneStrain) solution.state.nu = nu;
    if (!fm::is_strain(kind)) return;
    // Stresses of a material are told in MPa where its modulus is in GPa.
    const bool is_GPa = E.unit == "GPa";
    solution.stress_unit = is_GPa ? "MPa" : E.unit;
    solution.state.E = micro * (is_GPa ? 1e3 : 1.0) * E.values.front();
}

Message flaw_sentence(fm::StrengthFlaw flaw, std::string_view name)
{
    switch (flaw) {
    case fm::StrengthFlaw::NotPositive:
        return {translatable("{name} must be greater than 0"), {{"name", std::string(name)}}};
    case fm::StrengthFlaw::AngleOutOfRange:
        return {translatable("{name} must be at least 0 and less than 90 degrees"), {{"name", std::string(name)}}};
    case fm::StrengthFlaw::AboveOne: break;
    }
    return {translatable("{name} must be at most 1"), {{"name", std::string(name)}}};
}

double fm::Strength::*member_at(StrengthPlace place)
{
    constexpr std::array members{&fm::Strength::fy,  &fm::Strength::ft,  &fm::Strength::fc, &fm::Strength::c,
                                 &fm::Strength::phi, &fm::Strength::sci, &fm::Strength::m,  &fm::Strength::s};
    return members[static_cast<std::size_t>(place)];
}

/// What the criterion reads is counted in the unit of the stresses; the others are judged alone.
void read_strength(const Document& document, Reader& reader, Solution& solution)
{
    const bool has_stress = fm::is_stress(solution.state.kind) || solution.state.E;
    const std::string unit = fm::is_stress(solution.state.kind) ? solution.unit : solution.stress_unit;
    const bool is_judging = document.criterion && has_stress;
    fm::Strength strength;
    for (std::size_t i = 0; i < n_strengths; ++i) {
        const auto place = static_cast<StrengthPlace>(i);
        const bool is_plain = place == StrengthPlace::phi || place == StrengthPlace::m || place == StrengthPlace::s;
        const bool is_read = is_judging && std::ranges::count(::mohr::strengths_of(*document.criterion), place) > 0;
        const NumberId number{Group::Strength, i};
        const double value = reader.read_in(document.strengths[i], is_plain || !is_read ? "" : unit,
                                            is_plain ? femoop::dimension::none : femoop::dimension::stress, number);
        strength.*member_at(place) = place == StrengthPlace::phi ? value * degree : value;
        if (const auto flaw = fm::why_not(member_at(place), strength.*member_at(place)))
            reader.refuse(flaw_sentence(*flaw, name(place)), number);
    }
    if (is_judging) solution.strength = strength;
}

Solution read(const Document& document, Reader& reader)
{
    Solution solution;
    read_state(document, reader, solution);
    read_path(document, reader, solution);
    read_elasticity(document, reader, solution);
    read_strength(document, reader, solution);
    return solution;
}

} // namespace

Message sentence(const femoop::Fault& fault)
{
    Message words(femoop::pattern(fault.kind));
    for (std::size_t i = 0; i < fault.arguments.size(); ++i) {
        std::string text = fault.arguments[i];
        text.erase(0, text.find_first_not_of(' ')); // of a component that is named without its state
        if (femoop::is_word(fault.kind, i)) words.arguments.emplace_back(std::to_string(i), Message(text));
        else words.arguments.emplace_back(std::to_string(i), std::move(text));
    }
    return words;
}

std::vector<Fault> faults(const Document& document)
{
    std::vector<Fault> all;
    const auto& n = document.normal;
    if (!(std::hypot(n[0], n[1], n[2]) > 0.0) || !std::isfinite(std::hypot(n[0], n[1], n[2])))
        all.push_back({translatable("the normal of the plane has no direction")});
    if (!std::isfinite(document.angle)) all.push_back({translatable("the angle of the plane is no number")});
    if (document.state().size() != names(document.subject).size()) {
        all.push_back({translatable("a number of the state is missing")});
        return all;
    }
    Reader reader(document);
    read(document, reader);
    const auto section = section_figure(document.section);
    if (const auto* const reason = std::get_if<Message>(&section)) reader.refuse(*reason, {Group::Section, 0});
    all.insert(all.end(), reader.faults.begin(), reader.faults.end());
    return all;
}

std::optional<Fault> why_not(const Document& document)
{
    const std::vector<Fault> all = faults(document);
    return all.empty() ? std::nullopt : std::optional(all.front());
}

Solution solve(const Document& document, fm::ShearRule rule)
{
    Reader reader(document);
    Solution s = read(document, reader);
    if (s.unit.empty() && fm::is_strain(s.state.kind)) s.unit = "10⁻⁶";
    s.angle = document.angle * degree;
    // The circle of second moments counts -Ixy downwards; in space the shear on a plane is a size.
    s.rule = document.subject == Subject::Inertia ? fm::ShearRule::TensorDown
             : is_in_space(document.subject)      ? fm::ShearRule::ClockwiseUp
                                                  : rule;
    const auto& n = document.normal;
    static_cast<fm::PointResults&>(s) = fm::point_results({.state = s.state,
                                                           .rule = s.rule,
                                                           .angle = s.angle,
                                                           .normal = Eigen::Vector3d(n[0], n[1], n[2]),
                                                           .criterion = s.strength ? document.criterion : std::nullopt,
                                                           .strength = s.strength.value_or(fm::Strength{})});
    return s;
}

std::vector<fm::ConstructionStep> construction_of(const Document& document, const Solution& s)
{
    if (!is_in_space(document.subject)) return fm::construction(s.plane, s.angle);
    const auto& n = document.normal;
    return fm::construction(s.space_principal, {n[0], n[1], n[2]});
}

namespace {

bool is_small(double value, double beside) { return std::abs(value) <= 1e-12 * std::abs(beside); }

void add_plane_remarks(const Solution& s, std::vector<Message>& all)
{
    const auto& [first, second, angle] = s.principal;
    const double largest = std::max(std::abs(first), std::abs(second));
    if (largest == 0.0) all.emplace_back(translatable("Everything is 0: the circle is a point at the origin."));
    else if (!angle)
        all.emplace_back(translatable("The circle is a point: every direction is principal, "
                                      "no plane of this set has shear, and θp is undefined."));
    else if (is_small(s.circle.centre, largest))
        all.emplace_back(translatable("Pure shear: the circle lies about the origin, "
                                      "and on the planes of largest shear no normal component acts."));
    else if (is_small(second, first) || is_small(first, second))
        all.emplace_back(translatable("One principal value alone: the circle touches the shear axis."));
}

void add_space_remarks(const Solution& s, std::vector<Message>& all)
{
    const auto& v = s.space_principal.values;
    const double largest = std::max(std::abs(v[0]), std::abs(v[2]));
    if (largest == 0.0) all.emplace_back(translatable("Everything is 0: the circles are a point at the origin."));
    else if (is_small(v[0] - v[2], largest))
        all.emplace_back(
            translatable("The three circles are a point: every direction is principal, and no plane has shear."));
    else if (is_small(v[0] - v[1], largest) || is_small(v[1] - v[2], largest))
        all.emplace_back(
            translatable("Two principal values are equal: two circles are one, "
                         "the third is a point, and every direction square to the single one is principal."));
}

void add_third_remark(const Solution& s, std::vector<Message>& all)
{
    if (s.absolute_shear <= s.circle.radius * (1.0 + 1e-9)) return;
    all.emplace_back(translatable(
        "The third principal value lies outside the circle of this plane, so the largest shear in space acts on "
        "planes that are inclined to it."));
}

} // namespace

std::vector<Message> remarks(const Document& document, const Solution& solution)
{
    std::vector<Message> all;
    if (is_in_space(document.subject)) {
        add_space_remarks(solution, all);
        return all;
    }
    add_plane_remarks(solution, all);
    if (solution.space) add_third_remark(solution, all);
    return all;
}

} // namespace mohr
