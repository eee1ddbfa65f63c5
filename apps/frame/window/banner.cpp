#include "apps/frame/window/banner.h"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/session/fault_target.h"
#include "apps/frame/session/tabs.h"
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

/// What keeps the picture from showing results, with its head; nothing where it shows them, or says it itself.
struct Hindrance {
    std::string head; ///< "" where the faults say all
    std::vector<femoop::Fault> faults;
};

Hindrance hindrance(const Session& session)
{
    const ui::Catalogue& tr = session.view.tr;
    if (!session.shown_mechanisms().empty()) return {}; // the picture itself says how a mechanism moves
    if (const BlankCase* const blank = session.shown_blank())
        return {tr("Case {case} has no results.", {{"case", session.model().case_name(blank->id)}}), blank->faults};
    if (session.solution().results) return {};
    std::vector<femoop::Fault> errors = session.solution().faults;
    std::erase_if(errors, [](const auto& fault) { return femoop::severity(fault.kind) != femoop::Severity::Error; });
    return {"", std::move(errors)};
}

void show_box(Desk& desk, const std::string& head, const std::vector<femoop::Fault>& faults)
{
    constexpr std::size_t most_faults = 8;
    const ui::Catalogue& tr = desk.session.view.tr;
    std::vector<std::string> lines;
    if (!head.empty()) lines.push_back(head);
    for (const femoop::Fault& fault : std::span(faults).first(std::min(faults.size(), most_faults)))
        lines.push_back("• " + sentence(fault, tr));
    if (faults.size() > most_faults)
        lines.push_back(tr("… and {count} more", {{"count", std::to_string(faults.size() - most_faults)}}));
    const std::optional<std::size_t> clicked = ui::begin_message_box(lines);
    const std::size_t n_heads = head.empty() ? 0 : 1;
    const bool is_fault = clicked && *clicked >= n_heads && *clicked - n_heads < std::min(faults.size(), most_faults);
    if (is_fault && !desk.session.notice) go_to(desk, faults[*clicked - n_heads]); // a notice's are of another model
    show_notice_buttons(desk);
    ui::end_message_box();
}

} // namespace

void banner(Desk& desk)
{
    if (const std::optional<Notice> notice = desk.session.notice)
        return show_box(desk, desk.session.view.tr(notice->sentence), notice->faults);
    const auto [head, faults] = hindrance(desk.session);
    if (!faults.empty()) show_box(desk, head, faults);
}

} // namespace frame
