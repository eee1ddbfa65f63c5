#include "apps/frame/session/other_programs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "apps/cross/document/file.h"
#include "apps/cross/document/solution.h"
#include "apps/frame/document/fault/place.h"
#include "apps/mohr/document/file.h"
#include "apps/mohr/document/section_text.h"
#include "femoop/edit/excerpt.h"
#include "femoop/edit/short_number.h"
#include "femoop/files/whole_file.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/io/model_file.h"
#include "femoop/methods/mohr/section_stress.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "femoop/section/profile.h"
#include "femoop/section/shape.h"
#include "femoop/section/tapered_section.h"
#include "ui/workspace/standard_commands.h"

namespace frame {

using femoop::MemberComponent;
using femoop::MemberId;
using ui::Message;
using ui::translatable;

namespace dimension = femoop::dimension;

namespace {

// ---- moment distribution

/// A case that is faulty is empty, so that it hinders no other.
femoop::Excerpt excerpt(const Session& session, const std::vector<MemberId>& members, femoop::CaseId load_case)
{
    const bool is_sound = session.solution().blank_case(load_case) == nullptr;
    femoop::Model model = is_sound ? without_blank_cases(session.model(), session.solution()) : session.model();
    if (members.size() == model.members.size()) return {.model = std::move(model), .held = {}};
    return excerpt_of(model, members);
}

} // namespace

std::vector<MemberId> chosen_members(const Session& session)
{
    std::vector<MemberId> members;
    for (const Part& part : session.selection.parts())
        if (const auto* const member = std::get_if<MemberId>(&part)) members.push_back(*member);
    if (!members.empty()) return members;
    for (std::size_t m = 0; m < session.model().members.size(); ++m) members.emplace_back(m);
    return members;
}

femoop::Model structure_handed(const Session& session, const std::vector<MemberId>& members, femoop::CaseId load_case)
{
    return excerpt(session, members, load_case).model;
}

Offer moment_distribution(const Session& session, const std::vector<MemberId>& members, femoop::CaseId load_case)
{
    const femoop::Model model = structure_handed(session, members, load_case);
    cross::Document document{.model = model};
    document.method.load_case = load_case;
    if (auto solution = cross::solve(document); !solution.faults.empty())
        return about_model(translatable("moment distribution cannot do this"),
                           named(std::move(solution.faults), model));
    document = cross::read_document(femoop::write_model(model)); // with the method that the file asks for
    document.method.load_case = load_case;
    return ui::ExportToApp{.program = "cross", .document = cross::write_document(document)};
}

Offer moment_distribution(const Session& session)
{
    return moment_distribution(session, chosen_members(session), session.view.load_case);
}

std::string held_nodes(const Session& session)
{
    const femoop::Excerpt chosen = excerpt(session, chosen_members(session), session.view.load_case);
    std::string names;
    for (const femoop::NodeId node : chosen.held) names += (names.empty() ? "" : ", ") + chosen.model[node].id;
    return names;
}

namespace {

// ---- Mohr's circle

/// Of the last of six significant digits.
double unit_of(double value) { return std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5.0); }

/// Six significant digits; 0 for what is nothing but rounding beside the largest of its kind.
std::string amount(double value, double largest, femoop::Dimension kind, const femoop::Units& units)
{
    if (!(std::abs(value) > 1e-10 * largest)) return femoop::quantity_text(0.0, kind, units);
    const double unit = unit_of(value);
    return femoop::quantity_text(femoop::short_number(std::round(value / unit) * unit, std::abs(value)), kind, units);
}

/// Of a fibre [mm]; the outermost is not rounded beyond the section's edge.
std::string fibre_text(double y, const femoop::mohr::SectionFigure& figure)
{
    const double height = figure.top() - figure.bottom(), unit = unit_of(y);
    const double near = std::round(y / unit) * unit;
    const bool is_beyond = std::max(near - figure.top(), figure.bottom() - near) > 1e-9 * height;
    return amount(is_beyond ? std::trunc(y / unit) * unit : near, height, dimension::length, mohr::newtons_and_mm);
}

/// As it was typed; in the units of Mohr's circle where it was a bare number.
std::string text_of(const femoop::Quantity& quantity, femoop::Dimension kind, const femoop::Units& units)
{
    if (quantity.has_text()) return std::string(quantity.text());
    const double value = femoop::converted(quantity.value(), kind, units, mohr::newtons_and_mm);
    return femoop::quantity_text(value, kind, mohr::newtons_and_mm);
}

constexpr std::string_view turned_suffix = " turned";

} // namespace

std::optional<std::string> section_text(const femoop::Section& section, const femoop::Units& units)
{
    const std::string_view end = section.turned ? turned_suffix : "";
    if (section.profile) return *section.profile + std::string(end);
    if (!section.shape) return std::nullopt;
    std::string words(name(section.shape->kind));
    for (const femoop::ShapeDimension& side : dimensions(section.shape->kind)) {
        const auto& value = *section.shape.*side.value;
        if (!value) continue;
        const double mm = femoop::converted(value->value(), dimension::length, units, mohr::newtons_and_mm);
        words += " " + std::string(side.key) + "=" + femoop::number_text(mm) + "mm";
    }
    return words + std::string(end);
}

