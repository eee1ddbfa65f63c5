#include "apps/frame/window/section_window.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "apps/drawing/section_picture.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/frame/window/number_row.h"
#include "femoop/section/outline.h"
#include "femoop/section/principal_axes.h"
#include "femoop/section/section_properties.h"
#include "ui/paint/painter.h"
#include "ui/text/number_format.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using femoop::SectionShapeKind;
using ui::Measure;
using ui::translatable;

namespace {

struct ShapeEntry {
    SectionShapeKind kind;
    std::string_view label;
};
constexpr std::array shapes{
    ShapeEntry{SectionShapeKind::Rectangle, translatable("Rectangle")},
    ShapeEntry{SectionShapeKind::Circle, translatable("Circle")},
    ShapeEntry{SectionShapeKind::Tube, translatable("Tube")},
    ShapeEntry{SectionShapeKind::Box, translatable("Box")},
    ShapeEntry{SectionShapeKind::I, translatable("I section")},
    ShapeEntry{SectionShapeKind::T, translatable("T section")},
    ShapeEntry{SectionShapeKind::L, translatable("L section, angle")},
    ShapeEntry{SectionShapeKind::C, translatable("Channel")},
};

std::string_view meaning(std::string_view key)
{
    if (key == "h") return translatable("Height");
    if (key == "b") return translatable("Width");
    if (key == "d") return translatable("Diameter");
    if (key == "t") return translatable("Thickness");
    if (key == "bf") return translatable("Width of the flange");
    if (key == "tf") return translatable("Thickness of the flange");
    return translatable("Thickness of the web");
}

void show_dimensions(Workspace& workspace, ui::NumberFields& fields)
{
    SectionDraft& draft = workspace.section;
    if (!draft.section().shape) {
        ImGui::TextWrapped(
            "%s",
            workspace.session.view.tr("This section is given by its numbers. Choose a shape or a profile.").c_str());
        return;
    }
    const Rows rows("section dimensions");
    if (!rows.is_open()) return;
    for (const femoop::ShapeDimension& dimension : dimensions(draft.section().shape->kind)) {
        const std::string words = workspace.session.view.tr(meaning(dimension.key)) + ' ' + std::string(dimension.key);
        rows.name(workspace.session.units().label(words, Measure::SectionLength));
        femoop::Quantity value = *((*draft.section().shape).*dimension.value);
        const auto why_not_this = [&](double wanted) -> std::optional<ui::Message> {
            femoop::SectionShape next = *draft.section().shape;
            next.*dimension.value = femoop::Quantity(wanted);
            const auto fault = why_not(next);
            return fault ? std::optional(sentence_of(*fault, workspace.session.units())) : std::nullopt;
        };
        if (edit_quantity(workspace, fields, {dimension.key, Measure::SectionLength, 0.0F, why_not_this}, value))
            draft.set_dimension(workspace.session, dimension, value);
    }
}

std::string plain(std::string_view text)
{
    std::string letters;
    for (const char c : text)
        if (std::isspace(static_cast<unsigned char>(c)) == 0)
            letters += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return letters;
}

void show_target(Workspace& workspace, ui::TabStops& stops)
{
    SectionDraft& draft = workspace.section;
    if (!draft.existing()) return;
    const ui::Catalogue& tr = workspace.session.view.tr;
    const femoop::Model& before = workspace.session.history().settled().model;
    const std::string n_users = std::to_string(members_with(before, *draft.existing()).size());
    const std::string change = tr("Change {id} (members: {count})",
                                  {{"id", before[*draft.existing()].id}, {"count", n_users}});
    const std::string make = tr("A new one (selected members: {count})",
                                {{"count", std::to_string(draft.n_members())}});
    const bool is_new = draft.target() == SectionTarget::New;
    if (ImGui::RadioButton(ui::label_beside_box(change, "this").c_str(), !is_new))
        draft.set_target(workspace.session, SectionTarget::This);
    if (!is_new) stops.add();
    if (ImGui::RadioButton(ui::label_beside_box(make, "new").c_str(), is_new))
        draft.set_target(workspace.session, SectionTarget::New);
    if (is_new) stops.add();
}

/// A cell of the table of properties: the symbol, its value and unit.
void show_property(const ui::DisplayUnits& units, const char* symbol, double value, Measure measure)
{
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(symbol);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(with_minus(units.text(value, measure)).c_str());
}

/// A length to a power that no measure names: the section modulus.
void show_modulus(const ui::DisplayUnits& units, const char* symbol, double value)
{
    const ui::DisplayUnit length = units.unit(Measure::SectionLength);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(symbol);
    ImGui::TableNextColumn();
    const std::string number = ui::number_text(value * std::pow(length.factor, 3), units.format());
    ImGui::TextUnformatted((number + ' ' + length.name + "³").c_str());
}

void show_properties_of(const femoop::SectionProperties& s, const ui::DisplayUnits& units)
{
    if (!ImGui::BeginTable("section properties", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
    show_property(units, "A", s.A, Measure::Area);
    show_property(units, "J", s.J, Measure::SecondMoment);
    show_property(units, "Iz", s.Iz, Measure::SecondMoment);
    show_property(units, "Iy", s.Iy, Measure::SecondMoment);
    if (s.Wz) show_modulus(units, "Wz", *s.Wz);
    if (s.Wy) show_modulus(units, "Wy", *s.Wy);
    if (s.Asy) show_property(units, "Asy", *s.Asy, Measure::Area);
    if (s.Asz) show_property(units, "Asz", *s.Asz, Measure::Area);
    if (s.yc) show_property(units, "yc", *s.yc, Measure::SectionLength);
    if (s.Iyz != 0.0) {
        const femoop::PrincipalAxes axes = principal_axes(s);
        show_property(units, "Iyz", s.Iyz, Measure::SecondMoment);
        show_property(units, "I1", axes.I1, Measure::SecondMoment);
        show_property(units, "I2", axes.I2, Measure::SecondMoment);
        show_property(units, "∠ z′1", axes.angle * 180.0 / std::numbers::pi, Measure::Angle);
    }
    ImGui::EndTable();
}

} // namespace

void SectionWindow::show_buttons(Workspace& workspace, ui::NumberFields& fields) const
{
    SectionDraft& draft = workspace.section;
    const ui::FootAnswer answer = ui::foot_buttons(
        {.may_accept = !why_not_accept(draft), .is_typing = fields.is_typing()}, workspace.session.view.tr,
        fields.stops());
    if (answer == ui::FootAnswer::Accept) draft.accept(workspace.session);
    else if (answer == ui::FootAnswer::Cancel) draft.cancel(workspace.session);
}

std::optional<ui::Message> SectionWindow::why_not_accept(const SectionDraft& draft) const
{
    if (!lists_profiles(draft)) return std::nullopt;
    const auto& chosen = draft.section().profile;
    if (!chosen) return translatable("no profile is chosen; click one in the list, or a shape");
    const std::vector<const femoop::Profile*> listed = listed_profiles();
    if (std::ranges::find(listed, femoop::find_profile(*chosen)) != listed.end()) return std::nullopt;
    return ui::Message(translatable("the list does not show {profile}, which is chosen; click one in the list"),
                       {{"profile", *chosen}});
}

void SectionWindow::show(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields)
{
    SectionDraft& draft = workspace.section;
    if (!draft.is_open()) {
        is_listing_ = is_naming_ = false;
        family_.reset();
        filter_.clear();
    }
    if (!window_.begin(draft.is_open(), "###section", workspace.session.view.tr("Section"), fields.stops())) return;
    ui::SideWindow::begin_content();
    show_content(workspace, gui, fields);
    ui::SideWindow::end_content();
    show_buttons(workspace, fields);
    window_.end(draft.is_open(), fields.stops());
}

void SectionWindow::show_content(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields)
{
    const SectionDraft& draft = workspace.section;
    ui::TabStops& stops = fields.stops();
    show_name(workspace, stops);
    show_target(workspace, stops);
    show_shapes(workspace, gui, stops);
    show_families(workspace, stops);
    if (lists_profiles(draft)) show_profiles(workspace, stops);
    else show_dimensions(workspace, fields);
    show_turned(workspace);
    stops.add();
    if (const auto reason = why_not_accept(draft)) ui::wrapped_text(workspace.session.view.tr(*reason));
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const auto properties = section_properties(draft.section(), workspace.session.model().units);
    const float below = (properties.Iyz != 0.0 ? 7.5F : 5.5F) * line;
    show_picture(workspace, gui, std::max(ImGui::GetContentRegionAvail().y - below, 5.5F * line));
    show_properties_of(properties, workspace.session.units());
}

void SectionWindow::show_name(Workspace& workspace, ui::TabStops& stops)
{
    SectionDraft& draft = workspace.section;
    const ui::Catalogue& tr = workspace.session.view.tr;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Name").c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    if (!is_naming_) name_ = draft.section().id; // another's was typed before
    if (ImGui::InputText("###name", &name_)) reason_ = draft.set_name(workspace.session, name_);
    stops.add(ui::TabStops::Kind::Text);
    is_naming_ = ImGui::IsItemActive();
    if (!is_naming_) reason_.reset();
    if (reason_) ui::wrapped_text(tr(*reason_));
}

void SectionWindow::show_shapes(Workspace& workspace, ui::ImGuiSession& gui, ui::TabStops& stops)
{
    SectionDraft& draft = workspace.section;
    const bool is_one_chosen = !lists_profiles(draft) && draft.section().shape;
    const float gap = 0.2F * ImGui::GetFontSize();
    const float n = static_cast<float>(shapes.size());
    const float side = std::floor((ImGui::GetContentRegionAvail().x - (n - 1.0F) * gap) / n);
    for (const ShapeEntry& entry : shapes) {
        if (entry.kind != shapes.front().kind) ImGui::SameLine(0.0F, gap);
        const bool is_chosen = is_one_chosen && draft.section().shape->kind == entry.kind;
        if (is_chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
        const bool is_clicked = ImGui::Button(("###" + std::string(entry.label)).c_str(), {side, side});
        if (is_chosen) ImGui::PopStyleColor();
        if (is_chosen || (!is_one_chosen && entry.kind == shapes.front().kind)) stops.add();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", workspace.session.view.tr(entry.label).c_str());
        const ImVec2 corner = ImGui::GetItemRectMin();
        const double size = static_cast<double>(side) / gui.scale();
        ui::Painter painter({size, size}, fonts_);
        const bool is_dark = ui::Theme(workspace.session.view.theme).is_dark();
        draw_section_icon(painter, usual_shape(entry.kind, {}),
                          ui::Theme(is_dark ? ui::ThemeName::Dark : ui::ThemeName::Light));
        gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
                 {static_cast<double>(corner.x), static_cast<double>(corner.y)});
        if (!is_clicked) continue;
        is_listing_ = false;
        draft.choose_shape(workspace.session, entry.kind);
    }
}

void SectionWindow::show_families(Workspace& workspace, ui::TabStops& stops)
{
    const float gap = 0.2F * ImGui::GetFontSize();
    constexpr int n_in_row = 6;
    const float width = (ImGui::GetContentRegionAvail().x - (n_in_row - 1) * gap) / n_in_row;
    int place = 0;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0F, ImGui::GetStyle().FramePadding.y});
    for (const femoop::ProfileFamily family : femoop::profile_families()) {
        const bool is_first = place == 0;
        if (place++ % n_in_row != 0) ImGui::SameLine(0.0F, gap);
        const bool is_one_chosen = lists_profiles(workspace.section) && family_;
        const bool is_chosen = is_one_chosen && family_ == family;
        if (is_chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
        const bool is_clicked = ImGui::Button(std::string(name(family)).c_str(), {width, 0.0F});
        if (is_chosen) ImGui::PopStyleColor();
        if (is_chosen || (!is_one_chosen && is_first)) stops.add();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(standard(family)).c_str());
        if (!is_clicked) continue;
        family_ = is_chosen ? std::nullopt : std::optional(family);
        filter_.clear();
        is_listing_ = begins_filter_ = true;
    }
    ImGui::PopStyleVar();
}

