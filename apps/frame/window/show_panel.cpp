#include "apps/frame/window/show_panel.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "apps/frame/window/factor_slider.h"
#include "apps/frame/window/influence_panel.h"
#include "ui/text/number_format.h"

namespace frame {

using ui::translatable;

namespace {

void toggle(Workspace& workspace, const CommandTable& commands, Show item)
{
    const auto* const command = commands.find(command_id(item));
    if (command == nullptr) return;
    bool is_on = command->is_on(workspace);
    if (ImGui::Checkbox(ui::label(*command, workspace, workspace.session.view.tr).c_str(), &is_on))
        run(*command, workspace);
    if (command->shortcuts.empty()) return;
    const std::string key = text(command->shortcuts.front());
    const float at = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(key.c_str()).x;
    const float end_of_label = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    if (end_of_label + 0.3F * ImGui::GetFontSize() > at) return; // no room for it
    ImGui::SameLine(at);
    ImGui::TextDisabled("%s", key.c_str());
}

void show_toggles(Workspace& workspace, const CommandTable& commands, std::initializer_list<Show> items)
{
    for (const Show item : items) toggle(workspace, commands, item);
}

// A name with a value at the end of its line.
void named_value(const std::string& name, const std::string& value)
{
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
    ImGui::TextDisabled("%s", value.c_str());
}

void step_slider(Session& session)
{
    constexpr int most = 20;
    named_value(session.view.tr("Steps of a member"), std::to_string(session.view.steps));
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::SliderInt("###steps", &session.view.steps, 2, most, "",
                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
}

double with_two_digits(double x)
{
    const double decade = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
    return std::round(x / decade) * decade;
}

void deformation_slider(Session& session, const FactorLook& look)
{
    constexpr double usual = 100.0;
    std::optional<double>& scale = session.view.deformation_scale;
    if (!scale) ImGui::TextUnformatted(look.tr("Deformed shape").c_str());
    else {
        const FactorSlider slider{.id = "###deformation",
                                  .name = look.tr("Deformed shape"),
                                  .usual = usual,
                                  .least = 1.0,
                                  .most = 1e4,
                                  .least_typed = 1e-3,
                                  .most_typed = 1e9};
        if (show(slider, look, *scale)) scale = with_two_digits(*scale); // as on the label
    }
    bool is_automatic = !scale;
    if (ImGui::Checkbox(look.tr("automatic").c_str(), &is_automatic))
        scale = is_automatic ? std::nullopt : std::optional(usual);
}

void show_results(Workspace& workspace, const CommandTable& commands)
{
    using enum Show;
    panel_heading(workspace.session.view.tr("Results"));
    show_toggles(workspace, commands, {N, V, M});
    const femoop::AnalysisKind kind = workspace.session.model().analysis;
    if (kind == femoop::AnalysisKind::Grillage || kind == femoop::AnalysisKind::Frame3d) toggle(workspace, commands, T);
    show_toggles(workspace, commands, {Deformed, Reactions});
}

void show_picture(Workspace& workspace, const CommandTable& commands, bool has_line)
{
    using enum Show;
    panel_heading(workspace.session.view.tr("Picture"));
    if (!has_line) toggle(workspace, commands, Loads);
    show_toggles(workspace, commands, {Values, NodeNames, MemberNames, Dimensions});
    if (!workspace.session.document().companion.dimensions.empty()) toggle(workspace, commands, DrawnDimensions);
    show_toggles(workspace, commands, {LocalAxes, Legend});
}

void show_scales(Session& session, ui::NumberFields& fields, bool has_line)
{
    const ui::Catalogue& tr = session.view.tr;
    panel_heading(tr("Scales"));
    const FactorLook look{fields, tr, {.digits = 2, .mark = session.view.numbers.mark}};
    show({.id = "###diagrams", .name = tr("Diagrams")}, look, session.view.diagram_factor);
    if (session.view.show.contains(Show::StepValues) && !has_line) step_slider(session);
    show({.id = "###loads", .name = tr("Load arrows")}, look, session.view.load_factor);
    show({.id = "###symbols", .name = tr("Symbols")}, look, session.view.symbol_factor);
    if (!has_line) deformation_slider(session, look);
}

} // namespace

void panel_heading(const std::string& text)
{
    ImGui::Spacing();
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::Separator();
}

void show_panel(Workspace& workspace, const CommandTable& commands, CaseList& cases, ui::NumberFields& fields)
{
    Session& session = workspace.session;
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.FramePadding.x, 0.3F * style.FramePadding.y});
    const bool has_line = session.influence.is_on(session.model());
    if (has_line) {
        influence_choices(workspace, commands);
    } else {
        cases.show(workspace, commands);
        show_results(workspace, commands);
    }
    show_picture(workspace, commands, has_line);
    show_scales(session, fields, has_line);
    if (const auto* const animate = commands.find("view.animate")) {
        bool is_on = animate->is_on(workspace);
        if (ImGui::Checkbox(session.view.tr(animate->label).c_str(), &is_on)) run(*animate, workspace);
    }
    ImGui::PopStyleVar();
}

} // namespace frame
