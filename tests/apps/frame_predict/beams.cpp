#include "tests/apps/frame_predict/beams.h"

#include <algorithm>
#include <cmath>

#include "femoop/analysis/linear_static.h"

namespace predict_test {

namespace {

void add_member(Model& model, const char* name, NodeId from, NodeId to)
{
    model.add(Member{.id = name, .nodes = {from, to}, .material = MaterialId(0), .section = SectionId(0)});
}

Model bare()
{
    Model model;
    model.add(Material{.id = "steel", .E = 210e6});
    model.add(Section{.id = "s", .A = 0.01, .Iz = 2e-4});
    return model;
}

void load(Model& model, const std::vector<decltype(MemberLoad::load)>& loads)
{
    LoadCase load_case{.id = "P"};
    for (const auto& one : loads) load_case.members.push_back({MemberId(0), one});
    model.add(load_case);
}

} // namespace

Model beam(const Supports& supports, const std::vector<decltype(MemberLoad::load)>& loads)
{
    Model model = bare();
    const NodeId a = model.add(Node{.id = "A", .at = {0, 0}, .support = Support{.kind = supports.left}});
    const NodeId b = model.add(Node{.id = "B", .at = {L, 0}, .support = Support{.kind = supports.right}});
    add_member(model, "AB", a, b);
    load(model, loads);
    return model;
}

Model two_spans(const std::vector<decltype(MemberLoad::load)>& loads_on_first)
{
    Model model = bare();
    const NodeId a = model.add(Node{.id = "A", .at = {0, 0}, .support = Support{.kind = SupportKind::Pin}});
    const NodeId b = model.add(Node{.id = "B", .at = {L, 0}, .support = Support{.kind = SupportKind::Roller}});
    const NodeId c = model.add(Node{.id = "C", .at = {2 * L, 0}, .support = Support{.kind = SupportKind::Roller}});
    add_member(model, "AB", a, b);
    add_member(model, "BC", b, c);
    load(model, loads_on_first);
    return model;
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
