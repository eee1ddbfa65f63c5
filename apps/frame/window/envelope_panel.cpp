#include "apps/frame/window/envelope_panel.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "apps/drawing/measures.h"
#include "apps/drawing/results/case_numbers.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/frame/window/result_list.h"
#include "femoop/result/components.h"
#include "femoop/result/envelope.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using namespace femoop;

namespace {

// One stays: an envelope of nothing has no values.
void choose_cases(Session& session)
{
    const Model& model = session.model();
    const std::size_t n_chosen = envelope_cases(model, session.view).size();
    for (std::size_t i = 0; i < model.n_cases(); ++i) {
        const std::string& name = model.case_name(CaseId(i));
        const bool is_blank = session.solution().blank_case(CaseId(i)) != nullptr;
        bool takes_part = !is_blank && (n_chosen == model.n_cases() || !session.view.left_out.contains(name));
        const bool is_last = takes_part && n_chosen == 1;
        ImGui::BeginDisabled(is_last || is_blank);
        if (ImGui::Checkbox(ui::label_beside_box(name, "part " + std::to_string(i)).c_str(), &takes_part)) {
            if (takes_part) session.view.left_out.erase(name);
            else session.view.left_out.insert(name);
        }
        ImGui::EndDisabled();
    }
}

/// The tables of the panel.
class EnvelopeTables {
public:
    explicit EnvelopeTables(Workspace& workspace)
        : workspace_(workspace),
          session_(workspace.session),
          units_(session_.units()),
          envelope_(*session_.solution().results, envelope_cases(model(), session_.results_view())),
          numbers_(*session_.solution().results, units_)
    {}

    void member_forces(MemberComponent component)
    {
        const std::string id(name(component, model().analysis));
        const ui::Measure measure = measure_of(component);
        if (!result_section(tr()("Members: {value}", {{"value", units_.label(id, measure)}}), id.c_str())) return;
        result_list(id.c_str(), headings(tr()("Member")), model().members.size(), [&](ResultRow& row, std::size_t i) {
            row.part(session_, MemberId(i), model().members[i].id);
            const GoverningExtremes found = envelope_.extremes(MemberId(i), component);
            for (const GoverningExtreme& extreme : {found.max, found.min}) {
                const Curve curve = (*session_.solution().results)[extreme.load_case].curve(MemberId(i));
                const MovingEffect effect = drawing::number_on_diagram(MemberId(i), curve, component, extreme.x,
                                                                       extreme.value);
                cells(row, {extreme.value, extreme.load_case}, measure, effect, MemberId(i));
            }
        });
    }

    void reactions(Dof dof)
    {
        std::vector<NodeId> supported;
        const CaseResult any = (*session_.solution().results)[envelope_.cases().front()];
        for (std::size_t i = 0; i < model().nodes.size(); ++i)
            if (any.is_supported(NodeId(i))) supported.emplace_back(i);
        const std::string id(force_name(dof));
        const ui::Measure measure = force_measures.of(dof);
        if (!result_section(tr()("Reactions: {value}", {{"value", units_.label(id, measure)}}), id.c_str())) return;
        result_list(id.c_str(), headings(tr()("Node")), supported.size(), [&](ResultRow& row, std::size_t i) {
            row.part(session_, supported[i], model()[supported[i]].id);
            const GoverningRange range = envelope_.reaction(supported[i], dof);
            const MovingEffect effect{.quantity = ExpectedQuantity::Reaction, .node = supported[i], .dof = dof};
            for (const Governing& bound : {range.max, range.min}) cells(row, bound, measure, effect, supported[i]);
        });
    }

private:
    const Model& model() const { return session_.model(); }
    const ui::Catalogue& tr() const { return session_.view.tr; }

    std::vector<std::string> headings(const std::string& part) const
    {
        return {part, tr()("max"), tr()("Case") + "###of max", tr()("min"), tr()("Case") + "###of min"};
    }
    void cells(ResultRow& row, const Governing& bound, ui::Measure measure, const MovingEffect& effect,
               const Part& part)
    {
        row.number(workspace_, numbers_[bound.load_case].number(bound.value, measure),
                   {.effect = effect, .of = bound.load_case}, part);
        row.name(model().case_name(bound.load_case));
    }

    Workspace& workspace_;
    Session& session_;
    ui::DisplayUnits units_;
    Envelope envelope_;
    NumbersOfCases numbers_;
};

} // namespace

void envelope_panel(Workspace& workspace)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    ImGui::TextDisabled("%s", tr("Envelope of").c_str());
    choose_cases(session);
    if (ui::wrapped_button(tr("Tables with places (F4)"), "tables")) workspace.bottom = {true, TableKind::Envelope};
    EnvelopeTables tables(workspace);
    for (const MemberComponent component : section_force_components(session.model().analysis))
        tables.member_forces(component);
    for (const Dof dof : dof_list(session.model().analysis)) tables.reactions(dof);
}

} // namespace frame
