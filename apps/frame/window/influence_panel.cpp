#include "apps/frame/window/influence_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/line_diagram.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/frame/session/train_commands.h"
#include "apps/frame/window/result_list.h"
#include "apps/frame/window/show_panel.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using drawing::InfluencePicture;
using drawing::StandingTrain;
using ui::translatable;

namespace {

void choose_quantity(Session& session)
{
    AskedLine& line = session.influence;
    const femoop::Model& model = session.model();
    const auto now = line.effect(model);
    for (const femoop::MovingEffect& choice : line.choices(model))
        if (ImGui::RadioButton(effect_text(model, session.units(), choice).c_str(), choice == now)) line.choose(choice);
}

// What stays on the sheet, each with a button that takes it off.
void show_kept(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const femoop::Model& model = session.model();
    const std::vector<femoop::MovingEffect> kept = session.influence.kept(model);
    if (!kept.empty()) panel_heading(session.tr()("Kept lines"));
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const std::string id = "###drop " + std::to_string(i);
        if (ImGui::SmallButton(("×" + id).c_str())) session.influence.drop(model, kept[i]);
        ImGui::SameLine();
        ImGui::TextUnformatted(effect_text(model, session.units(), kept[i]).c_str());
    }
    const auto& keep = *commands.find("view.influence.keep");
    const bool is_off = ui::why_not(keep, workspace).has_value();
    ImGui::BeginDisabled(is_off);
    if (ui::wrapped_button(session.tr()("Keep this line"), "keep line")) run(keep, workspace);
    ImGui::EndDisabled();
}

void choose_train(Session& session)
{
    AskedLine& line = session.influence;
    const std::string now = chosen_train(session);
    const std::vector<femoop::Train>& trains = session.model().moving_loads.trains;
    if (ImGui::RadioButton((session.tr()("no train") + "###no train").c_str(), now.empty() && !line.is_traced()))
        line.choose_train({});
    if (ImGui::RadioButton((session.tr()("unit load") + "###unit load").c_str(), line.is_traced())) line.trace();
    for (std::size_t i = 0; i < trains.size(); ++i) {
        const std::string label = ui::item_label(trains[i].id, "train " + std::to_string(i));
        if (ImGui::RadioButton(label.c_str(), trains[i].id == now)) line.choose_train(trains[i].id);
    }
}

/// The line's numbers and its train's.
class InfluenceTables {
public:
    InfluenceTables(Workspace& workspace, const InfluencePicture& picture)
        : workspace_(workspace),
          session_(workspace.session),
          picture_(picture),
          units_(session_.units()),
          unit_(ordinate_unit(units_, picture)),
          effect_(effect_text(session_.model(), units_, picture.line.effect))
    {}

    void title() const { ImGui::TextDisabled("%s", tr()("Influence line of {effect}", {{"effect", effect_}}).c_str()); }

    void candidates() const
    {
        AskedLine& line = session_.influence;
        const bool is_max = line.standing()->kind == femoop::ExtremeKind::Max;
        const std::string name = is_max ? tr()("Candidates for the largest value")
                                        : tr()("Candidates for the least value");
        if (line.candidates().empty() || !result_section(name, "candidates")) return;
        const ui::Measure measure = drawing::measure_of(picture_.line.effect);
        const std::vector<std::string> headings{units_.label("s", ui::Measure::Length), tr()("direction"),
                                                tr()("candidate"), units_.label(component(), measure)};
        const std::vector<CandidatePosition> all = worst_first(line.candidates(), is_max);
        result_list("candidates", headings, all.size(), [&](ResultRow& row, std::size_t i) {
            place_cell(row, {all[i].position, all[i].reversed});
            row.name(all[i].reversed ? "<" : ">");
            row.name(tr()(name_of(all[i].kind)));
            row.number(workspace_, text(all[i].value, measure),
                       under({.place = {all[i].position, all[i].reversed}, .is_unit_load = false}));
        });
        ui::wrapped_text(tr()(
            "s is the place of the leading axle. At a break an axle passes an end of a piece of the line (− before "
            "it, + after it, where the effect jumps); at a root the effect is level between two breaks. It can be "
            "largest or least nowhere else. A click sets the train there."));
    }

