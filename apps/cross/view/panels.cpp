#include "apps/cross/view/panels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "apps/cross/view/numbers.h"
#include "ui/paint/wrapped_lines.h"

namespace cross {

namespace {

constexpr double slender = 0.12;     // height of a beam's picture, of its length
constexpr double title_ems = 1.7;    // height of a title, of the size of type
constexpr double usual_arrow = 34.0; // [px] of the largest load, in the theme's symbols
constexpr double edge = 3.0;         // [px] that labels keep from the border of their panel
constexpr double least_afar = 14.0;  // [px] of type that the last row reads in a small picture

constexpr std::size_t most_with_all_values = 24; // members; of more the values are thinned out in a small picture

struct Extent {
    ui::World2 low, high;
    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
};

Extent extent_of(const drawing::StructureShape& shape)
{
    if (shape.nodes.empty()) return {{0.0, 0.0}, {1.0, 0.0}};
    Extent extent{{shape.nodes[0].x(), shape.nodes[0].y()}, {shape.nodes[0].x(), shape.nodes[0].y()}};
    for (const Eigen::Vector3d& node : shape.nodes) {
        extent.low = {std::min(extent.low.x, node.x()), std::min(extent.low.y, node.y())};
        extent.high = {std::max(extent.high.x, node.x()), std::max(extent.high.y, node.y())};
    }
    return extent;
}

ui::PlaneCamera camera_over(const Extent& extent, ui::Size panel, ui::Margins margins)
{
    constexpr double most = 0.24, most_left = 0.36, most_above = 0.42; // of a small panel
    ui::PlaneCamera camera;
    margins.left = std::min(margins.left, most_left * panel.width);
    margins.right = std::min(margins.right, most * panel.width);
    margins.top = std::min(margins.top, most_above * panel.height);
    margins.bottom = std::min(margins.bottom, most * panel.height);
    camera.fit(std::array{extent.low, extent.high}, panel, margins);
    return camera;
}

/// The beam at a height of the panel, over the whole width.
ui::PlaneCamera beam_camera(const Extent& extent, ui::Size panel, double margin, double middle)
{
    const double scale = (panel.width - 2.0 * margin) / std::max(extent.width(), 1e-9);
    const double y = 0.5 * (extent.low.y + extent.high.y);
    return ui::PlaneCamera({margin - scale * extent.low.x, middle + scale * y}, scale);
}

/// The sheet needs room for its columns, so a low frame is drawn higher and a slender one broader.
void draw_out(Panel& panel, Extent extent, double em, const SheetRoom& room = {})
{
    constexpr double least = 0.6, most = 2.2;
    const ui::Margins margins{room.beside * em, room.above * em, room.beside * em, room.below * em};
    const double width = panel.box.width() - margins.left - margins.right;
    const double height = panel.box.height() - margins.top - margins.bottom;
    const double natural = width / std::max(extent.width(), 1e-9) * extent.height();
    if (natural > 0.0) panel.stretch = std::clamp(height / natural, least, most);
    extent.low.y *= panel.stretch;
    extent.high.y *= panel.stretch;
    if (panel.storeys.is_to_scale()) panel.camera = camera_over(extent, panel.box.size(), margins);
    else panel.camera.fit(std::array{extent.low, extent.high}, panel.box.size(), margins);
}

constexpr double lines_of_loads = 14.2; // title, value, arrows, beam, dimension lines

/// What a beam's sheet lacks on a low projector for columns that the last row reads.
double lacking(double height, const ui::Theme& theme, BeamColumns columns)
{
    constexpr double below = 12.2;   // lines: title, beam, head, three numbers and the sum
    constexpr double in_turn = 17.4; // title, beam, twice head, two numbers and the sum
    const double lines = columns == BeamColumns::Below ? below : in_turn;
    return legible_type(theme) > 0.0 ? std::max(0.0, lines * theme.type().normal - height) : 0.0;
}

using Heights = std::array<double, 3>; // of structure, deformed shape and moments over the sheet of a beam

double total(const Heights& heights) { return std::accumulate(heights.begin(), heights.end(), 0.0); }

constexpr Heights lines_of_pictures{10.4, 4.7, 6.5}; // of type, in the pictures over a beam's sheet on a low projector

/// Those that are shown, for a size of type.
Heights at_least(Heights heights, double type)
{
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (heights[i] > 0.0) heights[i] = std::max(heights[i], type * lines_of_pictures[i]);
    return heights;
}

/// The pictures give so much of what they can spare in a size of type.
Heights spared(Heights heights, double wanted, double type)
{
    Heights spare{};
    for (std::size_t i = 0; i < heights.size(); ++i) spare[i] = std::max(0.0, heights[i] - type * lines_of_pictures[i]);
    const double share = std::min(1.0, wanted / std::max(total(spare), 1e-9));
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] -= share * spare[i];
    return heights;
}

/// What the sheet lacks they give, as long as their values are as large as the panels' text. Between the panels the
/// deformed shape leaves its room to it where it lacks more, then the moments; where that is not enough, and in a
/// whole window, values are as small as the last row reads.
Heights heights_above(ui::Size size, const ui::Theme& theme, BeamColumns columns)
{
    constexpr double narrow = 40.0; // ems
    const double height = size.height, em = theme.type().normal;
    const double first_share = std::clamp(lines_of_loads * em / height, 0.24, 0.305);
    const double less = 0.25 * (first_share - 0.24);
    const Heights usual{first_share * height, (0.16 - less) * height, (0.20 - less) * height};
    const bool is_narrow = size.width <= narrow * em;
    const std::array fewer{usual, Heights{usual[0], 0.0, usual[2]}, Heights{usual[0], 0.0, 0.0}};
    Heights heights = usual;
    if (legible_type(theme) == 0.0) return heights;
    for (const double type : {em, least_afar})
        for (const Heights& some : std::span(fewer).first(is_narrow ? fewer.size() : 1)) {
            const Heights all = at_least(some, type);
            heights = spared(all, lacking(height - total(all), theme, columns), type);
            if (lacking(height - total(heights), theme, columns) <= 0.0) return heights;
        }
    return heights;
}

/// Below the heading.
void put_beam(Panel& sheet, const Extent& extent, double margin, const ui::Theme& theme)
{
    constexpr double usual = 2.9, high = 2.45, long_title = 30.0; // ems below the top of the sheet, in width
    const double em = theme.type().normal, height = sheet.box.height();
    const bool is_low = lacking(height, theme, BeamColumns::Below) > 0.0 && sheet.box.width() > long_title * em;
    sheet.camera = beam_camera(extent, sheet.box.size(), margin, (is_low ? high : usual) * em);
}

Panels stacked(const Extent& extent, ui::Size sheet, const ui::Theme& theme, BeamColumns columns)
{
    const double em = theme.type().normal, margin = std::min(4.6 * em, 0.1 * sheet.width);
    constexpr double lines_below_beam = 7.1; // supports, dimension lines and the text of the lower one
    Panels panels{.is_stacked = true};
    double top = 0.0;
    const auto next = [&](Panel& panel, double height, double middle) {
        panel.box = ui::box_at({0.0, top}, {sheet.width, height});
        panel.camera = beam_camera(extent, panel.box.size(), margin, middle);
        top += height;
    };
    const auto [first, second, third] = heights_above(sheet, theme, columns); // dimension lines keep their size
    next(panels.structure, first, first - lines_below_beam * std::min(em, first / lines_of_loads));
    next(panels.deformed, second, 0.56 * second);
    next(panels.moments, third, 0.56 * third);
    panels.sheet.box = {{0.0, top}, {sheet.width, sheet.height}};
    put_beam(panels.sheet, extent, margin, theme);
    const bool is_afar = legible_type(theme) > 0.0;
    const Heights lines = is_afar ? Heights{lines_of_pictures[0], 6.0, lines_of_pictures[2]}
                                  : Heights{lines_of_loads, 7.0, 9.0};
    panels.structure.ems_high = lines[0];
    panels.deformed.ems_high = lines[1];
    panels.moments.ems_high = lines[2];
    return panels;
}

/// Of the theme's type, where there is little room; on the projector the last row reads it.
double share_of_type(const Panel& panel, const ui::Theme& theme)
{
    const bool is_afar = legible_type(theme) > 0.0;
    const double enough = is_afar ? 21.0 : 24.0; // of the panel's width in ems
    const double em = theme.type().normal, least = is_afar ? least_afar : 11.0;
    const double room = std::min(panel.box.width() / enough, panel.box.height() / panel.ems_high);
    return std::clamp(room / em, std::min(1.0, least / em), 1.0);
}

/// The boxes of the three small pictures and of the sheet.
Panels divided(ui::Size sheet, const ui::Theme& theme, const Arrangement& arrangement)
{
    constexpr double share_of_row = 0.27; // of the height
    const bool is_column = arrangement.small == SmallPictures::Left;
    const double left = std::max(arrangement.small_share * sheet.width, arrangement.small_ems * theme.type().normal);
    const ui::Size size = is_column ? ui::Size{left, sheet.height / 3.0}
                                    : ui::Size{sheet.width / 3.0, share_of_row * sheet.height};
    const ui::Point next = is_column ? ui::Point{0.0, size.height} : ui::Point{size.width, 0.0};
    Panels panels;
    ui::Point corner;
    for (Panel* const panel : {&panels.structure, &panels.deformed, &panels.moments}) {
        panel->box = ui::box_at(corner, size);
        corner = corner + next;
    }
    panels.sheet.box = {is_column ? ui::Point{left, 0.0} : ui::Point{0.0, size.height}, {sheet.width, sheet.height}};
    return panels;
}

Panels beside(const Extent& extent, ui::Size sheet, const ui::Theme& theme, const Arrangement& arrangement)
{
    constexpr double usual_above = 5.2, moments_above = 6.6; // ems: fixed-end moments are the largest of all
    constexpr double usual_side = 5.0, moments_side = 7.0;   // ems: a foot's value stands beyond its ordinate
    const double em = theme.type().normal;
    Panels panels = divided(sheet, theme, arrangement);
    for (Panel* const panel : {&panels.structure, &panels.deformed, &panels.moments}) {
        panel->ems_high = 13.0;
        const double own = share_of_type(*panel, theme) * em;
        const bool has_moments = panel == &panels.moments;
        const double above = own * (has_moments ? moments_above : usual_above);
        const double side = own * (has_moments ? moments_side : usual_side);
        panel->camera = camera_over(extent, panel->box.size(), {side, above, side, 3.4 * own});
    }
    panels.sheet.storeys = arrangement.storeys;
    draw_out(panels.sheet, extent, em, arrangement.room);
    return panels;
}

} // namespace

