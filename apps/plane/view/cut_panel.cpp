#include "apps/plane/view/cut_panel.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ui/paint/wrapped_lines.h"

namespace plane {

namespace {

namespace fp = femoop::plane;
using ui::Point;
using ui::Role;
using ui::translatable;

constexpr double panel_height = 210.0, narrowest_panel = 380.0, words_share = 0.34; // [px]

constexpr std::size_t stations_of_piece = 3; // of elements: its ends and its middle

/// What stands at a place of a cut.
struct CutValue {
    double s = 0.0, value = 0.0;
};

using CutValues = std::vector<CutValue>;

/// Values piece after piece, parted where there is no material between two pieces.
std::vector<CutValues> stretches(const CutValues& values, std::size_t n_of_piece)
{
    constexpr double apart = 1e-9; // of the whole
    const double length = values.back().s - values.front().s;
    std::vector<CutValues> parted;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool begins_piece = i % n_of_piece == 0;
        if (parted.empty() || (begins_piece && values[i].s > values[i - 1].s + apart * length)) parted.emplace_back();
        parted.back().push_back(values[i]);
    }
    return parted;
}

ui::TextStyle small_words(const ui::Theme& theme, Role role, ui::Anchor anchor)
{
    ui::TextStyle style = theme.text(role, anchor);
    style.size = theme.type().small;
    return style;
}

/// One stress along a cut: the values to the right of the axis where they are positive, s upwards.
class StressPlot {
public:
    StressPlot(ui::Painter& painter, const ui::Theme& theme, const ui::Box& box)
        : painter_(painter), theme_(theme), box_(box)
    {}

    void fit(const CutValues& a, const CutValues& b)
    {
        for (const auto* values : {&a, &b})
            for (const CutValue& v : *values) {
                low_ = std::min(low_, v.value);
                high_ = std::max(high_, v.value);
            }
        start_ = a.front().s;
        end_ = a.back().s;
        if (!(high_ > low_)) high_ = low_ + 1.0;
    }

    void draw_area(const CutValues& values, std::size_t n_of_piece, const ui::RoleStyle& look)
    {
        for (const CutValues& stretch : stretches(values, n_of_piece)) {
            std::vector<Point> line = points(stretch), area = line;
            area.push_back({x(0.0), y(stretch.back().s)});
            area.push_back({x(0.0), y(stretch.front().s)});
            painter_.polygon(area, look.fill);
            painter_.polyline(line, look.stroke);
        }
    }

    void draw_line(const CutValues& values, std::size_t n_of_piece, const ui::Stroke& stroke)
    {
        for (const CutValues& stretch : stretches(values, n_of_piece)) painter_.polyline(points(stretch), stroke);
    }

    void draw_axis()
    {
        const ui::Stroke stroke{.color = theme_.stroke(Role::Edge).color, .width = 1.0};
        painter_.line({x(0.0), y(start_) + 3.0}, {x(0.0), y(end_) - 3.0}, stroke);
    }

    void write(const CutValue& at, const std::string& text)
    {
        const bool is_right = at.value >= 0.0;
        ui::TextStyle style = small_words(theme_, Role::Label, is_right ? ui::Anchor::Left : ui::Anchor::Right);
        style.plate = ui::with_opacity(theme_.background(), 0.75);
        const double edge = 0.7 * style.size;
        const double height = std::clamp(y(at.s), box_.min.y + edge, box_.max.y - edge);
        painter_.text({x(at.value) + (is_right ? 5.0 : -5.0), height}, text, style);
    }

private:
    double x(double value) const
    {
        // room for the numbers on both sides
        const double margin = 4.2 * theme_.type().small, left = box_.min.x + margin, right = box_.max.x - margin;
        return left + (value - low_) / (high_ - low_) * (right - left);
    }
    double y(double s) const { return box_.max.y - 4.0 - (s - start_) / (end_ - start_) * (box_.height() - 8.0); }
    std::vector<Point> points(const CutValues& values) const
    {
        std::vector<Point> line;
        for (const CutValue& v : values) line.push_back({x(v.value), y(v.s)});
        return line;
    }

    ui::Painter& painter_;
    const ui::Theme& theme_;
    ui::Box box_;
    double low_ = 0.0, high_ = 0.0, start_ = 0.0, end_ = 1.0;
};

/// The panel of one cut.
class CutPanel {
public:
    CutPanel(ui::Painter& painter, const CutPicture& picture, const PlateOptions& options,
             const ui::DisplayUnits& units, const ui::Box& box)
        : painter_(painter), picture_(picture), options_(options), units_(units), theme_(options.theme), box_(box)
    {
        const double narrowest = narrowest_panel * theme_.symbol_scale();
        if (box.width() < narrowest) theme_ = theme_.scaled(std::max(0.5, box.width() / narrowest));
    }