    void ordinates() const
    {
        if (!result_section(tr()("Ordinates"), "ordinates")) return;
        constexpr std::size_t n = 11; // of each member
        const std::vector<femoop::influence::LineStation> all = stations(picture_.line, n);
        const std::string heading = "η" + (unit_.name.empty() ? "" : " [" + unit_.name + "]");
        const double rounding = drawing::written_as_zero * picture_.line.ordinates.largest();
        result_list("ordinates", {units_.label("s", ui::Measure::Length), heading}, all.size(),
                    [&](ResultRow& row, std::size_t i) {
                        row.name(text(all[i].s, ui::Measure::Length));
                        const double value = std::abs(all[i].value) > rounding ? all[i].value : 0.0;
                        row.number(workspace_, text(value * unit_.factor, ui::Measure::Plain),
                                   under({.place = {.position = all[i].s}, .is_unit_load = true}));
                    });
        if (picture_.line.ordinates.largest() > 0.0) ui::wrapped_text(areas_text(units_, picture_, tr()));
    }

private:
    const ui::Catalogue& tr() const { return session_.tr(); }
    std::string text(double value, ui::Measure measure) const
    {
        return drawing::with_minus(units_.number(value, measure));
    }
    std::string component() const
    {
        return femoop::influence::component_name(session_.model().analysis, picture_.line.effect);
    }

    /// The effect as it is under such a load.
    PointedNumber under(const LoadOnLine& load) const { return {.effect = picture_.line.effect, .under = load}; }

    static std::vector<CandidatePosition> worst_first(std::vector<CandidatePosition> all, bool is_max)
    {
        std::ranges::stable_sort(all, [&](const CandidatePosition& a, const CandidatePosition& b) {
            return is_max ? a.value > b.value : a.value < b.value;
        });
        return all;
    }

    void place_cell(ResultRow& row, const AskedTrain::Place& place) const
    {
        AskedLine& line = session_.influence;
        if (row.choice(text(place.position, ui::Measure::Length), line.stands_at(place))) line.put_train(place);
    }

    static std::string_view name_of(CandidatePosition::Kind kind)
    {
        switch (kind) {
        case CandidatePosition::Kind::Break: return translatable("break");
        case CandidatePosition::Kind::BreakBefore: return translatable("break −");
        case CandidatePosition::Kind::BreakAfter: return translatable("break +");
        case CandidatePosition::Kind::Root: break;
        }
        return translatable("root");
    }

    Workspace& workspace_;
    Session& session_;
    const InfluencePicture& picture_;
    ui::DisplayUnits units_;
    drawing::OrdinateUnit unit_;
    std::string effect_;
};

} // namespace

void influence_choices(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const ui::Catalogue tr = session.tr();
    panel_heading(tr("Influence line"));
    choose_quantity(session);
    show_kept(workspace, commands);
    panel_heading(tr("Train"));
    choose_train(session);
    const StandingTrain* const standing = session.influence.standing();
    if (standing != nullptr && !session.influence.is_traced()) {
        const femoop::ExtremeKind kind = standing->kind;
        const auto way = [&](std::string_view label, femoop::ExtremeKind sought) {
            const std::string button = tr(label) + "###" + std::string(label);
            if (ImGui::RadioButton(button.c_str(), kind == sought)) session.influence.seek(sought);
        };
        ImGui::Spacing();
        way(translatable("its largest value"), femoop::ExtremeKind::Max);
        way(translatable("its least value"), femoop::ExtremeKind::Min);
    }
    ImGui::Spacing();
    const auto& close = *commands.find("view.influence.close");
    if (ui::wrapped_button(tr(close.label), "close line")) run(close, workspace);
}

void influence_panel(Workspace& workspace)
{
    Session& session = workspace.session;
    const InfluencePicture* const picture = session.influence.picture(session.model(), session.generation(),
                                                                      session.view);
    if (picture == nullptr) return ui::wrapped_text(session.tr()("the model has no results"));
    if (session.hidden)
        return ui::wrapped_text(session.tr()("Sketch the line with the pencil (K); H reveals it, with its ordinates."));
    const InfluenceTables tables(workspace, *picture);
    tables.title();
    const bool is_traced = session.influence.is_traced();
    if (session.influence.standing() != nullptr && !is_traced) tables.candidates();
    if (picture->traced)
        ui::wrapped_text(session.tr()("The ordinates stand here when the load has passed its whole path."));
    else tables.ordinates();
}

} // namespace frame
