#include "ui/widgets/offer.h"

#include <imgui.h>

namespace ui {

std::optional<OfferAnswer> show_offer(const std::string& sentence, const Catalogue& tr)
{
    std::optional<OfferAnswer> answer;
    ImGui::Separator();
    ImGui::TextUnformatted((sentence + ":").c_str());
    if (ImGui::SmallButton((tr("Take over") + "###take over").c_str())) answer = OfferAnswer::TakeOver;
    if (ImGui::SmallButton((tr("Keep as it is") + "###keep").c_str())) answer = OfferAnswer::Keep;
    return answer;
}

} // namespace ui
