#include "apps/frame/session/readout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "femoop/result/results.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::Painter;
using ui::Point;
using ui::Role;

namespace {

std::vector<Reading> displacements_of(AnalysisKind kind)
{
    using C = MemberComponent;
    std::vector<Reading> list;
    if (kind != AnalysisKind::Grillage) list.push_back({C::u, "u", Measure::Displacement, Role::Deformed});
    list.push_back({C::v, "v", Measure::Displacement, Role::Deformed});
    if (is_3d(kind)) list.push_back({C::w, "w", Measure::Displacement, Role::Deformed});
    return list;
}

std::optional<CaseResult> case_shown(const Session& session)
{
    const auto& results = session.solution().results;
    if (!results || results->n_cases() == 0) return std::nullopt;
    return (*results)[session.view.load_case];
}

// ---- the card ----

// Sizes in ems of the theme's normal type.
constexpr double line_height = 1.45, padding = 0.6, sketch_width = 6.4, text_width = 9.2;

struct Card {
    ui::Box box;
    double em = 13.0;
};

Card placed_card(const Painter& painter, const ui::Theme& theme, Point at, std::size_t n_lines)
{
    const double em = theme.type().normal;
    const double rows = std::max<double>(static_cast<double>(n_lines) + 1.0, 4.5);
    const ui::Size size{(sketch_width + text_width + 2.0 * padding) * em, (rows * line_height + 2.0 * padding) * em};
    const double gap = 1.6 * em;
    const ui::Box sheet = painter.sheet();
    Point corner{at.x + gap, at.y - gap - size.height};
    if (corner.x + size.width > sheet.max.x) corner.x = at.x - gap - size.width;
    if (corner.y < sheet.min.y) corner.y = at.y + gap;
    corner.x = std::clamp(corner.x, sheet.min.x, std::max(sheet.min.x, sheet.max.x - size.width));
    corner.y = std::clamp(corner.y, sheet.min.y, std::max(sheet.min.y, sheet.max.y - size.height));
    return {ui::box_at(corner, size), em};
}

void arrow(Painter& painter, Point from, Point to, const ui::Stroke& stroke, double head)
{
    const Point along = ui::direction(to - from);
    const Point across = ui::left_normal(along);
    const Point neck = to - head * along;
    painter.line(from, neck, stroke);
    painter.polygon({to, neck + 0.42 * head * across, neck - 0.42 * head * across}, stroke.color);
}

void moment_arrow(Painter& painter, Point center, double radius, bool is_counter_clockwise, const ui::Stroke& stroke,
                  double head)
{
    const double start = -0.30 * std::numbers::pi, sweep = 0.60 * std::numbers::pi;
    painter.arc({center, radius, start, sweep}, stroke);
    const double tip_angle = is_counter_clockwise ? start + sweep : start;
    const double turn = is_counter_clockwise ? 1.0 : -1.0;
    const Point tip{center.x + radius * std::cos(tip_angle), center.y - radius * std::sin(tip_angle)};
    // Counter-clockwise as seen, with y down.
    const Point along{-turn * std::sin(tip_angle), -turn * std::cos(tip_angle)};
    const Point across = ui::left_normal(along);
    painter.polygon({tip + head * along, tip + 0.42 * head * across, tip - 0.42 * head * across}, stroke.color);
}

// The part of the member before the cut, and what acts on its face.
void draw_free_body(Painter& painter, const ui::Theme& theme, const Card& card, const SectionForces& forces,
                    AnalysisKind kind)
{
    const double em = card.em;
    const Point face{card.box.min.x + (padding + 2.9) * em, card.box.min.y + (padding + 1.45 + 2.1) * em};
    const double half = 0.55 * em;
    const ui::RoleStyle member = theme[Role::Member];
    const Point tail = face - Point{2.6 * em, 0.0};
    painter.polygon(
        {tail - Point{0.0, half}, face - Point{0.0, half}, face + Point{0.0, half}, tail + Point{0.0, half}},
        ui::with_opacity(member.stroke.color, 0.18));
    ui::Stroke outline = member.stroke;
    outline.width = 1.2;
    painter.polyline(
        {tail - Point{0.0, half}, face - Point{0.0, half}, face + Point{0.0, half}, tail + Point{0.0, half}}, outline);
    const double head = 0.6 * em;
    const auto pen = [&](Role role) { return ui::Stroke{.color = theme[role].stroke.color, .width = 1.8, .dash = {}}; };
    const double size = std::max({std::abs(forces.N), std::abs(forces.Vy), 1e-300});
    const bool has_axial = kind != AnalysisKind::Grillage && std::abs(forces.N) > 1e-9 * size;
    if (has_axial) {
        const Point near = face + Point{0.9 * em, 0.0}, far = face + Point{2.6 * em, 0.0};
        if (forces.N > 0.0) arrow(painter, near, far, pen(Role::AxialForce), head);
        else arrow(painter, far, near, pen(Role::AxialForce), head);
    }
    if (std::abs(forces.Vy) > 1e-9 * size) {
        const double down = forces.Vy > 0.0 ? 1.0 : -1.0;
        const Point middle = face + Point{0.45 * em, 0.0};
        arrow(painter, middle - Point{0.0, down * 1.1 * em}, middle + Point{0.0, down * 1.1 * em},
              pen(Role::ShearForce), head);
    }
    if (std::abs(forces.Mz) > 1e-12 * size)
        moment_arrow(painter, face, 1.75 * em, forces.Mz > 0.0, pen(Role::BendingMoment), head);
}

} // namespace

