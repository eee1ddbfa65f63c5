#pragma once

#include <functional>
#include <vector>

#include "apps/frame/predict/prediction.h"
#include "femoop/model/model.h"

namespace predict_test {

using namespace femoop;

constexpr double L = 6.0; ///< of every member [m]

/// A beam AB of length L with one load case "P", or with a second span BC of the same length.
struct Supports {
    SupportKind left, right;
};
Model beam(const Supports& supports, const std::vector<decltype(MemberLoad::load)>& loads);
Model two_spans(const std::vector<decltype(MemberLoad::load)>& loads_on_first);

inline constexpr Supports simple{SupportKind::Pin, SupportKind::Roller};
inline constexpr Supports fixed{SupportKind::Fixed, SupportKind::Fixed};
inline constexpr Supports propped{SupportKind::Fixed, SupportKind::Roller};

DistributedLoad uniform(double q);               ///< [kN/m] down, on the whole member
DistributedLoad trapezoid(double q1, double q2); ///< [kN/m] down
PointLoad force(double x, double P);             ///< [kN] down
PointLoad moment(double x, double M);            ///< [kN m] counter-clockwise

/// A member's moments under the case "P".
Curve moments(const Model& model, std::size_t member = 0);

/// A diagram as a function of x/L.
using Diagram = std::function<double(double)>;
/// The true one, its largest ordinate 0.3 lengths.
Diagram true_diagram(const Curve& curve);
/// Drawn from the left to the right, a point every hundredth of the length, and two at each place of `also`.
frame::Guess drawn(const Diagram& diagram, const std::vector<double>& also = {});
std::vector<frame::StrokePoint> stroke(const Diagram& diagram, const std::vector<double>& also = {});

frame::Score scored(const Curve& curve, const frame::Guess& guess);

} // namespace predict_test
