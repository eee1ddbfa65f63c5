#include "apps/plane/view/error_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "apps/plane/view/plate_scene.h"
#include "ui/paint/wrapped_lines.h"

namespace plane {

namespace {

using discretize::ErrorCycle;
using discretize::MeshError;
using ui::Point;
using ui::Role;
using ui::translatable;

constexpr double narrowest_curve = 380.0, share_of_words = 0.46; // [px]

std::string short_number(double value, const ui::NumberFormat& numbers)
{
    return ui::number_text(value, {.digits = 2, .mark = numbers.mark});
}

/// "(40; 0) mm", no finer than the element is; with the name of a point that it is at.
std::string place_words(const discretize::SmallElement& element, const femoop::plane::PlaneModel& model,
                        const ui::DisplayUnits& units)
{
    const double step = std::pow(10.0, std::ceil(std::log10(element.size)));
    Eigen::Vector2d at{step * std::round(element.at.x() / step), step * std::round(element.at.y() / step)};
    std::string name;
    double nearest = 4.0 * element.size;
    for (const auto& point : model.points) {
        const Eigen::Vector2d place(point.at[0], point.at[1]);
        const double distance = (place - element.at).norm();
        if (distance > nearest) continue;
        nearest = distance;
        at = place;
        name = point.id + " ";
    }
    return name + units.place(at.x(), at.y()) + " " + units.unit(ui::Measure::Length).name;
}

ui::DashPattern dashes(const ui::Theme& theme) { return ui::DashPattern{6.0, 3.0}.scaled(theme.symbol_scale()); }
ui::DashPattern dots() { return {1.5, 3.0}; }

/// A logarithmic axis from one place of the sheet to another.
struct LogAxis {
    double low = 1.0, high = 10.0; ///< above 0
    double from = 0.0, to = 1.0;   ///< on the sheet

    double at(double value) const { return from + std::log(value / low) / std::log(high / low) * (to - from); }
    /// In each decade, the fewer the more decades there are.
    std::vector<double> marks() const
    {
        static constexpr std::array dense{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0};
        static constexpr std::array usual{1.0, 2.0, 5.0};
        static constexpr std::array few{1.0};
        std::span<const double> steps = usual;
        if (high / low < 10.0) steps = dense;
        if (high / low > 200.0) steps = few;
        std::vector<double> marks;
        for (double decade = std::pow(10.0, std::floor(std::log10(low))); decade <= high; decade *= 10.0)
            for (const double step : steps)
                if (const double mark = step * decade; mark >= low * (1.0 - 1e-9) && mark <= high * (1.0 + 1e-9))
                    marks.push_back(mark);
        return marks;
    }
};

/// The diagram in its box.
class ErrorDiagram {
public:
    ErrorDiagram(ui::Painter& painter, const ErrorCycle& cycle, const PlateOptions& options, const ui::Theme& theme,
                 const ui::Box& box)
        : painter_(painter), cycle_(cycle), options_(options), theme_(theme), size_(theme.type().small)
    {
        box_ = {{box.min.x + 3.6 * size_, box.min.y + 1.6 * size_}, {box.max.x - 1.2 * size_, box.max.y - 2.9 * size_}};
        const MeshError& first = cycle.meshes().front();
        unknowns_ = {.low = n_of(first), .high = n_of(first), .from = box_.min.x, .to = box_.max.x};
        errors_ = {.low = 100.0 * first.error, .high = 100.0 * first.error, .from = box_.max.y, .to = box_.min.y};
        for (const auto* meshes : {&cycle.meshes(), &cycle.uniform()})
            for (const MeshError& mesh : *meshes) include(mesh);
        unknowns_.low /= 1.25;
        unknowns_.high *= 1.25;
        errors_.low /= 1.25;
        errors_.high *= 1.25;
    }

    void draw()
    {
        draw_axes();
        draw_smooth_slope();
        if (cycle_.uniform().size() > 1) draw_meshes(cycle_.uniform(), theme_.series(5), dashes(theme_), false);
        draw_meshes(cycle_.meshes(), theme_.series(0), {}, true);
    }

private:
    static double n_of(const MeshError& mesh) { return static_cast<double>(mesh.n_unknowns); }

    void include(const MeshError& mesh)
    {
        unknowns_.low = std::min(unknowns_.low, n_of(mesh));
        unknowns_.high = std::max(unknowns_.high, n_of(mesh));
        if (mesh.error <= 0.0) return;
        errors_.low = std::min(errors_.low, 100.0 * mesh.error);
        errors_.high = std::max(errors_.high, 100.0 * mesh.error);
    }

    Point place(const MeshError& mesh) const
    {
        return {unknowns_.at(n_of(mesh)), errors_.at(std::max(100.0 * mesh.error, errors_.low))};
    }

    ui::TextStyle style(Role role, ui::Anchor anchor) const
    {
        ui::TextStyle style = theme_.text(role, anchor);
        style.size = size_;
        return style;
    }