const Panel& Panels::operator[](Part part) const
{
    switch (part) {
    case Part::Structure: return structure;
    case Part::Deformed: return deformed;
    case Part::Moments: return moments;
    case Part::Sheet: break;
    }
    return sheet;
}

namespace {

bool is_flat(const Extent& extent) { return extent.height() <= slender * extent.width(); }

} // namespace

Panel panel_alone(Part part, const drawing::StructureShape& shape, ui::Size sheet, const ui::Theme& theme)
{
    const Extent extent = extent_of(shape);
    const double em = theme.type().normal;
    const double foot = part == Part::Moments ? 7.0 * em : 3.6 * em; // arrows of reactions
    const ui::Box box = ui::box_at({0.0, 0.0}, sheet);
    Panel panel{.box = box, .whole = box, .ems_high = 7.0};
    if (is_flat(extent)) {
        const double middle = part == Part::Sheet       ? 2.9 * em
                              : part == Part::Structure ? sheet.height - 6.4 * em
                                                        : 0.56 * sheet.height;
        panel.camera = beam_camera(extent, sheet, std::min(4.6 * em, 0.1 * sheet.width), middle);
    } else if (part == Part::Sheet) {
        draw_out(panel, extent, em);
    } else {
        panel.camera = camera_over(extent, sheet, {7.0 * em, 5.2 * em, 7.0 * em, foot});
    }
    return panel;
}

