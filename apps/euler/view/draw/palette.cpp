#include "apps/euler/view/draw/palette.h"

#include <algorithm>
#include <iterator>

namespace euler {

using ui::Role;

namespace {

constexpr double most_opaque = 0.28; // up to which a surface draws areas without soft borders, so that no seams show

ui::Color at_most_opaque(ui::Color color, double share)
{
    const double opacity = std::min(most_opaque, share * color.a / 255.0);
    return ui::with_opacity(color, opacity);
}

bool shows_step(const Marks& marks)
{
    return !marks.created.empty() || !marks.changed.empty() || !marks.killed.empty() || !marks.preview.empty();
}

} // namespace

Palette::Palette(std::span<const Subject> subjects, const Look& look) : subjects_(subjects), theme_(look.full_theme())
{
    for (const Subject& subject : subjects) marks_.emplace_back(*subject.solid, subject.marks);
}

std::optional<Role> Palette::step_role(const Part& part) const
{
    const MarkTable& marks = marks_[part.subject];
    if (marks.is_killed(part.entity)) return Role::Killed;
    if (marks.is_created(part.entity) || marks.is_preview(part.entity)) return Role::Created;
    if (marks.is_changed(part.entity)) return Role::Changed;
    return std::nullopt;
}

ui::Color Palette::face(std::size_t subject, topology::FaceId f) const
{
    const Part part{subject, f};
    const MarkTable& marks = marks_[subject];
    const double presence = marks.presence(f);
    if (marks.is_hovered(f)) return at_most_opaque(theme_.stroke(Role::Hover).color, most_opaque);
    if (marks.is_selected(f)) return at_most_opaque(theme_.stroke(Role::Selection).color, most_opaque);
    if (marks.is_legal(f)) return at_most_opaque(theme_.stroke(Role::Offered).color, most_opaque);
    if (marks.is_illegal(f)) return at_most_opaque(gray(), 0.12);
    const auto role = step_role(part);
    if (role && role != Role::Changed) return at_most_opaque(theme_.stroke(*role).color, most_opaque * presence);
    const double share = shows_step(subjects_[subject].marks) ? 0.5 : 1.0;
    return at_most_opaque(theme_.series(solid(subject).outer(f).index).fill, share);
}

ui::Color Palette::hatching(std::size_t subject, topology::FaceId f) const
{
    const MarkTable& marks = marks_[subject];
    const ui::Color own = marks.is_illegal(f) ? gray() : theme_.series(solid(subject).outer(f).index).stroke.color;
    return ui::with_opacity(own, 0.45 * marks.presence(f));
}

ui::Stroke Palette::edge(const Part& part, bool is_hidden, std::optional<std::size_t> series) const
{
    const MarkTable& marks = marks_[part.subject];
    if (const auto role = step_role(part)) {
        ui::Stroke stroke = theme_.stroke(*role);
        if (marks.is_preview(part.entity)) stroke.dash = ui::DashPattern{5.0, 4.0}.scaled(theme_.symbol_scale());
        return stroke;
    }
    ui::Stroke stroke = theme_.stroke(is_hidden ? Role::HiddenEdge : Role::Edge);
    if (series) {
        stroke = theme_.series(*series).stroke;
        stroke.width = theme_.stroke(Role::Edge).width * 1.8;
        const double scale = theme_.symbol_scale();
        const ui::DashPattern rhythms[] = {stroke.dash, ui::DashPattern{9.0, 3.0}.scaled(scale),
                                           ui::DashPattern{3.0, 3.0}.scaled(scale),
                                           ui::DashPattern{9.0, 3.0, 2.0, 3.0}.scaled(scale)};
        stroke.dash = rhythms[*series / ui::n_series % std::size(rhythms)];
    }
    if (marks.is_illegal(part.entity)) stroke.color = gray();
    return stroke;
}

ui::Stroke Palette::arrow(std::size_t subject, topology::HalfEdgeId h, bool is_hidden) const
{
    const Part part{subject, h};
    const topology::LoopId loop = solid(subject).loop(h);
    ui::Stroke stroke = theme_.series(loop.index).stroke;
    stroke.width = 1.7 * theme_.symbol_scale();
    stroke.dash = solid(subject).is_outer(loop) ? ui::DashPattern{} : ui::DashPattern{4.0, 2.5};
    if (const auto role = step_role(part)) stroke.color = theme_.stroke(*role).color;
    if (marks_[subject].is_illegal(h)) stroke.color = gray();
    if (is_hidden && !marks_[subject].is_legal(h)) stroke.color = pale(stroke.color, 0.5);
    return stroke;
}

ui::Color Palette::vertex(const Part& part, bool is_hidden) const
{
    if (const auto role = step_role(part)) return theme_.stroke(*role).color;
    if (is_hidden || marks_[part.subject].is_illegal(part.entity)) return gray();
    return theme_.fill(Role::Node);
}

std::optional<ui::Color> Palette::halo(const Part& part) const
{
    const MarkTable& marks = marks_[part.subject];
    const auto of = [&](Role role, double opacity) { return ui::with_opacity(theme_.stroke(role).color, opacity); };
    if (marks.is_hovered(part.entity)) return of(Role::Hover, 0.6);
    if (marks.is_selected(part.entity)) return of(Role::Selection, 0.5);
    if (marks.is_legal(part.entity)) return of(Role::Offered, 0.85);
    return std::nullopt;
}

ui::TextStyle Palette::name(const Part& part, bool is_hidden) const
{
    ui::TextStyle style = theme_.text(is_hidden ? Role::HiddenEdge : Role::Label);
    const topology::Solid& of = solid(part.subject);
    using topology::EntityKind;
    if (part.entity.kind != EntityKind::Vertex) style.size = theme_.type().small;
    if (part.entity.kind == EntityKind::Face) {
        style.color = theme_.series(of.outer(topology::FaceId{part.entity.index}).index).text;
        style.size = theme_.type().normal;
        style.weight = ui::Weight::Bold;
    }
    if (part.entity.kind == EntityKind::Loop) style.color = theme_.series(part.entity.index).text;
    if (part.entity.kind == EntityKind::HalfEdge)
        style.color = theme_.series(of.loop(topology::HalfEdgeId{part.entity.index}).index).text;
    if (const auto role = step_role(part)) style.color = theme_[*role].text;
    const bool is_faint = is_hidden && part.entity.kind != EntityKind::Vertex && !step_role(part);
    if (is_faint) style.color = pale(style.color, 0.3);
    return style;
}

} // namespace euler
