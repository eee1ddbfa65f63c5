#pragma once

#include "apps/euler/view/marks.h"
#include "topology/halfedge/solid.h"
#include "topology/script/names.h"

#include <compare>
#include <cstddef>

namespace euler {

/// One of the solids of a picture. The solid and its names outlive whatever draws them.
struct Subject {
    const topology::Solid* solid;
    const topology::Names* names;
    Marks marks{};
};

/// An entity of one of them.
struct Part {
    std::size_t subject = 0;
    topology::Entity entity;

    friend auto operator<=>(const Part&, const Part&) = default;
};

} // namespace euler
