#pragma once

#include <cstdint>
#include <optional>

#include "femoop/methods/counting/counting.h"
#include "femoop/model/model.h"

namespace frame {

/// What the degree of indeterminacy of a model is made of, counted when it is first asked for.
class KeptCounting {
public:
    /// Null where the model has errors, or no members.
    /// \param generation  grows whenever the model changes
    const femoop::counting::Counting* of(const femoop::Model& model, std::uint64_t generation) const;

private:
    mutable std::optional<std::uint64_t> generation_;
    mutable std::optional<femoop::counting::Counting> counting_;
};

} // namespace frame
