#include "apps/frame/window/status_bar.h"

#include <imgui.h>

#include <string>

#include "apps/frame/window/fixed_panel.h"
#include "femoop/result/structure_words.h"

namespace frame {

namespace {

// As the second of two: hinges take more from the whole than the supports give.
std::string summand(int number) { return number < 0 ? "(−" + std::to_string(-number) + ")" : std::to_string(number); }

std::string degree_text(const femoop::Indeterminacy& degree, const ui::Catalogue& tr)
{
    if (degree.has_foundation) return tr("on an elastic foundation");
    return tr("degree of indeterminacy {total} = {external} external + {internal} internal",
              {{"total", std::to_string(degree.total())},
               {"external", std::to_string(degree.external)},
               {"internal", summand(degree.internal)}});
}

} // namespace

void status_bar(const Session& session)
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float height = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos({viewport.WorkPos.x, viewport.WorkPos.y + viewport.WorkSize.y - height});
    ImGui::SetNextWindowSize({viewport.WorkSize.x, height});
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.7F * em, 0.15F * em});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    ImGui::Begin("###status", nullptr, fixed_panel | ImGuiWindowFlags_NoScrollbar);
    const ui::Catalogue& tr = session.view.tr;
    std::string text = femoop::size_words(session.model(), tr);
    if (const auto& results = session.solution().results) {
        text += "   ·   " + degree_text(results->indeterminacy(), tr);
    } else {
        text += "   ·   " + tr("not solved");
    }
    ImGui::TextUnformatted(text.c_str());
    const ui::DisplayUnits units = session.units();
    const std::string right = units.unit(ui::Measure::Force).name + ", " + units.unit(ui::Measure::Length).name + ", " +
                              units.unit(ui::Measure::Displacement).name;
    ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(right.c_str()).x - em);
    ImGui::TextDisabled("%s", right.c_str());
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

} // namespace frame