void let_columns_stand_in_turn(Panel& sheet, const drawing::StructureShape& shape, const ui::Theme& theme, double foot)
{
    constexpr double heading = 1.8, side = 1.2; // ems: half a support
    const double em = theme.type().normal, middle = 0.5 * (heading * em + sheet.box.height() - foot);
    sheet.columns = BeamColumns::InTurn;
    sheet.camera = beam_camera(extent_of(shape), sheet.box.size(), side * em, middle);
}

bool is_beam(const drawing::StructureShape& shape) { return is_flat(extent_of(shape)); }

Panel stretch_of_sheet(const drawing::StructureShape& shape, ui::Size page, double whole_width, double left,
                       const ui::Theme& theme)
{
    Panel panel = panel_alone(Part::Sheet, shape, {whole_width, page.height}, theme);
    panel.box = ui::box_at({0.0, 0.0}, page);
    panel.whole = ui::box_at({-left, 0.0}, {whole_width, page.height});
    panel.camera.pan({-left, 0.0});
    return panel;
}

void make_room(Panel& sheet, const drawing::StructureShape& shape, const ui::Theme& theme, const SheetRoom& room)
{
    draw_out(sheet, extent_of(shape), theme.type().normal, room);
}

double height_alone(Part part, const drawing::StructureShape& shape, double width, std::size_t n_lines,
                    const ui::Theme& theme)
{
    const Extent extent = extent_of(shape);
    const double em = theme.type().normal;
    if (!is_flat(extent)) {
        const double natural = width * extent.height() / std::max(extent.width(), 1e-9);
        return part == Part::Sheet ? std::clamp(1.3 * natural, 0.75 * width, 1.3 * width)
                                   : std::clamp(0.8 * natural, 0.45 * width, 0.9 * width);
    }
    const double lines = static_cast<double>(std::clamp<std::size_t>(n_lines, 2, 16));
    return part == Part::Sheet ? em * (10.0 + 1.4 * lines) : part == Part::Structure ? 15.0 * em : 11.0 * em;
}

