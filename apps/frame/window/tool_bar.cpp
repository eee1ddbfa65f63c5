#include "apps/frame/window/tool_bar.h"
#include "apps/drawing/draw.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "apps/drawing/draw.h"
#include "apps/frame/session/edit_commands.h"
#include "apps/frame/session/funicular_commands.h"
#include "apps/frame/session/plane_commands.h"
#include "apps/frame/session/train_commands.h"
#include "apps/frame/tools/kept_settings.h"
#include "apps/frame/tools/tool_loads.h"
#include "apps/frame/window/number_row.h"
#include "apps/frame/window/tool_icon.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/quantity/number_text.h"
#include "ui/text/shortened.h"
#include "ui/widgets/tooltip.h"

namespace frame {

using ui::translatable;

namespace {

// One button of the row: the tool's icon, framed where the hand holds it.
void tool_button(Workspace& workspace, const CommandTable& commands, const ToolEntry& entry, ui::ImGuiSession& gui,
                 const ui::Fonts& fonts, const ui::Theme& theme)
{
    const auto& command = *commands.find(entry.id);
    const auto reason = why_not(command, workspace);
    const ui::Catalogue& tr = workspace.session.view.tr;
    const float side = ImGui::GetFrameHeight() * 1.25F;
    const bool is_on = command.is_on(workspace);
    if (is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    ImGui::BeginDisabled(reason.has_value());
    const bool is_clicked = ImGui::Button(("###" + std::string(entry.id)).c_str(), {side, side});
    ImGui::EndDisabled();
    if (is_on) ImGui::PopStyleColor();
    const ImVec2 corner = ImGui::GetItemRectMin();
    const double edge = 0.12 * static_cast<double>(side);
    const double size = (static_cast<double>(side) - 2.0 * edge) / gui.scale();
    ui::Painter painter({size, size}, fonts);
    draw_tool_icon(painter, entry.value, theme);
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x) + edge, static_cast<double>(corner.y) + edge});
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        const std::string tip = reason ? tr(*reason) : tr(entry.label) + "  (" + text(command.shortcuts.front()) + ")";
        ui::show_tooltip(tip);
    }
    if (is_clicked) run(command, workspace);
}

struct SupportTool {
    femoop::SupportKind kind;
    std::string_view label;
};
constexpr std::array supports{
    SupportTool{femoop::SupportKind::Pin, translatable("Pinned")},
    SupportTool{femoop::SupportKind::Roller, translatable("Roller")},
    SupportTool{femoop::SupportKind::Fixed, translatable("Fixed")},
};

constexpr std::string_view no_train = translatable("no train"), unit_load = translatable("unit load");

/// The number that a load of the tool has.
struct LoadValue {
    ui::Measure measure;
    femoop::Quantity ToolSettings::*value;
};
LoadValue value_of(LoadKind kind)
{
    if (kind == LoadKind::Force) return {ui::Measure::Force, &ToolSettings::force};
    if (kind == LoadKind::Moment) return {ui::Measure::Moment, &ToolSettings::moment};
    return {ui::Measure::ForcePerLength, &ToolSettings::line_load};
}

void support_settings(Workspace& workspace)
{
    ToolSettings& settings = workspace.tool_controller.settings();
    for (const SupportTool& choice : supports) {
        const std::string label = workspace.session.view.tr(choice.label) + "###" + std::string(choice.label);
        if (ImGui::RadioButton(label.c_str(), settings.support == choice.kind)) settings.support = choice.kind;
        ImGui::SameLine();
    }
}

