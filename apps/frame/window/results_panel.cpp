#include "apps/frame/window/results_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "apps/drawing/measures.h"
#include "apps/drawing/results/case_numbers.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/reactions.h"
#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/session/fault_target.h"
#include "apps/frame/session/truss_commands.h"
#include "apps/frame/window/envelope_panel.h"
#include "apps/frame/window/influence_panel.h"
#include "apps/frame/window/no_results.h"
#include "apps/frame/window/result_list.h"
#include "apps/frame/window/train_envelope_panel.h"
#include "apps/frame/window/truss_panel.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/result/components.h"
#include "femoop/result/difference.h"
#include "femoop/result/results.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;

namespace {

// The results of the case that is shown, and how its numbers are written.
struct ShownCase {
    Workspace& workspace;
    CaseResult result;
    ui::DisplayUnits units;
    CaseNumbers numbers;

    Session& session() const { return workspace.session; }
    const Model& model() const { return session().model(); }
    const ui::Catalogue& tr() const { return session().view.tr; }
};

void displacements(const ShownCase& shown)
{
    const std::vector<Dof> list = dof_list(shown.model().analysis);
    std::vector<std::string> headings{shown.tr()("Node")};
    for (const Dof dof : list) headings.push_back(shown.units.label(name(dof), displacement_measures.of(dof)));
    result_list("displacements", headings, shown.model().nodes.size(), [&](ResultRow& row, std::size_t i) {
        row.part(shown.session(), NodeId(i), shown.model().nodes[i].id);
        const NodeVector u = shown.result.displacement(NodeId(i));
        for (const Dof dof : list)
            row.number(shown.workspace, shown.numbers.number(u[index(dof)], displacement_measures.of(dof)),
                       {{.quantity = ExpectedQuantity::Displacement, .node = NodeId(i), .dof = dof}}, NodeId(i));
    });
}

void reactions(const ShownCase& shown)
{
    const std::vector<Dof> list = dof_list(shown.model().analysis);
    std::vector<NodeId> supported;
    for (std::size_t i = 0; i < shown.model().nodes.size(); ++i) {
        if (shown.result.is_supported(NodeId(i))) supported.emplace_back(i);
    }
    std::vector<std::string> headings{shown.tr()("Node")};
    for (const Dof dof : list) headings.push_back(shown.units.label(force_name(dof), force_measures.of(dof)));
    const bool has_slanting = drawing::has_slanting_support(shown.model());
    if (has_slanting) headings.push_back(shown.units.label("R", ui::Measure::Force));
    result_list("reactions", headings, supported.size(), [&](ResultRow& row, std::size_t i) {
        row.part(shown.session(), supported[i], shown.model()[supported[i]].id);
        const NodeVector r = shown.result.reaction(supported[i]);
        for (const Dof dof : list)
            row.number(shown.workspace, shown.numbers.number(r[index(dof)], force_measures.of(dof)),
                       {{.quantity = ExpectedQuantity::Reaction, .node = supported[i], .dof = dof}}, supported[i]);
        if (!has_slanting) return;
        const bool is_slanting = drawing::slanting_normal(shown.model(), supported[i]).has_value();
        if (is_slanting)
            row.number(shown.workspace, shown.numbers.number(drawing::resultant(r), ui::Measure::Force),
                       {{.quantity = ExpectedQuantity::Reaction, .node = supported[i]}}, supported[i]);
        else row.number("");
    });
}

float width_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// The section force at the two ends of a member, its largest value and its smallest.
std::array<std::string, 4> force_texts(const ShownCase& shown, MemberComponent component, std::size_t member)
{
    const Curve curve = shown.result.curve(MemberId(member));
    const Extremes extremes = curve.extremes(component);
    const auto text = [&](double value) { return shown.numbers.number(value, measure_of(component)); };
    return {text(curve.value(component, 0.0)), text(curve.value(component, curve.length(), Side::Before)),
            text(extremes.max.value), text(extremes.min.value)};
}

/// Which numbers of the results they are.
std::array<MovingEffect, 4> force_numbers(const ShownCase& shown, MemberComponent component, std::size_t member)
{
    const MemberId id(member);
    const Curve curve = shown.result.curve(id);
    const auto [max, min] = curve.extremes(component);
    return {number_at_section({id, 0.0}, component, curve.length()),
            number_at_section({id, curve.length()}, component, curve.length()),
            number_on_diagram(id, curve, component, max.x, max.value),
            number_on_diagram(id, curve, component, min.x, min.value)};
}

/// Whether the panel is broad enough for all four beside the members' names; of many the first ones tell.
bool have_room(const ShownCase& shown, MemberComponent component, const std::vector<std::string>& headings)
{
    constexpr std::size_t most_measured = 12;
    std::array<float, 5> widths{};
    for (std::size_t j = 0; j < widths.size(); ++j) widths[j] = width_of(headings[j]);
    for (std::size_t i = 0; i < std::min(shown.model().members.size(), most_measured); ++i) {
        widths[0] = std::max(widths[0], width_of(shown.model().members[i].id));
        const auto texts = force_texts(shown, component, i);
        for (std::size_t j = 0; j < texts.size(); ++j) widths[j + 1] = std::max(widths[j + 1], width_of(texts[j]));
    }
    const float pads = 2.0F * ImGui::GetStyle().CellPadding.x * static_cast<float>(widths.size());
    const float bar = shown.model().members.size() + 1 > most_measured ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    return std::accumulate(widths.begin(), widths.end(), pads + bar) <= ImGui::GetContentRegionAvail().x;
}

// For each member its largest and its smallest value of one section force, and where there is room those at its ends;
// the tables at the bottom of the window have them all, with their places.
void member_forces(const ShownCase& shown, MemberComponent component, const std::string& id)
{
    const ui::Catalogue& tr = shown.tr();
    std::vector<std::string> headings{tr("Member"), tr("start"), tr("end"), tr("max"), tr("min")};
    const bool has_ends = have_room(shown, component, headings);
    if (!has_ends) headings.erase(headings.begin() + 1, headings.begin() + 3);
    result_list(id.c_str(), headings, shown.model().members.size(), [&](ResultRow& row, std::size_t i) {
        row.part(shown.session(), MemberId(i), shown.model().members[i].id);
        const auto texts = force_texts(shown, component, i);
        const auto numbers = force_numbers(shown, component, i);
        for (std::size_t j = has_ends ? 0 : 2; j < texts.size(); ++j)
            row.number(shown.workspace, texts[j], {numbers[j]}, MemberId(i));
    });
}

void show_equilibrium(const ShownCase& shown)
{
    const ui::Catalogue& tr = shown.tr();
    const Equilibrium equilibrium = shown.result.equilibrium();
    for (const Dof dof : equilibrium_dofs(shown.model().analysis)) {
        const auto sum = [&](const NodeVector& of) {
            return shown.numbers.text(of[index(dof)], force_measures.of(dof));
        };
        ImGui::TextWrapped(
            "%s", tr("Σ{force}: loads {loads}, reactions {reactions}", {{"force", force_name(dof)},
                                                                        {"loads", sum(equilibrium.sum_loads)},
                                                                        {"reactions", sum(equilibrium.sum_reactions)}})
                      .c_str());
    }
    const ui::NumberFormat two_digits{.digits = 2, .mark = shown.units.format().mark};
    ui::wrapped_text(tr("Largest force out of balance: {residual} of the largest load",
                        {{"residual", ui::number_text(equilibrium.residual, two_digits)}}));
}

/// "M", "Fy", "uy".
std::string component_name(const Difference& one, AnalysisKind analysis)
{
    if (const auto* const component = std::get_if<MemberComponent>(&one.component))
        return std::string(name(*component, analysis));
    const Dof dof = std::get<Dof>(one.component);
    return std::string(one.quantity == ComparedQuantity::Reaction ? force_name(dof) : name(dof));
}

Measure measure_of_difference(const Difference& one)
{
    if (const auto* const component = std::get_if<MemberComponent>(&one.component)) return measure_of(*component);
    const Dof dof = std::get<Dof>(one.component);
    return one.quantity == ComparedQuantity::Reaction ? force_measures.of(dof) : displacement_measures.of(dof);
}

/// " (3.2 m)" of a section force; " (40%)" where the member had another length.
std::string section_text(const ShownCase& shown, const Difference& one)
{
    const auto* const member = std::get_if<femoop::MemberId>(&one.part);
    if (member == nullptr || !one.share) return "";
    if (!one.is_as_long) return " (" + shown.units.number(100.0 * *one.share, Measure::Plain) + "%)";
    const double x = *one.share * geometry_of(shown.model(), shown.model()[*member]).length;
    return " (" + shown.units.text(x, Measure::Length) + ")";
}

/// The value of the present results. \pre a section, of a section force
femoop::MovingEffect effect_of(const ShownCase& shown, const Difference& one)
{
    femoop::MovingEffect effect{.quantity = one.quantity == ComparedQuantity::Reaction
                                                ? femoop::ExpectedQuantity::Reaction
                                                : femoop::ExpectedQuantity::Displacement};
    if (const auto* const node = std::get_if<femoop::NodeId>(&one.part)) {
        effect.node = *node;
        effect.dof = std::get<Dof>(one.component);
        return effect;
    }
    const auto member = std::get<MemberId>(one.part);
    const double length = geometry_of(shown.model(), shown.model()[member]).length;
    return number_at_section({member, *one.share * length}, std::get<MemberComponent>(one.component), length);
}

/// "BC (3.2 m): M [kN·m]", the value, that of what is compared with, and the change.
void difference_row(ResultRow& row, const ShownCase& shown, const Difference& one)
{
    const Measure measure = measure_of_difference(one);
    const auto part = std::visit([](auto id) { return Part(id); }, one.part);
    const std::string id = std::visit([&](auto id_of_part) { return shown.model()[id_of_part].id; }, one.part);
    const std::string component = shown.units.label(component_name(one, shown.model().analysis), measure);
    row.part(shown.session(), part, id + section_text(shown, one) + ": " + component);
    const std::array values{std::optional(one.now), one.then, one.change()};
    constexpr std::array of_column{Compared::Now, Compared::Kept, Compared::Change};
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i])
            row.number(shown.workspace, with_minus(shown.units.number(*values[i], measure)),
                       {.effect = effect_of(shown, one), .compared = of_column[i]}, part);
        else row.number("");
    }
}

