#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "apps/plane/backdrop/backdrop.h"
#include "apps/plane/discretize/error_cycle.h"
#include "femoop/plane/model/plane_model.h"

namespace plane {

using femoop::plane::PlaneModel;

/// A plane model that is drawn, which is saved, and how its mesh was refined, which is not; and the image behind it.
struct Document {
    PlaneModel model;
    std::shared_ptr<const discretize::ErrorCycle> cycle{}; ///< of this model; null: its mesh is as the model says
    std::optional<Backdrop> backdrop{};

    /// That its mesh is made by in place of its own; null: none.
    std::shared_ptr<const topology::SizeField> sizes() const { return cycle ? cycle->sizes() : nullptr; }

    friend bool operator==(const Document&, const Document&) = default;
};

/// An empty drawing of a plate in N and mm.
Document new_document();

/// How wide a sheet without a drawing is, in the model's unit of length.
double usual_width(const PlaneModel& model);

/// About how much memory it takes [bytes]: a history is bounded by it.
std::size_t memory_footprint(const Document& document);

/// A ... Z, A1 ... Z1 and so on: the first that no point has.
std::string fresh_point_id(const PlaneModel& model);

} // namespace plane
