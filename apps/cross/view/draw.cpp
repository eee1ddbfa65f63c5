#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "apps/cross/view/exercise_picture.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/scene.h"
#include "apps/cross/view/sheet_picture.h"
#include "apps/cross/view/structure_pictures.h"
#include "femoop/model/dof.h"
#include "ui/paint/surface.h"
#include "ui/paint/text_measure.h"
#include "ui/paint/wrapped_lines.h"

namespace cross {

namespace {

void draw_faults(ui::Painter& painter, const Scene& scene)
{
    const ui::Theme theme = scene.look.full_theme();
    const ui::TextStyle style = theme.text(ui::Role::Error, ui::Anchor::TopLeft);
    ui::Point at{2.0 * style.size, 3.0 * style.size};
    for (const femoop::Fault& fault : scene.solution.faults)
        for (const std::string& line : ui::wrapped_lines(painter.fonts(), fault_text(fault, scene.look.tr), style,
                                                         painter.size().width - 4.0 * style.size)) {
            painter.text(at, line, style);
            at.y += 1.5 * style.size;
        }
}

/// Remembers every string.
class TextCollector : public ui::Surface {
public:
    explicit TextCollector(const ui::Fonts& fonts) : fonts_(fonts) {}
    void clip(const ui::Box& /*box*/) override {}
    void stroke(const ui::Path& /*path*/, const ui::Stroke& /*stroke*/) override {}
    void fill(std::span<const ui::Point> /*polygon*/, ui::Color /*color*/) override {}
    void stroke_arc(const ui::Arc& /*arc*/, const ui::Stroke& /*stroke*/) override {}
    void fill_disc(ui::Point /*center*/, double /*radius*/, ui::Color /*color*/) override {}
    void text(ui::Point at, std::string_view utf8, const ui::TextStyle& style) override
    {
        texts.push_back({std::string(utf8), ui::text_box(fonts_, at, utf8, style), style.color});
    }

