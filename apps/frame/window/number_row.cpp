#include "apps/frame/window/number_row.h"

#include <imgui.h>

#include <utility>

#include "ui/text/number_format.h"

namespace frame {

using ui::translatable;
using Kind = ui::NumberFieldEvent::Kind;

Rows::Rows(const char* id) : is_open_(ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp))
{
    if (!is_open_) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.52F);
    ImGui::TableSetupColumn("field", ImGuiTableColumnFlags_WidthStretch, 0.48F);
}

Rows::~Rows()
{
    if (is_open_) ImGui::EndTable();
}

void Rows::name(const std::string& text) const
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0F);
}

namespace {

constexpr int exact_digits = 15;

// As it is edited: the text that was typed, or every digit of the number in the unit shown.
std::string exact_text(const Number& number, const ui::DisplayUnits& units)
{
    if (!number.value) return "";
    if (number.value->has_text()) return std::string(number.value->text());
    return ui::number_text(units.shown(*number.value, number.measure), {exact_digits, units.format().mark});
}

ui::Phrase change_label(const Session& session, const Number& number)
{
    return {translatable("Change {number}: {part}"),
            {{"number", number.label}, {"part", title(session.model(), number.id.part)}}};
}

std::string reason(const femoop::Fault& fault, const ui::Catalogue& tr)
{
    std::string text = femoop::message(fault, tr);
    if (text.starts_with(": ")) text.erase(0, 2); // the place, which the field itself shows
    return text;
}

void take_text(Desk& desk, ui::NumberFields& fields, const Number& number, const ui::NumberFieldEvent& event)
{
    Session& session = desk.session;
    const bool is_emptied = event.text.find_first_not_of(' ') == std::string::npos;
    if (is_emptied && number.presence == Need::Optional) {
        session.change(Step::Click, change_label(session, number),
                       [&](Document& document) { clear_number(document, number.id); });
        return;
    }
    const auto typed = quantity_typed(event.text, number.measure, session.model().units, session.units());
    if (const auto* const fault = std::get_if<femoop::Fault>(&typed)) {
        fields.reject(event, reason(*fault, session.view.tr));
        return;
    }
    session.change(Step::Click, change_label(session, number),
                   [&](Document& document) { set_number(document, number.id, std::get<femoop::Quantity>(typed)); });
}

void take_drag(Desk& desk, const Number& number, double shown)
{
    Session& session = desk.session;
    const auto value = quantity_typed(ui::number_text(shown, {exact_digits}), number.measure, session.model().units,
                                      session.units());
    if (!std::holds_alternative<femoop::Quantity>(value)) return;
    session.change(Step::Drag, change_label(session, number),
                   [&](Document& document) { set_number(document, number.id, std::get<femoop::Quantity>(value)); });
}

} // namespace

void show_number(const Rows& rows, Desk& desk, ui::NumberFields& fields, const Number& number)
{
    const ui::DisplayUnits units = desk.session.units();
    const ui::Catalogue& tr = desk.session.view.tr;
    rows.name(units.label(tr(number.label), number.measure));
    const std::optional<double> shown = number.value ? std::optional(units.shown(*number.value, number.measure))
                                                     : std::nullopt;
    const ui::NumberFieldEvent event = fields.show(
        "number" + std::to_string(number.id.place),
        {.text = number.value ? units.number(*number.value, number.measure) : tr("not given"),
         .exact_text = exact_text(number, units),
         .value = shown});
    if (event.kind == Kind::Dragged) take_drag(desk, number, event.value);
    if (event.kind == Kind::Settled) desk.session.settle();
    if (event.kind == Kind::Typed) take_text(desk, fields, number, event);
}

void show_numbers(Desk& desk, ui::NumberFields& fields, const Part& part)
{
    const std::vector<Number> all = numbers(desk.session.model(), part);
    const Rows rows("numbers");
    if (!rows.is_open()) return;
    for (const Number& number : all) show_number(rows, desk, fields, number);
}

} // namespace frame
