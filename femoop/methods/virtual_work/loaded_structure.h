#pragma once

#include <cstddef>
#include <vector>

#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/element/span_load.h"
#include "femoop/load/case_terms.h"
#include "femoop/model/model.h"
#include "femoop/result/magnitudes.h"
#include "femoop/result/results.h"

namespace femoop::virtual_work {

/// A loading of a structure with its results. \pre both live as long as this
struct Loading {
    const Model& model;
    const Results& results;
    CaseId load_case;
};

/// Of a member's end, the axis along which or about which a section force acts.
LocalAxis axis_of(MemberComponent force);

/// A loading, as far as its members and supports are asked.
class LoadedStructure {
public:
    explicit LoadedStructure(const Loading& loading);

    const Discretisation& structure() const { return structure_; }
    const CaseResult& result() const { return result_; }
    const Magnitudes& magnitudes() const { return magnitudes_; }
    SpanLoading span_loading(MemberId member) const;

private:
    Discretisation structure_;
    std::vector<CaseLoads> loads_;
    std::vector<CaseTerms::Term> terms_;
    CaseResult result_;
    Magnitudes magnitudes_;
};

/// A section force between a member's end (0 or 1) and its node: before what acts on the very end.
double force_in_joint(const Curve& curve, const SpanLoading& loading, std::size_t end, MemberComponent force);

/// From global axes to those of a support.
NodeVector in_axes_of(const Discretisation::SupportRow& support, NodeVector v);

} // namespace femoop::virtual_work
