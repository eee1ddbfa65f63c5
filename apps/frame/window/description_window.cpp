#include "apps/frame/window/description_window.h"

#include <imgui.h>

#include "apps/frame/window/no_results.h"
#include "ui/widgets/words_window.h"

namespace frame {

void description_window(Desk& desk, bool& is_open)
{
    const ui::Catalogue& tr = desk.tr();
    ui::words_window(tr("Model and results in words"), desk.session.in_words(), tr, is_open, [&] {
        if (desk.session.hidden) ImGui::SameLine();
        offer_to_reveal(desk);
    });
}

} // namespace frame
