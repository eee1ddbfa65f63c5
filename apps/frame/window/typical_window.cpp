#include "apps/frame/window/typical_window.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "apps/drawing/draw.h"
#include "apps/frame/window/number_row.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "ui/paint/painter.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using ui::translatable;

namespace {

femoop::Dimension dimension_of(ui::Measure measure)
{
    if (measure == ui::Measure::Length) return femoop::dimension::length;
    if (measure == ui::Measure::Force) return femoop::dimension::force;
    return measure == ui::Measure::ForcePerLength ? femoop::dimension::force_per_length : femoop::dimension::none;
}

/// A field for a number in m and kN, in the units of the screen. \returns the number where it was changed
std::optional<double> number_field(Workspace& workspace, ui::NumberFields& fields, const TypicalNumber& number,
                                   double value)
{
    const femoop::Units file = workspace.session.model().units, metric;
    const femoop::Dimension dimension = dimension_of(number.measure);
    const auto metric_value = [=](double v) { return femoop::converted(v, dimension, file, metric); };
    femoop::Quantity quantity(femoop::converted(value, dimension, metric, file));
    const auto reason = [&](double v) { return why_not(number, metric_value(v)); };
    if (!edit_quantity(workspace, fields, {number.id, number.measure, 0.0F, reason}, quantity)) return std::nullopt;
    return metric_value(quantity);
}

/// A slider that rests on whole steps.
std::optional<double> slider(const TypicalNumber& number, double value)
{
    auto position = static_cast<float>(value);
    const float room = ImGui::GetContentRegionAvail().x;
    const float field = 4.2F * ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.x; // for "16.404"
    ImGui::SetNextItemWidth(std::max(std::min(0.56F * room, room - field), 1.0F));
    const std::string id = "###slider " + std::string(number.id);
    const bool is_moved = ImGui::SliderFloat(id.c_str(), &position, static_cast<float>(number.least),
                                             static_cast<float>(number.most), "", ImGuiSliderFlags_NoInput);
    if (!is_moved) return std::nullopt;
    const double n_steps = std::round((static_cast<double>(position) - number.least) / number.step);
    const double next = std::min(number.least + n_steps * number.step, number.most);
    return next != value ? std::optional(next) : std::nullopt;
}

std::optional<double> options(const TypicalNumber& number, double value, const ui::Catalogue& tr, ui::TabStops& stops)
{
    std::optional<double> chosen;
    const float end = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const ImGuiStyle& style = ImGui::GetStyle();
    for (std::size_t i = 0; i < number.options.size(); ++i) {
        const std::string_view option = number.options[i];
        const float words = ImGui::CalcTextSize(tr(option).c_str()).x;
        const float width = style.ItemSpacing.x + ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + words;
        if (i > 0 && ImGui::GetItemRectMax().x + width <= end) ImGui::SameLine(); // else in a line of its own
        const bool is_on = value == static_cast<double>(i);
        const std::string id = ui::label_beside_box(tr(option), std::string(number.id) + std::string(option));
        if (ImGui::RadioButton(id.c_str(), is_on)) chosen = static_cast<double>(i);
        if (is_on) stops.add();
    }
    return chosen;
}

/// A row of the table: the number's name, its slider and its field.
std::optional<double> number_row(Workspace& workspace, ui::NumberFields& fields, const Rows& rows,
                                 const TypicalNumber& number, double value)
{
    rows.name(workspace.session.units().label(workspace.session.view.tr(number.label), number.measure));
    if (!number.options.empty()) return options(number, value, workspace.session.view.tr, fields.stops());
    const std::optional<double> slid = slider(number, value);
    ImGui::SameLine();
    const std::optional<double> typed = number_field(workspace, fields, number, value);
    return typed ? typed : slid;
}

constexpr TypicalNumber distance_number{.id = "distance",
                                        .label = translatable("Distance from it"),
                                        .measure = ui::Measure::Length,
                                        .most = 20.0,
                                        .step = 0.5};

void show_setting(Workspace& workspace, ui::TabStops& stops)
{
    TypicalDraft& draft = workspace.typical;
    const ui::Catalogue& tr = workspace.session.view.tr;
    if (!draft.can_stand_beside()) {
        const bool is_something_lost = !workspace.session.history().settled().model.nodes.empty();
        if (is_something_lost)
            ImGui::TextWrapped("%s", tr("It takes the place of what is there; Undo brings that back.").c_str());
        return;
    }
    const bool is_beside = draft.setting() == Setting::Beside;
    if (ImGui::RadioButton(ui::label_beside_box(tr("Right of what is there"), "beside").c_str(), is_beside))
        draft.set_setting(workspace.session, Setting::Beside);
    if (is_beside) stops.add();
    if (ImGui::RadioButton(ui::label_beside_box(tr("In place of what is there"), "in place").c_str(), !is_beside))
        draft.set_setting(workspace.session, Setting::InPlace);
    if (!is_beside) stops.add();
}

void show_numbers_of(Workspace& workspace, ui::NumberFields& fields)
{
    TypicalDraft& draft = workspace.typical;
    const Rows rows("typical numbers");
    if (!rows.is_open()) return;
    const std::size_t chosen = draft.chosen();
    for (std::size_t i = 0; i < draft.numbers().size() && draft.chosen() == chosen; ++i) {
        const auto value = number_row(workspace, fields, rows, draft.structure().numbers[i], draft.numbers()[i]);
        if (value) draft.set(workspace.session, i, *value);
    }
    if (draft.setting() == Setting::InPlace) return;
    const auto distance = number_row(workspace, fields, rows, distance_number, draft.distance());
    if (distance) draft.set_distance(workspace.session, *distance);
}

void show_buttons(Workspace& workspace, ui::NumberFields& fields)
{
    TypicalDraft& draft = workspace.typical;
    const ui::Catalogue& tr = workspace.session.view.tr;
    const ui::FootAnswer answer = ui::foot_buttons(
        {.accept = tr("Insert") + "###insert", .is_typing = fields.is_typing()}, tr, fields.stops());
    if (answer == ui::FootAnswer::Accept) draft.insert(workspace.session);
    else if (answer == ui::FootAnswer::Cancel) draft.cancel(workspace.session);
}

/// Room for the longest of the names, as high for all.
float caption_height(const Workspace& workspace, float width)
{
    float height = 0.0F;
    for (const TypicalStructure& structure : typical_structures())
        height = std::max(
            height, ImGui::CalcTextSize(workspace.session.view.tr(structure.label).c_str(), nullptr, false, width).y);
    return height;
}

} // namespace

