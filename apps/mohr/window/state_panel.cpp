#include "apps/mohr/window/state_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include "apps/mohr/view/axis.h"
#include "apps/mohr/view/names.h"
#include "femoop/model/quantity/number_text.h"
#include "ui/text/arithmetic.h"
#include "ui/text/language_manner.h"
#include "ui/widgets/command_combo.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/field_row.h"
#include "ui/widgets/wrapped_text.h"

namespace mohr {

namespace fm = femoop::mohr;
using Kind = ui::NumberFieldEvent::Kind;
using ui::translatable;

namespace {

// A value of which the document keeps no text: how it is shown, and what a new one does.
struct ValueRow {
    std::string label, id;
    double value = 0.0;
    std::function<Edit(double)> edit;
    ui::Message step;
};

void heading(const std::string& words)
{
    ImGui::Spacing();
    ImGui::Separator();
    ui::wrapped_text(words);
}

void value_row(Workspace& workspace, ui::NumberFields& fields, const ValueRow& row)
{
    Session& session = workspace.session;
    const std::string shown = session.look.number(row.value);
    ui::begin_field_row(row.label, shown);
    const ui::NumberFormat exact{15, session.look.format().mark};
    const auto event = fields.show(row.id, {shown, ui::number_text(row.value, exact), row.value});
    if (event.kind == Kind::Dragged) session.drag(row.edit(event.value), row.step);
    if (event.kind == Kind::Settled) session.settle();
    if (event.kind != Kind::Typed) return;
    const auto number = ui::number_typed(event.text);
    if (!number) fields.reject(event, session.tr()("this is no number"));
    else if (const auto reason = session.apply(row.edit(*number), row.step))
        fields.reject(event, session.tr()(*reason));
}

// A number of more digits than anyone types, rounded, with its unit; nothing for others.
std::optional<std::string> short_enough(const std::string& text, const std::optional<ui::LeadingNumber>& number,
                                        const Look& look)
{
    constexpr std::size_t most = 10; // characters
    constexpr int digits = 6;
    if (!number || number->is_computed || number->length <= most) return std::nullopt;
    const std::string rounded = ui::number_text(number->value, {digits, look.format().mark});
    return ui::with_minus_signs(rounded) + printed_unit(text.substr(number->length));
}

// "(0.8; 0.6; 0)", "0.8 0.6 0"; nothing for what are no three numbers.
std::optional<std::array<double, 3>> vector_typed(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return c == ';' || c == '(' || c == ')'; }, ' ');
    std::istringstream words(text);
    std::array<double, 3> vector{};
    std::size_t n = 0;
    for (std::string word; words >> word; ++n) {
        if (word.ends_with(',')) word.pop_back();
        const auto number = ui::number_typed(word);
        if (!number || n == vector.size()) return std::nullopt;
        vector[n] = *number;
    }
    return n == vector.size() ? std::optional(vector) : std::nullopt;
}

} // namespace

void StatePanel::show(Workspace& workspace, const CommandTable& commands)
{
    show_kind(workspace, commands);
    show_numbers(workspace);
    if (workspace.session.document().subject == Subject::Rosette)
        for (const char* id : {"state.rosette_45", "state.rosette_60"}) ui::command_button(workspace, commands, id);
    const Subject subject = workspace.session.document().subject;
    if (is_in_space(subject) && !workspace.session.is_concealing()) show_space_principal(workspace);
    else if (subject != Subject::Section && !workspace.session.is_concealing()) show_principal(workspace);
    if (!workspace.session.is_concealing()) show_plane(workspace);
    show_material(workspace);
    show_criterion(workspace, commands);
}

void StatePanel::show_kind(Workspace& workspace, const CommandTable& commands)
{
    ImGui::TextUnformatted(workspace.tr()("State").c_str());
    const Subject now = workspace.session.document().subject;
    ui::command_combo(workspace, commands, "###subject", subjects(),
                      [&](const SubjectEntry& entry) { return entry.value == now; });
}

void StatePanel::number_row(Workspace& workspace, const std::string& label, NumberId number)
{
    Session& session = workspace.session;
    const std::string& text = text_of(session.document(), number);
    const auto leading = number.group == Group::Section ? std::nullopt : ui::leading_number(text);
    const std::string id = "###" + std::to_string(static_cast<int>(number.group)) + "." + std::to_string(number.place);
    std::string exact = number.group == Group::Section ? text : printed_unit(text);
    if (ui::decimal_mark(session.tr().language()) == ui::DecimalMark::Comma && number.group != Group::Section)
        for (char& c : exact) c = c == '.' ? ',' : c;
    const std::string shown = short_enough(text, leading, session.look).value_or(ui::with_minus_signs(exact));
    ui::begin_field_row(label, shown);
    const auto event = fields_.show(id, {.text = shown,
                                         .exact_text = exact,
                                         .value = leading ? std::optional(leading->value) : std::nullopt,
                                         .is_typed_only = number.group == Group::Section && number.place == 0});
    if (event.kind == Kind::Dragged && leading)
        session.drag(with_number(session.document(), number, femoop::number_text(event.value)),
                     translatable("Change a number"));
    if (event.kind == Kind::Settled) session.settle();
    if (event.kind != Kind::Typed) return;
    if (const auto reason = session.set_number(number, event.text)) fields_.reject(event, session.tr()(*reason));
}