Eigen::Vector2d middle_of(const drawing::StructureShape& shape)
{
    const Extent extent = extent_of(shape);
    return {0.5 * (extent.low.x + extent.high.x), 0.5 * (extent.low.y + extent.high.y)};
}

Zoom zoomed(const Zoom& zoom, Eigen::Vector2d own_middle, Eigen::Vector2d at, double factor)
{
    const double next = std::clamp(zoom.factor * factor, Zoom::least, Zoom::most);
    const Eigen::Vector2d middle = zoom.middle.value_or(own_middle);
    return {next, at + (middle - at) * (zoom.factor / next)};
}

Zoom moved(const Zoom& zoom, Eigen::Vector2d own_middle, Eigen::Vector2d by)
{
    return {zoom.factor, zoom.middle.value_or(own_middle) - by, zoom.is_of_sheet};
}

namespace {

/// What was in the middle makes room for what the zoom looks at.
void look_closer(Panel& panel, const Eigen::Vector2d& own, const Zoom& zoom)
{
    const ui::Point middle = panel.camera.to_sheet({panel.bays(own.x()), panel.stretch * panel.storeys(own.y())});
    const Eigen::Vector2d at = zoom.middle.value_or(own);
    const double scale = zoom.factor * panel.camera.scale();
    const ui::Point corner = panel.box.min, end = panel.box.max - corner;
    const ui::World2 low = panel.camera.to_world({}), high = panel.camera.to_world(end);
    panel.is_zoomed = true;
    panel.zoom = zoom.factor;
    panel.camera = ui::PlaneCamera(
        {middle.x - scale * panel.bays(at.x()), middle.y + scale * panel.stretch * panel.storeys(at.y())}, scale);
    panel.whole = {corner + panel.camera.to_sheet(low), corner + panel.camera.to_sheet(high)};
}

} // namespace

double share_of_small_pictures(const drawing::StructureShape& shape)
{
    constexpr std::size_t of_a_portal = 4;
    return shape.members.size() <= of_a_portal ? 0.34 : 0.26;
}

Panels panels_for(const drawing::StructureShape& shape, ui::Size sheet, const ui::Theme& theme,
                  const Arrangement& arrangement)
{
    const Extent extent = extent_of(shape);
    Panels panels = is_flat(extent) ? stacked(extent, sheet, theme, arrangement.columns)
                                    : beside(extent, sheet, theme, arrangement);
    if (is_flat(extent) && arrangement.columns == BeamColumns::InTurn)
        let_columns_stand_in_turn(panels.sheet, shape, theme);
    if (arrangement.loaded) panels.structure.look_as(*arrangement.loaded);
    panels.sheet.bays = arrangement.bays;
    look_closer(panels, shape, arrangement.zoom);
    return panels;
}

double legible_type(const ui::Theme& theme)
{
    return theme.name() == ui::ThemeName::Projector ? theme.type().normal : 0.0;
}

