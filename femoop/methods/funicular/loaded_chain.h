#pragma once

#include <span>
#include <variant>

#include "femoop/methods/funicular/chain.h"
#include "femoop/methods/funicular/funicular.h"

namespace femoop::funicular {

/// What the funiculars of a load case have in common, whatever their closing line and their rise.
struct LoadedChain {
    Chain chain;
    SimpleSpan span; ///< under the loads of the case
};

/// \param members  its links; none: the only chain of the structure
/// \pre the members and the case are of the model, which can be discretised
std::variant<LoadedChain, Refusal> loaded_chain(const Model& model, std::span<const MemberId> members,
                                                CaseId load_case);

} // namespace femoop::funicular
