#include "apps/drawing/results/influence_picture.h"

#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/line_diagram.h"
#include "apps/drawing/results/line_motion.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/methods/influence/usual_path.h"
#include "femoop/result/components.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

namespace drawing {

namespace {

using Eigen::Vector3d;
using femoop::ExpectedQuantity;
using femoop::LocalAxis;
using femoop::MemberComponent;
using femoop::MovingEffect;
using femoop::Side;
using femoop::influence::LinePiece;
using femoop::influence::MotionPiece;
using femoop::influence::PathMember;

constexpr double square_enough = 1e-6;  // of the load: what of it lies across the member
constexpr double clearly_across = 0.25; // likewise: along the load its ordinates can still be told apart

/// The part of a line over one member of the path, or over a part of it.
class LineOnMember final : public LineFunction {
public:
    LineOnMember(const femoop::influence::PiecewiseLine& line, const femoop::influence::Stretch& part)
        : begin_(part.from), end_(part.to)
    {
        const double near = 1e-12 * line.length();
        for (const LinePiece& piece : line.pieces)
            if (piece.to > begin_ + near && piece.from < end_ - near) pieces_.push_back(&piece);
    }

    bool is_empty() const { return pieces_.empty(); }

    double length() const override { return end_ - begin_; }

    std::vector<double> breaks() const override
    {
        std::vector<double> places{0.0};
        for (const LinePiece* piece : pieces_) places.push_back(std::min(piece->to, end_) - begin_);
        return places;
    }

    double value(double x, Side side = Side::After) const override { return piece_at(x, side).value(begin_ + x); }

    femoop::Extremes extremes() const override
    {
        femoop::Extremes found{{0.0, value(0.0)}, {0.0, value(0.0)}};
        for (const LinePiece* piece : pieces_) {
            std::vector<double> places = piece->turning_places();
            places.insert(places.begin(), std::max(piece->from, begin_));
            places.push_back(std::min(piece->to, end_));
            for (const double s : places) {
                if (s < begin_ || s > end_) continue;
                const femoop::Extreme here{s - begin_, piece->value(s)};
                if (here.value > found.max.value) found.max = here;
                if (here.value < found.min.value) found.min = here;
            }
        }
        return found;
    }

    std::optional<double> slope(double x, Side side) const override { return piece_at(x, side).slope(begin_ + x); }

    std::vector<double> level_places() const override
    {
        std::vector<double> places;
        for (const LinePiece* piece : pieces_)
            for (const double s : piece->turning_places())
                if (s >= begin_ && s <= end_) places.push_back(s - begin_);
        return places;
    }

private:
    const LinePiece& piece_at(double x, Side side) const
    {
        const double s = begin_ + x;
        for (const LinePiece* piece : pieces_)
            if (s < piece->to || (side == Side::Before && s <= piece->to)) return *piece;
        return *pieces_.back();
    }

    double begin_, end_;
    std::vector<const LinePiece*> pieces_; ///< \pre at least one
};

/// Draws one line and what stands on it.
class InfluenceDrawing {
public:
    InfluenceDrawing(const Scene& scene, const InfluencePicture& picture, const InfluenceScale& scale)
        : scene_(scene),
          picture_(picture),
          scale_(scale),
          unit_(ordinate_unit(scene.units, picture)),
          role_(drawing::role_of(picture.line.effect))
    {}

    void draw() const
    {
        if (scale_.largest > 0.0) draw_line();
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Symbols);
        mark_section();
    }

private:
    Sketch& sketch() const { return scene_.sketch; }

    void draw_line() const
    {
        if (!picture_.traced) draw_moved();
        for (const PathMember& on : picture_.path.members) draw_on(on);
        write_end(picture_.path.members.front(), 0.0);
        write_end(picture_.path.members.back(), picture_.path.length());
        for (const auto& force : picture_.forces) draw_ordinate(force);
    }

    std::string text(double ordinate) const { return scene_.number(ordinate * unit_.factor, ui::Measure::Plain); }