    void draw_axes()
    {
        const ui::Stroke grid{.color = ui::with_opacity(theme_.stroke(Role::FaintLabel).color, 0.35), .width = 0.7};
        const ui::Stroke axis{.color = theme_.stroke(Role::Edge).color, .width = 1.0};
        double last = -1e9;
        for (const double mark : unknowns_.marks()) {
            const double x = unknowns_.at(mark);
            painter_.line({x, box_.min.y}, {x, box_.max.y}, grid);
            const std::string text = ui::number_text(mark, options_.numbers);
            const double half = 0.5 * painter_.measure(text, style(Role::Label, ui::Anchor::Top)).width;
            if (x - half < last + 0.6 * size_) continue; // no room beside the one before
            painter_.text({x, box_.max.y + 0.2 * size_}, text, style(Role::Label, ui::Anchor::Top));
            last = x + half;
        }
        last = 1e9;
        for (const double mark : errors_.marks()) {
            const double y = errors_.at(mark);
            painter_.line({box_.min.x, y}, {box_.max.x, y}, grid);
            if (y > last - 1.1 * size_) continue;
            painter_.text({box_.min.x - 0.4 * size_, y}, short_number(mark, options_.numbers),
                          style(Role::Label, ui::Anchor::Right));
            last = y;
        }
        painter_.polyline(std::vector<Point>{box_.min, {box_.min.x, box_.max.y}, box_.max}, axis);
        painter_.text({0.5 * (box_.min.x + box_.max.x), box_.max.y + 1.5 * size_}, options_.tr("unknowns N"),
                      style(Role::FaintLabel, ui::Anchor::Top));
        painter_.text({box_.min.x, box_.min.y - 0.3 * size_}, options_.tr("error [%]"),
                      style(Role::FaintLabel, ui::Anchor::BottomLeft));
    }

    /// Through the first mesh, as far as the diagram reaches.
    void draw_smooth_slope()
    {
        const MeshError& first = cycle_.meshes().front();
        const double p = cycle_.smooth_rate(), e = 100.0 * first.error;
        const double n = std::min(unknowns_.high, n_of(first) * std::pow(e / errors_.low, 1.0 / p));
        ui::Stroke stroke = theme_.stroke(Role::FaintLabel);
        stroke.dash = dots();
        painter_.line(place(first), {unknowns_.at(n), errors_.at(e * std::pow(n / n_of(first), -p))}, stroke);
    }

    void draw_meshes(const std::vector<MeshError>& meshes, const ui::RoleStyle& look, const ui::DashPattern& dash,
                     bool is_filled)
    {
        std::vector<Point> line;
        for (const MeshError& mesh : meshes) line.push_back(place(mesh));
        ui::Stroke stroke = look.stroke;
        stroke.dash = dash;
        if (line.size() > 1) painter_.polyline(line, stroke);
        const double radius = 3.2 * theme_.symbol_scale();
        stroke.dash = {};
        for (const Point& at : line) {
            if (is_filled) painter_.disc(at, radius, stroke.color);
            else painter_.circle(at, 1.3 * radius, stroke);
        }
    }

    ui::Painter& painter_;
    const ErrorCycle& cycle_;
    const PlateOptions& options_;
    const ui::Theme& theme_;
    double size_; ///< em
    ui::Box box_;
    LogAxis unknowns_, errors_;
};

/// A title, what the lines mean and the sentences, one below the other in a box.
class CurveWords {
public:
    CurveWords(const ErrorCycle& cycle, const femoop::plane::PlaneModel& model, const PlateOptions& options,
               const ui::Theme& theme, const ui::Fonts& fonts, const ui::Box& box)
        : theme_(theme), fonts_(fonts), box_(box), y_(box.min.y)
    {
        ui::TextStyle title = theme.text(Role::Label, ui::Anchor::TopLeft), plain = title;
        title.weight = ui::Weight::Bold;
        plain.size = theme.type().small;
        const ui::Catalogue& tr = options.tr;
        add(tr("Error against unknowns, {case}", {{"case", model.case_name(cycle.load_case())}}), title);
        y_ += 0.2 * title.size;
        add_key(theme.series(0).stroke, {}, tr("refined by the error"), plain);
        if (cycle.uniform().size() > 1) add_key(theme.series(5).stroke, dashes(theme), tr("refined evenly"), plain);
        add_key(theme.stroke(Role::FaintLabel), dots(),
                tr("smooth stresses: N^{rate}", {{"rate", exponent_text(cycle.smooth_rate(), options.numbers)}}),
                plain);
        y_ += 0.4 * plain.size;
        for (const std::string& sentence : sentences(cycle, model, options)) add(sentence, plain);
    }

    bool fits() const { return y_ <= box_.max.y; }