/// Every case is compared with this one from now on.
void compare_with_case(Session& session, CaseId load_case)
{
    ReferenceResults paired = *session.reference;
    const std::string name = paired.model.case_name(load_case);
    paired.load_case = load_case;
    paired.name = paired.name.empty() ? name : paired.name + ": " + name;
    session.reference = std::make_shared<const ReferenceResults>(std::move(paired));
}

/// That the case that is shown has no counterpart, and what it can be compared with.
void show_no_counterpart(const ShownCase& shown, const std::string& name)
{
    const ui::Catalogue& tr = shown.tr();
    const auto reference = shown.session().reference; // a click replaces it
    ui::wrapped_text(tr("{case}: there is no load case of this name in {name}, so nothing is compared.",
                        {{"case", shown.result.name()}, {"name", name}}));
    for (std::size_t i = 0; i < reference->model.n_cases(); ++i) {
        const std::string other = reference->model.case_name(CaseId(i));
        if (ui::wrapped_button(tr("Compare with {case}", {{"case", other}}), "with" + std::to_string(i)))
            compare_with_case(shown.session(), CaseId(i));
    }
}

/// The present results beside those that are kept, part by part.
void show_differences(const ShownCase& shown)
{
    const std::shared_ptr<const ReferenceResults> kept = shown.session().reference;
    const ReferenceResults& reference = *kept;
    const auto counterpart = reference.counterpart(shown.model(), shown.session().view.load_case);
    const ui::Catalogue& tr = shown.tr();
    const std::string name = reference.name.empty() ? tr("the results that were kept") : reference.name;
    if (!result_section(tr("Compared with {name}", {{"name", name}}), "differences")) return;
    if (!counterpart) return show_no_counterpart(shown, name);
    const Differences all({&shown.model(), shown.result}, {&reference.model, reference.results[*counterpart]});
    const std::vector<std::string> headings{tr("Part"), tr("now"), tr("kept"), "Δ"};
    result_list("differences", headings, all.size(),
                [&](ResultRow& row, std::size_t i) { difference_row(row, shown, all[i]); });
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ui::wrapped_text(tr("Of a section force where it differs most"));
    ImGui::PopStyleColor();
}

} // namespace

