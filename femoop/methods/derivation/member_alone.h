#pragma once

#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop::derivation {

/// A member taken out of its structure and held at both nodes: what its loads do while the nodes stand still, and what
/// the motion of its nodes does without loads, each a structure that the analysis solves. Their sum is the member in
/// the structure.
struct MemberAlone {
    Results results;
    CaseResult loaded() const { return results[CaseId(0)]; }
    CaseResult moved() const { return results[CaseId(1)]; }
    static constexpr MemberId member{0};
};

/// \param load_case  a load case, no combination, whose results `solved` are
MemberAlone take_out(const Model& model, MemberId member, const LoadCase& load_case, const CaseResult& solved);

} // namespace femoop::derivation
