#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "apps/frame/document/document.h"
#include "apps/frame/document/number.h"
#include "apps/frame/document/part.h"
#include "apps/frame/tables/table.h"
#include "femoop/model/load.h"
#include "femoop/model/quantity/quantity.h"
#include "ui/text/message.h"

namespace frame {

/// What a cell holds: nothing, a number, a share of a length, a name or a word of ours.
using CellValue = std::variant<std::monostate, femoop::Quantity, femoop::Percent, std::string, ui::Message>;

/// A load that is to go to another load case, once all cells are written: until then its place must stay.
struct CaseMove {
    Part load;
    std::size_t load_case = 0;
};

/// A text on its way into a cell.
struct CellText {
    std::string_view text;
    const Manner& manner;
    std::vector<CaseMove>& moves;

    bool is_empty() const { return text.empty() || text == "–" || text == "-"; }
};

/// Why a text cannot go into a cell, as a sentence in the reader's language.
using Refusal = std::optional<std::string>;

/// One property of all parts of a kind.
struct Column {
    ui::Message heading; ///< without its unit
    ui::Measure measure = ui::Measure::Plain;
    bool is_number = false;
    Need need = Need::Optional; ///< whether a new row must have it
    std::function<CellValue(const femoop::Model&, const Part&)> read;
    std::function<Refusal(Document&, const Part&, const CellText&)> write{}; ///< absent: cannot be changed here
};

Cell cell_of(const CellValue& value, ui::Measure measure, const Manner& manner);

/// Reads the entry as a quantity, or says why it is none. An empty one is nothing.
std::variant<std::optional<femoop::Quantity>, std::string> quantity_of(const CellText& entry, ui::Measure measure,
                                                                       const femoop::Units& units);

/// The sentence for an empty cell that must hold something.
std::string value_needed(const Manner& manner);

/// Does the text say this word, in the reader's language or in English?
bool says(const CellText& entry, std::string_view sentence);

/// A column of numbers that are read and set by functions. `set` may refuse.
struct NumberAccess {
    std::function<std::optional<femoop::Quantity>(const femoop::Model&, const Part&)> get;
    std::function<Refusal(Document&, const Part&, const std::optional<femoop::Quantity>&, const Manner&)> set;
};
Column number_column(ui::Message heading, ui::Measure measure, NumberAccess access);

/// A column of words out of a list.
struct WordAccess {
    std::vector<std::string_view> words; ///< translatable
    std::function<std::size_t(const femoop::Model&, const Part&)> get;
    std::function<void(Document&, const Part&, std::size_t)> set;
};
Column word_column(ui::Message heading, const WordAccess& access);

/// A column of numbers that the parts hold as fields: find(model, part) is the address of a Quantity or of an
/// optional one, for a const model and for another; null where the part has none.
template <class Find> Column field_column(ui::Message heading, ui::Measure measure, Find find)
{
    const auto get = [find](const femoop::Model& model, const Part& part) -> std::optional<femoop::Quantity> {
        const auto* const field = find(model, part);
        if (field == nullptr) return std::nullopt;
        return *field;
    };
    const auto set = [find](Document& document, const Part& part, const std::optional<femoop::Quantity>& value,
                            const Manner& manner) -> Refusal {
        auto* const field = find(document.model, part);
        if (field == nullptr) return manner.tr("this row has no such value");
        if constexpr (std::is_same_v<std::remove_pointer_t<decltype(find(document.model, part))>, femoop::Quantity>) {
            if (!value) return value_needed(manner);
            *field = *value;
        } else {
            *field = value;
        }
        return std::nullopt;
    };
    return number_column(std::move(heading), measure, {get, set});
}

} // namespace frame