std::vector<SheetRoom> rooms_tried(const ui::Theme& theme)
{
    constexpr std::array usual{SheetRoom{},
                               SheetRoom{11.0, 9.0, 4.0},
                               SheetRoom{6.5, 4.0, 3.0},
                               SheetRoom{8.5, 4.0, 3.0},
                               SheetRoom{11.0, 4.0, 3.0},
                               SheetRoom{4.6, 3.0, 2.4},
                               SheetRoom{5.6, 3.0, 2.4},
                               SheetRoom{2.5, 9.0, 4.0}};
    constexpr std::array afar{SheetRoom{9.5, 2.6, 2.4}, SheetRoom{10.5, 3.0, 2.4}, SheetRoom{5.4, 9.0, 2.4}};
    std::vector<SheetRoom> rooms(usual.begin(), usual.end());
    if (legible_type(theme) > 0.0) rooms.insert(rooms.end(), afar.begin(), afar.end());
    return rooms;
}

namespace {

/// A beam's columns hang down from it, or stand on it too, and grow with the zoom, so its sheet moves up and down, as
/// far as they reach.
/// \returns how it was taken
Zoom look_closer_at_columns(Panel& sheet, const Eigen::Vector2d& own, Zoom zoom)
{
    const double height = sheet.box.height(), growth = std::max(1.0, zoom.factor);
    const double scale = zoom.factor * sheet.camera.scale();
    const double beam = sheet.camera.to_sheet({own.x(), own.y()}).y;
    const double above = (growth - 1.0) * (sheet.columns == BeamColumns::InTurn ? beam : 0.0);
    const double below = (growth - 1.0) * height - above;
    if (zoom.middle) zoom.middle->y() = std::clamp(zoom.middle->y(), own.y() - below / scale, own.y() + above / scale);
    look_closer(sheet, own, zoom);
    sheet.whole.min.y = sheet.box.min.y - above + (zoom.middle ? scale * (zoom.middle->y() - own.y()) : 0.0);
    sheet.whole.max.y = sheet.whole.min.y + growth * height;
    return zoom;
}

} // namespace

void look_closer(Panels& panels, const drawing::StructureShape& shape, Zoom zoom)
{
    const std::array all{&panels.structure, &panels.deformed, &panels.moments, &panels.sheet};
    for (Panel* const panel : all) panel->whole = panel->box;
    panels.zoom = zoom;
    if (zoom.factor == 1.0 && !zoom.middle) return;
    const Eigen::Vector2d own = middle_of(shape);
    if (!is_beam(shape)) {
        for (Panel* const panel : all)
            if (!zoom.is_of_sheet || panel == &panels.sheet) look_closer(*panel, own, zoom);
        return;
    }
    panels.zoom = look_closer_at_columns(panels.sheet, own, zoom);
    if (zoom.is_of_sheet) return;
    if (zoom.middle) zoom.middle->y() = own.y();
    for (Panel* const panel : {&panels.structure, &panels.deformed, &panels.moments}) {
        look_closer(*panel, own, zoom);
        panel->zoom = 1.0;
    }
}

void make_room_for_reactions(Panels& panels, const drawing::StructureShape& shape, const ui::Theme& theme)
{
    Panel& panel = panels.moments;
    if (panel.is_zoomed) return;
    const Extent extent = extent_of(shape);
    const double em = theme.type().normal;
    const ui::Size size = panel.box.size();
    panel.ems_high = 13.0;
    if (panels.is_stacked) {
        panel.camera = beam_camera(extent, size, std::min(4.6 * em, 0.1 * size.width), 0.45 * size.height);
        return;
    }
    const double side = std::min(9.0 * em, 0.32 * size.width);
    panel.camera.fit(std::array{extent.low, extent.high}, size,
                     {.left = side,
                      .top = std::min(5.2 * em, 0.24 * size.height),
                      .right = side,
                      .bottom = std::min(8.0 * em, 0.34 * size.height)});
}

ui::Theme theme_in(const Panel& panel, const Look& look)
{
    const ui::Theme theme = look.full_theme();
    return theme.scaled(share_of_type(panel, theme));
}

ui::Theme theme_of_marks(const Panel& panel, const Look& look)
{
    constexpr double most = 2.0;
    return theme_in(panel, look).scaled(std::clamp(panel.zoom, 1.0, most));
}

Drawn::View view_of(const Panel& panel) { return {panel.box, panel.camera, panel.stretch, panel.bays, panel.storeys}; }

