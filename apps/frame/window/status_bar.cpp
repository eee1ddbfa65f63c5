#include "apps/frame/window/status_bar.h"

#include <imgui.h>

#include <string>

#include "femoop/result/structure_words.h"
#include "ui/widgets/panel.h"

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
    ui::begin_status_bar();
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
    ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(right.c_str()).x - ImGui::GetFontSize());
    ImGui::TextDisabled("%s", right.c_str());
    ui::end_status_bar();
}

} // namespace frame
