#include "ui/widgets/offer.h"

namespace ui {

FootMessage offer_message(std::string_view sentence, const Catalogue& tr)
{
    return {{tr(sentence)}, {tr("Take over") + "###take over", tr("Keep as it is") + "###keep"}};
}

Request answer_of_button(std::size_t button) { return button == 0 ? Request::TakeOver : Request::KeepAsItIs; }

} // namespace ui
