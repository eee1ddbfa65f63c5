#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/document/part.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/ids.h"
#include "femoop/model/model.h"

namespace frame {

/// Where a fault is, step by step, as its first argument says it in the words of the file:
/// load_cases[3] "T".members[0] "CD".at
struct FaultPlace {
    struct Step {
        std::string key;
        std::optional<std::size_t> index{}; ///< of an entry of a list
        std::string name{};                 ///< of the entry; of a load that of its node or member; "" where unknown
    };
    std::vector<Step> steps; ///< at least one

    bool is_load() const; ///< a load or settlement of a load case, or a key of one
    std::string text() const;
};

/// Nothing for a fault that has no place, such as that of a structure which can move.
std::optional<FaultPlace> place_of(const femoop::Fault& fault);

/// The faults with every name that the model has for their places, so that they can be told without it.
std::vector<femoop::Fault> named(std::vector<femoop::Fault> faults, const femoop::Model& model);

/// The load case or combination that alone has the fault: the structure and other cases can be solved without it.
std::optional<femoop::CaseId> case_of(const femoop::Fault& fault, const femoop::Model& model);

/// The part that the place lies in, by its names where it has some. Nothing where the model lacks it.
std::optional<Part> part_at(const FaultPlace& place, const femoop::Model& model);

} // namespace frame