// The model's trains, and those of the library.
void list_trains(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const std::string now = chosen_train(session);
    if (ImGui::Selectable((tr(no_train) + "###none").c_str(), now.empty() && !session.influence.is_traced()))
        session.influence.choose_train({});
    if (ImGui::Selectable((tr(unit_load) + "###unit load").c_str(), session.influence.is_traced()))
        session.influence.trace();
    const std::vector<femoop::Train> trains = session.model().moving_loads.trains;
    for (std::size_t i = 0; i < trains.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string label = trains[i].id + "###of the model";
        if (ImGui::Selectable(label.c_str(), trains[i].id == now)) session.influence.choose_train(trains[i].id);
        ImGui::PopID();
    }
    ImGui::Separator();
    ImGui::TextDisabled("%s", tr("Take from the library").c_str());
    for (const LibraryCommand& entry : library_commands()) {
        if (ImGui::Selectable((tr(entry.label) + "###" + std::string(entry.id)).c_str()))
            run(*commands.find(entry.id), workspace);
        if (ImGui::IsItemHovered()) ui::show_tooltip(std::string(entry.train->source));
    }
}

/// What the list of trains shows while it is closed.
std::string shown_train(const Session& session)
{
    const std::string name = chosen_train(session);
    return !name.empty() ? name : session.tr()(session.influence.is_traced() ? unit_load : no_train);
}

constexpr float most_train_width = 11.0F; ///< [em] of the list of trains

float width_beside_text() { return ImGui::GetFrameHeight() + 2.0F * ImGui::GetStyle().FramePadding.x; }

/// Of the list of trains, at the least: its text, but for the rest of a very long name.
float least_train_width(const Session& session)
{
    constexpr float least = 5.0F; // [em]
    const float em = ImGui::GetFontSize();
    const float of_text = ImGui::CalcTextSize(shown_train(session).c_str()).x + width_beside_text();
    return std::clamp(of_text, least * em, most_train_width * em);
}

/// Of round buttons with these names, one beside the other.
float buttons_width(std::span<const std::string> names)
{
    float width = 0.0F;
    for (const std::string& name : names)
        width += ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(name.c_str()).x +
                 ImGui::GetStyle().ItemSpacing.x;
    return width;
}

// Which train stands on the line, and whether its largest or its least value is sought.
void train_settings(Workspace& workspace, const CommandTable& commands)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const drawing::StandingTrain* const standing = session.influence.standing();
    const bool has_ways = standing != nullptr && !session.influence.is_traced();
    const float em = ImGui::GetFontSize(), of_ways = has_ways ? 9.0F * em : 0.0F; // the two buttons behind it
    const float room = std::max(ImGui::GetContentRegionAvail().x, 2.0F * width_beside_text());
    const float width = std::clamp(room - of_ways, std::min(least_train_width(session), room), most_train_width * em);
    const std::string shown = ui::shortened_to_fit(shown_train(session), 1, [&](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str()).x <= width - width_beside_text();
    });
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("###train", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        list_trains(workspace, commands);
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    const std::array ways{tr("max"), tr("min")}; // on the projector they stand in the panel at the left alone
    const bool have_room = buttons_width(ways) <= ImGui::GetContentRegionAvail().x;
    if (!has_ways || !have_room) return;
    const femoop::ExtremeKind kind = standing->kind;
    const auto way = [&](std::string_view label, femoop::ExtremeKind sought) {
        const std::string button = tr(label) + "###" + std::string(label);
        if (ImGui::RadioButton(button.c_str(), kind == sought)) session.influence.seek(sought);
        ImGui::SameLine();
    };
    way(translatable("max"), femoop::ExtremeKind::Max);
    way(translatable("min"), femoop::ExtremeKind::Min);
}

// Which quantity the influence line is of, where there is room for it: the panel at the left has it, too. While there is
// none the hint says how to ask for one.
void influence_settings(Workspace& workspace, const CommandTable& commands)
{
    AskedLine& line = workspace.session.influence;
    const femoop::Model& model = workspace.session.model();
    const std::optional<femoop::MovingEffect> now = line.effect(model);
    const std::vector<femoop::MovingEffect> choices = line.choices(model);
    std::vector<std::string> names;
    for (const femoop::MovingEffect& choice : choices)
        names.push_back(femoop::influence::component_name(model.analysis, choice));
    const float of_trains = now ? least_train_width(workspace.session) : 0.0F;
    const bool have_room = buttons_width(names) + of_trains <= ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; have_room && i < choices.size(); ++i) {
        if (ImGui::RadioButton(names[i].c_str(), choices[i] == now)) line.choose(choices[i]);
        ImGui::SameLine();
    }
    if (now) train_settings(workspace, commands);
}

