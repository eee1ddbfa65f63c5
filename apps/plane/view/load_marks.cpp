#include "apps/plane/view/load_marks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>

#include "apps/drawing/sketch/symbols.h"
#include "apps/plane/view/case_shares.h"
#include "apps/plane/view/path_load.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using drawing::Clearance;
using Eigen::Vector2d;
using ui::Point;
using ui::Role;

// [px]
constexpr double arrow_step = 24.0, least_height = 14.0, most_height = 38.0, along_gap = 7.0, base_gap = 3.0,
                 over_support = 15.0, body_arrow = 34.0;
constexpr double most_of_radius = 0.7;
constexpr int most_arrows = 120;
constexpr double along_cosine = 0.2; // of a load to the outward normal, below which it runs along the curve

/// Arrows of one load along one stretch, and its values.
class PathLoadMarks {
public:
    PathLoadMarks(const PlateScene& scene, const PathLoad& load, double share, double base)
        : scene_(scene),
          load_(load),
          largest_(load.largest()),
          height_(scene.sketch.px(least_height + (most_height - least_height) * share)),
          base_(base)
    {
        if (load.path.line.front() != load.path.line.back()) return;
        const double radius = load.path.extent() * scene.camera.scale() / (2.0 * std::numbers::pi);
        height_ = std::min(height_, most_of_radius * radius); // so that arrows in a hole do not meet
    }

    /// How far it reaches from the curve.
    double draw() const
    {
        const double length = load_.path.extent() * scene_.camera.scale();
        const int n = static_cast<int>(
            std::clamp(std::round(length / scene_.sketch.px(arrow_step)), 1.0, 1.0 * most_arrows));
        draw_area();
        for (int i = 0; i <= n; ++i) draw_arrow(static_cast<double>(i) / n, length / n);
        if (scene_.shows(PlateShow::Values)) write_values();
        return base_ + height_;
    }

private:
    struct Arrow {
        Point foot, end; ///< at the curve, and away from it
        bool is_pull = false, is_along = false;
    };

    Arrow arrow(double share) const
    {
        const double s = load_.place(share);
        const auto [at, part] = load_.path.at(s);
        const Vector2d q = load_.at(s);
        const Point out = PlateScene::direction(load_.path.outward(part));
        const Point d = PlateScene::direction(q.norm() > 0.0 ? q.normalized() : load_.path.outward(part));
        const double towards = ui::dot(d, out), height = largest_ > 0.0 ? height_ * q.norm() / largest_ : 0.0;
        const Point foot = scene_.place(at) + (base_gap + base_) * out;
        Arrow arrow{.foot = foot, .end = foot + (towards < 0.0 ? -height : height) * d};
        arrow.is_pull = towards >= along_cosine;
        arrow.is_along = std::abs(towards) < along_cosine;
        return arrow;
    }

    void draw_arrow(double share, double step) const
    {
        const double s = load_.place(share);
        const Arrow shown = arrow(share);
        if (!shown.is_along) {
            if (ui::distance(shown.foot, shown.end) < scene_.sketch.px(4.0)) return;
            return drawing::draw(scene_.sketch, {.tail = shown.is_pull ? shown.foot : shown.end,
                                                 .head = shown.is_pull ? shown.end : shown.foot,
                                                 .head_size = 7.0});
        }
        if (share >= 1.0) return;
        const double between = s + 0.5 * step / scene_.camera.scale();
        const auto [at, part] = load_.path.at(between);
        const Vector2d q = load_.at(between);
        if (q.norm() <= 1e-9 * largest_) return;
        const Point middle = scene_.place(at) +
                             (base_ + scene_.sketch.px(along_gap)) * PlateScene::direction(load_.path.outward(part));
        const Point half = 0.42 * step * std::max(0.3, q.norm() / largest_) * PlateScene::direction(q.normalized());
        drawing::draw(scene_.sketch, {.tail = middle - half, .head = middle + half, .head_size = 7.0});
    }

    void draw_area() const
    {
        std::vector<Point> feet, ends;
        for (int i = 0; i <= PathLoad::samples; ++i) {
            const Arrow shown = arrow(static_cast<double>(i) / PathLoad::samples);
            if (shown.is_along) return;
            feet.push_back(shown.foot);
            ends.push_back(shown.end);
        }
        const ui::Stroke stroke = scene_.sketch.thin(Role::Load);
        scene_.sketch.polyline(ends, stroke);
        const ui::LayerScope layer(scene_.sketch.painter(), ui::Layer::Areas);
        ends.insert(ends.end(), feet.rbegin(), feet.rend());
        const ui::Color fill = scene_.sketch.theme().fill(Role::Load);
        scene_.sketch.polygon(ends, ui::with_opacity(fill, 0.5 * fill.a / 255.0));
    }

