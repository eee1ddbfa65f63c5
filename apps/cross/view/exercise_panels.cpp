#include "apps/cross/view/exercise_panels.h"

#include <algorithm>
#include <vector>

namespace cross {

namespace {

constexpr double narrow = 38.0; // width of a window, in ems

/// Lines below the sheet, in the usual size of type: the legend, and where sheets are added what belongs to no end.
double lines_below(const Scene& scene) { return scene.worksheet_stage == scene.worksheet->n_sheets() ? 7.0 : 4.0; }

/// Room for dimension lines on the left and below, since all lengths are needed.
ui::PlaneCamera roomy_camera(const drawing::StructureShape& shape, ui::Size size, double em)
{
    std::vector<ui::World2> nodes;
    for (const Eigen::Vector3d& node : shape.nodes) nodes.push_back({node.x(), node.y()});
    constexpr double most = 0.36; // of a small panel
    const double left = std::min(9.0 * em, most * size.width), right = std::min(4.5 * em, most * size.width);
    const double top = std::min(6.5 * em, most * size.height), bottom = std::min(6.0 * em, most * size.height);
    ui::PlaneCamera camera;
    camera.fit(nodes, size, {.left = left, .top = top, .right = right, .bottom = bottom});
    return camera;
}

/// In a narrow window the sheet lies below the structure, which the moments stand beside once it is right.
Panels narrow_panels(const drawing::StructureShape& shape, ui::Size size, const Scene& scene, const SheetRoom& room)
{
    constexpr double closer = 0.7; // margins for small cells
    const ui::Theme theme = scene.look.full_theme();
    const double em = theme.type().normal, top = 0.28 * size.height;
    const double left = scene.worksheet->is_solved() ? 0.5 * size.width : size.width;
    Panels panels{.is_stacked = true};
    panels.structure.box = ui::box_at({0.0, 0.0}, {left, top});
    panels.moments.box = ui::box_at({left, 0.0}, {size.width - left, top});
    panels.structure.camera = panels.moments.camera = roomy_camera(shape, panels.structure.box.size(), em);
    panels.structure.ems_high = panels.moments.ems_high = 13.0;
    const double height = std::max(0.5 * (size.height - top), size.height - top - lines_below(scene) * em);
    panels.sheet = panel_alone(Part::Sheet, shape, {size.width, height}, theme.scaled(closer));
    make_room(panels.sheet, shape, theme.scaled(closer), room);
    panels.sheet.box = ui::box_at({0.0, top}, {size.width, size.height - top});
    return panels;
}

Panels panels_without_zoom(const drawing::StructureShape& shape, ui::Size size, const Scene& scene,
                           const SheetRoom& room)
{
    const ui::Theme theme = scene.look.full_theme();
    const double em = theme.type().normal, below = lines_below(scene) * em;
    Panels panels = panels_for(shape, size, theme);
    if (!panels.is_stacked)
        panels = panels_for(shape, {size.width, std::max(0.5 * size.height, size.height - below)}, theme);
    if (!panels.is_stacked) make_room(panels.sheet, shape, theme, room);
    panels.sheet.box.max.y = size.height;
    if (!panels.is_stacked && size.width < narrow * em) return narrow_panels(shape, size, scene, room);
    if (panels.is_stacked) {
        const double top = panels.structure.box.max.y,
                     height = scene.worksheet->is_solved() ? panels.moments.box.height() : 0.0;
        panels.moments.box = {{0.0, top}, {size.width, top + height}};
        panels.sheet.box.min.y = top + height;
        return panels;
    }
    const double left = panels.sheet.box.min.x, half = 0.5 * size.height;
    panels.structure.box = {{0.0, 0.0}, {left, half}};
    panels.moments.box = {{0.0, half}, {left, size.height}};
    panels.structure.camera = panels.moments.camera = roomy_camera(shape, panels.structure.box.size(), em);
    return panels;
}

} // namespace

Panels exercise_panels(const drawing::StructureShape& shape, ui::Size size, const Scene& scene, const SheetRoom& room,
                       BeamColumns columns)
{
    Panels panels = panels_without_zoom(shape, size, scene, room);
    const ui::Theme theme = scene.look.full_theme();
    constexpr double of_lengths = 1.0; // lines of the legend, that those of a beam take in a narrow picture
    if (columns == BeamColumns::InTurn)
        let_columns_stand_in_turn(panels.sheet, shape, theme, (lines_below(scene) + of_lengths) * theme.type().normal);
    look_closer(panels, shape, {});
    return panels;
}

} // namespace cross