    void draw(ui::Painter& painter) const
    {
        for (const Line& line : lines_) {
            double left = box_.min.x;
            if (line.key) {
                const double half = 0.6 * line.style.size, length = key_length();
                painter.line({left, line.y + half}, {left + length, line.y + half}, *line.key);
                left += length + 6.0;
            }
            painter.text({left, line.y}, line.text, line.style);
        }
    }

private:
    struct Line {
        std::string text;
        ui::TextStyle style;
        double y;
        std::optional<ui::Stroke> key{};
    };

    double key_length() const { return 22.0 * theme_.symbol_scale(); }

    void add(const std::string& words, const ui::TextStyle& style)
    {
        for (const std::string& line : ui::wrapped_lines(fonts_, words, style, box_.width())) {
            lines_.push_back({line, style, y_});
            y_ += 1.3 * style.size;
        }
    }

    void add_key(ui::Stroke stroke, const ui::DashPattern& dash, const std::string& words, const ui::TextStyle& style)
    {
        stroke.dash = dash;
        lines_.push_back({words, style, y_, stroke});
        y_ += 1.35 * style.size;
    }

    ui::Theme theme_;
    const ui::Fonts& fonts_;
    ui::Box box_;
    double y_;
    std::vector<Line> lines_;
};

/// In the largest type in which all of it has room.
void draw_words(ui::Painter& painter, const ErrorCycle& cycle, const femoop::plane::PlaneModel& model,
                const PlateOptions& options, const ui::Theme& theme, const ui::Box& box)
{
    for (const double scale : {1.0, 0.9, 0.8, 0.7}) {
        const CurveWords words(cycle, model, options, theme.scaled(scale), painter.fonts(), box);
        if (words.fits() || scale == 0.7) return words.draw(painter);
    }
}

} // namespace

std::string percent_text(double share, const ui::NumberFormat& numbers)
{
    constexpr double rounding = 1e-9;
    const double shown = std::abs(share) < rounding ? 0.0 : share;
    return ui::number_text(100.0 * shown, {.digits = 3, .mark = numbers.mark}) + " %";
}

std::string exponent_text(double rate, const ui::NumberFormat& numbers)
{
    return ui::with_minus_signs(short_number(-rate, numbers));
}

ui::Message reason_of(const discretize::NextMesh& next, const ErrorCycle& cycle)
{
    using discretize::CycleEnd;
    if (*next.end == CycleEnd::Exact)
        return translatable("the estimated error is rounding; there is nothing to refine");
    if (*next.end == CycleEnd::NoGain)
        return translatable("the last mesh has more unknowns and hardly less error than the one before");
    const double two_digits = std::pow(10.0, std::floor(std::log10(next.n_unknowns)) - 1.0);
    const double about = two_digits * std::round(next.n_unknowns / two_digits);
    return {translatable("the next mesh would have about {n} unknowns, more than {most}"),
            {{"n", std::to_string(std::llround(about))}, {"most", std::to_string(cycle.most_unknowns())}}};
}

std::vector<std::string> sentences(const ErrorCycle& cycle, const femoop::plane::PlaneModel& model,
                                   const PlateOptions& options)
{
    const ui::Catalogue& tr = options.tr;
    const MeshError &first = cycle.meshes().front(), &last = cycle.meshes().back();
    std::vector<std::string> all;
    const auto falls = [&](std::string_view sentence, const std::optional<double>& rate) {
        if (rate && *rate > 0.0) all.push_back(tr(sentence, {{"rate", exponent_text(*rate, options.numbers)}}));
    };
    all.push_back(
        tr("error {first} with {n} unknowns, {last} with {m}", {{"first", percent_text(first.error, options.numbers)},
                                                                {"n", std::to_string(first.n_unknowns)},
                                                                {"last", percent_text(last.error, options.numbers)},
                                                                {"m", std::to_string(last.n_unknowns)}}));
    falls(translatable("refined by the error it goes with N^{rate}"), rate(cycle.meshes()));
    falls(translatable("refined evenly it goes with N^{rate}"), rate(cycle.uniform()));
    if (const auto at = cycle.singular_place())
        all.push_back(tr("slower than smooth stresses would: they grow without bound near {place}, as at a corner, the "
                         "end of a support or a single force",
                         {{"place", place_words(*at, model, display_units(model, options))}}));
    return all;
}

void draw_error_curve(ui::Painter& painter, const ErrorCycle& cycle, const femoop::plane::PlaneModel& model,
                      const PlateOptions& options, const ui::Box& box)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    ui::Theme theme(options.theme);
    const double narrowest = narrowest_curve * theme.symbol_scale();
    if (box.width() < narrowest) theme = theme.scaled(std::max(0.5, box.width() / narrowest));
    const double words = share_of_words * box.width();
    draw_words(painter, cycle, model, options, theme,
               {box.min + Point{14.0, 4.0}, {box.min.x + words - 8.0, box.max.y - 4.0}});
    ErrorDiagram(painter, cycle, options, theme, {{box.min.x + words, box.min.y}, box.max}).draw();
}

} // namespace plane