    void write_value(double share, std::initializer_list<double> others = {}) const
    {
        const double size = load_.at(load_.place(share)).norm();
        if (!(size > 1e-9 * largest_)) return;
        const auto target = [&](double at) {
            const Arrow shown = arrow(at);
            if (!shown.is_along) return shown.end;
            const auto part = load_.path.at(load_.place(at)).part;
            return shown.foot + scene_.sketch.px(along_gap + 4.0) * PlateScene::direction(load_.path.outward(part));
        };
        drawing::Caption caption{
            .text = scene_.text(size, measure_of(load_.load.kind)),
            .role = Role::Load,
            .target = target(share),
            .toward = PlateScene::direction(load_.path.outward(load_.path.at(load_.place(share)).part)),
            .rank = drawing::Rank::Load};
        for (const double other : others) caption.others.push_back(target(other));
        scene_.sketch.caption(std::move(caption));
    }

    bool is_even() const
    {
        for (int i = 0; i <= PathLoad::samples; ++i)
            if (largest_ - load_.at(load_.place(static_cast<double>(i) / PathLoad::samples)).norm() > 1e-6 * largest_)
                return false;
        return true;
    }

    void write_values() const
    {
        const double start = load_.at(load_.place(0.0)).norm(), end = load_.at(load_.place(1.0)).norm();
        if (is_even()) return write_value(0.5, {0.35, 0.65, 0.2, 0.8});
        write_value(0.0);
        write_value(1.0);
        if (largest_ > 1.01 * std::max(start, end)) write_value(load_.share_of_largest());
    }

    const PlateScene& scene_;
    const PathLoad& load_;
    double largest_, height_, base_;
};

/// All loads of one case.
class CaseLoadMarks {
public:
    explicit CaseLoadMarks(const PlateScene& scene)
        : scene_(scene),
          shares_(shares_of(scene.model(), scene.options.load_case)),
          forces_(point_forces(scene.model(), scene.options.load_case))
    {
        for (const CaseShare& share : shares_) find_largest(share);
        for (const PointForce& load : forces_) largest_force_ = std::max(largest_force_, load.force.norm());
    }

    void draw()
    {
        for (const CaseShare& share : shares_)
            for (const fp::CurveLoad& load : share.load_case.curves) draw_curve_load(load, share.factor);
        for (const PointForce& load : forces_) draw_point_force(load);
        for (const CaseShare& share : shares_) {
            for (const fp::RegionLoad& load : share.load_case.regions) draw_region_load(load, share.factor);
            for (const fp::PlaneSettlement& one : share.load_case.settlements) draw_settlement(one, share.factor);
        }
    }

private:
    const std::vector<CurvePath>& paths(fp::CurveId curve)
    {
        const auto [found, is_new] = paths_.try_emplace(curve.index);
        if (is_new) found->second = paths_of(scene_.outline, curve);
        return found->second;
    }

    void find_largest(const CaseShare& share)
    {
        for (const fp::CurveLoad& load : share.load_case.curves)
            for (const fp::CurveId curve : load.curves)
                for (const CurvePath& path : paths(curve)) {
                    double& largest = largest_[load.kind == fp::CurveLoadKind::Line];
                    largest = std::max(largest, PathLoad{load, path, share.factor}.largest());
                }
    }

    void draw_curve_load(const fp::CurveLoad& load, double factor)
    {
        const double largest = largest_[load.kind == fp::CurveLoadKind::Line];
        for (const fp::CurveId curve : load.curves) {
            double& base = base_.try_emplace(curve.index, first_base(curve)).first->second;
            double reach = base;
            for (const CurvePath& path : paths(curve)) {
                if (!path.touches_material()) continue;
                const PathLoad along{load, path, factor};
                const double of_path = along.largest();
                if (!(of_path > 0.0)) continue;
                reach = std::max(reach, PathLoadMarks(scene_, along, of_path / largest, base).draw());
            }
            if (reach > base) base = reach + 1.6 * scene_.sketch.theme().type().normal;
        }
    }

    double first_base(fp::CurveId curve) const
    {
        const bool is_supported = scene_.shows(PlateShow::Supports) && scene_.model()[curve].support.has_value();
        return is_supported ? scene_.sketch.px(over_support) : 0.0;
    }

