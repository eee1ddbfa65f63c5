#pragma once

#include <optional>
#include <string>

#include "femoop/model/model.h"

namespace frame {

/// A number of the results, by the name of its node or member, so that it goes on while the model changes.
struct NamedEffect {
    std::string node, member; ///< one of them
    femoop::MovingEffect effect;

    NamedEffect(const femoop::Model& model, const femoop::MovingEffect& of);
};

/// The same number of a model; a place beyond the end of its member is its end. Nothing where its part is gone.
std::optional<femoop::MovingEffect> effect_in(const femoop::Model& model, const NamedEffect& named);

} // namespace frame
