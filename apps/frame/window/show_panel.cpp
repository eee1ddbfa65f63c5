#include "apps/frame/window/show_panel.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "ui/text/number_format.h"

namespace frame {

using ui::translatable;

namespace {

void heading(const std::string& text)
{
    ImGui::Spacing();
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::Separator();
}

void toggle(Desk& desk, const CommandTable& commands, Show item)
{
    const auto* const command = commands.find(command_id(item));
    if (command == nullptr) return;
    bool is_on = command->is_on(desk);
    if (ImGui::Checkbox(ui::label(*command, desk, desk.session.view.tr).c_str(), &is_on)) run(*command, desk);
    if (command->shortcuts.empty()) return;
    const std::string key = text(command->shortcuts.front());
    const float at = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(key.c_str()).x;
    const float end_of_label = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    if (end_of_label + 0.3F * ImGui::GetFontSize() > at) return; // no room for it
    ImGui::SameLine(at);
    ImGui::TextDisabled("%s", key.c_str());
}

void show_toggles(Desk& desk, const CommandTable& commands, std::initializer_list<Show> items)
{
    for (const Show item : items) toggle(desk, commands, item);
}

// A name with a value at the end of its line.
void named_value(const std::string& name, const std::string& value)
{
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
    ImGui::TextDisabled("%s", value.c_str());
}

// A slider over powers of ten; true while it moves.
bool power_slider(const char* id, double& factor, float least, float most)
{
    float power = static_cast<float>(std::log10(factor));
    ImGui::SetNextItemWidth(-1.0F);
    if (!ImGui::SliderFloat(id, &power, least, most, "")) return false;
    factor = std::pow(10.0, static_cast<double>(power));
    return true;
}

void step_slider(Session& session)
{
    constexpr int most = 20;
    named_value(session.view.tr("Steps of a member"), std::to_string(session.view.steps));
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::SliderInt("###steps", &session.view.steps, 2, most, "", ImGuiSliderFlags_AlwaysClamp);
}

// A factor from a tenth to ten times the automatic size; a double click brings the automatic size back.
void factor_slider(const std::string& name, const char* id, double& factor, const ui::NumberFormat& format)
{
    named_value(name, "× " + ui::number_text(factor, format));
    power_slider(id, factor, -1.0F, 1.0F);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) factor = 1.0;
}

void deformation_slider(Session& session, const ui::NumberFormat& format)
{
    std::optional<double>& scale = session.view.deformation_scale;
    const ui::Catalogue& tr = session.view.tr;
    named_value(tr("Deformed shape"), scale ? "× " + ui::number_text(*scale, format) : "");
    bool is_automatic = !scale;
    if (ImGui::Checkbox(tr("automatic").c_str(), &is_automatic))
        scale = is_automatic ? std::nullopt : std::optional(100.0);
    if (!scale || !power_slider("###deformation", *scale, 0.0F, 4.0F)) return;
    const double decade = std::pow(10.0, std::floor(std::log10(*scale)) - 1.0);
    scale = std::round(*scale / decade) * decade; // two digits, as on the label
}

} // namespace

void show_panel(Desk& desk, const CommandTable& commands, CaseList& cases)
{
    using enum Show;
    Session& session = desk.session;
    const ui::Catalogue& tr = session.view.tr;
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.FramePadding.x, 0.3F * style.FramePadding.y});
    cases.show(desk, commands);
    heading(tr("Results"));
    show_toggles(desk, commands, {N, V, M});
    const femoop::AnalysisKind kind = session.model().analysis;
    if (kind == femoop::AnalysisKind::Grillage || kind == femoop::AnalysisKind::Frame3d) toggle(desk, commands, T);
    show_toggles(desk, commands, {Deformed, Reactions});
    heading(tr("Picture"));
    show_toggles(desk, commands, {Loads, Values, NodeNames, MemberNames, Dimensions});
    if (!session.document().companion.dimensions.empty()) toggle(desk, commands, DrawnDimensions);
    show_toggles(desk, commands, {LocalAxes, Legend});
    heading(tr("Scales"));
    const ui::NumberFormat format{.digits = 2, .mark = session.view.numbers.mark};
    factor_slider(tr("Diagrams"), "###diagrams", session.view.diagram_factor, format);
    if (session.view.show.contains(StepValues)) step_slider(session);
    factor_slider(tr("Load arrows"), "###loads", session.view.load_factor, format);
    factor_slider(tr("Symbols"), "###symbols", session.view.symbol_factor, format);
    deformation_slider(session, format);
    if (const auto* const animate = commands.find("view.animate")) {
        bool is_on = animate->is_on(desk);
        if (ImGui::Checkbox(tr(animate->label).c_str(), &is_on)) run(*animate, desk);
    }
    ImGui::PopStyleVar();
}

} // namespace frame
