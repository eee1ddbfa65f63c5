#include "apps/frame/window/banner.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "apps/frame/session/tabs.h"
#include "apps/frame/view/results/mechanism_picture.h"
#include "ui/widgets/panel.h"

namespace frame {

namespace {

void show_notice_buttons(Desk& desk)
{
    if (!desk.session.notice) return;
    const ui::Catalogue& tr = desk.session.view.tr;
    const bool is_closed = ImGui::Button((tr("Close") + "###close notice").c_str());
    const std::optional<std::filesystem::path> to_mend = desk.session.notice->to_mend;
    ImGui::SameLine();
    const bool is_opened = to_mend && ImGui::Button((tr("Open all the same") + "###open notice").c_str());
    if (is_closed || is_opened) desk.session.notice.reset();
    if (is_opened) open_file(desk, *to_mend, Session::Purpose::Mend);
}

} // namespace

void banner(Desk& desk)
{
    Session& session = desk.session;
    const ui::Catalogue& tr = session.view.tr;
    std::vector<std::string> lines;
    if (session.notice) {
        lines.push_back(tr(session.notice->sentence));
        for (const femoop::Fault& fault : session.notice->faults) lines.push_back("• " + sentence(fault, tr));
    } else if (session.solution().mechanisms.empty()) { // the picture itself says how a mechanism moves
        for (const femoop::Fault& fault : session.solution().faults) {
            const bool is_error = femoop::severity(fault.kind) == femoop::Severity::Error;
            if (is_error) lines.push_back("• " + sentence(fault, tr));
        }
    }
    if (lines.empty()) return;
    constexpr std::size_t most_lines = 8;
    if (lines.size() > most_lines) {
        const std::size_t n_more = lines.size() - most_lines;
        lines.resize(most_lines);
        lines.push_back(tr("… and {count} more", {{"count", std::to_string(n_more)}}));
    }
    ui::begin_message_box(lines);
    show_notice_buttons(desk);
    ui::end_message_box();
}

} // namespace frame
