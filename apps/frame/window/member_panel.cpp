#include "apps/frame/window/member_panel.h"

#include <imgui.h>

#include <algorithm>

#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/member/member_results.h"
#include "apps/frame/session/snapping.h"
#include "apps/frame/window/no_results.h"

namespace frame {

namespace {

std::optional<double> pinned(const Session& session, femoop::MemberId member)
{
    if (!session.pin || session.pin->member != member) return std::nullopt;
    return session.pin->x;
}

} // namespace

std::optional<femoop::MemberId> MemberPanel::member_of(const Session& session)
{
    const std::optional<Part> only = session.selection.only();
    if (const auto* const member = only ? std::get_if<femoop::MemberId>(&*only) : nullptr) return *member;
    return session.pin ? std::optional(session.pin->member) : std::nullopt;
}

void MemberPanel::show(Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    if (explain_no_results(workspace)) return;
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const auto& results = session.solution().results;
    const std::optional<femoop::MemberId> member = member_of(session);
    if (results->n_cases() == 0) {
        ImGui::TextWrapped("%s", tr("There are no results: see the problems.").c_str());
        return;
    }
    if (!member) {
        ImGui::TextWrapped("%s", tr("Select a member to see its diagrams and formulas.").c_str());
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::BeginChild("###member results", {0.0F, 0.0F}, true);
    show_picture(session, *member, gui, fonts);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void MemberPanel::show_picture(Session& session, femoop::MemberId member, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const double scale = gui.scale();
    MemberResultsSubject subject{session.model(), *session.solution().results, session.view, member,
                                 pinned(session, member)};
    const auto logical = [&](float pixels) { return static_cast<double>(pixels) / scale; };
    const ui::Size sheet{logical(room.x), std::max(logical(room.y), least_height(subject))};
    const ImVec2 mouse = ImGui::GetMousePos();
    const ui::Point place{logical(mouse.x - corner.x), logical(mouse.y - corner.y)};
    if (ImGui::IsWindowHovered()) {
        if (const auto section = section_at(subject, sheet, place)) {
            const Cut cut = snapped(session, shape_of(session.model()), {member, *section},
                                    pixels_per_length(subject, sheet));
            subject.cursor = cut.x;
            if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) session.pin = cut;
        }
    }
    ui::Painter painter(sheet, fonts);
    draw_member_results(painter, subject);
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    ImGui::Dummy({room.x, static_cast<float>(scale * sheet.height)});
}

bool MemberPanel::handle_key(Session& session, const ui::Chord& chord)
{
    const bool is_arrow = chord.key == ui::Key::Left || chord.key == ui::Key::Right;
    const std::optional<femoop::MemberId> member = member_of(session);
    if (!is_arrow || chord.modifiers.ctrl || !member || !session.solution().results) return false;
    const double length = session.solution().results->geometry(*member).length;
    const double step = length / (chord.modifiers.shift ? 100.0 : 20.0);
    const double now = pinned(session, *member).value_or(0.5 * length);
    const double next = chord.key == ui::Key::Left ? now - step : now + step;
    session.pin = Cut{*member, std::clamp(next, 0.0, length)};
    return true;
}

} // namespace frame
