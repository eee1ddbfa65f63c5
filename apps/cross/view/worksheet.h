#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "apps/cross/document/document.h"
#include "apps/cross/document/solution.h"
#include "femoop/methods/cross/exercise/hint.h"
#include "femoop/methods/cross/exercise/judge.h"
#include "ui/text/display_units.h"

namespace cross {

/// A pupil's sheet with what was written into it and what is said of that.
struct Worksheet {
    femoop::cross::Form form;
    std::vector<std::optional<femoop::cross::Entry>> entries;
    std::vector<femoop::cross::Judgement> judgements;
    bool shows_judgement = true; ///< false: the teacher has it judged at the end

    bool is_good(femoop::cross::BlankId id) const; ///< right, or by the right operation
    bool is_written(femoop::cross::BlankId id) const { return entries[id.index].has_value(); }
    /// Every cell is good; those that may stay empty need nothing.
    bool is_solved() const;
    std::size_t n_needed() const; ///< cells that may not stay empty
    std::size_t n_sheets() const { return form.n_sheets(); }
    /// The sheet that a cell stands on; n_sheets() for those of all sheets together.
    std::size_t stage_of(femoop::cross::BlankId id) const;
    std::size_t n_stages() const { return n_sheets() + (n_sheets() > 1 ? 1 : 0); }
};

/// The paper of a document whose sheet a pupil fills; nothing where its structure cannot be distributed, or where the
/// sheet would be too long.
std::optional<Worksheet> worksheet_of(const Document& document);
/// The same with other numbers written into it.
void judge_again(Worksheet& worksheet, const Document& document);

/// What a cell's numbers are counted in: "kN·m", "1/m", "" for a plain number; and how many of the model's units that
/// is.
struct CellUnit {
    std::string name;
    double size = 1.0;
};
CellUnit unit_of(const Worksheet& worksheet, femoop::cross::BlankId id, const ui::DisplayUnits& units);

/// What belongs into a cell for the numbers that were had, as a pupil would write it.
std::string text_for(const Worksheet& worksheet, femoop::cross::BlankId id, const ui::DisplayUnits& units);

} // namespace cross
