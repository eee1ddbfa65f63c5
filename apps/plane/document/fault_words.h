#pragma once

#include <optional>
#include <string>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"
#include "femoop/model/fault/fault.h"
#include "ui/text/catalogue.h"

namespace plane {

/// A fault in the words of the app: it names the point, curve or region where the file's reader is told the place in
/// the file.
std::string sentence(const femoop::Fault& fault, const PlaneModel& model, const ui::Catalogue& tr);

/// What a click on the fault selects: the part that it is about, a face without a region too. Nothing where it is about
/// none. \param drawing  null where there is none
std::optional<Part> part_of(const femoop::Fault& fault, const PlaneModel& model, const discretize::Drawing* drawing);

} // namespace plane
