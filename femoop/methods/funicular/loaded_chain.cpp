#include "femoop/methods/funicular/loaded_chain.h"

#include <utility>
#include <vector>

namespace femoop::funicular {

std::variant<LoadedChain, Refusal> loaded_chain(const Model& model, std::span<const MemberId> members, CaseId load_case)
{
    const Discretisation structure = discretise(model);
    const std::vector<MemberId> across = members.empty() ? members_across(structure) : std::vector<MemberId>();
    const std::span<const MemberId> links = members.empty() ? across : members;
    if (auto refusal = why_no_chain(structure, links)) return *std::move(refusal);
    Chain chain = chain_of(structure, links);
    if (auto refusal = why_no_vertical_loads(model, structure, chain, load_case)) return *std::move(refusal);
    SimpleSpan span(chain.left().x(), chain.right().x(), vertical_loads(model, structure, chain, load_case));
    return LoadedChain{std::move(chain), std::move(span)};
}

} // namespace femoop::funicular