void TypicalWindow::show(Workspace& workspace, ui::ImGuiSession& gui, ui::NumberFields& fields)
{
    TypicalDraft& draft = workspace.typical;
    if (!window_.begin(draft.is_open(), "###typical", workspace.session.view.tr("Typical structures"), fields.stops()))
        return;
    ui::SideWindow::begin_content();
    const float line = ImGui::GetFrameHeightWithSpacing();
    const float below = (static_cast<float>(draft.numbers().size()) + 4.5F) * line - ImGui::GetStyle().ItemSpacing.y;
    show_list(workspace, gui, fields.stops(), std::max(ImGui::GetContentRegionAvail().y - below, 6.0F * line));
    ImGui::Separator();
    show_numbers_of(workspace, fields);
    show_setting(workspace, fields.stops());
    ui::SideWindow::end_content();
    show_buttons(workspace, fields);
    window_.end(draft.is_open(), fields.stops());
    if (generation_ != workspace.session.generation()) workspace.asked.push_back(ui::Request::Fit);
    generation_ = workspace.session.generation();
}

void TypicalWindow::show_list(Workspace& workspace, ui::ImGuiSession& gui, ui::TabStops& stops, float height)
{
    ImGui::BeginChild("###structures", {0.0F, height});
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = ImGui::GetWindowWidth() - style.ScrollbarSize;
    const float n_columns = std::clamp(std::floor(room / (7.0F * ImGui::GetFontSize())), 1.0F, 4.0F);
    const float width = (room - (n_columns - 1.0F) * style.ItemSpacing.x) / n_columns;
    const ui::Size size{static_cast<double>(width), std::round(0.6 * static_cast<double>(width))};
    draw_pictures(workspace, (1.0 / gui.scale()) * size);
    std::optional<std::size_t> chosen;
    const auto all = typical_structures();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % static_cast<std::size_t>(n_columns) != 0) ImGui::SameLine();
        if (show_entry(all[i], workspace, gui, size)) chosen = i;
        if (workspace.typical.chosen() == i) stops.add();
        const bool may_be_lost = workspace.typical.chosen() == i && seen_ != std::pair(i, height);
        if (!may_be_lost) continue;
        ImGui::ScrollToItem(ImGuiScrollFlags_KeepVisibleCenterY);
        seen_ = {i, height};
    }
    ImGui::EndChild();
    if (chosen) workspace.typical.choose(workspace.session, *chosen);
}

bool TypicalWindow::show_entry(const TypicalStructure& structure, const Workspace& workspace, ui::ImGuiSession& gui,
                               ui::Size size)
{
    const auto place = static_cast<std::size_t>(&structure - typical_structures().data());
    const std::string name = workspace.session.view.tr(structure.label);
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    const float pad = 0.25F * ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool is_clicked = ImGui::Selectable(("###" + std::string(structure.id)).c_str(),
                                              workspace.typical.chosen() == place, 0,
                                              {width, height + caption_height(workspace, width - 2.0F * pad) + pad});
    gui.show(pictures_[place], *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    const ImVec2 extent = ImGui::CalcTextSize(name.c_str(), nullptr, false, width - 2.0F * pad);
    const ImVec2 at{corner.x + std::max(0.5F * (width - extent.x), pad), corner.y + height};
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, ImGui::GetColorU32(ImGuiCol_Text),
                                        name.c_str(), nullptr, width - 2.0F * pad);
    return is_clicked;
}

void TypicalWindow::draw_pictures(const Workspace& workspace, ui::Size size)
{
    if (!pictures_.empty() && theme_ == workspace.session.view.theme && size_ == size) return;
    theme_ = workspace.session.view.theme;
    size_ = size;
    pictures_.clear();
    const bool is_projected = theme_ == ui::ThemeName::Projector; // whose lines are too broad for small pictures
    DrawOptions options{
        .show = {}, .theme = is_projected ? ui::ThemeName::Light : theme_, .tr = workspace.session.view.tr};
    for (const TypicalStructure& structure : typical_structures()) {
        ui::Painter painter(size, fonts_);
        const femoop::Model model = structure.model(first_numbers(structure));
        options.symbol_factor = is_seen_in_space(model.analysis) ? 0.25 : 0.55; // many supports close together
        draw(painter, {model}, options);
        pictures_.push_back(painter.picture());
    }
}

} // namespace frame