void draw_borders(ui::Painter& painter, const Panels& panels, const ui::Theme& theme)
{
    const ui::LayerScope layer(painter, ui::Layer::Grid);
    const ui::Stroke stroke = theme.stroke(ui::Role::GridAxis);
    const bool is_row = panels.deformed.box.min.x > panels.structure.box.min.x;
    for (const Panel* const panel : {&panels.structure, &panels.deformed, &panels.moments}) {
        const bool is_last = panel == &panels.moments;
        const ui::Box& box = panel->box;
        if (is_row && !is_last) painter.line({box.max.x, box.min.y}, box.max, stroke);
        if (panels.is_stacked || is_row || !is_last) painter.line({box.min.x, box.max.y}, box.max, stroke);
    }
    if (panels.is_stacked || is_row) return;
    const double x = panels.sheet.box.min.x;
    painter.line({x, panels.sheet.box.min.y}, {x, panels.sheet.box.max.y}, stroke);
}

namespace {

/// A title as it is written: in one line, or in several.
struct Title {
    ui::TextStyle style;
    std::vector<std::string> lines;
};

Title title_in(const ui::Painter& painter, const Panel& panel, const std::string& title, const ui::Theme& theme)
{
    constexpr double least = 0.85; // of the size of type; else there are two lines
    ui::TextStyle style = theme.text(ui::Role::FaintLabel, ui::Anchor::TopLeft);
    style.weight = ui::Weight::Bold;
    const double room = panel.box.width() - 1.2 * style.size;
    const double shrunk = room / std::max(1.0, painter.measure(title, style).width);
    style.size *= std::clamp(shrunk, least, 1.0);
    return {style, ui::wrapped_lines(painter.fonts(), title, style, room + 1.0)};
}

} // namespace

ui::Box draw_title(ui::Painter& painter, const Panel& panel, const std::string& title, const ui::Theme& theme)
{
    const auto [style, lines] = title_in(painter, panel, title, theme);
    const ui::LayerScope layer(painter, panel.is_zoomed ? ui::Layer::Overlay : ui::Layer::Labels);
    const ui::Box box = title_box(painter, panel, title, theme);
    if (panel.is_zoomed) // columns that stand there would be half covered
        painter.rectangle({panel.box.min, {panel.box.max.x, box.max.y}}, theme.background());
    ui::Point at = panel.box.min + ui::Point{0.6 * style.size, 0.4 * style.size};
    for (const std::string& line : lines) {
        painter.text(at, line, style);
        at.y += 1.15 * style.size;
    }
    return box;
}

ui::Box title_box(const ui::Painter& painter, const Panel& panel, const std::string& title, const ui::Theme& theme)
{
    const Title written = title_in(painter, panel, title, theme);
    double width = 0.0;
    for (const std::string& line : written.lines) width = std::max(width, painter.measure(line, written.style).width);
    const double size = written.style.size;
    return ui::box_at(panel.box.min,
                      {width + 1.2 * size, (0.55 + 1.15 * static_cast<double>(written.lines.size())) * size});
}

