#include "apps/cross/view/verdict_mark.h"

namespace cross {

using femoop::cross::Verdict;

ui::Role role_of(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Open: return ui::Role::Label;
    case Verdict::Right: return ui::Role::Created;
    case Verdict::FollowsRight: return ui::Role::Changed;
    case Verdict::Slipped:
    case Verdict::Wrong: return ui::Role::Error;
    }
    return ui::Role::Label;
}

void draw_verdict(ui::Painter& painter, const ui::Theme& theme, Verdict verdict, ui::Point middle, double em)
{
    if (verdict == Verdict::Open) return;
    ui::Stroke stroke = theme.stroke(role_of(verdict));
    stroke.color = theme[role_of(verdict)].text;
    stroke.width = 0.14 * em;
    stroke.dash = {};
    const auto at = [&](double x, double y) { return middle + ui::Point{x * em, y * em}; };
    if (verdict == Verdict::Slipped || verdict == Verdict::Wrong) {
        painter.line(at(-0.24, -0.24), at(0.24, 0.24), stroke);
        painter.line(at(-0.24, 0.24), at(0.24, -0.24), stroke);
        return;
    }
    painter.polyline({at(-0.3, 0.02), at(-0.08, 0.26), at(0.32, -0.28)}, stroke);
    if (verdict == Verdict::FollowsRight) painter.line(at(-0.3, -0.42), at(0.32, -0.42), stroke);
}

} // namespace cross
