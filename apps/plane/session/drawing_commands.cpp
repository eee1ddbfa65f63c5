#include "apps/plane/session/drawing_commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "apps/plane/document/erase.h"
#include "apps/plane/document/regions.h"
#include "apps/plane/session/backdrop_commands.h"
#include "ui/workspace/standard_commands.h"

namespace plane {

using ui::Key;
using ui::Message;
using ui::Reason;
using ui::translatable;
using Menu = ui::MenuBuilder<Workspace>;

namespace {

constexpr std::array tool_entries{
    ToolEntry{ToolKind::Select, "tool.select", translatable("Select, move"), {{Key::V, {}}}},
    ToolEntry{ToolKind::Line, "tool.line", translatable("Draw lines"), {{Key::L, {}}}},
    ToolEntry{ToolKind::Polyline, "tool.polyline", translatable("Draw a polyline"), {{Key::O, {}}}},
    ToolEntry{ToolKind::Arc, "tool.arc", translatable("Draw an arc through three places"), {{Key::A, {}}}},
    ToolEntry{
        ToolKind::ArcCenter, "tool.arc_center", translatable("Draw an arc about a centre"), {{Key::A, ui::shift}}},
    ToolEntry{ToolKind::Circle, "tool.circle", translatable("Draw a circle"), {{Key::C, {}}}},
    ToolEntry{ToolKind::Ellipse, "tool.ellipse", translatable("Draw an ellipse"), {{Key::E, {}}}},
    ToolEntry{ToolKind::Bezier, "tool.bezier", translatable("Draw a Bézier curve"), {{Key::B, {}}}},
    ToolEntry{ToolKind::Spline, "tool.spline", translatable("Draw a spline"), {{Key::S, {}}}},
    ToolEntry{ToolKind::Point, "tool.point", translatable("Place a point"), {{Key::N, {}}}},
    ToolEntry{ToolKind::Erase, "tool.erase", translatable("Erase"), {{Key::X, {}}}},
    ToolEntry{ToolKind::Probe, "tool.probe", translatable("Probe the stresses at a place"), {{Key::Q, {}}}},
    ToolEntry{ToolKind::Cut, "tool.cut", translatable("Cut through the body"), {{Key::U, {}}}},
    ToolEntry{ToolKind::Align,
              "tool.background",
              translatable("Place the image behind the drawing by two points"),
              {{Key::P, ui::shift}}},
};

Reason needs_selection(const Workspace& workspace)
{
    if (!workspace.session.selection().empty()) return std::nullopt;
    return translatable("nothing is selected");
}

/// With nothing selected the probe or the cut goes that the hand had hold of last.
bool deletes_reading(const Workspace& workspace)
{
    return workspace.session.selection().empty() && workspace.session.look.readings.is_selected;
}

/// Faces have nothing of their own but the entry that they are of.
void delete_selection(Workspace& workspace)
{
    Readings& readings = workspace.session.look.readings;
    if (deletes_reading(workspace)) return readings.remove(*readings.last);
    const std::vector<Part> parts = workspace.session.selection();
    const std::optional<RegionId> region = workspace.session.selected_region();
    if (region) {
        workspace.change({translatable("Empty a region"), [region](Document& document) {
                              Erased erased;
                              erased.regions.resize(document.model.regions.size());
                              erased.regions[region->index] = true;
                              erase_entries(document.model, erased);
                          }});
        workspace.session.select_nothing();
        return;
    }
    workspace.change({translatable("Delete"), [parts](Document& document) { erase_parts(document, parts); }});
}

Reason why_not_delete(const Workspace& workspace)
{
    if (deletes_reading(workspace)) return std::nullopt;
    if (const Reason reason = needs_selection(workspace)) return reason;
    const auto& parts = workspace.session.selection();
    const bool has_curves = std::ranges::any_of(
        parts, [](const Part& part) { return !std::holds_alternative<FacePlace>(part); });
    if (has_curves || workspace.session.selected_region()) return std::nullopt;
    return translatable("a face is bounded by curves; delete those, or a region that it has");
}

void give_up(Workspace& workspace)
{
    if (!workspace.hand.escape()) workspace.session.select_nothing();
}

Reason why_not_finish(const Workspace& workspace)
{
    const std::optional<CurveTool>& tool = workspace.hand.curve_tool();
    if (tool && tool->lacks_places()) return translatable("the curve needs another place");
    if (workspace.hand.has_begun()) return std::nullopt;
    return translatable("no curve is begun");
}

Reason why_no_gap(const Workspace& workspace)
{
    if (told_gap(workspace)) return std::nullopt;
    return translatable("no outline is open");
}

void join_ends(Workspace& workspace)
{
    workspace.change({translatable("Close a gap"),
                      [gap = *workspace.session.gap()](Document& document) { close_gap(document, gap); }});
}

Reason why_no_dispute(const Workspace& workspace)
{
    if (workspace.session.solution().dispute()) return std::nullopt;
    return translatable("no face is claimed by two regions");
}

/// The face goes to the first or the second of the two entries.
ui::MenuBuilder<Workspace>::Run keep(RegionId Dispute::*which)
{
    return [which](Workspace& workspace) {
        const std::shared_ptr<const Solution> solution = workspace.session.kept_solution();
        const Dispute dispute = *solution->dispute();
        workspace.change({translatable("Choose a region"), [=](Document& document) {
                              settle_dispute(document, *solution->drawing(), dispute, dispute.*which);
                          }});
    };
}

} // namespace

std::span<const ToolEntry> tools() { return tool_entries; }

void add_edit_commands(CommandTable& table)
{
    Menu menu(table, ui::standard::edit_menu);
    menu.step({"edit.deselect", translatable("Give up, select nothing"), {{Key::Escape, {}}}}, give_up);
    menu.step({"edit.delete", translatable("Delete the selection"), {{Key::Delete, {}}, {Key::Backspace, {}}}},
              delete_selection, why_not_delete);
}

void add_drawing_commands(CommandTable& table)
{
    Menu menu(table, translatable("Draw"));
    for (const ToolEntry& entry : tool_entries)
        menu.choice(
            entry, [](const Workspace& workspace) { return workspace.hand.tool(); },
            [](Workspace& workspace, ToolKind tool) { workspace.hand.select(tool); },
            entry.value == ToolKind::Align ? Menu::WhyNot(why_no_backdrop) : Menu::WhyNot());
    menu.step(
        {"draw.finish", translatable("End the curve"), {{Key::Enter, {}}}},
        [](Workspace& workspace) {
            if (workspace.hand.align_tool()) workspace.align(workspace.hand.finish_aligning());
            else workspace.draw(workspace.hand.finish());
        },
        why_not_finish);
    menu.step({"draw.close_gap", translatable("Close the gap"), {{Key::J, {}}}}, join_ends, why_no_gap);
    menu.step(
        {"draw.leave_gap", translatable("Leave the gap open")},
        [](Workspace& workspace) { workspace.session.leave_gap(); }, why_no_gap);
    menu.step({"region.keep_first", translatable("The face is the first region's")}, keep(&Dispute::first),
              why_no_dispute);
    menu.step({"region.keep_second", translatable("The face is the second region's")}, keep(&Dispute::second),
              why_no_dispute);
    menu.toggle(
        {"draw.grid", translatable("Draw to the grid"), {{Key::G, {}}}},
        [](auto& workspace) -> auto& { return workspace.hand.snaps_to_grid; });
    menu.toggle(
        {"draw.parts", translatable("Draw to points and curves"), {{Key::G, ui::shift}}},
        [](auto& workspace) -> auto& { return workspace.hand.snaps_to_parts; });
}

std::optional<Gap> told_gap(const Workspace& workspace)
{
    if (workspace.hand.has_begun() || workspace.session.history().is_dragging()) return std::nullopt;
    return workspace.session.gap();
}

bool is_out_of_reach(const PlaneModel& model, const FlatPoint& place)
{
    constexpr double most = 1e6, least_width = 1.0; // [m]
    double width = least_width / femoop::metres(model.units.length);
    for (const auto& point : model.points) width = std::max({width, std::abs(point.at[0]), std::abs(point.at[1])});
    return std::max(std::abs(place.x), std::abs(place.y)) > most * width;
}

void make_region_at(Workspace& workspace, const FacePlace& place)
{
    const auto face = workspace.session.face_of(place);
    if (!face) return;
    const FlatPoint inside = workspace.session.drawing()->faces()[*face].inside;
    workspace.change({translatable("Make a region"), [inside](Document& document) { make_region(document, inside); }});
}

void click_part(Workspace& workspace, const std::optional<Part>& part, bool adds)
{
    Session& session = workspace.session;
    session.look.readings.is_selected = false;
    if (!part) {
        if (!adds) session.select_nothing();
        return;
    }
    if (adds) return session.toggle(*part);
    session.select(*part);
    workspace.topic = Topic::Properties;
    const auto* const place = std::get_if<FacePlace>(&*part);
    const auto face = place != nullptr ? session.face_of(*place) : std::nullopt;
    if (face && !session.drawing()->faces()[*face].region) make_region_at(workspace, *place);
}

void read_at(Workspace& workspace, const FlatPoint& place)
{
    Readings& readings = workspace.session.look.readings;
    workspace.session.select_nothing(); // Delete takes away what was placed last
    if (workspace.hand.tool() == ToolKind::Probe) return readings.add_probe(place);
    if (const auto ends = workspace.hand.cut_to(place)) readings.add_cut((*ends)[0], (*ends)[1]);
}

void type_place(Workspace& workspace, const FlatPoint& place)
{
    Hand& hand = workspace.hand;
    if (hand.reads()) return read_at(workspace, place);
    if (hand.align_tool()) return workspace.align(hand.align_as_typed(place, workspace.session.units()));
    if (hand.curve_tool()) {
        Aim aim = hand.aim();
        aim.snap = {place, SnapKind::Free};
        return workspace.draw(hand.click(aim));
    }
    workspace.change({translatable("Place a point"), [place](Document& document) { corner_at(document, {place}); }});
}

} // namespace plane
