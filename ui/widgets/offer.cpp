#include "ui/widgets/offer.h"

#include <imgui.h>

#include <cstddef>

#include "ui/text/shortened.h"
#include "ui/widgets/panel.h"

namespace ui {

namespace {

bool fits(const std::string& text, float room) { return ImGui::CalcTextSize(text.c_str()).x <= room; }

/// As much as there is room for [px].
std::string cut_to(const std::string& text, float room)
{
    std::string cut = text;
    for (std::size_t n = text.size(); n > 1 && !fits(cut, room); --n) cut = shortened(text, n - 1);
    return cut;
}

} // namespace

std::optional<OfferAnswer> show_offer(const OfferWords& words, const Catalogue& tr)
{
    const std::string take_over = tr("Take over") + "###take over", keep = tr("Keep as it is") + "###keep";
    std::optional<OfferAnswer> answer;
    ImGui::Separator();
    const std::string whole = tr(words.sentence) + ":";
    const float buttons = width_of_button(take_over) + width_of_button(keep);
    const float room = ImGui::GetContentRegionAvail().x - buttons - 3.0F * ImGui::GetStyle().ItemSpacing.x;
    const std::string shown = fits(whole, room) ? whole : cut_to(tr(words.brief) + ":", room);
    ImGui::TextUnformatted(shown.c_str());
    if (shown != whole && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", whole.c_str());
    if (ImGui::SmallButton(take_over.c_str())) answer = OfferAnswer::TakeOver;
    if (ImGui::SmallButton(keep.c_str())) answer = OfferAnswer::Keep;
    return answer;
}

} // namespace ui