void results_panel(Workspace& workspace, ui::NumberFields& fields)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const auto& results = session.solution().results;
    if (session.influence.is_on(session.model())) return influence_panel(workspace);
    if (shown_truss(session) != nullptr) return truss_panel(workspace);
    if (explain_no_results(workspace)) return;
    if (results->n_cases() == 0 && !session.shows_train_envelope()) {
        ui::wrapped_text(tr("The model has no load case."));
        return;
    }
    if (session.shows_train_envelope()) return train_envelope_panel(workspace, fields);
    if (session.view.is_envelope) return envelope_panel(workspace);
    const CaseResult result = (*results)[session.view.load_case];
    const ui::DisplayUnits units = session.units();
    const ShownCase shown{workspace, result, units, CaseNumbers(result, units)};
    ImGui::TextDisabled("%s", tr("Case {case}", {{"case", result.name()}}).c_str());
    if (ui::wrapped_button(tr("Tables with places (F4)"), "tables")) workspace.bottom = {true, TableKind::Extremes};
    if (session.reference) show_differences(shown);
    for (const MemberComponent component : section_force_components(session.model().analysis)) {
        const std::string id(name(component, session.model().analysis));
        if (result_section(tr("Members: {value}", {{"value", units.label(id, measure_of(component))}}), id.c_str()))
            member_forces(shown, component, id);
    }
    if (result_section(tr("Reactions"), "reactions")) reactions(shown);
    if (result_section(tr("Displacements"), "displacements")) displacements(shown);
    if (result_section(tr("Equilibrium"), "equilibrium")) show_equilibrium(shown);
}