    void draw(std::size_t n)
    {
        if (picture_.hindrance) return write_hindrance(n);
        const double words = words_share * box_.width(), plot = 0.5 * (box_.width() - words);
        write_words(n);
        const double top = box_.min.y + 2.4 * theme_.type().small;
        draw_plot({{box_.min.x + words, top}, {box_.min.x + words + plot, box_.max.y - 6.0}}, "σx′",
                  &fp::CutStation::sx, &fp::CutTheory::Station::sigma);
        draw_plot({{box_.min.x + words + plot, top}, {box_.max.x - 6.0, box_.max.y - 6.0}}, "τx′y′",
                  &fp::CutStation::txy, &fp::CutTheory::Station::tau);
    }

private:
    std::string text(double value, ui::Measure measure) const
    {
        return ui::with_minus_signs(units_.text(value, measure));
    }
    std::string place(const Eigen::Vector2d& at) const { return units_.place(at.x(), at.y()); }

    void write_hindrance(std::size_t n)
    {
        ui::TextStyle title = theme_.text(Role::Label, ui::Anchor::TopLeft);
        title.weight = ui::Weight::Bold;
        const Point at = box_.min + Point{14.0, 4.0};
        painter_.text(at, options_.tr("Cut {n}", {{"n", std::to_string(n)}}), title);
        painter_.text(at + Point{0.0, 1.5 * title.size}, options_.tr(*picture_.hindrance),
                      small_words(theme_, Role::Label, ui::Anchor::TopLeft));
    }

    /// What the stresses miss, and what equilibrium gives, as wide as the words are.
    double write_warning(double left, double y, ui::TextStyle style)
    {
        const ui::Catalogue& tr = options_.tr;
        const fp::CutForces& by = picture_.warning->balanced;
        const double size = force_size();
        style.color = theme_.stroke(Role::Error).color;
        const std::string percent = ui::number_text(100.0 * picture_.warning->missed,
                                                    {.digits = 2, .mark = options_.numbers.mark});
        const std::string what = tr("misses equilibrium by {missed} %; digits that hold: {digits}",
                                    {{"missed", percent}, {"digits", std::to_string(picture_.warning->digits)}});
        const std::string right = tr("by equilibrium N = {N}, V = {V}, M = {M}",
                                     {{"N", text(rounded(by.N, size), ui::Measure::Force)},
                                      {"V", text(rounded(by.V, size), ui::Measure::Force)},
                                      {"M", text(rounded(by.M, size * picture_.cut.length()), ui::Measure::Moment)}});
        const double width = words_share * box_.width() - 18.0;
        for (const std::string& sentence : {what, right})
            for (const std::string& line : ui::wrapped_lines(painter_.fonts(), sentence, style, width)) {
                painter_.text({left, y}, line, style);
                y += 1.3 * style.size;
            }
        return y;
    }

    void write_words(std::size_t n)
    {
        const ui::Catalogue& tr = options_.tr;
        ui::TextStyle title = theme_.text(Role::Label, ui::Anchor::TopLeft);
        title.weight = ui::Weight::Bold;
        const ui::TextStyle line = small_words(theme_, Role::Label, ui::Anchor::TopLeft);
        double y = box_.min.y + 4.0;
        const double left = box_.min.x + 14.0;
        const auto write = [&](const std::string& words, const ui::TextStyle& style) {
            painter_.text({left, y}, words, style);
            y += 1.4 * style.size;
        };
        write(tr("Cut {n}", {{"n", std::to_string(n)}}), title);
        write(place(picture_.cut.start) + " – " + place(picture_.cut.end), line);
        write("N = " + text(rounded(picture_.forces.N, force_size()), ui::Measure::Force), line);
        write("V = " + text(rounded(picture_.forces.V, force_size()), ui::Measure::Force), line);
        write("M = " + text(rounded(picture_.forces.M, force_size() * picture_.cut.length()), ui::Measure::Moment),
              line);
        if (picture_.warning) y = write_warning(left, y + 0.3 * line.size, line);
        y += (picture_.warning ? 0.3 : 0.5) * line.size;
        draw_key(left, y, line);
    }

    /// What is rounding beside the others is nothing.
    static double rounded(double value, double beside) { return std::abs(value) < 1e-9 * beside ? 0.0 : value; }
    double force_size() const
    {
        const fp::CutForces& f = picture_.forces;
        return std::max({std::abs(f.N), std::abs(f.V), std::abs(f.M) / picture_.cut.length()});
    }

    ui::RoleStyle of_elements() const { return theme_.series(0); }
    ui::Stroke of_theory() const
    {
        ui::Stroke stroke = theme_.series(5).stroke;
        stroke.dash = ui::DashPattern{6.0, 3.0}.scaled(theme_.symbol_scale());
        stroke.width *= 1.2;
        return stroke;
    }