std::vector<const femoop::Profile*> SectionWindow::listed_profiles() const
{
    const std::string wanted = plain(filter_);
    std::vector<const femoop::Profile*> listed;
    for (const femoop::Profile& profile : family_ ? femoop::profiles(*family_) : femoop::profiles())
        if (profile.name.find(wanted) != std::string_view::npos) listed.push_back(&profile);
    if (!listed.empty()) return listed;
    constexpr std::size_t most = 8;
    const bool is_size = family_ && !wanted.empty() && std::isdigit(static_cast<unsigned char>(wanted.front())) != 0;
    const std::string asked = is_size ? std::string(name(*family_)) + wanted : wanted;
    for (const std::string_view name : femoop::near_profiles(asked, most)) listed.push_back(femoop::find_profile(name));
    return listed;
}

SectionWindow::Filtering SectionWindow::show_filter(const Workspace& workspace, ui::TabStops& stops)
{
    Filtering done;
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::PushID(family_ ? static_cast<int>(*family_) : -1); // another family's field is another: it keeps no text
    if (std::exchange(begins_filter_, false)) ImGui::SetKeyboardFocusHere();
    const std::string hint = workspace.session.view.tr("Type a part of its name: 300");
    const auto on_arrow = [](ImGuiInputTextCallbackData* data) {
        *static_cast<int*>(data->UserData) = data->EventKey == ImGuiKey_DownArrow ? 1 : -1;
        return 0;
    };
    done.is_entered = ImGui::InputTextWithHint(
        "###filter", hint.c_str(), &filter_,
        ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory,
        on_arrow, &done.step);
    done.is_edited = ImGui::IsItemEdited();
    stops.add(ui::TabStops::Kind::Text);
    ImGui::PopID();
    return done;
}