    std::vector<WrittenText> texts;

private:
    const ui::Fonts& fonts_;
};

std::vector<WrittenText> texts_of(const ui::Painter& painter)
{
    TextCollector collector(painter.fonts());
    painter.picture().draw_on(collector);
    return std::move(collector.texts);
}

Arrangement with_columns(ui::Painter& painter, const drawing::StructureShape& shape, const Scene& scene,
                         BeamColumns columns)
{
    Arrangement arrangement{.columns = columns};
    const Panels whole = panels_for(shape, painter.size(), scene.look.full_theme(), arrangement);
    arrangement.bays = sheet_bays(painter, whole.sheet, scene);
    return arrangement;
}

/// Columns stand above the beam too where only so all of them are read.
Arrangement of_beam(ui::Painter& painter, const drawing::StructureShape& shape, const Scene& scene)
{
    const ui::Theme theme = scene.look.full_theme();
    Look look = scene.look;
    look.zoom = {.is_of_sheet = true};
    const Scene whole{scene.document, scene.solution, scene.state, scene.phase, {}, look};
    const auto fits = [&](const Arrangement& one) {
        return is_legible(painter, panels_for(shape, painter.size(), theme, one).sheet, whole);
    };
    Arrangement best = with_columns(painter, shape, scene, BeamColumns::Below);
    if (!fits(best))
        if (Arrangement in_turn = with_columns(painter, shape, scene, BeamColumns::InTurn); fits(in_turn))
            best = std::move(in_turn);
    const Panels panels = panels_for(shape, painter.size(), theme, best);
    best.loaded = view_of_loads(panels.structure, scene, painter.fonts());
    return best;
}

/// The small pictures stand over the sheet, or are narrower, where only so its numbers are read from the last row, or
/// more nearly.
Arrangement of_frame(ui::Painter& painter, const drawing::StructureShape& shape, const Scene& scene)
{
    const ui::Theme theme = scene.look.full_theme();
    Arrangement best{.small_share = share_of_small_pictures(shape)};
    const auto sheet_of = [&](const Arrangement& one) { return panels_for(shape, painter.size(), theme, one).sheet; };
    FittedSheet fitted = fitted_sheet(painter, sheet_of(best), scene);
    Arrangement above = best, narrow = best;
    above.small = SmallPictures::Above;
    narrow.small_share = 0.0;
    narrow.small_ems = 9.0;
    const double legible = legible_type(theme);
    for (const Arrangement& one : {above, narrow}) {
        if (fitted.layout.type >= legible && (legible == 0.0 || fitted.layout.clarity == 1.0)) break;
        FittedSheet other = fitted_sheet(painter, sheet_of(one), scene);
        if (is_better(other.layout, fitted.layout)) best = one, fitted = std::move(other);
    }
    best.room = fitted.room;
    best.storeys = fitted.storeys;
    best.loaded = view_of_loads(panels_for(shape, painter.size(), theme, best).structure, scene, painter.fonts());
    return best;
}

Arrangement arrangement_of(ui::Painter& painter, const drawing::StructureShape& shape, const Scene& scene)
{
    return is_beam(shape) ? of_beam(painter, shape, scene) : of_frame(painter, shape, scene);
}

void draw_forces(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    if (scene.look.shears) draw_shear_state(painter, panel, scene);
    else draw_moment_state(painter, panel, scene);
}

} // namespace

double legible_zoom(ui::Painter& painter, const Scene& scene)
{
    constexpr double step = 1.06, most = 8.0;
    const ui::Theme theme = scene.look.full_theme();
    const drawing::StructureShape shape = drawing::shape_of(scene.document.model);
    if (!scene.solution.task || scene.worksheet != nullptr) return 1.0;
    if (legible_type(theme) == 0.0 && !is_beam(shape)) return 1.0; // at a desk a large frame is rather seen whole
    Arrangement arrangement = arrangement_of(painter, shape, scene);
    Look look = scene.look;
    const Scene enlarged{scene.document, scene.solution, scene.state, scene.phase, {}, look};
    for (look.zoom = {1.0, {}, true}; look.zoom.factor < most; look.zoom.factor *= step) {
        arrangement.zoom = look.zoom;
        if (is_legible(painter, panels_for(shape, painter.size(), theme, arrangement).sheet, enlarged)) break;
    }
    return look.zoom.factor;
}

Drawn draw(ui::Painter& painter, const Scene& scene)
{
    Drawn drawn;
    if (!scene.solution.task) {
        draw_faults(painter, scene);
        return drawn;
    }
    if (scene.worksheet != nullptr) return draw_exercise(painter, scene);
    const ui::Theme theme = scene.look.full_theme();
    const drawing::StructureShape shape = drawing::shape_of(scene.document.model);
    Arrangement arrangement = arrangement_of(painter, shape, scene);
    arrangement.zoom = scene.look.zoom;
    Panels panels = panels_for(shape, painter.size(), theme, arrangement);
    if (scene.look.shears) make_room_for_reactions(panels, shape, theme);
    draw_borders(painter, panels, theme);
    drawn.loads = draw_loaded(painter, panels.structure, scene).loads;
    drawn.texts = texts_of(painter);
    drawn.corner = panels.structure.box.min;
    drawn.camera = panels.structure.camera;
    for (std::size_t n = 0; n < shape.nodes.size(); ++n)
        drawn.nodes.push_back({femoop::NodeId(n), panels.structure.at(shape.nodes[n])});
    if (panels.has_deformed()) draw_deformed_state(painter, panels.deformed, scene);
    if (panels.has_moments()) draw_forces(painter, panels.moments, scene);
    const DrawnSheet sheet = draw_sheet(painter, panels.sheet, scene);
    drawn.way_to_turn = sheet.way_to_turn;
    drawn.sheet_type = sheet.type;
    drawn.n_without_room = sheet.n_left_out;
    const auto& joints = scene.solution.task->problem.joints;
    for (std::size_t j = 0; j < joints.size(); ++j)
        for (const Part part : {Part::Structure, Part::Deformed, Part::Moments, Part::Sheet})
            if (const ui::Point at = panels[part].at(shape[joints[j].node]); panels[part].box.contains(at))
                drawn.joints.push_back({femoop::cross::JointId(j), part, at});
    drawn.zoom = panels.zoom;
    drawn.middle = middle_of(shape);
    for (const Part part : {Part::Structure, Part::Deformed, Part::Moments, Part::Sheet})
        drawn.views.push_back(view_of(panels[part]));
    return drawn;
}

Eigen::Vector2d Drawn::View::drawn_at(ui::Point at) const
{
    const ui::World2 drawn = camera.to_world(at - box.min);
    return {drawn.x, drawn.y / stretch};
}

Zoom Drawn::View::drawn(const Zoom& zoom) const
{
    return {zoom.factor, zoom.middle ? std::optional(drawn(*zoom.middle)) : std::nullopt, zoom.is_of_sheet};
}

Zoom Drawn::View::place(const Zoom& zoom) const
{
    return {zoom.factor, zoom.middle ? std::optional(place(*zoom.middle)) : std::nullopt, zoom.is_of_sheet};
}

const Drawn::View* Drawn::view_at(ui::Point at) const
{
    const auto view = std::ranges::find_if(views, [&](const View& one) { return one.box.contains(at); });
    return view == views.end() ? nullptr : &*view;
}

std::optional<Eigen::Vector2d> Drawn::place_at(ui::Point at) const
{
    const View* const view = view_at(at);
    return view == nullptr ? std::nullopt : std::optional(view->place(view->drawn_at(at)));
}

std::optional<Zoom> Drawn::zoomed_at(const Zoom& zoom, ui::Point at, double factor) const
{
    const View* const view = view_at(at);
    if (view == nullptr) return std::nullopt;
    return view->place(zoomed(view->drawn(zoom), view->drawn(middle), view->drawn_at(at), factor));
}

std::optional<Zoom> Drawn::moved_along(const Zoom& zoom, ui::Point from, ui::Point to) const
{
    const View* const view = view_at(from);
    if (view == nullptr) return std::nullopt;
    return view->place(moved(view->drawn(zoom), view->drawn(middle), view->drawn_at(to) - view->drawn_at(from)));
}

std::optional<femoop::NodeId> pick_node(const Drawn& drawn, ui::Point at, double reach)
{
    std::optional<femoop::NodeId> found;
    if (!drawn.is_in_structure(at)) return found;
    double nearest = reach;
    for (const NodeMark& mark : drawn.nodes) {
        const double distance = ui::distance(mark.at, at);
        if (distance >= nearest) continue;
        nearest = distance;
        found = mark.node;
    }
    return found;
}

bool is_within(const drawing::LoadMark& mark, ui::Point at)
{
    constexpr double reach = 3.0, of_arc = 8.0; // [px]
    if (mark.area.empty()) return false;
    ui::Box box{mark.area.front(), mark.area.front()};
    for (const ui::Point& p : mark.area) box = ui::united(box, {p, p});
    if (!box.grown(reach).contains(at)) return false;
    const double radius = ui::distance(mark.root, mark.tip);
    const bool is_arc = femoop::is_rotation(mark.dof) && box.grown(-of_arc).contains(mark.root);
    return !is_arc || std::abs(ui::distance(mark.root, at) - radius) <= of_arc;
}

const drawing::LoadMark* pick_load(const Drawn& drawn, ui::Point at)
{
    const auto is_there = [&](const drawing::LoadMark& mark) { return is_within(mark, at); };
    const auto found = std::ranges::find_if(drawn.loads, is_there);
    return found == drawn.loads.end() ? nullptr : &*found;
}

std::optional<femoop::cross::BlankId> pick_cell(const Drawn& drawn, ui::Point at)
{
    const auto found = std::ranges::find_if(drawn.cells, [&](const CellMark& mark) { return mark.box.contains(at); });
    return found == drawn.cells.end() ? std::nullopt : std::optional(found->cell);
}

std::optional<femoop::cross::JointId> pick(const Drawn& drawn, ui::Point at, double reach)
{
    std::optional<femoop::cross::JointId> found;
    double nearest = reach;
    for (const JointMark& mark : drawn.joints) {
        const double distance = ui::distance(mark.at, at);
        if (distance >= nearest) continue;
        nearest = distance;
        found = mark.joint;
    }
    return found;
}

} // namespace cross
