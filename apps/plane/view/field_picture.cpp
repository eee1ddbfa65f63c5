#include "apps/plane/view/field_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "apps/plane/view/color_scale.h"
#include "apps/plane/view/plate_scene.h"
#include "femoop/plane/result/iso_areas.h"
#include "femoop/plane/result/round_levels.h"
#include "ui/paint/wrapped_lines.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;
using fp::PlaneComponent;
using ui::Point;
using ui::Role;

constexpr double swatch = 16.0, legend_gap = 6.0, legend_border = 14.0; // [px]
constexpr double least_label_line = 70.0;                               // [px] that a contour is long to bear its value
constexpr double narrowest_notes = 108.0;                               // [px]

bool is_of_stress(PlaneComponent component)
{
    const auto stresses = fp::components_of(fp::PlaneQuantity::Stress);
    return std::ranges::find(stresses, component) != stresses.end();
}

/// The field where displacements take it.
fp::TriangulatedField moved(const PlateScene& scene, const fp::TriangulatedField& field)
{
    fp::TriangulatedField there = field;
    if (scene.magnification != 0.0)
        for (std::size_t i = 0; i < there.places.size(); ++i)
            there.places[i] += scene.magnification * scene.result->displacement(there.located[i]);
    return there;
}

void draw_bands(const PlateScene& scene, const FieldPicture& picture, const fp::TriangulatedField& field)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Background);
    for (std::size_t i = 0; i < picture.colors.size(); ++i) {
        // what is below the first level is drawn with it
        const double level = i == 0 ? -std::numeric_limits<double>::infinity() : picture.levels[i];
        for (const fp::IsoArea& area : fp::areas_above(field, level)) {
            std::vector<std::vector<Point>> loops{scene.on_sheet(area.outside)};
            for (const fp::IsoLoop& hole : area.holes) loops.push_back(scene.on_sheet(hole));
            scene.sketch.painter().region(loops, picture.colors[i]);
        }
    }
}

/// Values of lines, each on its line where it covers no other.
class LineLabels {
public:
    explicit LineLabels(const PlateScene& scene) : scene_(scene), style_(scene.sketch.theme().text(Role::Label))
    {
        style_.size = scene.sketch.theme().type().small;
        style_.plate = scene.sketch.theme().background();
    }

    void write(const std::vector<Point>& line, const std::string& text)
    {
        double length = 0.0;
        for (std::size_t i = 1; i < line.size(); ++i) length += ui::distance(line[i - 1], line[i]);
        if (length < scene_.sketch.px(least_label_line)) return;
        for (const std::size_t share : {4u, 3u, 5u, 2u, 6u, 1u, 7u}) {
            const Point at = line[share * line.size() / 8];
            const ui::Box box = ui::text_box(scene_.sketch.painter().fonts(), at, text, style_).grown(2.0);
            if (std::ranges::any_of(taken_, [&](const ui::Box& other) { return other.overlaps(box); })) continue;
            const ui::LayerScope layer(scene_.sketch.painter(), ui::Layer::Labels);
            scene_.sketch.painter().text(at, text, style_);
            scene_.sketch.reserve(box);
            taken_.push_back(box);
            return;
        }
    }

private:
    const PlateScene& scene_;
    ui::TextStyle style_;
    std::vector<ui::Box> taken_;
};

void draw_lines(const PlateScene& scene, const FieldPicture& picture, const fp::TriangulatedField& field)
{
    const ui::Stroke stroke = scene.sketch.thin(Role::Edge);
    LineLabels labels(scene);
    for (const double level : picture.levels)
        for (const auto& line : fp::iso_lines(field, level)) {
            const std::vector<Point> seen = scene.on_sheet(line);
            scene.sketch.polyline(seen, stroke, drawing::Clearance::Soft);
            if (scene.shows(PlateShow::Values)) labels.write(seen, picture.number(level, scene.units));
        }
}

std::string extreme_text(femoop::ExtremeKind which, const std::string& value, bool is_of_nodes_alone,
                         const ui::Catalogue& tr)
{
    const bool is_max = which == femoop::ExtremeKind::Max;
    if (is_of_nodes_alone)
        return is_max ? tr("max at nodes {value}", {{"value", value}}) : tr("min at nodes {value}", {{"value", value}});
    return is_max ? tr("max {value}", {{"value", value}}) : tr("min {value}", {{"value", value}});
}

struct Range {
    double low = 0.0, high = 0.0;
};

/// Of all that is drawn: between nodes, what is made of several stresses can be less or more than at any node.
Range drawn_range(const fp::TriangulatedField& field, Range at_nodes)
{
    for (const std::array<double, 3>& values : field.values)
        for (const double value : values) {
            at_nodes.low = std::min(at_nodes.low, value);
            at_nodes.high = std::max(at_nodes.high, value);
        }
    return at_nodes;
}

Point drawn_place(const PlateScene& scene, Vector2d at)
{
    const auto places = scene.input.results->locator().find(at);
    if (scene.magnification != 0.0 && !places.empty())
        at += scene.magnification * scene.result->displacement(places.front());
    return scene.place(at);
}

