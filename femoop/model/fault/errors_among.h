#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "femoop/model/fault/fault.h"

namespace femoop {

/// The faults without the warnings.
inline std::vector<Fault> errors_among(std::vector<Fault> faults)
{
    std::erase_if(faults, [](const Fault& fault) { return !is_error(fault); });
    return faults;
}

} // namespace femoop