void StatePanel::show_numbers(Workspace& workspace)
{
    const Subject subject = workspace.session.document().subject;
    const auto parts = names(subject);
    if (subject == Subject::Section) number_row(workspace, workspace.tr()("Section"), {Group::Section, 0});
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string unit(bare_unit(subject, i));
        const std::string label = std::string(parts[i]) + (unit.empty() ? "" : " [" + unit + "]");
        number_row(workspace, label, {Group::State, i});
    }
}

void StatePanel::show_principal(Workspace& workspace)
{
    const Solution s = workspace.session.solution(); // copies: a row may change what the session holds
    const Document document = workspace.session.document();
    const Names names = names_of(document.subject);
    heading(workspace.tr()("By principal values"));
    const double angle = s.principal.angle.value_or(0.0) * 180.0 / std::numbers::pi;
    const ui::Message step = translatable("Change the principal values");
    value_row(workspace, fields_,
              {axis_title(names.first, s.unit), "###first", s.principal.first,
               [&](double v) { return with_principal(document, v, s.principal.second, angle); }, step});
    value_row(workspace, fields_,
              {axis_title(names.second, s.unit), "###second", s.principal.second,
               [&](double v) { return with_principal(document, s.principal.first, v, angle); }, step});
    value_row(workspace, fields_,
              {"θp [°]", "###direction", angle,
               [&](double v) { return with_principal(document, s.principal.first, s.principal.second, v); }, step});
}

void StatePanel::show_space_principal(Workspace& workspace)
{
    const Solution s = workspace.session.solution(); // copies: a row may change what the session holds
    const Document document = workspace.session.document();
    heading(workspace.tr()("By principal values"));
    for (std::size_t i = 0; i < 3; ++i)
        value_row(workspace, fields_,
                  {axis_title("σ" + std::to_string(i + 1), s.unit), "###value" + std::to_string(i),
                   s.space_principal.values[i],
                   [&, i](double v) {
                       fm::SpacePrincipal principal = s.space_principal;
                       principal.values[i] = v;
                       return with_space_principal(document, principal);
                   },
                   translatable("Change the principal values")});
    for (int i = 0; i < 3; ++i) show_direction(workspace, i);
}

void StatePanel::show_direction(Workspace& workspace, int direction)
{
    Session& session = workspace.session;
    const std::string n = std::to_string(direction + 1);
    const Eigen::Vector3d d = session.solution().space_principal.directions.col(direction);
    const auto text = [&](int digits) {
        std::string all;
        for (const double part : d)
            all += (all.empty() ? "" : "; ") + ui::number_text(part, {digits, session.look.format().mark});
        return all;
    };
    const std::string shown = ui::with_minus_signs(text(3));
    ui::begin_field_row(session.tr()("direction {n}", {{"n", n}}), shown);
    const auto event = fields_.show(
        "###along" + n, {.text = shown, .exact_text = text(12), .value = std::nullopt, .is_typed_only = true});
    if (event.kind != Kind::Typed) return;
    const auto along = vector_typed(event.text);
    if (!along) fields_.reject(event, session.tr()("write three numbers, such as 1; 0; 0"));
    else if (const auto reason = session.set_direction(direction, *along)) fields_.reject(event, session.tr()(*reason));
}

void StatePanel::show_plane(Workspace& workspace)
{
    const Document document = workspace.session.document(); // a copy: a row may change what the session holds
    heading(workspace.tr()("Plane"));
    const ui::Message step = translatable("Turn the plane");
    if (!is_in_space(document.subject))
        return value_row(
            workspace, fields_,
            {"θ [°]", "###angle", document.angle, [&](double v) { return with_angle(document, v); }, step});
    for (std::size_t i = 0; i < 3; ++i)
        value_row(workspace, fields_,
                  {std::string("n") + "xyz"[i], "###normal" + std::to_string(i), document.normal[i],
                   [&, i](double v) {
                       auto normal = document.normal;
                       normal[i] = v;
                       return with_normal(document, normal);
                   },
                   step});
}

void StatePanel::show_material(Workspace& workspace)
{
    const fm::Kind kind = workspace.session.solution().state.kind;
    if (!fm::is_strain(kind) && kind != fm::Kind::PlaneStrain) return;
    heading(workspace.tr()("Material"));
    if (fm::is_strain(kind)) number_row(workspace, "E", {Group::Elasticity, 0});
    number_row(workspace, "ν", {Group::Elasticity, 1});
}

void StatePanel::show_criterion(Workspace& workspace, const CommandTable& commands)
{
    if (workspace.session.document().subject == Subject::Inertia) return;
    heading(workspace.tr()("Criterion"));
    const auto now = workspace.session.document().criterion;
    ui::command_combo(workspace, commands, "###criterion", criteria(),
                      [&](const CriterionEntry& entry) { return entry.value == now; });
    if (!now) return;
    for (const StrengthPlace place : strengths_of(*now)) {
        const std::string unit = place == StrengthPlace::phi ? " [°]" : "";
        number_row(workspace, std::string(name(place)) + unit, {Group::Strength, static_cast<std::size_t>(place)});
    }
}

} // namespace mohr