    void draw_key(double left, double y, const ui::TextStyle& style)
    {
        const ui::Catalogue& tr = options_.tr;
        const double length = 22.0 * theme_.symbol_scale(), half = 0.6 * style.size, gap = 6.0;
        const auto write = [&](double x, const ui::Stroke& stroke, const std::string& words) {
            painter_.line({x, y + half}, {x + length, y + half}, stroke);
            painter_.text({x + length + gap, y}, words, style);
            return x + length + gap + painter_.fonts().measure(words, style.size).width;
        };
        const double end = write(left, of_elements().stroke, tr("elements"));
        if (picture_.warning) { // which took the room
            write(end + 2.0 * gap, of_theory(), tr("beam theory"));
            return;
        }
        y += 1.4 * style.size;
        write(left, of_theory(), tr("beam theory"));
        y += 1.4 * style.size;
        painter_.text({left + length + gap, y}, "N/A − My/I,  VQ/(It)", style);
    }

    void draw_plot(const ui::Box& box, const std::string& name, double fp::CutStation::*of_elements_at,
                   double fp::CutTheory::Station::*of_theory_at)
    {
        CutValues elements, theory;
        for (const fp::CutStation& station : picture_.stations)
            elements.push_back({station.s, station.*of_elements_at});
        for (const auto& station : picture_.theory.stations) theory.push_back({station.s, station.*of_theory_at});
        // a sheet's shear may be rounding alone beside its other stress
        double largest = 0.0;
        for (const fp::CutStation& s : picture_.stations)
            largest = std::max({largest, std::abs(s.sx), std::abs(s.txy)});
        for (auto* values : {&elements, &theory})
            for (CutValue& v : *values) v.value = rounded(v.value, largest);
        const ui::DisplayUnit unit = units_.unit(ui::Measure::Stress);
        painter_.text({box.center().x, box.min.y - 1.6 * theme_.type().small}, name + " [" + unit.name + "]",
                      small_words(theme_, Role::Label, ui::Anchor::Top));
        StressPlot plot(painter_, theme_, box);
        plot.fit(elements, theory);
        const std::size_t n_pieces = elements.size() / stations_of_piece;
        plot.draw_area(elements, stations_of_piece, of_elements());
        plot.draw_line(theory, theory.size() / n_pieces, of_theory());
        plot.draw_axis();
        const double step = 1e-9 * largest; // of two that differ by rounding always the same one is written
        const auto [low, high] = std::ranges::minmax(
            elements, {}, [step](const CutValue& v) { return step > 0.0 ? std::round(v.value / step) : v.value; });
        const auto number = [&](double v) { return ui::with_minus_signs(units_.number(v, ui::Measure::Stress)); };
        plot.write(high, number(high.value));
        if (low.value < high.value) plot.write(low, number(low.value));
    }

    ui::Painter& painter_;
    const CutPicture& picture_;
    const PlateOptions& options_;
    const ui::DisplayUnits& units_;
    ui::Theme theme_;
    ui::Box box_;
};

} // namespace

CutPicture cut_picture(const fp::PlaneResults& results, const fp::PlaneCase& result, const fp::Cut& cut)
{
    if (results.model().analysis == femoop::StressState::Axisymmetric)
        return {.cut = cut, .hindrance = translatable("a body of revolution has no N, V and M on a cut")};
    CutPicture picture{.cut = cut, .stations = result.stations(cut)};
    if (picture.stations.empty()) {
        picture.hindrance = translatable("the cut meets no material");
        return picture;
    }
    picture.forces = result.forces(cut);
    const auto n_pieces = static_cast<int>(picture.stations.size() / stations_of_piece);
    picture.theory = fp::beam_theory(results, result, cut, std::max(9, 64 / n_pieces)); // a parabola looks like one
    picture.warning = fp::cut_warning(results, result, cut);
    return picture;
}

void draw_cut(const PlateScene& scene, const fp::Cut& cut, std::size_t n)
{
    const Point start = scene.place(cut.start), end = scene.place(cut.end);
    ui::Stroke stroke = scene.sketch.stroke(Role::Selection);
    stroke.width = scene.sketch.px(2.0);
    stroke.dash = ui::DashPattern{12.0, 3.0, 3.0, 3.0}.scaled(scene.sketch.theme().symbol_scale());
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    scene.sketch.line(start, end, stroke);
    scene.sketch.disc(start, scene.sketch.px(3.5), stroke.color);
    scene.sketch.caption({.text = std::to_string(n),
                          .target = end,
                          .toward = end - start,
                          .rank = drawing::Rank::Extreme,
                          .weight = ui::Weight::Bold});
}

void draw_cut_panel(ui::Painter& painter, const CutPicture& picture, std::size_t n, const PlateOptions& options,
                    const ui::DisplayUnits& units, const ui::Box& box)
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    CutPanel(painter, picture, options, units, box).draw(n);
}

double cut_panel_height(const ui::Theme& theme) { return panel_height * theme.symbol_scale(); }

double cut_panel_width(const ui::Theme& theme) { return narrowest_panel * theme.symbol_scale(); }

std::size_t most_cuts(const ui::Theme& theme, double width)
{
    return static_cast<std::size_t>(std::max(1.0, std::floor(width / (narrowest_panel * theme.symbol_scale()))));
}

} // namespace plane