    void draw_point_force(const PointForce& load)
    {
        const Vector2d at = fp::position(scene_.model()[load.point]), &force = load.force;
        if (!(force.norm() > 0.0)) return;
        const Point d = PlateScene::direction(force.normalized()), foot = scene_.place(at);
        const double length = scene_.sketch.px(28.0 + 18.0 * force.norm() / largest_force_);
        const bool is_pull = pulls(at, force.normalized());
        const Point far = foot + (is_pull ? length : -length) * d;
        const Point near = foot + (is_pull ? base_gap : -base_gap) * d;
        drawing::draw(scene_.sketch, {.tail = is_pull ? near : far, .head = is_pull ? far : near});
        if (!scene_.shows(PlateShow::Values)) return;
        scene_.sketch.caption({.text = scene_.text(force.norm(), ui::Measure::Force),
                               .role = Role::Load,
                               .target = far,
                               .toward = far - foot,
                               .rank = drawing::Rank::Load});
    }

    /// Material or curves lie behind the place, so the arrow leaves it.
    bool pulls(const Vector2d& at, const Vector2d& d) const
    {
        double behind = 0.0, ahead = 0.0;
        for (const OutlinedPiece& piece : scene_.outline.pieces)
            for (const Vector2d& other : {piece.line.front(), piece.line.back()}) {
                const Vector2d away = other - at;
                if (!(away.norm() > 0.0)) continue;
                behind = std::max(behind, -away.normalized().dot(d));
                ahead = std::max(ahead, away.normalized().dot(d));
            }
        return ahead < behind - 0.05;
    }

    std::vector<double> values_in(const fp::Field& field, const OutlinedFace& face, double factor) const
    {
        std::vector<double> values{factor * fp::value(field, {.x = face.inside.x(), .y = face.inside.y()})};
        for (const PlaceLine& loop : face.loops)
            for (const Vector2d& at : loop) values.push_back(factor * fp::value(field, {.x = at.x(), .y = at.y()}));
        return values;
    }

    void write_in(const OutlinedFace& face, const std::string& text, Role role) const
    {
        if (!scene_.shows(PlateShow::Values)) return;
        scene_.sketch.caption({.text = text,
                               .role = role,
                               .target = scene_.place(face.inside),
                               .toward = {0.0, 1.0},
                               .gap = scene_.sketch.px(8.0),
                               .rank = drawing::Rank::Load});
    }

    void draw_body_force(const fp::BodyForce& body, const OutlinedFace& face, double factor) const
    {
        const fp::FieldPlace at{.x = face.inside.x(), .y = face.inside.y()};
        const Vector2d b = factor *
                           Vector2d(body.bx ? fp::value(*body.bx, at) : 0.0, body.by ? fp::value(*body.by, at) : 0.0);
        if (b.norm() > 0.0) {
            const Point d = PlateScene::direction(b.normalized()), middle = scene_.place(face.inside);
            const Point beside = middle + scene_.sketch.px(26.0) * ui::left_normal(d);
            const Point half = 0.5 * scene_.sketch.px(body_arrow) * d;
            drawing::draw(scene_.sketch, {.tail = beside - half, .head = beside + half});
        }
        const NumberText volume = [&](double v) { return scene_.text(v, ui::Measure::ForcePerVolume); };
        const NumberText bare = [&](double v) {
            return ui::with_minus_signs(scene_.units.number(v, ui::Measure::ForcePerVolume));
        };
        std::string text;
        if (body.bx) text = "bx = " + range_text(values_in(*body.bx, face, factor), volume, bare);
        if (body.by)
            text += (text.empty() ? "" : ", ") + std::string("by = ") +
                    range_text(values_in(*body.by, face, factor), volume, bare);
        write_in(face, text, Role::Load);
    }

    void draw_rotation(const fp::SteadyRotation& rotation, const OutlinedFace& face, double factor)
    {
        // forces grow with the square of omega, so a factor makes no other omega of it
        std::string text = "ω = " + scene_.number(rotation.omega) + " rad/s";
        if (factor != 1.0) text = scene_.number(factor) + " × (" + text + ")";
        write_in(face, text, Role::Load);
        if (scene_.model().analysis == femoop::StressState::Axisymmetric || is_turning_) return;
        is_turning_ = true;
        const Vector2d about = rotation.about.empty() ? Vector2d(0.0, 0.0)
                                                      : Vector2d(rotation.about[0], rotation.about[1]);
        drawing::draw(scene_.sketch, drawing::CurvedArrow{.frame = {.origin = scene_.place(about)},
                                                          .radius = 15.0,
                                                          .sense = rotation.omega < 0.0 ? -1.0 : 1.0,
                                                          .role = Role::Load});
        scene_.sketch.disc(scene_.place(about), scene_.sketch.px(2.0), scene_.sketch.stroke(Role::Load).color);
    }

