#pragma once

#include <utility>

#include "topology/halfedge/solid.h"

namespace topology {

/// Tables that were filled in from outside, taken as a solid as they are: the one way past the operators, for readers
/// of files, which validate what they assembled before anyone else sees it.
class Assembly {
public:
    explicit Assembly(Tables tables) { solid_.t_ = std::move(tables); }
    const Solid& solid() const { return solid_; }

private:
    Solid solid_;
};

} // namespace topology