namespace {

/// Where the only selected member has its largest moment.
std::optional<Cut> worst_cut(const Session& session)
{
    const auto part = session.selection.only();
    const auto* const member = part ? std::get_if<MemberId>(&*part) : nullptr;
    if (member == nullptr) return std::nullopt;
    const femoop::Curve curve = (*session.solution().results)[session.view.load_case].curve(*member);
    const femoop::Extremes extremes = curve.extremes(MemberComponent::Mz);
    const bool is_sagging = std::abs(extremes.max.value) >= std::abs(extremes.min.value);
    return Cut{*member, is_sagging ? extremes.max.x : extremes.min.x};
}

std::optional<Message> why_no_forces(const Session& session)
{
    using enum femoop::AnalysisKind;
    if (session.hidden || !session.solution().results) return session.why_no_results();
    if (session.model().n_cases() == 0) return Message(translatable("the model has no load case; add one first"));
    if (session.model().analysis != Frame2d && session.model().analysis != Truss2d)
        return Message(translatable(
            "a section's circle is that of a plane frame or truss; here members bend in other planes too"));
    return std::nullopt;
}

/// Of the case that is shown.
std::optional<Message> why_no_forces_here(const Session& session)
{
    if (auto reason = why_no_forces(session)) return reason;
    if (session.view.is_envelope)
        return Message(translatable("an envelope is no state of a section; choose a load case"));
    return session.why_no_results();
}

mohr::Document section_document(const Session& session, const Cut& cut, femoop::CaseId load_case,
                                const mohr::Document& begun, const femoop::mohr::SectionFigure& figure)
{
    const femoop::Units& units = session.model().units;
    const femoop::CaseResult result = (*session.solution().results)[load_case];
    const femoop::SectionForces f = result.curve(cut.member).forces(cut.x);
    const femoop::Magnitudes largest = result.magnitudes();
    const auto in_mohr = [&](double value, femoop::Dimension kind) {
        return femoop::converted(value, kind, units, mohr::newtons_and_mm);
    };
    const double y = most_stressed(figure, {.N = in_mohr(f.N, dimension::force),
                                            .V = in_mohr(f.Vy, dimension::force),
                                            .M = in_mohr(f.Mz, dimension::moment)});
    mohr::Document document = begun;
    document.subject = mohr::Subject::Section;
    document.state() = {amount(f.N, largest.force, dimension::force, units),
                        amount(f.Vy, largest.force, dimension::force, units),
                        amount(f.Mz, largest.moment, dimension::moment, units), fibre_text(y, figure)};
    const femoop::Material& material = session.model()[*session.model()[cut.member].material];
    document.elasticity[0] = text_of(material.E, dimension::stress, units);
    document.elasticity[1] = femoop::number_text(material.poisson());
    if (material.fy)
        document.strengths[static_cast<std::size_t>(mohr::StrengthPlace::fy)] = text_of(*material.fy, dimension::stress,
                                                                                        units);
    return document;
}

} // namespace

std::optional<Cut> cut_for_circle(const Session& session)
{
    if (why_no_forces_here(session)) return std::nullopt;
    return session.pin ? session.pin : session.hover ? session.hover : worst_cut(session);
}

namespace {

/// A section as Mohr's circle names it, and its figure.
struct NamedFigure {
    std::string words;
    femoop::mohr::SectionFigure figure;
};

/// What stands there: along a taper as deep as the member is at that place.
femoop::Section section_at(const femoop::Model& model, const Cut& cut)
{
    const femoop::Member& member = model[cut.member];
    const femoop::Section& section = model[*member.section];
    if (member.depths.size() != 2 || !femoop::can_taper(section)) return section;
    return at_depth(section, depth_at(member, cut.x / geometry_of(model, member).length));
}

std::variant<NamedFigure, Message> figure_of(const femoop::Model& model, const Cut& cut)
{
    const femoop::Member& member = model[cut.member];
    if (!member.section || !member.material)
        return Message(translatable("member {id} has no section: it is rigid"), {{"id", member.id}});
    const femoop::Section section = section_at(model, cut);
    const auto words = section_text(section, model.units);
    if (!words)
        return Message(
            translatable(
                "section {name} is given by numbers alone, so its fibres are not known; choose a profile or a shape"),
            {{"name", section.id}});
    if (section.A || section.Iz)
        return Message(
            translatable("section {name} is {outline} with an area or a second moment of its own, "
                         "which its outline does not have, so its fibres are not known; take the own values away"),
            {{"name", section.id}, {"outline", *words}});
    auto figure = mohr::section_figure(*words);
    if (auto* const reason = std::get_if<Message>(&figure)) return std::move(*reason);
    return NamedFigure{*words, std::get<femoop::mohr::SectionFigure>(std::move(figure))};
}

/// Without the work of handing it over: it is asked for in every frame that shows the command.
std::optional<Message> why_no_circle(const Session& session)
{
    if (auto reason = why_no_forces_here(session)) return reason;
    const auto cut = cut_for_circle(session);
    if (!cut || cut->member.index >= session.model().members.size())
        return Message(translatable("point at a section of a member, or select one member"));
    auto figure = figure_of(session.model(), *cut);
    const auto* const reason = std::get_if<Message>(&figure);
    return reason != nullptr ? std::optional(*reason) : std::nullopt;
}

} // namespace

