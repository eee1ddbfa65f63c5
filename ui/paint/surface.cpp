#include "ui/paint/surface.h"

#include "ui/paint/mesh/keyhole.h"

namespace ui {

void Surface::fill_region(std::span<const std::vector<Point>> loops, Color color)
{
    std::vector<Point> outline;
    for (const auto& [loop, corner] : keyhole(loops)) outline.push_back(loops[loop][corner]);
    if (outline.size() >= 3) fill(outline, color);
}

} // namespace ui
