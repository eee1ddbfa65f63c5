// Diagrams of a former solution.
#include "apps/drawing/results/diagram.h"

#include <algorithm>
#include <optional>
#include <string>

namespace drawing {

namespace {

bool lies_there_now(const Scene& former, std::size_t i, const Scene& present)
{
    constexpr double nothing = 1e-6; // of the structure's size
    const std::string& id = former.model.members[i].id;
    const bool is_same_place = i < present.model.members.size() && present.model.members[i].id == id;
    const auto now = is_same_place ? femoop::MemberId(i) : present.model.find_member(id);
    if (!now) return false;
    const MemberShape &a = former.shape.members[i], &b = present.shape[*now];
    return std::max((a.start - b.start).norm(), (a.end - b.end).norm()) <= nothing * present.shape.size;
}

} // namespace

void draw_reference_members(const Scene& former, const Scene& present)
{
    ui::Stroke stroke = former.sketch.thin(ui::Role::Member);
    stroke.color = ui::with_opacity(stroke.color, 0.5);
    for (std::size_t i = 0; i < former.shape.members.size(); ++i) {
        const MemberShape& member = former.shape.members[i];
        if (lies_there_now(former, i, present)) continue;
        former.sketch.line(former.projection(member.start), former.projection(member.end), stroke, Clearance::Soft);
    }
}

void draw_reference(const Scene& scene, const SolvedCase& solved, const Diagram& diagram, double part)
{
    if (diagram.is_zero()) return;
    Sketch& sketch = scene.sketch;
    ui::Stroke stroke = sketch.thin(role_of(diagram.component));
    stroke.color = ui::with_opacity(stroke.color, 0.6);
    stroke.dash = {5.0, 3.0};
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i) {
        const femoop::Curve& curve = solved.curves.at(i);
        const SymbolFrame frame = diagram_frame(scene, scene.shape.members[i], diagram.component);
        const auto at = [&](double x, double value) {
            return frame(x * scene.projection.scale(), value * part * diagram.pixels_per_unit);
        };
        std::vector<ui::Point> line{at(0.0, 0.0)};
        for (const Ordinate& o :
             ordinates_of(SectionForce(curve, diagram.component), 0.3 / (part * diagram.pixels_per_unit)))
            line.push_back(at(o.x, o.value));
        line.push_back(at(curve.length(), 0.0));
        sketch.polyline(line, stroke, Clearance::Soft);
    }
}

int part_of_scale(double former, double present)
{
    constexpr double most = 2.5; // times the present height
    for (int decade = 1; decade < 100000000; decade *= 10)
        for (const int step : {1, 2, 5})
            if (former <= most * present * step * decade) return step * decade;
    return 1000000000;
}

} // namespace drawing
