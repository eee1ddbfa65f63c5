#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/mohr/document/document.h"
#include "ui/text/message.h"

namespace mohr {

/// The text of a file (.mohr): JSON of what the document holds, of its own subject's numbers.
///
///     {"cremona": 1, "mohr": "plane_stress", "state": ["50 MPa", "-10 MPa", "40 MPa"], "angle": 20,
///      "normal": [1, 1, 1], "E": "200 GPa", "nu": "0.3",
///      "criterion": "tresca", "strength": {"fy": "250 MPa"}}
std::string file_text(const Document& document);

/// What a text says, or everything that is wrong with it. What it does not say is as in `textbook_state`.
std::variant<Document, std::vector<ui::Message>> read_file_text(std::string_view text);

/// What a section has in common with the frame that it is of, as the text of a file: the section, what it carries and
/// the material, with all else as in `textbook_state`.
std::string file_text_of_section(const Document& document);
/// The document with what such a text says. The fibre stays where it is if the section reaches it.
Document with_section_of(const Document& document, const Document& other);

std::string_view word(Subject subject); ///< "plane_stress"

} // namespace mohr
