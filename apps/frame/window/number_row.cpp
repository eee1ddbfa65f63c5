#include "apps/frame/window/number_row.h"

#include <imgui.h>

#include <functional>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "apps/frame/document/fault/sentence.h"
#include "ui/text/number_format.h"
#include "ui/widgets/wrapped_text.h"

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
    ui::wrapped_text(text);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0F);
}

namespace {

constexpr int digits_to_edit = 15;

// As it is edited: the text that was typed, or every digit of the number in the unit shown.
std::string exact_text(const std::optional<femoop::Quantity>& value, ui::Measure measure, const ui::DisplayUnits& units)
{
    if (!value) return "";
    if (value->has_text()) return std::string(value->text());
    return ui::number_text(units.shown(*value, measure), {digits_to_edit, units.format().mark});
}

std::string reason(const femoop::Fault& fault, const ui::Catalogue& tr)
{
    std::string text = sentence(fault, tr);
    if (text.starts_with(": ")) text.erase(0, 2); // the place, which the field itself shows
    return text;
}

std::optional<ui::Message> change(Session& session, const SharedNumber& number,
                                  const std::function<void(Document&, const NumberId&)>& command, Step step)
{
    std::vector<Part> parts;
    for (const NumberId& id : number.ids) parts.push_back(id.part);
    return session.change({change_label(session.model(), number.of_first.label, parts),
                           [&](Document& document) {
                               for (const NumberId& id : number.ids) command(document, id);
                           },
                           step});
}

std::optional<ui::Message> set(Session& session, const SharedNumber& number, const femoop::Quantity& value, Step step)
{
    return change(
        session, number, [&](Document& document, const NumberId& id) { set_number(document, id, value); }, step);
}

void take_text(Workspace& workspace, ui::NumberFields& fields, const SharedNumber& number,
               const ui::NumberFieldEvent& event)
{
    Session& session = workspace.session;
    const bool is_emptied = event.text.find_first_not_of(' ') == std::string::npos;
    if (is_emptied && number.is_mixed) return;
    if (is_emptied && number.of_first.presence == Need::Optional) {
        change(session, number, clear_number, Step::Click);
        return;
    }
    const auto typed = quantity_typed(event.text, number.of_first.measure, session.model().units, session.units());
    if (const auto* const fault = std::get_if<femoop::Fault>(&typed)) {
        fields.reject(event, reason(*fault, session.view.tr));
        return;
    }
    if (const auto objection = set(session, number, std::get<femoop::Quantity>(typed), Step::Click))
        fields.reject(event, session.view.tr(*objection));
}

void take_drag(Workspace& workspace, const SharedNumber& number, double shown)
{
    Session& session = workspace.session;
    const auto value = quantity_typed(ui::number_text(shown, {digits_to_edit}), number.of_first.measure,
                                      session.model().units, session.units());
    if (const auto* const quantity = std::get_if<femoop::Quantity>(&value)) set(session, number, *quantity, Step::Drag);
}

std::string shown_text(const SharedNumber& number, const ui::DisplayUnits& units, const ui::Catalogue& tr)
{
    if (number.is_mixed) return tr("mixed");
    const Number& first = number.of_first;
    return first.value ? units.number(*first.value, first.measure) : tr("not given");
}

void show_number(const Rows& rows, Workspace& workspace, ui::NumberFields& fields, const SharedNumber& number,
                 bool begins)
{
    const ui::DisplayUnits units = workspace.session.units();
    const ui::Catalogue& tr = workspace.session.view.tr;
    const Number& first = number.of_first;
    rows.name(units.label(tr(first.label), first.measure));
    const std::optional<femoop::Quantity> common = number.is_mixed ? std::nullopt : first.value;
    const ui::NumberFieldEvent event = fields.show(
        "number" + std::to_string(first.id.place),
        {.text = shown_text(number, units, tr),
         .exact_text = exact_text(common, first.measure, units),
         .value = common ? std::optional(units.shown(*common, first.measure)) : std::nullopt,
         .begins = begins});
    if (event.kind == Kind::Dragged) take_drag(workspace, number, event.value);
    if (event.kind == Kind::Settled) workspace.session.settle();
    if (event.kind == Kind::Typed) take_text(workspace, fields, number, event);
}

bool is_depth(const SharedNumber& number)
{
    return std::holds_alternative<femoop::MemberId>(number.of_first.id.part) &&
           number.of_first.measure == ui::Measure::SectionLength;
}

} // namespace

ui::Message change_label(const femoop::Model& model, const ui::Message& what, std::span<const Part> parts)
{
    const ui::Message whose = parts.size() == 1 ? title(model, parts.front())
                                                : ui::Message(translatable("the selection"));
    return {translatable("Change {number}: {part}"), {{"number", what}, {"part", whose}}};
}

void show_numbers(Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts, bool begins)
{
    std::vector<SharedNumber> all = shared_numbers(workspace.session.model(), parts);
    std::erase_if(all, is_depth);
    const Rows rows("numbers");
    if (!rows.is_open()) return;
    for (const SharedNumber& number : all)
        show_number(rows, workspace, fields, number, begins && &number == &all.front());
}

void show_depths(const Rows& rows, Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts)
{
    for (const SharedNumber& number : shared_numbers(workspace.session.model(), parts))
        if (is_depth(number)) show_number(rows, workspace, fields, number, false);
}

bool edit_quantity(Workspace& workspace, ui::NumberFields& fields, const FieldPlace& place, femoop::Quantity& value)
{
    const Session& session = workspace.session;
    const ui::DisplayUnits units = session.units();
    const ui::NumberFieldEvent event = fields.show(place.id, {.text = units.number(value, place.measure),
                                                              .exact_text = exact_text(value, place.measure, units),
                                                              .value = units.shown(value, place.measure),
                                                              .width = place.width,
                                                              .begins = place.begins});
    if (event.kind != Kind::Dragged && event.kind != Kind::Typed) return false;
    const std::string text = event.kind == Kind::Typed ? event.text : ui::number_text(event.value, {digits_to_edit});
    const auto typed = quantity_typed(text, place.measure, session.model().units, units);
    if (const auto* const fault = std::get_if<femoop::Fault>(&typed)) {
        fields.reject(event, reason(*fault, session.view.tr));
        return false;
    }
    const femoop::Quantity& wanted = std::get<femoop::Quantity>(typed);
    const std::optional<ui::Message> objection = place.why_not ? place.why_not(wanted) : std::nullopt;
    if (objection && event.kind == Kind::Typed) fields.reject(event, session.view.tr(*objection));
    if (objection) return false;
    value = wanted;
    return true;
}

} // namespace frame
