#include "apps/plane/window/tool_icon.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace plane {

using ui::Point;
using ui::Role;

namespace {

/// Icons are drawn on a square of 24 units.
class Icon {
public:
    Icon(ui::Painter& painter, const ui::Theme& theme)
        : painter_(painter), ink_(theme.stroke(Role::Member).color), unit_(painter.size().width / 24.0)
    {}

    void select()
    {
        painter_.polygon({at(6, 3), at(6, 19), at(10, 15.5), at(12.5, 21), at(15, 20), at(12.5, 14.5), at(18, 14.5)},
                         ink_);
    }
    void line()
    {
        painter_.line(at(4, 19), at(20, 5), stroke());
        ends({at(4, 19), at(20, 5)});
    }
    void polyline()
    {
        painter_.polyline({at(3, 19), at(8, 6), at(14, 17), at(21, 5)}, stroke());
        ends({at(3, 19), at(21, 5)});
    }
    void arc()
    {
        curve(at(12, 20), 10.0, 10.0, 180.0, 0.0);
        ends({at(2, 20), at(12, 10), at(22, 20)});
    }
    void arc_center()
    {
        curve(at(4, 20), 15.0, 15.0, 90.0, 0.0);
        ends({at(4, 20), at(4, 5), at(19, 20)});
    }
    void circle()
    {
        painter_.circle(at(12, 12), 8.5 * unit_, stroke());
        ends({at(12, 12)});
    }
    void ellipse()
    {
        curve(at(12, 12), 10.0, 6.0, 0.0, 360.0);
        ends({at(12, 12)});
    }
    void bezier()
    {
        smooth([](double t) {
            const double u = 1.0 - t;
            return Point{3.0 * u * u * u + 3.0 * u * u * t * 4.0 + 3.0 * u * t * t * 20.0 + t * t * t * 21.0,
                         19.0 * u * u * u + 3.0 * u * u * t * 0.0 + 3.0 * u * t * t * 24.0 + t * t * t * 5.0};
        });
        ends({at(3, 19), at(21, 5)});
    }
    void spline()
    {
        smooth([](double t) { return Point{3.0 + 18.0 * t, 12.0 - 6.0 * std::sin(2.0 * std::numbers::pi * t)}; });
        ends({at(3, 12), at(12, 12), at(21, 12)});
    }
    void point() { painter_.disc(at(12, 12), 4.5 * unit_, ink_); }
    void erase()
    {
        painter_.line(at(5, 5), at(19, 19), stroke());
        painter_.line(at(19, 5), at(5, 19), stroke());
    }

    void probe()
    {
        painter_.circle(at(12, 12), 5.5 * unit_, stroke());
        painter_.disc(at(12, 12), 1.8 * unit_, ink_);
        for (const auto& [from, to] : {std::pair{at(12, 1), at(12, 6)}, std::pair{at(12, 18), at(12, 23)},
                                       std::pair{at(1, 12), at(6, 12)}, std::pair{at(18, 12), at(23, 12)}})
            painter_.line(from, to, stroke());
    }
    void cut()
    {
        painter_.polyline({at(2, 7), at(22, 7), at(22, 17), at(2, 17)}, {.color = ink_, .width = 1.2 * unit_},
                          ui::PathEnds::Closed);
        painter_.line(at(9, 22), at(14, 2), stroke());
        ends({at(9, 22), at(14, 2)});
    }

    void align()
    {
        painter_.polyline({at(2, 3), at(22, 3), at(22, 16), at(2, 16)}, {.color = ink_, .width = 1.2 * unit_},
                          ui::PathEnds::Closed);
        painter_.polyline({at(3, 15), at(9, 8), at(14, 13), at(17, 10), at(21, 15)},
                          {.color = ink_, .width = 1.2 * unit_});
        painter_.line(at(4, 21), at(20, 21), stroke());
        ends({at(4, 21), at(20, 21)});
    }

private:
    Point at(double x, double y) const { return {x * unit_, y * unit_}; }
    ui::Stroke stroke() const { return {.color = ink_, .width = 2.0 * unit_}; }
    void ends(std::initializer_list<Point> points)
    {
        for (const Point& p : points) painter_.disc(p, 2.2 * unit_, ink_);
    }
    /// From an angle to another, in degrees, seen counter-clockwise.
    void curve(Point center, double a, double b, double from, double to)
    {
        std::vector<Point> points;
        for (int i = 0; i <= 40; ++i) {
            const double angle = (from + (to - from) * i / 40.0) * std::numbers::pi / 180.0;
            points.push_back(center + Point{a * unit_ * std::cos(angle), -b * unit_ * std::sin(angle)});
        }
        painter_.polyline(points, stroke());
    }
    template <class PlaceAt> void smooth(const PlaceAt& place)
    {
        std::vector<Point> points;
        for (int i = 0; i <= 40; ++i) {
            const Point p = place(i / 40.0);
            points.push_back(at(p.x, p.y));
        }
        painter_.polyline(points, stroke());
    }

    ui::Painter& painter_;
    ui::Color ink_;
    double unit_;
};

} // namespace

void draw_tool_icon(ui::Painter& painter, ToolKind tool, const ui::Theme& theme)
{
    Icon icon(painter, theme);
    switch (tool) {
    case ToolKind::Select: return icon.select();
    case ToolKind::Line: return icon.line();
    case ToolKind::Polyline: return icon.polyline();
    case ToolKind::Arc: return icon.arc();
    case ToolKind::ArcCenter: return icon.arc_center();
    case ToolKind::Circle: return icon.circle();
    case ToolKind::Ellipse: return icon.ellipse();
    case ToolKind::Bezier: return icon.bezier();
    case ToolKind::Spline: return icon.spline();
    case ToolKind::Point: return icon.point();
    case ToolKind::Erase: return icon.erase();
    case ToolKind::Probe: return icon.probe();
    case ToolKind::Cut: return icon.cut();
    case ToolKind::Align: return icon.align();
    }
}

} // namespace plane
