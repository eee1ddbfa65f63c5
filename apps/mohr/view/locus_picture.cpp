#include "apps/mohr/view/locus_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/mohr/view/arrow.h"
#include "apps/mohr/view/axis.h"
#include "apps/mohr/view/circle_picture.h"
#include "apps/mohr/view/labels.h"
#include "apps/mohr/view/sentence.h"
#include "femoop/methods/mohr/locus.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::Role;

namespace {

using std::numbers::pi;

/// Two principal stresses of the plane, and what the third one is of their sum.
struct InPlane {
    fm::PlanePrincipal principal;
    double share = 0.0;
};

InPlane in_plane(const Solution& s)
{
    if (s.stress) return {fm::principal(fm::PlaneState{s.stress->x, s.stress->y, s.stress->xy})};
    return {s.principal, s.state.kind == fm::Kind::PlaneStrain ? *s.state.nu : 0.0};
}

/// A picture about its origin, which lies in the middle of the box.
struct Sheet {
    ui::Painter& painter;
    const Scene& scene;
    ui::Box box;
    double scale; ///< pixels of a unit of stress
    ui::Theme theme;

    ui::Point at(double x, double y) const { return box.center() + scale * ui::Point{x, -y}; }
    const Solution& solution() const { return scene.solution; }
    std::string unit() const { return solution().stress ? solution().stress_unit : solution().unit; }
    void axis(ui::Point to, const std::string& name, Labels& labels) const
    {
        arrow(painter, box.center(), to, theme.stroke(Role::Label), 8.0 * theme.symbol_scale());
        labels.add(to, to - box.center(), name, theme.text(Role::Label), 5.0);
    }
    void boundary(const std::vector<ui::Point>& points) const
    {
        const ui::ClipScope clip(painter, box);
        painter.polygon(points, theme.fill(Role::Guess));
        painter.polyline(points, theme.stroke(Role::Error), ui::PathEnds::Closed);
    }
};

double size_of(const fm::StressPair& pair) { return std::max(std::abs(pair.first), std::abs(pair.second)); }

constexpr double endless = 1e6; ///< times what acts, or the strength

/// As much of the boundary as is not far from where the state fails.
double reach_of(const std::vector<fm::StressPair>& pairs, double shown)
{
    double reach = 0.0, least = 1e300;
    for (const fm::StressPair& pair : pairs) least = std::min(least, size_of(pair));
    const double most = shown > 0.0 ? std::clamp(4.0 * shown, 2.0 * least, 8.0 * least) : 3.0 * least;
    for (const fm::StressPair& pair : pairs)
        if (size_of(pair) <= most) reach = std::max(reach, size_of(pair));
    return std::max({reach, std::min(shown, 20.0 * least), 1e-100});
}

void draw_pairs(ui::Painter& painter, const Scene& scene, const ui::Box& box)
{
    const Solution& s = scene.solution;
    const auto [principal, share] = in_plane(s);
    const fm::Strength& k = *s.strength;
    const double strongest = std::max({k.fy, k.ft, k.fc, k.c, k.sci});
    const auto pairs = fm::failing_pairs(*scene.document.criterion, k, share, endless * strongest, 360);
    const double factor = s.safety->factor.value_or(1.0);
    const fm::StressPair now{principal.first, principal.second}, end{factor * now.first, factor * now.second};
    const double reach = 1.15 * reach_of(pairs, std::max(size_of(now), size_of(end)));
    const ui::Theme theme = scene.look.full_theme();
    const double room = 0.5 * std::min(box.width(), box.height()) - 1.6 * theme.type().normal;
    const Sheet sheet{painter, scene, box, std::max(room, 1.0) / reach, theme};
    std::vector<ui::Point> points;
    for (const fm::StressPair& pair : pairs) points.push_back(sheet.at(pair.first, pair.second));
    sheet.boundary(points);
    Labels labels(box, painter.fonts());
    painter.line(sheet.at(-reach, 0.0), box.center(), theme.stroke(Role::Label));
    painter.line(sheet.at(0.0, -reach), box.center(), theme.stroke(Role::Label));
    sheet.axis(sheet.at(reach, 0.0), axis_title("σ1", sheet.unit()), labels);
    sheet.axis(sheet.at(0.0, reach), "σ2", labels);
    const ui::ClipScope clip(painter, box);
    if (s.safety->factor) {
        painter.line(box.center(), sheet.at(end.first, end.second), theme.stroke(Role::Warning));
        draw_mark(painter, scene, sheet.at(end.first, end.second), std::nullopt, Role::Warning);
        labels.add(sheet.at(end.first, end.second), {end.first, -end.second}, "× " + scene.look.number(factor),
                   theme.text(Role::Warning), 8.0);
    }
    draw_mark(painter, scene, sheet.at(now.first, now.second), std::nullopt, Role::Deformed);
    labels.add(sheet.at(now.first, now.second), {1.0, 1.0},
               "(" + scene.look.number(now.first) + "; " + scene.look.number(now.second) + ")",
               theme.text(Role::Deformed), 9.0);
    labels.draw(painter, theme);
}

/// The three axes are seen along the line of equal stresses, the first one upright.
void draw_deviatoric(ui::Painter& painter, const Scene& scene, const ui::Box& box)
{
    const Solution& s = scene.solution;
    const double mean = s.deviator.mean, size = std::sqrt(2.0 * s.deviator.J2), lode = s.deviator.lode.value_or(0.0);
    constexpr int n = 20; // in a sixth of the turn; the others mirror it
    std::vector<std::optional<double>> sixth;
    for (int i = 0; i <= n; ++i)
        sixth.push_back(fm::failing_deviator(*scene.document.criterion, *s.strength, mean, pi / 3.0 * i / n));
    double reach = size;
    for (const auto& radius : sixth)
        if (radius) reach = std::max(reach, std::min(*radius, 4.0 * std::max(size, sixth.front().value_or(size))));
    const ui::Theme theme = scene.look.full_theme();
    const double room = 0.5 * std::min(box.width(), box.height()) - 1.4 * theme.type().normal;
    const Sheet sheet{painter, scene, box, std::max(room, 1.0) / (1.2 * std::max(reach, 1e-100)), theme};
    const auto polar = [&](double radius, double turn) { // from axis 1 towards axis 2
        return sheet.at(-radius * std::sin(turn), radius * std::cos(turn));
    };
    std::vector<ui::Point> points;
    for (int i = 0; i < 6 * n; ++i) {
        const int fold = i % (2 * n);
        const auto& radius = sixth[static_cast<std::size_t>(fold <= n ? fold : 2 * n - fold)];
        points.push_back(polar(std::min(radius.value_or(1e3 * reach), 1e3 * reach), pi / 3.0 * i / n));
    }
    sheet.boundary(points);
    Labels labels(box, painter.fonts());
    for (int axis = 0; axis < 3; ++axis)
        sheet.axis(polar(1.15 * reach, 2.0 * pi / 3.0 * axis), "σ" + std::to_string(axis + 1), labels);
    draw_mark(painter, scene, polar(size, lode), std::nullopt, Role::Deformed);
    labels.add(polar(size, lode), polar(size, lode) - box.center(), "√(2 J2) = " + scene.look.number(size),
               theme.text(Role::Deformed), 9.0);
    labels.draw(painter, theme);
}

std::string what_is_shown(const Scene& scene)
{
    const Look& look = scene.look;
    if (is_in_space(scene.document.subject))
        return look.tr("the deviatoric plane of the mean stress {mean}",
                       {{"mean", look.number(scene.solution.deviator.mean)}});
    if (scene.solution.state.kind == fm::Kind::PlaneStrain)
        return look.tr("principal stresses of the plane, σz = ν(σ1 + σ2)");
    return look.tr("principal stresses of the plane, σz = 0");
}

} // namespace

bool has_locus(const Scene& scene)
{
    return scene.look.envelope && scene.solution.strength && scene.solution.safety && !scene.solution.section &&
           !scene.conceals;
}

void draw_locus(ui::Painter& painter, const Scene& scene, const ui::Box& whole)
{
    ui::TextStyle faint = scene.look.full_theme().text(Role::FaintLabel);
    faint.size = scene.look.full_theme().type().small;
    const ui::Box box = write_at_foot(painter, whole, what_is_shown(scene), faint, 1);
    if (box.width() < 40.0 || box.height() < 40.0) return;
    if (is_in_space(scene.document.subject)) draw_deviatoric(painter, scene, box);
    else draw_pairs(painter, scene, box);
}

} // namespace mohr
