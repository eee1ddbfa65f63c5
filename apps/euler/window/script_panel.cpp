#include "apps/euler/window/script_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "apps/euler/window/step_panel.h"
#include "ui/text/shortened.h"
#include "ui/widgets/item_label.h"

namespace euler {

namespace {

constexpr std::size_t most_letters = 200; // of a row

// What of a row has room, whose end gives way to an ellipsis.
std::string fitted(const std::string& row)
{
    const float room = ImGui::GetContentRegionAvail().x;
    std::size_t n = most_letters;
    std::string shown = ui::shortened(row, n);
    for (float width = ImGui::CalcTextSize(shown.c_str()).x; width > room && n > 1;
         width = ImGui::CalcTextSize(shown.c_str()).x) {
        n = std::min(n, shown.size());
        n = std::clamp<std::size_t>(static_cast<std::size_t>(static_cast<float>(n) * room / width), 1, n - 1);
        shown = ui::shortened(row, n);
    }
    return shown;
}

// The line before the first step.
void beginning(Session& session)
{
    const std::string name = session.tr()("the beginning") + "###step 0";
    if (ImGui::Selectable(name.c_str(), session.place() == 0)) session.go_to(0);
}

void line(Session& session, std::size_t i)
{
    const StepSummary step = session.stepper().summary(i);
    const std::string name = ui::item_label(fitted(std::to_string(i) + "  " + code(step)), "step " + std::to_string(i));
    const bool is_undone = i > session.place();
    if (is_undone) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const bool is_clicked = ImGui::Selectable(name.c_str(), i == session.place());
    if (is_undone) ImGui::PopStyleColor();
    if (!is_clicked) return;
    session.is_playing = false;
    session.go_to(i);
}

// The step that was in sight last; on the first look the present one.
int& seen_step(int place) { return *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("seen"), place); }

// The last item, which is the present line; it may take some frames until the list knows how long it is.
void bring_into_sight(int place)
{
    if (ImGui::IsItemVisible()) seen_step(place) = place;
    else ImGui::SetScrollHereY();
}

} // namespace

void script_panel(Desk& desk)
{
    Session& session = desk.session;
    ImGui::BeginChild("###script");
    const auto place = static_cast<int>(session.place());
    const bool has_moved = seen_step(place) != place;
    beginning(session);
    if (has_moved && place == 0) bring_into_sight(place);
    ImGuiListClipper clipper; // a script may have a million lines
    clipper.Begin(static_cast<int>(session.n_steps()));
    if (has_moved && place > 0) clipper.ForceDisplayRangeByIndices(place - 1, place);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            line(session, static_cast<std::size_t>(i) + 1);
            if (has_moved && i + 1 == place) bring_into_sight(place);
        }
    ImGui::EndChild();
}

} // namespace euler
