#include "apps/frame/window/train_envelope_panel.h"

#include <imgui.h>

#include <string>
#include <utility>

#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/window/number_row.h"
#include "apps/frame/window/result_list.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/result/components.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using femoop::ExtremeKind;
using femoop::MemberComponent;
using femoop::MemberId;
using femoop::influence::TrainEffect;
using femoop::influence::WorstSection;
using ui::translatable;

namespace {

void choose_trains(Session& session)
{
    AskedEnvelope& envelope = session.train_envelope;
    const femoop::MovingEnvelope shown = envelope.envelope(session.model());
    const auto offer = [&](const std::string& id, const std::string& label, bool is_of_model) {
        AskedEnvelope::Choice choice = envelope.choice();
        const bool is_now = shown.id == id && choice.is_of_model == is_of_model;
        choice.is_of_model = is_of_model;
        choice.name = id;
        if (ImGui::RadioButton(label.c_str(), is_now)) envelope.choose(choice);
    };
    const auto& [paths, lines, trains, envelopes] = session.model().moving_loads;
    for (std::size_t i = 0; i < trains.size(); ++i)
        offer(trains[i].id, ui::item_label(trains[i].id, "train " + std::to_string(i)), false);
    for (std::size_t i = 0; i < envelopes.size(); ++i)
        offer(envelopes[i].id, ui::item_label(envelopes[i].id, "envelope " + std::to_string(i)), true);
}

// An envelope of the model has its own case.
void choose_permanent(Session& session)
{
    AskedEnvelope& envelope = session.train_envelope;
    const femoop::Model& model = session.model();
    const auto shown = envelope.envelope(model).with;
    ImGui::TextDisabled("%s", session.tr()("with").c_str());
    ImGui::BeginDisabled(envelope.choice().is_of_model);
    const auto offer = [&](const std::string& with, const std::string& label, bool is_now) {
        AskedEnvelope::Choice choice = envelope.choice();
        choice.with = with;
        if (ImGui::RadioButton(label.c_str(), is_now)) envelope.choose(choice);
    };
    offer({}, session.tr()("nothing else") + "###nothing else", !shown);
    for (std::size_t i = 0; i < model.n_cases(); ++i) {
        const femoop::CaseId id(i);
        ImGui::BeginDisabled(session.solution().blank_case(id) != nullptr);
        offer(model.case_name(id), ui::item_label(model.case_name(id), "with " + std::to_string(i)), shown == id);
        ImGui::EndDisabled();
    }
    ImGui::EndDisabled();
}

void edit_factor(Workspace& workspace, ui::NumberFields& fields)
{
    AskedEnvelope& envelope = workspace.session.train_envelope;
    if (envelope.choice().is_of_model) return;
    const auto why_not = [](double factor) -> std::optional<ui::Message> {
        if (factor > 0.0) return std::nullopt;
        return ui::Message(translatable("the factor of the trains is above 0; type another"));
    };
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(workspace.session.tr()("Factor of the trains").c_str());
    ImGui::SameLine();
    AskedEnvelope::Choice choice = envelope.choice();
    if (edit_quantity(workspace, fields, {"train factor", ui::Measure::Plain, 0.0F, why_not}, choice.factor))
        envelope.choose(choice);
}

/// The numbers of one member: its largest and its least value, and where they are.
class ExtremeTable {
public:
    ExtremeTable(Workspace& workspace, MemberComponent component)
        : workspace_(workspace),
          session_(workspace.session),
          units_(session_.units()),
          component_(component),
          has_several_(session_.train_envelope.envelope(session_.model()).trains.size() > 1)
    {}

