#include "ui/context/offered_copy.h"

#include <utility>

namespace ui {

OfferedCopy::OfferedCopy(Copy copy) : copy_(std::move(copy)) {}
OfferedCopy::~OfferedCopy() = default;

} // namespace ui
