#pragma once

#include "apps/cross/view/paper.h"
#include "ui/text/phrase.h"

namespace cross {

ui::Phrase words_of(femoop::cross::Difficulty difficulty); ///< "overhang, several EI"

/// "2nd turn, joint C: balance of CB", without unit.
ui::Phrase question(const Paper& paper, const femoop::Model& model, femoop::cross::BlankId id);

/// What kind of mistake it was; and an operation, never its number.
ui::Phrase words_of(femoop::cross::Slip slip);
ui::Phrase words_of(femoop::cross::Hint hint);

/// What is said of a cell: "right", "right for the numbers that you had", the mistake; nothing for an empty one.
ui::Phrase verdict_words(const femoop::cross::Judgement& judgement);

} // namespace cross
