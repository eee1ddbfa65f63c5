#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "apps/plane/discretize/error_cycle.h"
#include "femoop/plane/model/plane_model.h"

namespace plane {

using femoop::plane::PlaneModel;

/// A plane model that is drawn, which is saved, and how its mesh was refined, which is not.
struct Document {
    PlaneModel model;
    std::shared_ptr<const discretize::ErrorCycle> cycle{}; ///< of this model; null: its mesh is as the model says

    /// That its mesh is made by in place of its own; null: none.
    std::shared_ptr<const topology::SizeField> sizes() const { return cycle ? cycle->sizes() : nullptr; }

    friend bool operator==(const Document&, const Document&) = default;
};

/// An empty drawing of a plate in N and mm.
Document new_document();

/// About how much memory it takes [bytes]: a history is bounded by it.
std::size_t memory_footprint(const Document& document);

/// A ... Z, A1 ... Z1 and so on: the first that no point has.
std::string fresh_point_id(const PlaneModel& model);

} // namespace plane