/// Its words stand on the side where the other extreme is not, which they could be taken for.
void mark_extreme(const PlateScene& scene, const FieldPicture& picture, femoop::ExtremeKind which)
{
    const fp::FieldExtremes& both = *picture.extremes;
    const bool is_max = which == femoop::ExtremeKind::Max;
    const fp::PlaneExtreme& extreme = is_max ? both.max : both.min;
    const Point target = drawn_place(scene, extreme.at), other = drawn_place(scene, (is_max ? both.min : both.max).at);
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    scene.sketch.disc(target, scene.sketch.px(4.0), scene.sketch.theme().background());
    scene.sketch.ring(target, scene.sketch.px(4.0), scene.sketch.thin(Role::Edge));
    scene.sketch.disc(target, scene.sketch.px(1.8), scene.sketch.theme().stroke(Role::Edge).color);
    const std::string value = picture.number(extreme.value, scene.units) +
                              (picture.unit.empty() ? "" : " " + picture.unit);
    scene.sketch.caption({.text = extreme_text(which, value, picture.goes_beyond_nodes, scene.options.tr),
                          .target = target,
                          .toward = ui::distance(target, other) > 1.0 ? target - other : Point{0.0, -1.0},
                          .gap = scene.sketch.px(9.0),
                          .rank = drawing::Rank::Extreme,
                          .weight = ui::Weight::Bold});
}

/// "σx [MPa]"
std::string legend_title(const FieldPicture& picture)
{
    return picture.symbol + (picture.unit.empty() ? "" : " [" + picture.unit + "]");
}

ui::TextStyle title_style(const ui::Theme& theme)
{
    ui::TextStyle title = theme.text(Role::Label, ui::Anchor::TopLeft);
    title.weight = ui::Weight::Bold;
    return title;
}

} // namespace

std::string FieldPicture::number(double value, const ui::DisplayUnits& units) const
{
    const double most = std::max(std::abs(levels.front()), std::abs(levels.back()));
    if (std::abs(value) < 1e-9 * most) value = 0.0;
    return ui::with_minus_signs(units.number(shown * value, measure));
}

std::string symbol_of(PlaneComponent component)
{
    switch (component) {
    case PlaneComponent::sx: return "σx";
    case PlaneComponent::sy: return "σy";
    case PlaneComponent::sz: return "σz";
    case PlaneComponent::txy: return "τxy";
    case PlaneComponent::s1: return "σ1";
    case PlaneComponent::s2: return "σ2";
    case PlaneComponent::tmax: return "τmax";
    case PlaneComponent::Mises: return "σ Mises";
    case PlaneComponent::Tresca: return "σ Tresca";
    case PlaneComponent::ex: return "εx";
    case PlaneComponent::ey: return "εy";
    case PlaneComponent::ez: return "εz";
    case PlaneComponent::gxy: return "γxy";
    default: return std::string(fp::name(component));
    }
}

ui::Measure measure_of(PlaneComponent component)
{
    if (component == PlaneComponent::ux || component == PlaneComponent::uy) return ui::Measure::Displacement;
    return is_of_stress(component) ? ui::Measure::Stress : ui::Measure::Plain;
}

FieldPicture field_picture(const FieldShow& show, const fp::PlaneCase& result, const PlateOptions& options,
                           const ui::DisplayUnits& units)
{
    const ui::Catalogue& tr = options.tr;
    FieldPicture picture{.style = show.style,
                         .field = fp::component_field(result, show.component, options.reading),
                         .extremes = fp::field_extremes(result, show.component, options.reading),
                         .measure = measure_of(show.component),
                         .symbol = symbol_of(show.component)};
    picture.unit = units.unit(picture.measure).name;
    const double low = picture.extremes->min.value, high = picture.extremes->max.value;
    const Range drawn = drawn_range(picture.field, {low, high});
    const double band = 0.1 * (drawn.high - drawn.low); // about one of the picture's: less has the colour of the last
    picture.goes_beyond_nodes = drawn.low < low - band || drawn.high > high + band;
    const Range banded = picture.goes_beyond_nodes ? drawn : Range{low, high};
    // levels are round as they are shown
    const double factor = units.unit(picture.measure).factor;
    if (options.range) picture.levels = fp::equal_levels((*options.range)[0], (*options.range)[1]);
    else {
        picture.levels = fp::round_levels(banded.low * factor, banded.high * factor);
        for (double& level : picture.levels) level /= factor;
    }
    picture.colors = band_colors(picture.levels, ui::Theme(options.theme));
    if (is_of_stress(show.component))
        picture.notes.push_back(options.reading == fp::StressReading::Element ? tr("element values") : tr("smoothed"));
    if (options.range) picture.notes.push_back(tr("fixed range"));
    if (show.style == FieldStyle::Contours)
        picture.notes.push_back(
            tr("lines every {step}", {{"step", picture.number(picture.levels[1] - picture.levels[0], units)}}));
    for (const auto& [which, value] : {std::pair{femoop::ExtremeKind::Max, high}, {femoop::ExtremeKind::Min, low}})
        picture.notes.push_back(extreme_text(which, picture.number(value, units), picture.goes_beyond_nodes, tr));
    return picture;
}

