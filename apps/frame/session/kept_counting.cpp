#include "apps/frame/session/kept_counting.h"

#include "femoop/model/fault/fault.h"

namespace frame {

namespace {

std::optional<femoop::counting::Counting> counted(const femoop::Model& model)
{
    if (model.members.empty()) return std::nullopt;
    try {
        return femoop::counting::count(model);
    } catch (const femoop::ModelError&) {
        return std::nullopt;
    }
}

} // namespace

const femoop::counting::Counting* KeptCounting::of(const femoop::Model& model, std::uint64_t generation) const
{
    if (generation_ != generation) counting_ = counted(model);
    generation_ = generation;
    return counting_ ? &*counting_ : nullptr;
}

} // namespace frame
