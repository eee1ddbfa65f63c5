#include "apps/frame/window/banner.h"

#include <algorithm>
#include <string>
#include <vector>

#include "apps/frame/session/tabs.h"
#include "apps/frame/view/results/mechanism_picture.h"

namespace frame {

namespace {

std::string button(const ui::Catalogue& tr, std::string_view label, const char* id) { return tr(label) + id; }

ui::FootMessage message_of(const Notice& notice, const ui::Catalogue& tr)
{
    ui::FootMessage message{{tr(notice.sentence)}, {button(tr, ui::translatable("Close"), "###close notice")}};
    for (const femoop::Fault& fault : notice.faults) message.lines.push_back("• " + sentence(fault, tr));
    if (notice.to_mend) message.buttons.push_back(button(tr, ui::translatable("Open all the same"), "###open notice"));
    return message;
}

// One line, so that the picture keeps its room while a model is mended.
std::optional<ui::FootMessage> message_of(const Solution& solution, const ui::Catalogue& tr)
{
    const auto is_error = [](const femoop::Fault& fault) {
        return femoop::severity(fault.kind) == femoop::Severity::Error;
    };
    const auto first = std::ranges::find_if(solution.faults, is_error);
    // The picture itself says how a mechanism moves.
    if (first == solution.faults.end() || !solution.mechanisms.empty()) return std::nullopt;
    std::string line = sentence(*first, tr);
    const auto n = std::ranges::count_if(solution.faults, is_error);
    if (n > 1) line += "   " + tr("… and {count} more", {{"count", std::to_string(n - 1)}});
    return ui::FootMessage{{std::move(line)}, {button(tr, ui::translatable("Problems"), "###problems")}};
}

} // namespace

std::optional<ui::FootMessage> banner(const Desk& desk)
{
    const ui::Catalogue& tr = desk.session.view.tr;
    if (desk.session.notice) return message_of(*desk.session.notice, tr);
    return message_of(desk.session.solution(), tr);
}

void show_banner(Desk& desk, const ui::FootMessage& message)
{
    const auto pressed = ui::show(message);
    if (!pressed) return;
    if (!desk.session.notice) {
        desk.topic = Topic::Problems;
        desk.has_panels = true;
        return;
    }
    const std::optional<std::filesystem::path> to_mend = desk.session.notice->to_mend;
    desk.session.notice.reset();
    if (*pressed == 1 && to_mend) open_file(desk, *to_mend, Session::Purpose::Mend);
}

} // namespace frame