namespace {

enum class Pass : std::uint8_t { Measure, Write };

/// Of one line at least.
double height_of_title(const Panel& panel, const Look& look)
{
    return std::max(title_ems * theme_in(panel, look).type().normal, panel.title ? panel.title->height() : 0.0);
}

struct Sketched {
    drawing::Grips grips;
    std::optional<ui::Box> bounds; ///< of all marks
};

/// Arrows over a storey's beam end below the next beam.
double load_factor(const drawing::StructureShape& shape, const drawing::Projection& projection, double usual)
{
    constexpr double share = 0.5, least = 0.45; // of the storey, of the usual height
    double factor = 1.0;
    for (const drawing::MemberShape& member : shape.members) {
        const double height = std::abs(projection(member.end_node).y - projection(member.start_node).y);
        if (height > edge) factor = std::min(factor, share * height / usual);
    }
    return std::max(factor, least);
}

Sketched sketched(ui::Painter& painter, const Panel& panel, const Scene& scene, const StructureLook& look,
                  const Marks& marks, Pass pass)
{
    const ui::ClipScope clip(painter, panel.box);
    const ui::Theme theme = theme_of_marks(panel, scene.look);
    femoop::Model model = scene.document.model;
    for (femoop::Node& node : model.nodes) {
        if (!panel.bays.is_to_scale()) node.at[0] = femoop::Quantity(panel.bays(node.at[0].value()));
        if (panel.stretch != 1.0 || !panel.storeys.is_to_scale())
            node.at[1] = femoop::Quantity(panel.stretch * panel.storeys(node.at[1].value()));
    }
    for (femoop::Member& member : model.members) member.inextensible = false; // the method holds all: no mark tells it
    const drawing::StructureShape shape = drawing::shape_of(model);
    drawing::DrawOptions options;
    options.show = look.show;
    options.load_case = scene.document.method.load_case;
    options.theme = scene.look.theme;
    options.tr = scene.look.tr;
    const drawing::DrawState state{.locked_scale = look.locked_scale};
    const drawing::Projection projection(panel.camera, panel.box.min);
    const drawing::LevelOfDetail detail(shape, projection);
    ui::Box room = panel.box.grown(-edge);
    if (!panel.title) room.min.y += height_of_title(panel, scene.look);
    drawing::Sketch sketch({.painter = &painter,
                            .theme = &theme,
                            .room = room,
                            .symbol_factor = detail.symbol_share(),
                            .is_reduced = detail.is_reduced() && shape.members.size() > most_with_all_values,
                            .is_measured = pass == Pass::Measure});
    if (panel.title) sketch.reserve(*panel.title);
    options.load_factor = panel.arrows * load_factor(shape, projection, sketch.px(usual_arrow));
    const ui::DisplayUnits units = units_of(scene.document.model, scene.look.tr);
    marks({model, shape, projection, options, state, units, sketch, detail, look.show, look.units_stand});
    if (pass == Pass::Write) sketch.write_captions();
    return {sketch.grips(), sketch.bounds()};
}

/// What marks take beyond the structure, and at least the border of the panel; the structure keeps a share of the room.
ui::Margins margins_of(const ui::Box& marks, const ui::Box& structure, ui::Size size, double title)
{
    constexpr double most = 0.8; // of the panel
    const auto beyond = [](double reach) { return 2.0 * edge + std::max(0.0, reach); };
    ui::Margins margins{.left = beyond(structure.min.x - marks.min.x),
                        .top = title + beyond(structure.min.y - marks.min.y),
                        .right = beyond(marks.max.x - structure.max.x),
                        .bottom = beyond(marks.max.y - structure.max.y)};
    const auto limit = [](double& a, double& b, double room) {
        const double factor = std::min(1.0, most * room / (a + b));
        a *= factor;
        b *= factor;
    };
    limit(margins.left, margins.right, size.width);
    limit(margins.top, margins.bottom, size.height);
    return margins;
}

} // namespace

ui::PlaneCamera camera_around(const Marks& marks, const Panel& panel, const Scene& scene, const StructureLook& look,
                              const ui::Fonts& fonts)
{
    const Extent extent = extent_of(drawing::shape_of(scene.document.model));
    const double title = height_of_title(panel, scene.look);
    Panel fitted = panel;
    constexpr int trials = 4; // the room that marks take changes little from one scale to the next
    for (int i = 0; i < trials; ++i) {
        ui::Painter scratch(panel.box.size(), fonts);
        const auto bounds = sketched(scratch, fitted, scene, look, marks, Pass::Measure).bounds;
        if (!bounds) break;
        const ui::Box structure{fitted.at({extent.low.x, extent.high.y, 0.0}),
                                fitted.at({extent.high.x, extent.low.y, 0.0})};
        fitted.camera.fit(std::array{extent.low, extent.high}, panel.box.size(),
                          margins_of(*bounds, structure, panel.box.size(), title));
    }
    return fitted.camera;
}

LoadedView beam_around(const Marks& marks, const Panel& panel, const Scene& scene, const StructureLook& look,
                       const ui::Fonts& fonts)
{
    ui::Box room = panel.box.grown(-edge);
    room.min.y += height_of_title(panel, scene.look);
    Panel fitted = panel;
    std::optional<ui::Box> bounds;
    for (const double arrows : {1.0, 0.8, 0.65, 0.5}) {
        fitted.arrows = arrows;
        ui::Painter scratch(panel.box.size(), fonts);
        bounds = sketched(scratch, fitted, scene, look, marks, Pass::Measure).bounds;
        if (!bounds || bounds->height() <= room.height()) break;
    }
    if (!bounds) return {panel.camera};
    const double above = bounds->min.y - room.min.y, below = bounds->max.y - room.max.y; // free, lacking
    if (below > 0.0) fitted.camera.pan({0.0, -std::min(below, std::max(0.0, above))});
    return {fitted.camera, fitted.arrows};
}

drawing::Grips draw_structure_in(ui::Painter& painter, const Panel& panel, const Scene& scene,
                                 const StructureLook& look, const Marks& marks)
{
    return sketched(painter, panel, scene, look, marks, Pass::Write).grips;
}

} // namespace cross