    /// x along the path from where it comes onto the member, y to where positive ordinates are drawn.
    SymbolFrame frame_on(const PathMember& on) const
    {
        const MemberShape& member = scene_.shape[on.member];
        const Vector3d begin = member.at(on.is_reversed ? member.length : 0.0);
        return scene_.projection.frame(begin, on.is_reversed ? Vector3d(-member.x()) : member.x(), side_of(member));
    }

    Vector3d side_of(const MemberShape& member) const { return ordinate_side(picture_.load, member, scene_.is_flat()); }

    void draw_on(const PathMember& on) const
    {
        const femoop::influence::Stretch part{std::max(on.begin, picture_.traced ? picture_.traced->from : on.begin),
                                              std::min(on.end(), picture_.traced ? picture_.traced->to : on.end())};
        const LineOnMember line(picture_.line.ordinates, part);
        if (line.is_empty()) return;
        SymbolFrame frame = frame_on(on);
        frame.origin = frame((part.from - on.begin) * scene_.projection.scale(), 0.0);
        LineDiagram look{.frame = frame,
                         .role = role_,
                         .largest = scale_.largest,
                         .pixels_per_unit = scale_.pixels_per_unit,
                         .text = [this](double value) { return text(value); }};
        drawing::draw(quiet_scene(), line, look);
    }

    /// Where forces stand their ordinates are what one wants to read.
    Scene quiet_scene() const
    {
        Scene scene = scene_;
        if (!picture_.forces.empty()) scene.show.erase(Show::Values);
        return scene;
    }

    void write_end(const PathMember& on, double s) const
    {
        if (!scene_.shows(Show::Values)) return;
        const SymbolFrame frame = frame_on(on);
        const double along = s == 0.0 ? -1.0 : 1.0;
        sketch().caption({.text = "s = " + scene_.number(s, ui::Measure::Length),
                          .role = ui::Role::FaintLabel,
                          .target = frame((s - on.begin) * scene_.projection.scale(), 0.0),
                          .toward = along * frame.x - 2.0 * frame.y,
                          .gap = sketch().px(16.0),
                          .rank = Rank::Minor,
                          .size = sketch().lesser_value_size()});
    }

    ui::Point place(double s, double ordinate) const
    {
        const auto place = picture_.path.place(s);
        const PathMember& on = picture_.path.members[place.index];
        return frame_on(on)((s - on.begin) * scene_.projection.scale(), ordinate * scale_.pixels_per_unit);
    }

    void draw_ordinate(const femoop::influence::StandingForce& force) const
    {
        const ui::Point foot = place(force.s, 0.0), tip = place(force.s, force.ordinate);
        ui::Stroke stroke = sketch().stroke(role_);
        stroke.width *= 1.4;
        sketch().line(foot, tip, stroke);
        sketch().disc(tip, sketch().px(3.0), stroke.color);
        if (!scene_.shows(Show::Values)) return;
        const ui::Point toward = ui::distance(foot, tip) > 1.0 ? tip - foot : ui::Point{0.0, 1.0};
        sketch().caption({.text = text(force.ordinate),
                          .role = role_,
                          .target = tip,
                          .toward = toward,
                          .gap = sketch().px(5.0),
                          .rank = Rank::Extreme});
    }

    void draw_moved() const
    {
        if (picture_.motion.empty() || !scale_.shows_motion) return;
        const double opened = 0.5 * (1.0 + scene_.state.phase); // the release opens and closes, never the other way
        const double factor = scale_.pixels_per_unit / scene_.projection.scale() * opened;
        ui::Stroke stroke = sketch().thin(ui::Role::Deformed);
        stroke.dash = {6.0, 4.0};
        for (std::size_t i = 0; i < picture_.motion.size(); ++i) {
            const MemberShape& member = scene_.shape[femoop::MemberId(i)];
            if (stays(member, picture_.motion[i], factor)) continue;
            for (const auto& line : moved_lines(member, picture_.motion[i], factor))
                sketch().polyline(line, stroke, Clearance::Soft);
        }
    }

