#pragma once

#include <optional>
#include <vector>

#include "apps/frame/document/document.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/model/fault/fault.h"
#include "femoop/result/results.h"

namespace frame {

/// What is known of a document: its results, or why there are none. A pure function of the document.
struct Solution {
    std::optional<femoop::Results> results;
    std::vector<femoop::Fault> faults;         ///< errors and warnings of the model
    std::vector<femoop::Mechanism> mechanisms; ///< each way in which the structure can move; then there are no results

    bool has_errors() const;
};

/// Checks and solves. Never throws for what a model may contain.
Solution solve(const Document& document);

} // namespace frame
