#include "apps/plane/window/foot.h"

#include <string>

#include "apps/plane/session/drawing_commands.h"
#include "ui/text/number_format.h"

namespace plane {

namespace {

using ui::translatable;

std::string place_text(const Session& session, const FlatPoint& at)
{
    const ui::DisplayUnits units = session.units();
    return units.place(at.x, at.y) + " " + units.unit(ui::Measure::Length).name;
}

/// "R1: steel, 10 mm", "R2: hole".
std::string entry_text(const Session& session, RegionId id)
{
    const auto& region = session.model()[id];
    if (region.is_hole) return region.id + ": " + session.tr()("hole");
    std::string text = region.id;
    if (region.material.index < session.model().materials.size()) text += ": " + session.model()[region.material].id;
    if (region.thickness) text += ", " + session.units().text(*region.thickness, ui::Measure::Length);
    return text;
}

ui::FootMessage message_of(const Session& session, const Dispute& dispute)
{
    const ui::Catalogue& tr = session.tr();
    return {
        {tr("The face at {place} was two regions; which one is it now?", {{"place", place_text(session, dispute.at)}})},
        {entry_text(session, dispute.first) + "###keep first", entry_text(session, dispute.second) + "###keep second"}};
}

ui::FootMessage message_of(const Session& session, const Gap& gap)
{
    const ui::Catalogue& tr = session.tr();
    return {{tr("An outline is open from {from} to {to}: {width}",
                {{"from", place_text(session, gap.from)},
                 {"to", place_text(session, gap.to)},
                 {"width", session.units().text(gap.width, ui::Measure::Length)}})},
            {tr("Close the gap") + "###close gap", tr("Leave the gap open") + "###leave gap"},
            {0}};
}

ui::FootMessage message_of(const Session& session, const AnalysisRun& run)
{
    const ui::Catalogue& tr = session.tr();
    const auto percent = std::to_string(static_cast<int>(100.0 * run.share()));
    const std::string told = run.n_unknowns() == 0
                                 ? tr("The drawing is being meshed; Esc gives it up.")
                                 : tr("{n} unknowns are being solved for, {percent} % done; Esc gives it up.",
                                      {{"n", std::to_string(run.n_unknowns())}, {"percent", percent}});
    return {{told}, {tr("Give it up") + "###give up"}};
}

/// What the hand is to do next that places the image behind the drawing.
std::string_view step_of(const AlignTool& tool)
{
    if (!tool.has_begun()) return translatable("Click a place of the image that you know.");
    if (tool.picks()) return translatable("Click a second one, far from the first.");
    if (!tool.first_target())
        return translatable(
            "How far apart are they? Type it (120 mm) and press Enter. Or first where place 1 lies: type it "
            "(0, 0), or click it.");
    return translatable("Where does place 2 lie? Type its distance from place 1 or its place, or click it; Enter keeps "
                        "the scale.");
}

} // namespace

std::optional<ui::FootMessage> foot_of(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (workspace.hand.align_tool()) return ui::FootMessage{{session.tr()(step_of(*workspace.hand.align_tool()))}, {}};
    if (workspace.hand.has_begun() || session.history().is_dragging()) return std::nullopt;
    if (const auto& dispute = session.solution().dispute()) return message_of(session, *dispute);
    if (const auto gap = told_gap(workspace)) return message_of(session, *gap);
    if (session.run() != nullptr) return message_of(session, *session.run());
    if (const auto reason = session.why_no_results()) {
        const ui::Catalogue& tr = session.tr();
        ui::FootMessage told{{tr("No results: {reason}", {{"reason", tr(*reason)}})}, {tr("Problems") + "###problems"}};
        if (session.was_left()) told.buttons = {tr("Go on all the same") + "###go on"};
        return told;
    }
    return std::nullopt;
}

void answer_foot(Workspace& workspace, const CommandTable& commands, std::size_t pressed)
{
    Session& session = workspace.session;
    const bool is_of_drawing = session.solution().dispute() || told_gap(workspace);
    if (!is_of_drawing && (session.run() != nullptr || session.was_left())) {
        run(*commands.find(session.run() != nullptr ? "results.give_up" : "results.go_on"), workspace);
        return;
    }
    if (!is_of_drawing) {
        workspace.topic = Topic::Problems;
        workspace.has_panels = true;
        return;
    }
    const bool is_dispute = session.solution().dispute().has_value();
    const bool is_second = pressed == 1;
    const std::string_view id = is_dispute ? (is_second ? "region.keep_second" : "region.keep_first")
                                           : (is_second ? "draw.leave_gap" : "draw.close_gap");
    run(*commands.find(id), workspace);
}

} // namespace plane