// Which displacement of the place is found by virtual work.
void work_settings(Workspace& workspace)
{
    AskedWork& asked = workspace.session.virtual_work;
    const femoop::Model& model = workspace.session.model();
    const std::optional<femoop::MovingEffect> now = asked.displacement(model);
    for (const femoop::MovingEffect& choice : asked.choices(model)) {
        const std::string name = femoop::influence::component_name(model.analysis, choice);
        if (ImGui::RadioButton(name.c_str(), choice == now)) asked.choose(choice);
        ImGui::SameLine();
    }
}

/// How the load that is put stands in a bar of this width [px]: where it is narrow the unit goes first, then a part of
/// the load's name.
struct LoadLook {
    bool has_unit = true, has_arrow = true;
    float list = 11.0F * ImGui::GetFontSize(), field = 6.0F * ImGui::GetFontSize();

    LoadLook(const std::string& unit, float room)
    {
        const float gap = ImGui::GetStyle().ItemSpacing.x, em = ImGui::GetFontSize();
        const float of_unit = gap + ImGui::CalcTextSize(unit.c_str()).x;
        if (list + gap + field + of_unit <= room) return;
        field = 3.8F * em;
        has_unit = 7.0F * em + gap + field + of_unit <= room;
        list = std::clamp(room - gap - field - (has_unit ? of_unit : 0.0F), 3.0F * em, list);
        has_arrow = list > 7.0F * em;
    }
};

void load_settings(Workspace& workspace, ui::NumberFields& fields)
{
    ToolSettings& settings = workspace.tool_controller.settings();
    const ui::Catalogue& tr = workspace.session.view.tr;
    const femoop::AnalysisKind kind = workspace.session.model().analysis;
    const ToolLoadEntry& chosen = entry_of(settings.load, kind);
    const LoadValue number = value_of(chosen.load.kind);
    const std::string unit = workspace.session.units().unit(number.measure).name;
    const LoadLook look(unit, ImGui::GetContentRegionAvail().x);
    ImGui::SetNextItemWidth(look.list);
    const auto flags = ImGuiComboFlags_HeightLargest |
                       (look.has_arrow ? ImGuiComboFlags_None : ImGuiComboFlags_NoArrowButton);
    const bool is_open = ImGui::BeginCombo("###load kind", tr(chosen.name).c_str(), flags);
    if (is_open) {
        for (const ToolLoadEntry& entry : tool_loads(kind))
            if (ImGui::Selectable(tr(entry.name).c_str(), entry.load == chosen.load)) settings.load = entry.load;
        ImGui::EndCombo();
    } else if (!look.has_arrow && ImGui::IsItemHovered()) {
        ui::show_tooltip(tr(chosen.name));
    }
    ImGui::SameLine();
    edit_quantity(workspace, fields, {"tool load", number.measure, look.field}, settings.*number.value);
    ImGui::SameLine();
    if (look.has_unit) ImGui::TextUnformatted(unit.c_str());
    if (look.has_unit) ImGui::SameLine();
}

constexpr std::string_view grid_label = translatable("Grid"), snap_label = translatable("Snap");

/// How the switches of the grid stand in a bar of this width [px]: the unit goes first, then their words; where there is
/// no room at all the menu Draw has them.
struct SnapLook {
    bool has_words = true, is_tight = false, has_room = true;

    SnapLook(const std::string& words, const std::string& unit, float room)
    {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float gap = style.ItemSpacing.x, tick = ImGui::GetFrameHeight() + gap;
        const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
        const float of_words = width(words) + 2.0F * style.ItemInnerSpacing.x;
        is_tight = 2.0F * tick + of_words + wide() + width(unit) + 2.0F * gap > room;
        has_words = !is_tight || 2.0F * tick + of_words + narrow() <= room;
        has_room = has_words || 2.0F * tick + narrow() <= room;
    }
    float field() const { return is_tight ? narrow() : wide(); }

private:
    static float wide() { return 6.0F * ImGui::GetFontSize(); }
    static float narrow() { return 3.2F * ImGui::GetFontSize(); }
};

