#include "apps/frame/window/results_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/frame/document/measures.h"
#include "apps/frame/view/results/case_numbers.h"
#include "apps/frame/view/results/diagram.h"
#include "apps/frame/view/results/mechanism_picture.h"
#include "apps/frame/window/envelope_panel.h"
#include "apps/frame/window/no_results.h"
#include "apps/frame/window/result_list.h"
#include "femoop/result/components.h"
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
    Session& session;
    CaseResult result;
    ui::DisplayUnits units;
    CaseNumbers numbers;

    const Model& model() const { return session.model(); }
    const ui::Catalogue& tr() const { return session.view.tr; }
};

void displacements(const ShownCase& shown)
{
    const std::vector<Dof> list = dof_list(shown.model().analysis);
    std::vector<std::string> headings{shown.tr()("Node")};
    for (const Dof dof : list) headings.push_back(shown.units.label(name(dof), displacement_measures.of(dof)));
    result_list("displacements", headings, shown.model().nodes.size(), [&](std::size_t i) {
        part_cell(shown.session, NodeId(i), shown.model().nodes[i].id);
        const NodeVector u = shown.result.displacement(NodeId(i));
        for (const Dof dof : list) number_cell(shown.numbers.number(u[index(dof)], displacement_measures.of(dof)));
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
    result_list("reactions", headings, supported.size(), [&](std::size_t i) {
        part_cell(shown.session, supported[i], shown.model()[supported[i]].id);
        const NodeVector r = shown.result.reaction(supported[i]);
        for (const Dof dof : list) number_cell(shown.numbers.number(r[index(dof)], force_measures.of(dof)));
    });
}

// How many columns of numbers find room beside names of members.
int n_number_columns(const Model& model)
{
    float names = 0.0F;
    for (const Member& member : model.members) names = std::max(names, ImGui::CalcTextSize(member.id.c_str()).x);
    const float pad = 2.0F * ImGui::GetStyle().CellPadding.x;
    const float number = ImGui::CalcTextSize("−00.00").x + pad;
    const float room = ImGui::GetContentRegionAvail().x - std::max(names, 4.0F * ImGui::GetFontSize()) - pad;
    return static_cast<int>(room / number);
}

// For each member its largest and its smallest value of one section force, and where there is room those at its ends;
// the tables at the bottom of the window have them all, with their places.
void member_forces(const ShownCase& shown, MemberComponent component, const std::string& id)
{
    const ui::Catalogue& tr = shown.tr();
    const bool has_ends = n_number_columns(shown.model()) >= 4;
    std::vector<std::string> headings{tr("Member")};
    if (has_ends) headings.insert(headings.end(), {tr("start"), tr("end")});
    headings.insert(headings.end(), {tr("max"), tr("min")});
    result_list(id.c_str(), headings, shown.model().members.size(), [&](std::size_t i) {
        part_cell(shown.session, MemberId(i), shown.model().members[i].id);
        const Curve curve = shown.result.curve(MemberId(i));
        const Extremes extremes = curve.extremes(component);
        const auto value = [&](double v) { number_cell(shown.numbers.number(v, measure_of(component))); };
        if (has_ends) value(curve.value(component, 0.0));
        if (has_ends) value(curve.value(component, curve.length(), Side::Before));
        value(extremes.max.value);
        value(extremes.min.value);
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

} // namespace

void results_panel(Desk& desk)
{
    Session& session = desk.session;
    const ui::Catalogue& tr = session.view.tr;
    const auto& results = session.solution().results;
    if (explain_no_results(desk)) return;
    if (results->n_cases() == 0) {
        ui::wrapped_text(tr("The model has no load case."));
        return;
    }
    if (session.view.is_envelope) return envelope_panel(desk);
    const CaseResult result = (*results)[session.view.load_case];
    const ui::DisplayUnits units = session.units();
    const ShownCase shown{session, result, units, CaseNumbers(result, units)};
    ImGui::TextDisabled("%s", tr("Case {case}", {{"case", result.name()}}).c_str());
    if (ImGui::Button((tr("Tables with places (F4)") + "###tables").c_str())) desk.bottom = {true, TableKind::Extremes};
    for (const MemberComponent component : section_force_components(session.model().analysis)) {
        const std::string id(name(component, session.model().analysis));
        if (result_section(tr("Members: {value}", {{"value", units.label(id, measure_of(component))}}), id.c_str()))
            member_forces(shown, component, id);
    }
    if (result_section(tr("Reactions"), "reactions")) reactions(shown);
    if (result_section(tr("Displacements"), "displacements")) displacements(shown);
    if (result_section(tr("Equilibrium"), "equilibrium")) show_equilibrium(shown);
}

void problems_panel(Desk& desk)
{
    Session& session = desk.session;
    const ui::Catalogue& tr = session.view.tr;
    const Solution& solution = session.solution();
    if (solution.faults.empty()) ui::wrapped_text(tr("Nothing is wrong with the model."));
    for (std::size_t i = 0; i < solution.faults.size(); ++i) {
        const Fault& fault = solution.faults[i];
        const bool is_error = severity(fault.kind) == Severity::Error;
        ImGui::TextUnformatted((is_error ? tr("Error") : tr("Warning")).c_str());
        ui::wrapped_text(sentence(fault, tr));
        ImGui::Separator();
    }
    for (std::size_t i = 0; i < solution.mechanisms.size() && solution.mechanisms.size() > 1; ++i) {
        const std::string label = tr("Mechanism {number}", {{"number", std::to_string(i + 1)}});
        if (ImGui::RadioButton(label.c_str(), session.mechanism == i)) session.mechanism = i;
    }
}

void history_panel(Desk& desk)
{
    Session& session = desk.session;
    for (std::size_t i = 0; i < session.history().n_states(); ++i) {
        const bool is_ahead = i > session.history().place();
        if (is_ahead) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        const std::string label = ui::item_label(session.view.tr(session.history().label(i)), std::to_string(i));
        const bool is_chosen = ImGui::Selectable(label.c_str(), i == session.history().place());
        if (is_ahead) ImGui::PopStyleColor();
        if (is_chosen) {
            session.jump(i);
            return;
        }
    }
}

} // namespace frame
