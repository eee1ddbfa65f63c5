#pragma once

#include <cstddef>
#include <string>

#include "femoop/plane/model/plane_model.h"

namespace plane {

using femoop::plane::PlaneModel;

/// What is saved: a plane model that is drawn.
struct Document {
    PlaneModel model;

    friend bool operator==(const Document&, const Document&) = default;
};

/// An empty drawing of a plate in N and mm.
Document new_document();

/// About how much memory it takes [bytes]: a history is bounded by it.
std::size_t memory_footprint(const Document& document);

/// A ... Z, A1 ... Z1 and so on: the first that no point has.
std::string fresh_point_id(const PlaneModel& model);

} // namespace plane