// The distance of the grid's lines: a round one that suits the scale where nothing was typed.
void spacing_field(Workspace& workspace, ui::NumberFields& fields, const SnapLook& look)
{
    const Session& session = workspace.session;
    const ui::DisplayUnits units = session.units();
    ToolSettings& settings = workspace.tool_controller.settings();
    const std::optional<double> spacing = typed_spacing(settings, session.model().units);
    const std::string_view round = look.is_tight ? translatable("auto") : translatable("automatic");
    const std::string shown = spacing ? units.number(femoop::Quantity(*spacing), ui::Measure::Length)
                                      : session.view.tr(round);
    const ui::NumberFieldEvent event = fields.show(
        "grid spacing",
        {.text = shown, .exact_text = spacing ? shown : "", .value = std::nullopt, .width = look.field()});
    if (event.kind != ui::NumberFieldEvent::Kind::Typed) return;
    if (event.text.find_first_not_of(' ') == std::string::npos) return settings.spacing.clear();
    const auto typed = quantity_typed(event.text, ui::Measure::Length, session.model().units, units);
    const auto* const wanted = std::get_if<femoop::Quantity>(&typed);
    if (wanted != nullptr && wanted->value() > 0.0)
        settings.spacing = femoop::quantity_text(wanted->value(), femoop::dimension::length, session.model().units);
    else
        fields.reject(
            event,
            session.view.tr(
                "{text} is no distance of the grid's lines; type a length above zero, or nothing for a round one",
                {{"text", event.text}}));
}

void snap_settings(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    const std::string unit = workspace.session.units().unit(ui::Measure::Length).name;
    const SnapLook look(tr(grid_label) + tr(snap_label), unit, ImGui::GetContentRegionAvail().x);
    if (!look.has_room) return;
    const auto tick = [&](const char* id, std::string_view label) {
        const auto& command = *commands.find(id);
        bool is_on = command.is_on(workspace);
        if (ImGui::Checkbox(((look.has_words ? tr(label) : "") + "###" + id).c_str(), &is_on)) run(command, workspace);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", (tr(command.label) + "  (" + text(command.shortcuts.front()) + ")").c_str());
        ImGui::SameLine();
    };
    tick("draw.grid", grid_label);
    spacing_field(workspace, fields, look);
    ImGui::SameLine();
    if (!look.is_tight) ImGui::TextUnformatted(unit.c_str());
    if (!look.is_tight) ImGui::SameLine();
    tick("draw.snap", snap_label);
}