namespace {

/// A problem as a button of the panel's width. \returns whether it is clicked
bool problem_button(const Fault& fault, const ui::Catalogue& tr)
{
    const std::string words = (is_error(fault) ? tr("Error") : tr("Warning")) + "\n" + sentence(fault, tr);
    const ImVec2 corner = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, width);
    const bool is_clicked = ImGui::Selectable("###go", false, ImGuiSelectableFlags_None, {width, size.y});
    ImGui::SetCursorPos(corner);
    ui::wrapped_text(words);
    ImGui::Separator();
    return is_clicked;
}

} // namespace

void problems_panel(Workspace& workspace)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const std::vector<Fault>& faults = session.solution().faults;
    if (faults.empty()) ui::wrapped_text(tr("Nothing is wrong with the model."));
    else ImGui::TextDisabled("%s", tr("A click goes to the place.").c_str());
    for (std::size_t i = 0; i < faults.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (problem_button(faults[i], tr)) go_to(workspace, faults[i]);
        ImGui::PopID();
    }
    const std::size_t n_mechanisms = session.shown_mechanisms().size();
    for (std::size_t i = 0; i < n_mechanisms && n_mechanisms > 1; ++i) {
        const std::string label = tr("Mechanism {number}", {{"number", std::to_string(i + 1)}});
        if (ImGui::RadioButton(label.c_str(), session.mechanism == i)) session.mechanism = i;
    }
}

void history_panel(Workspace& workspace)
{
    Session& session = workspace.session;
    for (std::size_t i = 0; i < session.history().n_states(); ++i) {
        const bool is_ahead = i > session.history().place();
        if (is_ahead) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        const std::string label = ui::item_label(session.view.tr(session.history().label(i)), std::to_string(i));
        const bool is_chosen = ImGui::Selectable(label.c_str(), i == session.history().place());
        if (is_ahead) ImGui::PopStyleColor();
        if (is_chosen) {
            session.go_to_state(i);
            return;
        }
    }
}

} // namespace frame
