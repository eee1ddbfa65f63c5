#include "apps/frame/tables/column.h"

#include <algorithm>
#include <cctype>

#include "apps/frame/document/fault/sentence.h"
#include "femoop/model/quantity/number_text.h"
#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"

namespace frame {

using femoop::Quantity;

namespace {

constexpr int shown_digits = 6; // of data: enough for what people type
constexpr int exact_digits = 15;

std::string with_mark(std::string number, ui::DecimalMark mark)
{
    if (mark == ui::DecimalMark::Comma) std::ranges::replace(number, '.', ',');
    return number;
}

// Every digit in the unit shown. A conversion spoils the last one of seventeen, so that fifteen are written.
std::string all_digits(double stored, ui::Measure measure, const ui::DisplayUnits& units)
{
    const ui::DecimalMark mark = units.format().mark;
    if (units.unit(measure).factor == 1.0) return with_mark(femoop::number_text(stored), mark);
    return ui::number_text(units.shown(stored, measure), {exact_digits, mark});
}

std::string with_true_minus(std::string number)
{
    if (number.starts_with('-')) number.replace(0, 1, "−");
    return number;
}

Cell number_cell(const Quantity& value, ui::Measure measure, const ui::DisplayUnits& units)
{
    const double shown = units.shown(value, measure);
    const ui::NumberFormat format{std::max(shown_digits, units.format().digits), units.format().mark};
    std::string exact = all_digits(value, measure, units);
    std::string typed = value.has_text() ? std::string(value.text()) : exact;
    return {{shown, with_true_minus(ui::number_text(shown, format)), std::move(exact)}, std::move(typed)};
}

std::string lower(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
    return result;
}

} // namespace

Cell cell_of(const CellValue& value, ui::Measure measure, const Manner& manner)
{
    if (const auto* const number = std::get_if<Quantity>(&value)) return number_cell(*number, measure, manner.units);
    if (const auto* const share = std::get_if<femoop::Percent>(&value)) {
        Cell cell = number_cell(share->value, ui::Measure::Plain, manner.units);
        for (std::string* const text : {&cell.value.shown, &cell.value.exact, &cell.typed}) *text += '%';
        return cell;
    }
    if (const auto* const name = std::get_if<std::string>(&value)) return {*name};
    if (const auto* const word = std::get_if<ui::Message>(&value)) return {manner.tr(*word)};
    return {};
}

std::variant<std::optional<Quantity>, std::string> quantity_of(const CellText& entry, ui::Measure measure,
                                                               const femoop::Units& units)
{
    if (entry.is_empty()) return std::optional<Quantity>();
    std::string text(entry.text);
    if (text.starts_with("−")) text.replace(0, std::string_view("−").size(), "-"); // as tables show it
    auto typed = quantity_typed(text, measure, units, entry.manner.units);
    if (auto* const quantity = std::get_if<Quantity>(&typed)) return std::optional(std::move(*quantity));
    std::string reason = sentence(std::get<femoop::Fault>(typed), entry.manner.tr);
    if (reason.starts_with(": ")) reason.erase(0, 2); // the place, which whoever asked knows
    return reason;
}

std::string value_needed(const Manner& manner) { return manner.tr("a value is needed here"); }

bool says(const CellText& entry, std::string_view sentence)
{
    const std::string said = lower(entry.text);
    return said == lower(sentence) || said == lower(entry.manner.tr(sentence));
}

Column number_column(ui::Message heading, ui::Measure measure, NumberAccess access)
{
    Column column{.heading = std::move(heading), .measure = measure, .is_number = true, .read = {}};
    column.read = [get = std::move(access.get)](const femoop::Model& model, const Part& part) -> CellValue {
        if (const std::optional<Quantity> value = get(model, part)) return *value;
        return {};
    };
    column.write = [set = std::move(access.set), measure](Document& document, const Part& part,
                                                          const CellText& entry) -> Refusal {
        auto value = quantity_of(entry, measure, document.model.units);
        if (auto* const reason = std::get_if<std::string>(&value)) return std::move(*reason);
        return set(document, part, std::get<std::optional<Quantity>>(value), entry.manner);
    };
    return column;
}

Column word_column(ui::Message heading, const WordAccess& access)
{
    Column column{.heading = std::move(heading), .read = {}};
    column.read = [access](const femoop::Model& model, const Part& part) -> CellValue {
        return ui::Message(access.words.at(access.get(model, part)));
    };
    column.write = [access](Document& document, const Part& part, const CellText& entry) -> Refusal {
        std::string all;
        for (std::size_t i = 0; i < access.words.size(); ++i) {
            if (says(entry, access.words[i])) {
                access.set(document, part, i);
                return std::nullopt;
            }
            all += (i > 0 ? ", " : "") + entry.manner.tr(access.words[i]);
        }
        return entry.manner.tr("\"{text}\" is none of {words}", {{"text", entry.text}, {"words", all}});
    };
    return column;
}

} // namespace frame