// In space: the plane that a click means a place of.
void plane_settings(Workspace& workspace, ui::NumberFields& fields)
{
    WorkingPlane& plane = workspace.tool_controller.settings().plane;
    const float em = ImGui::GetFontSize();
    const auto planes = working_planes();
    const auto chosen = std::ranges::find(planes, plane.normal, &PlaneEntry::normal);
    ImGui::SetNextItemWidth(3.3F * em);
    if (ImGui::BeginCombo("###working plane", std::string(chosen->name).c_str())) {
        for (const PlaneEntry& entry : planes) {
            const std::string name(entry.name);
            if (ImGui::Selectable(name.c_str(), plane.normal == entry.normal)) plane.normal = entry.normal;
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    const std::string_view axis = axes.at(static_cast<std::size_t>(plane.index()));
    ImGui::TextUnformatted(workspace.session.units().label(axis, ui::Measure::Length).c_str());
    ImGui::SameLine();
    edit_quantity(workspace, fields, {"working plane", ui::Measure::Length, 2.4F * em}, plane.level);
    ImGui::SameLine();
}

std::string_view hint(ToolKind tool, bool is_in_space, bool is_turned)
{
    if (is_turned && tool == ToolKind::FreeBody)
        return translatable("Click, or draw a cut; V: other side. Shift turns.");
    if (is_in_space && tool == ToolKind::Member)
        return translatable("Click nodes or places of the plane, or type: 6,4,3  @0,0,3");
    if (is_in_space && tool == ToolKind::Node) return translatable("Click a place of the plane, or type it: 6,4,3");
    if (is_in_space && tool == ToolKind::Load)
        return translatable("Click members or nodes; the list has every direction.");
    if (is_in_space && tool == ToolKind::Select) return translatable("Click; Shift adds, Shift and drag: a window.");
    switch (tool) {
    case ToolKind::Select: return translatable("Click, drag, or draw a window; Shift adds.");
    case ToolKind::Member: return translatable("Click from place to place, or type: 4  4<30  @3,2  6,4");
    case ToolKind::Node: return translatable("Click a place, or type it: 6,4");
    case ToolKind::Support: return translatable("Click nodes.");
    case ToolKind::Load: return translatable("Click members or nodes; draw along a member to load a part of it.");
    case ToolKind::Hinge: return translatable("Click nodes or the ends of members.");
    case ToolKind::Dimension: return translatable("Click two nodes, then a place; more nodes go on.");
    case ToolKind::Predict: return translatable("Draw beside the members; H reveals.");
    case ToolKind::Influence: return translatable("Click a section or a support; drag the section along. R: trains");
    case ToolKind::FreeBody: return translatable("Click a part, or draw a cut; V: its other side");
    case ToolKind::Funicular: return translatable("Drag the rings; point to read. Shift+J: hinge");
    case ToolKind::VirtualWork: return translatable("Click a node or a section; drag the section along.");
    case ToolKind::Paste: return translatable("Click where it goes, or type the place: 6,4  @3,2");
    case ToolKind::Delete: break;
    }
    return translatable("Click what is to go.");
}

// As much of it as there is room for, and nothing where that would say nothing; the pointer on it has the whole.
void show_hint(const std::string& words)
{
    constexpr std::size_t least_letters = 24;
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string shown = ui::shortened_to_fit(
        words, least_letters, [&](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x <= room; });
    if (shown.empty()) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", shown.c_str());
    if (shown != words && ImGui::IsItemHovered()) ui::show_tooltip(words);
}

} // namespace

void tool_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts,
              ui::NumberFields& fields)
{
    const float em = ImGui::GetFontSize();
    const float top = ImGui::GetCursorPosY() + 0.125F * ImGui::GetFrameHeight();
    const ui::Theme theme(workspace.session.view.theme);
    for (const ToolEntry& entry : tools()) {
        const bool changes_nothing = entry.value == ToolKind::FreeBody || entry.value == ToolKind::Funicular ||
                                     entry.value == ToolKind::VirtualWork;
        if (changes_nothing) continue; // found in the menu
        tool_button(workspace, commands, entry, gui, fonts, theme);
        ImGui::SameLine(0.0F, 0.15F * em);
    }
    ImGui::SameLine(0.0F, em);
    ImGui::SetCursorPosY(top);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.5F * em, 0.0F});
    const ToolKind tool = workspace.tool_controller.kind();
    if (tool == ToolKind::Support) support_settings(workspace);
    if (tool == ToolKind::Load) load_settings(workspace, fields);
    if (tool == ToolKind::Influence) influence_settings(workspace, commands);
    if (tool == ToolKind::VirtualWork) work_settings(workspace);
    const bool is_in_space = femoop::is_3d(workspace.session.model().analysis);
    if (is_in_space && workspace.tool_controller.can_type()) plane_settings(workspace, fields);
    if (workspace.tool_controller.can_type() && tool != ToolKind::Dimension) snap_settings(workspace, commands, fields);
    const bool has_funicular = shown_funicular(workspace.session) != nullptr;
    show_hint(
        workspace.session.view.tr(tool == ToolKind::Funicular && !has_funicular
                                      ? translatable("Click a member of an arch or a beam; Shift: one more")
                                      : hint(tool, is_in_space, is_seen_in_space(workspace.session.model().analysis))));
    ImGui::PopStyleVar();
}

} // namespace frame
