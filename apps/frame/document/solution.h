#pragma once

#include <optional>
#include <vector>

#include "apps/frame/document/document.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/model/fault/fault.h"
#include "femoop/result/results.h"

namespace frame {

/// A load case or combination that has no results by a fault of its own.
struct BlankCase {
    femoop::CaseId id;
    std::vector<femoop::Fault> faults;           ///< its own, and those of the cases that it sums
    std::vector<femoop::Mechanism> mechanisms{}; ///< motions that its own loads drive
};

/// What is known of a document: its results, or why there are none. A pure function of the document.
struct Solution {
    std::optional<femoop::Results> results;    ///< of every case that is not blank; there is one
    std::vector<femoop::Fault> faults;         ///< errors and warnings of the model, their places named (fault/place.h)
    std::vector<femoop::Mechanism> mechanisms; ///< each way in which the structure can move; then there are no results
    std::vector<BlankCase> blank{}; ///< a fault of one case leaves the others their results; may be all cases

    bool has_errors() const;
    /// Null where the case has results, or the structure itself has none.
    const BlankCase* blank_case(femoop::CaseId id) const;
    std::vector<femoop::CaseId> solved_cases() const; ///< in their order; \pre results
};

/// Checks and solves. Never throws for what a model may contain.
Solution solve(const Document& document);

/// The model with nothing in its blank cases.
femoop::Model without_blank_cases(const femoop::Model& model, const Solution& solution);

/// The same without what is expected: what the results are those of.
femoop::Model solved_model(const femoop::Model& model, const Solution& solution);

} // namespace frame