std::vector<Reading> section_forces(AnalysisKind kind)
{
    using C = MemberComponent;
    const Reading normal{C::N, "N", Measure::Force, Role::AxialForce};
    const Reading shear{C::Vy, "V", Measure::Force, Role::ShearForce};
    const Reading moment{C::Mz, "M", Measure::Moment, Role::BendingMoment};
    const Reading torsion{C::T, "T", Measure::Moment, Role::Torsion};
    switch (kind) {
    case AnalysisKind::Truss2d:
    case AnalysisKind::Truss3d:
    case AnalysisKind::Frame2d: return {normal, shear, moment};
    case AnalysisKind::Grillage: return {shear, moment, torsion};
    case AnalysisKind::Frame3d: break;
    }
    return {normal,
            {C::Vy, "Vy", Measure::Force, Role::ShearForce},
            {C::Vz, "Vz", Measure::Force, Role::ShearForce},
            torsion,
            {C::My, "My", Measure::Moment, Role::BendingMoment},
            {C::Mz, "Mz", Measure::Moment, Role::BendingMoment}};
}

std::vector<ReadoutLine> readout_lines(const Session& session, const Cut& cut)
{
    const std::optional<CaseResult> result = case_shown(session);
    if (!result) return {};
    const Curve curve = result->curve(cut.member);
    const ui::DisplayUnits units = session.units();
    std::vector<ReadoutLine> lines;
    const auto add = [&](const std::vector<Reading>& readings) {
        for (const Reading& r : readings)
            lines.push_back({r.name, units.text(curve.value(r.component, cut.x), r.measure), r.role});
    };
    add(section_forces(session.model().analysis));
    add(displacements_of(session.model().analysis));
    return lines;
}

std::string readout_title(const Session& session, const Cut& cut)
{
    return session.view.tr("{member} at x = {x}", {{"member", session.model()[cut.member].id},
                                                   {"x", session.units().text(cut.x, Measure::Length)}});
}

void draw_readout(Painter& painter, const Session& session, const Cut& cut, Point at)
{
    const std::vector<ReadoutLine> lines = readout_lines(session, cut);
    if (lines.empty()) return;
    const ui::LayerScope overlay(painter, ui::Layer::Overlay);
    const ui::Theme theme(session.view.theme);
    const Card card = placed_card(painter, theme, at, lines.size());
    const double em = card.em;

    painter.disc(at, 0.32 * em, theme[Role::Selection].stroke.color);
    const Point nearest{std::clamp(at.x, card.box.min.x, card.box.max.x),
                        std::clamp(at.y, card.box.min.y, card.box.max.y)};
    painter.line(at, nearest, theme.stroke(Role::Leader));
    painter.rectangle(card.box, theme.background());
    const ui::Stroke border{.color = theme[Role::Leader].stroke.color, .width = 1.0, .dash = {}};
    painter.polyline({card.box.min, {card.box.max.x, card.box.min.y}, card.box.max, {card.box.min.x, card.box.max.y}},
                     border, ui::PathEnds::Closed);

    ui::TextStyle title = theme.text(Role::Label, ui::Anchor::Left);
    title.weight = ui::Weight::Bold;
    const double left = card.box.min.x + padding * em;
    double y = card.box.min.y + (padding + 0.5 * line_height) * em;
    painter.text({left, y}, readout_title(session, cut), title);
    for (const ReadoutLine& line : lines) {
        y += line_height * em;
        ui::TextStyle name = theme.text(line.role, ui::Anchor::Left);
        name.weight = ui::Weight::Bold;
        painter.text({left + sketch_width * em, y}, line.name, name);
        painter.text({card.box.max.x - padding * em, y}, line.value, theme.text(Role::Label, ui::Anchor::Right));
    }
    draw_free_body(painter, theme, card, case_shown(session)->curve(cut.member).forces(cut.x),
                   session.model().analysis);
}

} // namespace frame