    // Parted where a release lets one part move against the other.
    std::vector<std::vector<ui::Point>> moved_lines(const MemberShape& member,
                                                    const femoop::influence::MemberMotion& motion, double factor) const
    {
        constexpr int n = 16;         // parts of a piece: a cubic looks smooth
        constexpr double apart = 0.5; // [px]
        std::vector<std::vector<ui::Point>> lines;
        for (const MotionPiece& piece : motion) {
            std::vector<ui::Point> points;
            for (int i = 0; i <= n; ++i) points.push_back(moved(member, piece, piece.length() * i / n, factor));
            const bool goes_on = !lines.empty() && ui::distance(lines.back().back(), points.front()) < apart;
            if (!goes_on) lines.emplace_back();
            lines.back().insert(lines.back().end(), points.begin(), points.end());
        }
        return lines;
    }

    // Such a member would be dashed over.
    bool stays(const MemberShape& member, const femoop::influence::MemberMotion& motion, double factor) const
    {
        constexpr double near = 1.5; // [px]
        return std::ranges::all_of(motion, [&](const MotionPiece& piece) {
            return std::ranges::all_of(shares_of_piece, [&](double share) {
                const double t = share * piece.length();
                return ui::distance(moved(member, piece, t, factor), moved(member, piece, t, 0.0)) < near;
            });
        });
    }

    ui::Point moved(const MemberShape& member, const MotionPiece& piece, double t, double factor) const
    {
        const auto along = [&](LocalAxis axis) { return factor * piece.along[femoop::index(axis)](t); };
        return scene_.projection(member.at(piece.from + t) + along(LocalAxis::x) * member.x() +
                                 along(LocalAxis::y) * member.y() + along(LocalAxis::z) * member.z());
    }

    // A hinge where a moment is released; a cut where a force is; a disc where a displacement is asked for.
    void mark_section() const
    {
        const MovingEffect& effect = picture_.line.effect;
        if (effect.node && is_concealed(picture_)) // nothing else tells which one it is
            sketch().ring(scene_.projection(scene_.shape[*effect.node]), sketch().px(9.0), sketch().stroke(role_));
        if (!effect.member || !effect.at) return;
        const MemberShape& member = scene_.shape[*effect.member];
        const double x = std::clamp(femoop::along(*effect.at, member.length), 0.0, member.length);
        const SymbolFrame frame = scene_.frame_on(member, x);
        const ui::Stroke stroke = sketch().stroke(role_);
        const double size = sketch().px(5.0);
        if (is_displacement(*effect.component)) return sketch().disc(frame.origin, 0.8 * size, stroke.color);
        if (drawing::measure_of(*effect.component) == ui::Measure::Moment) {
            sketch().disc(frame.origin, size, sketch().theme().background());
            return sketch().ring(frame.origin, size, stroke);
        }
        for (const double at : {-0.4 * size, 0.4 * size})
            sketch().line(frame(at, -1.6 * size), frame(at, 1.6 * size), stroke);
    }

    const Scene& scene_;
    const InfluencePicture& picture_;
    const InfluenceScale& scale_;
    OrdinateUnit unit_;
    ui::Role role_;
};

} // namespace

InfluenceScale influence_scale(const Scene& scene, const InfluencePicture& picture, ui::Size panel)
{
    InfluenceScale scale{.largest = picture.line.ordinates.largest()};
    if (!(scale.largest > 0.0)) return scale;
    constexpr double share = 0.2;
    constexpr double most_motion = 2.0; // ordinate heights: a frame that sways would leave the sheet
    const std::optional<double> moved = drawn_motion(picture);
    scale.shows_motion = moved.has_value();
    const double shown = std::max(scale.largest, moved.value_or(0.0) / most_motion);
    scale.pixels_per_unit = ordinate_height(scene, share, panel) * scene.options.diagram_factor / shown;
    return scale;
}

