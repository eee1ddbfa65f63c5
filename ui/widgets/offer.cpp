#include "ui/widgets/offer.h"

#include <imgui.h>

#include <cstddef>

#include "ui/text/shortened.h"

namespace ui {

namespace {

float room_of_button(const std::string& label)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
}

/// As much of the sentence as there is room for [px].
std::string cut_to(const std::string& sentence, float room)
{
    std::string cut = sentence;
    for (std::size_t n = sentence.size(); n > 1 && ImGui::CalcTextSize(cut.c_str()).x > room; --n)
        cut = shortened(sentence, n - 1);
    return cut;
}

} // namespace

std::optional<OfferAnswer> show_offer(const std::string& sentence, const Catalogue& tr)
{
    const std::string take_over = tr("Take over") + "###take over", keep = tr("Keep as it is") + "###keep";
    std::optional<OfferAnswer> answer;
    ImGui::Separator();
    const std::string whole = sentence + ":";
    const float room = ImGui::GetContentRegionAvail().x - room_of_button(take_over) - room_of_button(keep);
    const std::string shown = cut_to(whole, room - ImGui::GetStyle().ItemSpacing.x);
    ImGui::TextUnformatted(shown.c_str());
    if (shown != whole && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", whole.c_str());
    if (ImGui::SmallButton(take_over.c_str())) answer = OfferAnswer::TakeOver;
    if (ImGui::SmallButton(keep.c_str())) answer = OfferAnswer::Keep;
    return answer;
}

} // namespace ui
