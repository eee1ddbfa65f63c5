#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"
#include "ui/text/message.h"

namespace plane {

/// What has a name: an entry of a list.
using Named = std::variant<NodeId, CurveId, RegionId, MaterialId, femoop::CaseId>;

const std::string& name_of(const PlaneModel& model, const Named& entry);
/// Why an entry cannot have this name; nothing where it can.
std::optional<ui::Message> why_not_named(const PlaneModel& model, const Named& entry, std::string_view name);
/// \pre it can have the name
void rename(Document& document, const Named& entry, std::string name);

} // namespace plane