FieldPicture error_picture(const fp::PlaneCase& result, const PlateOptions& options)
{
    const std::vector<double>& errors = result.element_errors();
    FieldPicture picture{.style = FieldStyle::Bands,
                         .field = fp::triangulated(result.structure().model(), 0,
                                                   [&](const fp::Location& at) { return errors[at.element.index]; }),
                         .measure = ui::Measure::Plain,
                         .shown = 100.0,
                         .symbol = "η",
                         .unit = "%"};
    const double most = errors.empty() ? 1.0 : *std::ranges::max_element(errors);
    picture.levels = options.range ? fp::equal_levels((*options.range)[0] / 100.0, (*options.range)[1] / 100.0)
                                   : fp::round_levels(0.0, most, 8);
    picture.colors = band_colors(picture.levels, ui::Theme(options.theme));
    double squares = 0.0;
    for (const double error : errors) squares += error * error;
    const std::string whole = ui::number_text(100.0 * std::sqrt(squares), {.digits = 3, .mark = options.numbers.mark});
    picture.notes = {options.tr("estimated error of each element"),
                     options.tr("of the whole {error} %", {{"error", whole}})};
    return picture;
}

void draw_field(const PlateScene& scene, const FieldPicture& picture)
{
    if (picture.style == FieldStyle::Bands) scene.shade_faces();
    const fp::TriangulatedField field = moved(scene, picture.field);
    if (picture.style == FieldStyle::Bands) draw_bands(scene, picture, field);
    else draw_lines(scene, picture, field);
    if (!picture.extremes || !scene.shows(PlateShow::Values)) return;
    mark_extreme(scene, picture, femoop::ExtremeKind::Max);
    if (picture.extremes->min.value < picture.extremes->max.value)
        mark_extreme(scene, picture, femoop::ExtremeKind::Min);
}

double legend_width(const FieldPicture& picture, const ui::DisplayUnits& units, const ui::Theme& theme,
                    const ui::Fonts& fonts)
{
    double widest = 0.0;
    for (const double level : picture.levels)
        widest = std::max(widest, fonts.measure(picture.number(level, units), theme.type().small).width);
    const double k = theme.symbol_scale();
    const double title = fonts.measure(legend_title(picture), title_style(theme)).width;
    return 2.0 * legend_border + std::max({k * narrowest_notes, title, k * swatch + legend_gap + widest});
}

void draw_legend(ui::Painter& painter, const FieldPicture& picture, const ui::DisplayUnits& units,
                 const ui::Theme& theme, const ui::Box& box)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const double k = theme.symbol_scale(), small = theme.type().small, left = box.min.x + legend_border;
    const ui::TextStyle title = title_style(theme);
    ui::TextStyle note = theme.text(Role::Label, ui::Anchor::TopLeft);
    note.size = small;
    note.color = theme[Role::FaintLabel].text;
    double y = box.min.y + 10.0;
    painter.text({left, y}, legend_title(picture), title);
    y += 1.5 * title.size;
    // where it is low, its colours are worth more than its notes
    const bool has_colors = picture.style == FieldStyle::Bands;
    const double of_colors = has_colors ? std::min(4.0, 1.2 * static_cast<double>(picture.colors.size())) * small : 0.0;
    for (const std::string& line : picture.notes)
        for (const std::string& part : ui::wrapped_lines(painter.fonts(), line, note, box.max.x - left - 2.0)) {
            if (y + 1.35 * small + 2.0 * small + of_colors > box.max.y) continue;
            painter.text({left, y}, part, note);
            y += 1.35 * small;
        }
    y += small;
    if (picture.style == FieldStyle::Contours) return;
    const auto n = static_cast<double>(picture.colors.size());
    const double height = std::min(1.9 * small, (box.max.y - small - y) / n);
    if (height <= 0.0) return;
    ui::TextStyle value = theme.text(Role::Label, ui::Anchor::Left);
    value.size = small;
    // as many values as stand clear of one another
    const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(1.15 * small / height)));
    for (std::size_t i = 0; i < picture.levels.size(); ++i) {
        const double top = y + height * (n - static_cast<double>(i));
        if (i < picture.colors.size())
            painter.rectangle({{left, top - height}, {left + k * swatch, top}}, picture.colors[i]);
        if (i % every == 0)
            painter.text({left + k * swatch + legend_gap, top}, picture.number(picture.levels[i], units), value);
    }
    painter.polyline({{left, y}, {left + k * swatch, y}, {left + k * swatch, y + n * height}, {left, y + n * height}},
                     {.color = theme.stroke(Role::Edge).color, .width = 0.8}, ui::PathEnds::Closed);
}

} // namespace plane
