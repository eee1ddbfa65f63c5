#include "tests/apps/frame_predict/beams.h"

#include <algorithm>
#include <cmath>

#include "femoop/analysis/linear_static.h"
#include "tests/frame_maker.h"

namespace predict_test {

namespace {

FrameMaker maker() { return FrameMaker({.id = "s", .A = 0.01, .Iz = 2e-4}); }

Model loaded(FrameMaker& made, const std::vector<decltype(MemberLoad::load)>& loads)
{
    for (const auto& one : loads) made.load("AB", one);
    return made.model;
}

} // namespace

Model beam(const Supports& supports, const std::vector<decltype(MemberLoad::load)>& loads)
{
    FrameMaker made = maker();
    return loaded(made.node("A", 0, 0, supports.left).node("B", L, 0, supports.right).member("A", "B"), loads);
}

Model two_spans(const std::vector<decltype(MemberLoad::load)>& loads_on_first)
{
    FrameMaker made = maker();
    made.node("A", 0, 0, SupportKind::Pin)
        .node("B", L, 0, SupportKind::Roller)
        .node("C", 2 * L, 0, SupportKind::Roller);
    return loaded(made.member("A", "B").member("B", "C"), loads_on_first);
}

DistributedLoad uniform(double q) { return {.values = {{.dof = Dof::uy, .start = -q}}}; }
DistributedLoad trapezoid(double q1, double q2) { return {.values = {{.dof = Dof::uy, .start = -q1, .end = -q2}}}; }
PointLoad force(double x, double P) { return {.at = Quantity(x), .components = {{Dof::uy, -P}}}; }
PointLoad moment(double x, double M) { return {.at = Quantity(x), .components = {{Dof::rz, M}}}; }

Curve moments(const Model& model, std::size_t member) { return analyse(model).at("P").curve(MemberId(member)); }

Diagram true_diagram(const Curve& curve)
{
    const Extremes extremes = curve.extremes(MemberComponent::Mz);
    const double largest = std::max(std::abs(extremes.max.value), std::abs(extremes.min.value));
    return [curve, largest](double x) { return 0.3 * curve.value(MemberComponent::Mz, x * curve.length()) / largest; };
}

std::vector<frame::StrokePoint> stroke(const Diagram& diagram, const std::vector<double>& also)
{
    std::vector<double> places = also;
    for (int i = 0; i <= 100; ++i) places.push_back(i / 100.0);
    for (const double x : also) places.push_back(x - 1e-6);
    std::ranges::sort(places);
    std::vector<frame::StrokePoint> points;
    for (const double x : places) points.push_back({x, diagram(x)});
    return points;
}

frame::Guess drawn(const Diagram& diagram, const std::vector<double>& also)
{
    frame::Guess guess;
    guess.draw(stroke(diagram, also));
    return guess;
}

frame::Score scored(const Curve& curve, const frame::Guess& guess)
{
    return frame::score(frame::truth(curve, MemberComponent::Mz), guess);
}

} // namespace predict_test