    void draw_region_load(const fp::RegionLoad& load, double factor)
    {
        for (const OutlinedFace& face : scene_.outline.faces) {
            if (!face.region || face.is_hole) continue;
            if (!load.regions.empty() && std::ranges::find(load.regions, *face.region) == load.regions.end()) continue;
            if (const auto* body = std::get_if<fp::BodyForce>(&load.load)) draw_body_force(*body, face, factor);
            if (const auto* rotation = std::get_if<fp::SteadyRotation>(&load.load))
                draw_rotation(*rotation, face, factor);
            const auto* heat = std::get_if<fp::TemperatureRise>(&load.load);
            if (heat == nullptr || !heat->rise) continue;
            const auto text = [&](double v) { return scene_.text(v, ui::Measure::Temperature); };
            const auto bare = [&](double v) {
                return ui::with_minus_signs(scene_.units.number(v, ui::Measure::Temperature));
            };
            write_in(face, "ΔT = " + range_text(values_in(*heat->rise, face, factor), text, bare), Role::Temperature);
        }
    }

    /// One line for each direction.
    void write_imposed(const fp::PlaneSettlement& one, const std::vector<fp::FieldPlace>& places, double factor,
                       const Vector2d& at, const Vector2d& out) const
    {
        if (!scene_.shows(PlateShow::Values)) return;
        const NumberText text = [&](double v) { return scene_.text(v, ui::Measure::Displacement); };
        const NumberText bare = [&](double v) {
            return ui::with_minus_signs(scene_.units.number(v, ui::Measure::Displacement));
        };
        double gap = over_support + 4.0;
        for (const auto& [name, field] : {std::pair("ux = ", &one.ux), std::pair("uy = ", &one.uy)}) {
            if (!*field) continue;
            std::vector<double> values;
            for (const fp::FieldPlace& place : places) values.push_back(factor * fp::value(**field, place));
            scene_.sketch.caption({.text = name + range_text(values, text, bare),
                                   .role = Role::Load,
                                   .target = scene_.place(at),
                                   .toward = PlateScene::direction(out),
                                   .gap = scene_.sketch.px(gap),
                                   .rank = drawing::Rank::Load});
            gap += 18.0;
        }
    }

    void draw_settlement(const fp::PlaneSettlement& one, double factor)
    {
        if (one.point) {
            const Vector2d at = fp::position(scene_.model()[*one.point]);
            write_imposed(one, {{.x = at.x(), .y = at.y()}}, factor, at, {0.0, -1.0});
        }
        for (const fp::CurveId curve : one.curves) {
            std::vector<fp::FieldPlace> places;
            for (const CurvePath& path : paths(curve))
                for (int i = 0; i <= PathLoad::samples; ++i) {
                    const double s = path.s.front() + path.extent() * i / PathLoad::samples;
                    const Vector2d at = path.at(s).at;
                    places.push_back({.x = at.x(), .y = at.y(), .s = s, .length = path.length});
                }
            if (places.empty()) continue;
            const CurvePath& path = paths(curve).front();
            const auto [at, part] = path.at(path.middle());
            write_imposed(one, places, factor, at, path.outward(part));
        }
    }

    const PlateScene& scene_;
    std::vector<CaseShare> shares_;
    std::vector<PointForce> forces_;
    std::map<std::size_t, std::vector<CurvePath>> paths_; ///< of curves
    double largest_[2] = {0.0, 0.0};                      ///< per area, per length
    double largest_force_ = 0.0;
    std::map<std::size_t, double> base_; ///< of curves: how far from it the next load begins
    bool is_turning_ = false;            ///< the centre of rotation is drawn
};

} // namespace

void draw_loads(const PlateScene& scene) { CaseLoadMarks(scene).draw(); }

std::string self_weight_text(const fp::PlaneModel& model, const PlateOptions& options)
{
    double factor = 0.0;
    for (const CaseShare& share : shares_of(model, options.load_case))
        factor += share.factor * share.load_case.self_weight;
    if (factor == 0.0) return {};
    if (factor == 1.0) return options.tr("with self-weight");
    return options.tr("with {factor} × self-weight", {{"factor", ui::number_text(factor, options.numbers)}});
}

} // namespace plane
