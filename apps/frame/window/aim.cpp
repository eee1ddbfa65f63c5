#include "apps/frame/window/aim.h"

#include <algorithm>
#include <cmath>

#include "femoop/edit/member_line.h"

namespace frame {

using Eigen::Vector2d;

namespace {

constexpr double snap_reach = 10.0;   // [px]
constexpr double grid_spacing = 16.0; // [px] at least
constexpr double grip_reach = 6.0;    // [px]

double distance_to(ui::Point a, ui::Point b, ui::Point p)
{
    const ui::Point along = b - a;
    const double square = ui::dot(along, along);
    const double t = square > 0.0 ? std::clamp(ui::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return ui::distance(p, a + t * along);
}

// By the count of its edges that a ray to the right crosses.
bool is_inside(const std::vector<ui::Point>& area, ui::Point p)
{
    bool is_in = false;
    for (std::size_t i = 0, j = area.size() - 1; i < area.size(); j = i++) {
        const bool straddles = (area[i].y > p.y) != (area[j].y > p.y);
        if (straddles && p.x < area[i].x + (area[j].x - area[i].x) * (p.y - area[i].y) / (area[j].y - area[i].y))
            is_in = !is_in;
    }
    return is_in;
}

bool is_under(const LoadMark& mark, ui::Point p)
{
    if (mark.area.size() > 2 && is_inside(mark.area, p)) return true;
    for (std::size_t i = 1; i < mark.area.size(); ++i)
        if (distance_to(mark.area[i - 1], mark.area[i], p) <= grip_reach) return true;
    return false;
}

std::optional<SupportGrip> support_at(const Projection& projection, ui::Point at, std::span<const SupportMark> marks)
{
    const auto mark = std::ranges::find_if(marks,
                                           [&](const auto& m) { return ui::distance(m.middle, at) <= m.radius; });
    if (mark == marks.end()) return std::nullopt;
    const auto root = place_in_plane(projection, mark->root), pressed = place_in_plane(projection, at);
    const bool has_direction = root && pressed && *root != *pressed; // not where the plane is seen from its edge
    return SupportGrip{mark->node, has_direction ? direction_of(*pressed - *root) : 0.0};
}

std::optional<DimensionPlace> dimension_at(ui::Point at, std::span<const DimensionMark> marks)
{
    const auto mark = std::ranges::find_if(
        marks, [&](const DimensionMark& m) { return distance_to(m.start, m.end, at) <= grip_reach; });
    return mark != marks.end() ? std::optional(mark->dimension) : std::nullopt;
}

std::optional<LoadGrip> grip_at(const Projection& projection, ui::Point at, std::span<const LoadMark> marks)
{
    const auto mark = std::ranges::find_if(marks, [&](const LoadMark& m) { return is_under(m, at); });
    if (mark == marks.end()) return std::nullopt;
    const auto root = place_in_plane(projection, mark->root), tip = place_in_plane(projection, mark->tip);
    if (!root || !tip || *root == *tip) return std::nullopt;
    return LoadGrip{mark->load, mark->dof, *tip - *root};
}

} // namespace

std::optional<Vector2d> place_in_plane(const Projection& projection, ui::Point at)
{
    const ui::Point origin = projection(Eigen::Vector3d::Zero());
    const ui::Point x = projection.direction(Eigen::Vector3d::UnitX()),
                    y = projection.direction(Eigen::Vector3d::UnitY());
    const double determinant = projection.scale() * (x.x * y.y - x.y * y.x);
    if (std::abs(determinant) < 1e-6 * projection.scale()) return std::nullopt;
    const ui::Point r = at - origin;
    return Vector2d(r.x * y.y - r.y * y.x, x.x * r.y - x.y * r.x) / determinant;
}

std::optional<Eigen::Vector3d> place_in_working_plane(const Projection& projection, const WorkingPlane& plane,
                                                      ui::Point at)
{
    const ui::Point origin = projection(plane.in_space({0.0, 0.0})), u = projection.direction(plane.first()),
                    v = projection.direction(plane.second());
    constexpr double flattest = 0.05; // of the area that is seen from the front
    const double determinant = u.x * v.y - v.x * u.y;
    if (std::abs(determinant) < flattest) return std::nullopt;
    const ui::Point r = (1.0 / (projection.scale() * determinant)) * (at - origin);
    return plane.in_space({r.x * v.y - r.y * v.x, u.x * r.y - u.y * r.x});
}

namespace {

/// To which places are rounded that nothing draws: the hand hardly feels it.
double fine_step(const ToolSettings& settings, const Projection& projection)
{
    return 0.1 * std::min(settings.grid, grid_of(projection));
}

/// The place that is meant on the member under the pointer.
SnapInSpace on_member(const Aim& aim, const femoop::Model& model, const ToolController& tool_controller)
{
    const femoop::MemberLine line = femoop::line_of(model, model[aim.cut->member]);
    const double seen = distance(aim.projection(line.start), aim.projection(line.at(line.length))); // [px]
    return snap_on_member(model, *aim.cut,
                          {.reach = seen > 0.0 ? snap_reach * line.length / seen : 0.0,
                           .fine = fine_step(tool_controller.settings(), aim.projection),
                           .from = tool_controller.tool().from_in_space(),
                           .is_off = aim.is_exact});
}

/// In space a hand means the node under the pointer, else a place of the member there, else one of the working plane.
void aim_in_space(Aim& aim, const femoop::Model& model, const ToolController& tool_controller)
{
    const ToolSettings& settings = tool_controller.settings();
    const WorkingPlane& plane = settings.plane;
    aim.snap.kind = SnapKind::Grid;
    if (settings.draws_to_parts && aim.node) {
        aim.in_space = femoop::position_of(model, *aim.node);
        aim.snap.kind = SnapKind::Node;
    } else if (settings.draws_to_parts && aim.cut) {
        const SnapInSpace meant = on_member(aim, model, tool_controller);
        aim.in_space = meant.place;
        aim.snap.kind = meant.kind;
    } else {
        aim.in_space = place_in_working_plane(aim.projection, plane, aim.on_sheet);
    }
    aim.is_lost = !aim.in_space;
    if (aim.snap.kind != SnapKind::Grid || aim.is_lost || aim.is_exact) return;
    const double step = settings.draws_to_grid ? settings.grid : fine_step(settings, aim.projection);
    const Vector2d steps = (plane.in_plane(*aim.in_space) / step).array().round();
    aim.in_space = plane.in_space(step * steps);
}

} // namespace

double grid_of(const Projection& projection) { return round_grid(grid_spacing / projection.scale()); }

Aim aim_at(const Document& document, const ToolController& tool_controller, const Projection& projection,
           const Pointer& pointer, const Pick& under, const Grips& grips)
{
    Aim aim;
    aim.node = under.node;
    aim.cut = under.cut;
    aim.adds = pointer.adds;
    aim.is_exact = pointer.is_exact;
    aim.on_sheet = pointer.at;
    aim.projection = projection;
    aim.pixel = 1.0 / projection.scale();
    const bool is_near = under.node || under.is_on_member;
    if (!is_near) {
        aim.support = support_at(projection, pointer.at, grips.supports);
        aim.dimension = dimension_at(pointer.at, grips.dimensions);
        aim.grip = grip_at(projection, pointer.at, grips.loads);
        aim.cut.reset(); // what is read at a distance is not touched
    }
    aim.pointer = place_in_plane(projection, pointer.at).value_or(Vector2d::Zero());
    if (femoop::is_3d(document.model.analysis)) {
        aim_in_space(aim, document.model, tool_controller);
        return aim;
    }
    const ToolSettings& settings = tool_controller.settings();
    aim.snap = snap(document.model, aim.pointer,
                    {.reach = snap_reach * aim.pixel,
                     .grid = settings.draws_to_grid ? settings.grid : 0.0,
                     .fine = fine_step(settings, projection),
                     .from = tool_controller.tool().from(),
                     .moving = tool_controller.tool().moving(),
                     .to_parts = settings.draws_to_parts,
                     .is_off = pointer.is_exact || !tool_controller.tool().snaps()});
    return aim;
}

} // namespace frame