Offer circle_at_section(const Session& session)
{
    if (const auto reason = why_no_circle(session)) return Notice{{*reason}};
    return circle_at(session, *cut_for_circle(session), session.view.load_case);
}

Offer circle_at(const Session& session, const Cut& cut, femoop::CaseId load_case)
{
    if (const auto reason = why_no_forces(session)) return Notice{{*reason}};
    if (session.solution().blank_case(load_case) != nullptr)
        return Notice{{{translatable("Case {case} has no results: see the problems."),
                        {{"case", session.model().case_name(load_case)}}}}};
    const auto found = figure_of(session.model(), cut);
    if (const auto* const reason = std::get_if<Message>(&found)) return Notice{{*reason}};
    const auto& [words, figure] = std::get<NamedFigure>(found);
    mohr::Document document = mohr::textbook_state();
    document.section = words;
    document = section_document(session, cut, load_case, document, figure);
    return ui::ExportToApp{.program = "mohr", .document = mohr::file_text(document)};
}

std::optional<femoop::Section> section_named(const std::string& typed_words, const femoop::Section& section,
                                             const femoop::Units& units)
{
    if (std::holds_alternative<Message>(mohr::section_figure(typed_words))) return std::nullopt;
    const bool is_turned = typed_words.ends_with(turned_suffix);
    const std::string words = typed_words.substr(0, typed_words.size() - (is_turned ? turned_suffix.size() : 0));
    femoop::Section next{.id = section.id, .turned = is_turned};
    if (femoop::find_profile(words) != nullptr) {
        next.profile = words;
        return next;
    }
    std::istringstream parts(words);
    std::string part;
    parts >> part;
    next.shape.emplace();
    for (const femoop::SectionShapeKind kind : femoop::section_shape_kinds())
        if (name(kind) == part) next.shape->kind = kind;
    while (parts >> part) {
        const std::string key = part.substr(0, part.find('=')), typed = part.substr(part.find('=') + 1);
        const bool is_bare = typed.find_first_not_of("0123456789.e+-") == std::string::npos;
        const std::string text = is_bare ? typed + " mm" : typed;
        const auto value = femoop::parse_quantity(text, dimension::length, units);
        if (!std::holds_alternative<double>(value)) return std::nullopt;
        for (const femoop::ShapeDimension& side : femoop::shape_dimensions())
            if (side.key == key) *next.shape.*side.value = femoop::Quantity(std::get<double>(value), text);
    }
    return next;
}

namespace {

void hand_over(Workspace& workspace, Offer offer, const Message& told)
{
    if (auto* const refusal = std::get_if<Notice>(&offer)) {
        workspace.session.notice = std::move(*refusal);
        return;
    }
    workspace.handed.push_back(std::get<ui::ExportToApp>(std::move(offer)));
    workspace.notify(told);
}

Message told_of_distribution(const Session& session)
{
    const std::string held = held_nodes(session);
    if (held.empty()) return translatable("the moments are distributed in a window of their own");
    return {translatable("the moments are distributed in a window of their own; "
                         "where members were left out the nodes are held fixed: {nodes}"),
            {{"nodes", held}}};
}

} // namespace

namespace {

void hand_over_distribution(Workspace& workspace)
{
    hand_over(workspace, moment_distribution(workspace.session), told_of_distribution(workspace.session));
}

void hand_over_circle(Workspace& workspace)
{
    hand_over(workspace, circle_at_section(workspace.session),
              translatable("the circle is drawn in a window of its own"));
}

// With a path, what the other program would get is written there.
CommandTable::RunWith into_file(void (*run)(Workspace&))
{
    return [run](Workspace& workspace, const ui::Argument& path) -> ui::Reason {
        run(workspace);
        if (workspace.handed.empty()) return workspace.session.notice->sentence;
        const std::error_code error = files::write_whole_file(path.text, workspace.handed.back().document);
        return error ? ui::Reason(error.message()) : std::nullopt;
    };
}

} // namespace

void add_method_commands(CommandTable& table)
{
    Menu menu(table, methods_menu);
    menu.step({"methods.distribution", translatable("Moment distribution of the selection")}, hand_over_distribution,
              [](const Workspace& workspace) { return workspace.distribution.why_not(workspace.session); });
    menu.step({"methods.circle", translatable("Mohr's circle at this section")}, hand_over_circle,
              [](const Workspace& workspace) { return why_no_circle(workspace.session); });
    table.with_argument("methods.distribution", into_file(hand_over_distribution));
    table.with_argument("methods.circle", into_file(hand_over_circle));
}

} // namespace frame
