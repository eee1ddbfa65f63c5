#include "apps/frame/window/tool_icon.h"

namespace frame {

using ui::Point;
using ui::Role;

namespace {

// Icons are drawn on a square of 24 units.
class Icon {
public:
    Icon(ui::Painter& painter, const ui::Theme& theme)
        : painter_(painter),
          ink_(theme.stroke(Role::Member).color),
          load_(theme.stroke(Role::Load).color),
          support_(theme.stroke(Role::Support).color),
          guess_(theme.stroke(Role::Guess).color),
          unit_(painter.size().width / 24.0)
    {}

    void select()
    {
        painter_.polygon({at(6, 3), at(6, 19), at(10, 15.5), at(12.5, 21), at(15, 20), at(12.5, 14.5), at(18, 14.5)},
                         ink_);
    }
    void member()
    {
        line(4, 19, 20, 5, 2.4, ink_);
        node(4, 19);
        node(20, 5);
    }
    void node_alone() { painter_.disc(at(12, 12), 4.5 * unit_, ink_); }
    void support()
    {
        painter_.polyline({at(12, 6), at(5, 17), at(19, 17)}, stroke(1.8, support_), ui::PathEnds::Closed);
        for (const double x : {4.0, 9.0, 14.0, 19.0}) line(x, 21.5, x + 2.5, 17.5, 1.3, support_);
        node(12, 5);
    }
    void load()
    {
        line(4, 5, 20, 5, 1.6, load_);
        for (const double x : {5.0, 12.0, 19.0}) arrow(x);
        line(3, 20, 21, 20, 2.4, ink_);
    }
    void hinge()
    {
        line(2, 12, 8, 12, 2.4, ink_);
        line(16, 12, 22, 12, 2.4, ink_);
        painter_.circle(at(12, 12), 4.0 * unit_, stroke(1.8, ink_));
    }
    void dimension()
    {
        for (const double x : {4.0, 20.0}) {
            line(x, 4, x, 20, 1.4, ink_);
            line(x - 2.5, 14.5, x + 2.5, 9.5, 2.0, ink_);
        }
        line(2, 12, 22, 12, 1.4, ink_);
    }
    void erase()
    {
        line(5, 5, 19, 19, 2.6, load_);
        line(5, 19, 19, 5, 2.6, load_);
    }

    void predict()
    {
        line(3, 7, 21, 7, 2.4, ink_);
        std::vector<Point> curve;
        for (int i = 0; i <= 12; ++i) curve.push_back(at(3.0 + 1.5 * i, 7.0 + 11.0 * i * (12 - i) / 36.0));
        painter_.polyline(curve, {.color = guess_, .width = 1.8 * unit_, .dash = {3.2 * unit_, 2.0 * unit_}});
        node(3, 7);
        node(21, 7);
    }

    // The hinge opens, and the beam goes down to either side of it.
    void influence()
    {
        line(2, 8, 22, 8, 1.4, ink_);
        line(2, 8, 12, 18, 2.4, guess_);
        line(12, 18, 22, 8, 2.4, guess_);
        arrow(12, 1, 8);
        node(2, 8);
        node(22, 8);
    }

private:
    Point at(double x, double y) const { return {unit_ * x, unit_ * y}; }
    ui::Stroke stroke(double width, ui::Color color) const { return {.color = color, .width = unit_ * width}; }
    void line(double x1, double y1, double x2, double y2, double width, ui::Color color)
    {
        painter_.line(at(x1, y1), at(x2, y2), stroke(width, color));
    }
    void node(double x, double y) { painter_.disc(at(x, y), 2.6 * unit_, ink_); }
    void arrow(double x, double top = 5, double tip = 18.5)
    {
        line(x, top, x, tip - 3.5, 1.6, load_);
        painter_.polygon({at(x - 2.5, tip - 5.0), at(x + 2.5, tip - 5.0), at(x, tip)}, load_);
    }

    ui::Painter& painter_;
    ui::Color ink_, load_, support_, guess_;
    double unit_;
};

} // namespace

void draw_tool_icon(ui::Painter& painter, ToolKind tool, const ui::Theme& theme)
{
    Icon icon(painter, theme);
    switch (tool) {
    case ToolKind::Select: icon.select(); break;
    case ToolKind::Member: icon.member(); break;
    case ToolKind::Node: icon.node_alone(); break;
    case ToolKind::Support: icon.support(); break;
    case ToolKind::Load: icon.load(); break;
    case ToolKind::Hinge: icon.hinge(); break;
    case ToolKind::Dimension: icon.dimension(); break;
    case ToolKind::Delete: icon.erase(); break;
    case ToolKind::Predict: icon.predict(); break;
    case ToolKind::Influence: icon.influence(); break;
    case ToolKind::FreeBody:
    case ToolKind::Funicular:
    case ToolKind::VirtualWork: break; // found in the menu
    case ToolKind::Paste: break;       // taken up by no button
    }
}

} // namespace frame