    void show() const
    {
        const femoop::Model& model = session_.model();
        const std::string id(femoop::name(component_, model.analysis));
        const std::string title = session_.tr()("Members: {value}",
                                                {{"value", units_.label(id, drawing::measure_of(component_))}});
        if (!result_section(title, id.c_str())) return;
        const auto& all = session_.train_envelope.members(component_);
        result_list(id.c_str(), headings(), all.size(), [&](ResultRow& row, std::size_t i) {
            row.part(session_, MemberId(i), model.members[i].id);
            cells(row, MemberId(i), ExtremeKind::Max, all[i].extreme.max, *all[i].extreme.max_train);
            cells(row, MemberId(i), ExtremeKind::Min, all[i].extreme.min, *all[i].extreme.min_train);
        });
    }

private:
    std::vector<std::string> headings() const
    {
        const ui::Catalogue& tr = session_.tr();
        std::vector<std::string> all{tr("Member")};
        for (const std::string_view which : {translatable("max"), translatable("min")}) {
            const std::string id = "###of " + std::string(which);
            all.push_back(tr(which));
            all.push_back(units_.label("x", ui::Measure::Length) + id);
            if (has_several_) all.push_back(tr("Train") + "###train of " + std::string(which));
        }
        return all;
    }

    void cells(ResultRow& row, MemberId member, ExtremeKind kind, const WorstSection& worst,
               const femoop::Train& train) const
    {
        value_cell(row, member, kind, worst);
        row.number(worst.sections.empty() ? "" : units_.number(worst.section, ui::Measure::Length));
        if (has_several_) row.name(train.id);
    }

    /// It can be asked where it comes from: at the section where it is worst.
    void value_cell(ResultRow& row, MemberId member, ExtremeKind kind, const WorstSection& worst) const
    {
        const std::string text = drawing::with_minus(units_.number(
            session_.train_envelope.without_noise(worst.placing.value, component_), drawing::measure_of(component_)));
        if (worst.sections.empty()) return row.number(text);
        const double length = femoop::geometry_of(session_.model(), session_.model()[member]).length;
        row.number(workspace_, text,
                   {.effect = number_at_section({member, worst.inside}, component_, length), .extreme = kind}, member);
    }

    Workspace& workspace_;
    Session& session_;
    ui::DisplayUnits units_;
    MemberComponent component_;
    bool has_several_;
};

} // namespace

void train_envelope_panel(Workspace& workspace, ui::NumberFields& fields)
{
    Session& session = workspace.session;
    ImGui::TextDisabled("%s", session.tr()("Envelope of").c_str());
    choose_trains(session);
    choose_permanent(session);
    edit_factor(workspace, fields);
    const auto* const picture = session.train_envelope.picture(session.model(), session.generation(),
                                                               session.results_view());
    if (picture == nullptr) {
        for (const std::string& reason : session.train_envelope.why_none(session.tr())) ui::wrapped_text(reason);
        return;
    }
    ui::wrapped_text(
        session.tr()("A click on a section, or W at a number, sets the governing train where it is worst for it."));
    for (const MemberComponent component : femoop::section_force_components(session.model().analysis))
        ExtremeTable(workspace, component).show();
}

std::vector<drawing::ReadingLine> envelope_lines(const Session& session, const drawing::Cut& cut)
{
    const ui::DisplayUnits units = session.units();
    const femoop::Model& model = session.model();
    const bool has_several = session.train_envelope.envelope(model).trains.size() > 1;
    const auto words = [&](double value, ui::Measure measure, const femoop::Train& train) {
        const std::string number = drawing::with_minus(units.number(value, measure));
        return has_several ? drawing::governed(number, train.id) : number;
    };
    std::vector<drawing::ReadingLine> list{
        {"x", drawing::with_minus(units.text(cut.x, ui::Measure::Length)), ui::Role::Label}};
    for (const TrainEffect& effect : session.train_envelope.at(cut)) {
        const MemberComponent component = *effect.effect.component;
        const ui::Measure measure = drawing::measure_of(component);
        const auto value = [&](double found) { return session.train_envelope.without_noise(found, component); };
        const std::string least = words(value(effect.min.value), measure, *effect.min_train),
                          most = words(value(effect.max.value), measure, *effect.max_train);
        list.push_back({std::string(femoop::name(component, model.analysis)),
                        (least == most ? least : least + " … " + most) + " " + units.unit(measure).name,
                        drawing::role_of(component)});
    }
    return list;
}

} // namespace frame
