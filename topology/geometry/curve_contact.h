#pragma once

#include <vector>

#include "topology/geometry/curve.h"

namespace topology {

/// Where two curves cross or touch: the parameter of each, and the place.
struct CurveContact {
    double t = 0.0, u = 0.0;
    FlatPoint at;
};

/// All contacts of two curves.
struct CurveContacts {
    std::vector<CurveContact> places; ///< ascending in t
    /// They lie on one another along a stretch, and are not two straight lines, nor two arcs of one circle.
    bool run_together = false;
};

/// Where two curves cross, and where they touch: where they come as close as `snap` without crossing, or cross twice
/// with less than that between the crossings, there is one contact. Two straight lines along one another, and two arcs
/// of one circle, have none: they meet in their ends. The same two curves always meet in the same places, bit for bit,
/// whichever comes first and whichever way they run.
/// Method  closed forms for straight lines and circles; else both are halved until they are apart, or cross at an angle
///         that leaves one crossing, which Newton's steps find; where they stay close and parallel, they touch
CurveContacts contacts(const Curve& a, const Curve& b, double snap);

} // namespace topology