void draw_influence(const Scene& scene, const InfluencePicture& picture, const InfluenceScale& scale)
{
    InfluenceDrawing(scene, picture, scale).draw();
}

Vector3d ordinate_side(const femoop::NodeVector& load, const femoop::MemberGeometry& member, bool is_flat)
{
    const Vector3d force(load[0], load[1], load[2]), x = member.axes.row(0), y = member.axes.row(1),
                                                     z = member.axes.row(2);
    if (force.cross(x).norm() > clearly_across * force.norm()) return force.normalized();
    const double along_y = force.dot(y), along_z = is_flat ? 0.0 : force.dot(z);
    const bool is_y = std::abs(along_y) >= std::abs(along_z);
    const double across = is_y ? along_y : along_z;
    if (std::abs(across) <= square_enough * force.norm()) return -y;
    return std::copysign(1.0, across) * (is_y ? y : z);
}

InfluencePicture concealed(InfluencePicture picture)
{
    picture.motion.clear();
    picture.forces.clear();
    picture.curve.reset();
    picture.traced = femoop::influence::Stretch{};
    picture.sentences.clear();
    return picture;
}

bool is_concealed(const InfluencePicture& picture) { return picture.traced && !(picture.traced->to > 0.0); }

OrdinateUnit ordinate_unit(const ui::DisplayUnits& units, const InfluencePicture& picture)
{
    const ui::Measure effect = measure_of(picture.line.effect);
    const ui::Measure load = femoop::influence::is_couple(picture.load) ? ui::Measure::Moment : ui::Measure::Force;
    const ui::DisplayUnit unit = units.per(load).unit(effect);
    return {unit.name, unit.factor};
}

std::string ordinate_text(const ui::DisplayUnits& units, const OrdinateUnit& unit, double value)
{
    return with_minus(units.number(value * unit.factor, ui::Measure::Plain)) + (unit.name.empty() ? "" : " ") +
           unit.name;
}

namespace {

// Of ordinates times a length: m², mm·m/kN.
std::string area_unit(const std::string& ordinate, const std::string& length)
{
    if (ordinate.empty()) return length;
    if (ordinate == length) return length + "²";
    const auto slash = std::min(ordinate.find('/'), ordinate.size());
    return ordinate.substr(0, slash) + "·" + length + ordinate.substr(slash);
}

} // namespace

std::string areas_text(const ui::DisplayUnits& units, const InfluencePicture& picture, const ui::Catalogue& tr)
{
    const femoop::influence::LineAreas areas = picture.line.ordinates.areas();
    const OrdinateUnit unit = ordinate_unit(units, picture);
    const ui::DisplayUnit length = units.unit(ui::Measure::Length);
    const auto text = [&](double area) {
        return with_minus(units.number(area * unit.factor * length.factor, ui::Measure::Plain));
    };
    const double rounding = written_as_zero * std::max(areas.positive, -areas.negative);
    std::string both = areas.positive > rounding ? "+" + text(areas.positive) : "";
    if (areas.negative < -rounding) both += (both.empty() ? "" : ", ") + text(areas.negative);
    return tr("areas {areas} {unit}", {{"areas", both}, {"unit", area_unit(unit.name, length.name)}});
}

std::string effect_text(const femoop::Model& model, const ui::DisplayUnits& units, const MovingEffect& effect)
{
    std::string text = femoop::influence::component_name(model.analysis, effect) + "(";
    text += effect.member ? model[*effect.member].id : model[*effect.node].id;
    if (!effect.at) return text + ")";
    if (const auto* const percent = std::get_if<femoop::Percent>(&*effect.at))
        return text + ", " + ui::number_text(percent->value, units.format()) + "%)";
    const double x = femoop::influence::told_place(model, *effect.member, std::get<femoop::Quantity>(*effect.at));
    return text + ", " + units.text(x, ui::Measure::Length) + ")";
}

