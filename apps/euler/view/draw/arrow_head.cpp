#include "apps/euler/view/draw/arrow_head.h"

namespace euler {

void draw_head(ui::Painter& painter, const std::vector<ui::Point>& line, double length, ui::Color color)
{
    const ui::Point tip = line.back();
    const ui::Point before = line.size() > 3 ? line[line.size() - 4] : line.front();
    const ui::Point back = -length * ui::direction(tip - before), aside = 0.36 * ui::left_normal(back);
    painter.polygon({tip, tip + back + aside, tip + back - aside}, color);
}

} // namespace euler