namespace {

/// The profile so many places on in the list, which the arrows go through while a name is typed.
const femoop::Profile* stepped(const std::vector<const femoop::Profile*>& listed, const femoop::Profile* chosen,
                               int step)
{
    if (step == 0 || listed.empty()) return nullptr;
    const auto now = std::ranges::find(listed, chosen);
    if (now == listed.end()) return listed.front();
    const std::ptrdiff_t place = now - listed.begin() + step, last = std::ssize(listed) - 1;
    return listed[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, last))];
}

} // namespace

// Enter takes the profile where it is the only one left.
void SectionWindow::show_profiles(Workspace& workspace, ui::TabStops& stops)
{
    SectionDraft& draft = workspace.section;
    const ui::Catalogue& tr = workspace.session.view.tr;
    const Filtering filtering = show_filter(workspace, stops);
    ImGui::BeginChild("###profiles", {0.0F, 4.0F * ImGui::GetTextLineHeightWithSpacing()}, true);
    if (filtering.is_edited) ImGui::SetScrollY(0.0F);
    const femoop::Profile* const chosen = draft.section().profile ? femoop::find_profile(*draft.section().profile)
                                                                  : nullptr;
    const std::vector<const femoop::Profile*> listed = listed_profiles();
    if (filtering.is_entered && listed.size() == 1) draft.choose_profile(workspace.session, listed.front()->name);
    if (const auto* const next = stepped(listed, chosen, filtering.step))
        draft.choose_profile(workspace.session, next->name);
    const bool is_found = std::ranges::any_of(listed, [wanted = plain(filter_)](const femoop::Profile* profile) {
        return profile->name.find(wanted) != std::string_view::npos;
    });
    if (!is_found) ui::wrapped_text(tr("no profile has {text} in its name", {{"text", filter_}}));
    for (const femoop::Profile* const profile : listed) {
        const std::string label(profile->name);
        if (ImGui::Selectable(label.c_str(), profile == chosen)) draft.choose_profile(workspace.session, profile->name);
        const bool was_chosen = profile == chosen && std::exchange(seen_, chosen) != chosen;
        if (was_chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
}

void SectionWindow::show_turned(Workspace& workspace) const
{
    SectionDraft& draft = workspace.section;
    bool is_turned = draft.section().turned;
    ImGui::BeginDisabled(!draft.section().shape && !draft.section().profile);
    if (ImGui::Checkbox((workspace.session.view.tr("Turned on its side") + "###turned").c_str(), &is_turned))
        draft.set_turned(workspace.session, is_turned);
    ImGui::EndDisabled();
}

void SectionWindow::show_picture(Workspace& workspace, ui::ImGuiSession& gui, float height) const
{
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    ui::Painter painter({static_cast<double>(width) / gui.scale(), static_cast<double>(height) / gui.scale()}, fonts_);
    draw_section(painter, workspace.section.section(), workspace.session.model().units,
                 {.theme = ui::Theme(workspace.session.view.theme), .units = workspace.session.units()});
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
}

} // namespace frame