namespace {

bool is_of_displacement(const MovingEffect& effect)
{
    return effect.quantity != ExpectedQuantity::Reaction &&
           (!effect.component || femoop::is_displacement(*effect.component));
}

std::string_view released_by(const MovingEffect& effect)
{
    if (effect.quantity == ExpectedQuantity::Reaction)
        return is_rotation(*effect.dof)
                   ? ui::translatable(
                         "The support gives way and turns by 1; the path moves by the line: M · 1 = 1 · η(s).")
                   : ui::translatable("The support gives way by 1; the path moves by the line: R · 1 = 1 · η(s).");
    if (is_of_displacement(effect) && measure_of(effect) == ui::Measure::Rotation)
        return ui::translatable(
            "A unit couple stands there; the path moves by the line (Maxwell): 1 · {component} = 1 · η(s).");
    if (is_of_displacement(effect))
        return ui::translatable(
            "A unit load stands there; the path moves by the line (Maxwell): 1 · {component} = 1 · η(s).");
    switch (*effect.component) {
    case MemberComponent::N:
        return ui::translatable("The member parts by 1 at the section; the path moves by the line: N · 1 = 1 · η(s).");
    case MemberComponent::Vy:
    case MemberComponent::Vz:
        return ui::translatable("The member steps by 1 at the section; the path moves by the line: V · 1 = 1 · η(s).");
    case MemberComponent::T:
        return ui::translatable("The member twists by 1 at the section; the path moves by the line: T · 1 = 1 · η(s).");
    default:
        return ui::translatable("A hinge at the section opens by 1; the path moves by the line: M · 1 = 1 · η(s).");
    }
}

} // namespace

std::string principle(const femoop::Model& model, const MovingEffect& effect, const ui::Catalogue& tr)
{
    if (const auto zero = zero_by_support(model, effect, tr)) return *zero;
    const std::string component = femoop::influence::component_name(model.analysis, effect);
    return tr(released_by(effect), {{"component", component}});
}

std::optional<std::string> zero_by_support(const femoop::Model& model, const MovingEffect& effect,
                                           const ui::Catalogue& tr)
{
    const std::string component = femoop::influence::component_name(model.analysis, effect);
    if (femoop::influence::is_unheld_reaction(model, effect))
        return tr(
            "The support of node {node} does not hold {component}: this reaction is zero wherever the load stands.",
            {{"node", model[*effect.node].id}, {"component", component}});
    if (const auto node = femoop::influence::holding_support(model, effect))
        return tr("The support of node {node} holds {component}: this displacement is zero wherever the load stands.",
                  {{"node", model[*node].id}, {"component", component}});
    return std::nullopt;
}

ui::Role role_of(const MovingEffect& effect)
{
    if (effect.quantity == ExpectedQuantity::Reaction) return ui::Role::Reaction;
    if (!effect.component || is_displacement(*effect.component)) return ui::Role::Deformed;
    return role_of(*effect.component);
}

Show show_of(const MovingEffect& effect, femoop::AnalysisKind kind)
{
    if (effect.quantity == ExpectedQuantity::Reaction) return Show::Reactions;
    if (!effect.component || is_displacement(*effect.component)) return Show::Deformed;
    constexpr std::array diagrams{Show::N, Show::V, Show::M, Show::T, Show::Vy, Show::Vz, Show::My, Show::Mz};
    const auto* const alone = std::ranges::find_if(
        diagrams, [&](Show item) { return components(item, kind) == std::vector{*effect.component}; });
    return alone == diagrams.end() ? Show::M : *alone;
}

ui::Measure measure_of(const MovingEffect& effect)
{
    if (effect.component) return measure_of(*effect.component);
    const bool turns = !femoop::is_resultant(effect) && is_rotation(*effect.dof);
    if (effect.quantity == ExpectedQuantity::Reaction) return turns ? ui::Measure::Moment : ui::Measure::Force;
    return turns ? ui::Measure::Rotation : ui::Measure::Displacement;
}

} // namespace drawing
