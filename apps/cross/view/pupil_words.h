#pragma once

#include "apps/cross/view/worksheet.h"
#include "ui/text/message.h"

namespace cross {

ui::Message words_of(femoop::cross::Difficulty difficulty); ///< "overhang, several EI"

/// "2nd turn, joint C: balance of CB", without unit.
ui::Message question(const Worksheet& worksheet, const femoop::Model& model, femoop::cross::BlankId id);

/// What kind of mistake it was; and an operation, never its number.
ui::Message words_of(femoop::cross::Slip slip);
ui::Message words_of(femoop::cross::Hint hint);

/// What is said of a cell: "right", "right for the numbers that you had", the mistake; nothing for an empty one.
ui::Message verdict_text(const femoop::cross::Judgement& judgement);

} // namespace cross
