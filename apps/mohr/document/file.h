#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/mohr/document/document.h"
#include "ui/text/phrase.h"

namespace mohr {

/// The text of a file (.mohr): JSON of what the document holds, of its own subject's numbers.
///
///     {"cremona": 1, "mohr": "plane_stress", "state": ["50 MPa", "-10 MPa", "40 MPa"], "angle": 20,
///      "normal": [1, 1, 1], "E": "200 GPa", "nu": "0.3",
///      "criterion": "tresca", "strength": {"fy": "250 MPa"}}
std::string file_text(const Document& document);

/// What a text says, or everything that is wrong with it. What it does not say is as in `textbook_state`.
std::variant<Document, std::vector<ui::Phrase>> read_file_text(std::string_view text);

std::string_view word(Subject subject); ///< "plane_stress"

} // namespace mohr
