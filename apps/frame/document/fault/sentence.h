#pragma once

#include <string>
#include <string_view>

#include "femoop/model/fault/fault.h"
#include "ui/text/catalogue.h"

namespace frame {

/// A fault as the apps tell it, to somebody who never saw the file: it names the case, the part and the field to fill
/// in by their labels. The command line tells the same fault in the words of the file (femoop::message). \pre the
/// fault's place is `named` (place.h); else parts are told by their numbers
std::string sentence(const femoop::Fault& fault, const ui::Catalogue& tr);

/// The English sentence of the apps: {0} ... as in femoop::pattern, but {0} is the part in words, {8} the label of the
/// field to fill in and {9} the table it stands in.
std::string_view spoken_pattern(femoop::FaultKind kind);

} // namespace frame
