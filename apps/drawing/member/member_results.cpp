#include "apps/drawing/member/member_results.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "apps/drawing/member/expression_lines.h"
#include "apps/drawing/results/case_numbers.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/sketch/sketch.h"
#include "femoop/result/components.h"

namespace drawing {

namespace {

using femoop::Curve;
using femoop::MemberComponent;
using ui::Measure;
using ui::Role;

constexpr int n_steps = 48; // of a curve between two load points
constexpr double least_row = 46.0;
constexpr double line_step = 1.3;            // of formulas, in ems
constexpr double least_formula_share = 0.62; // of the normal size, for the smallest formulas

/// Where things are on the sheet.
struct Columns {
    double scale = 1.0;
    double top = 0.0, bottom = 0.0; ///< of the rows
    double left = 0.0, right = 0.0; ///< of the axis
    double formulas = 0.0;          ///< where they begin
    double length = 1.0;            ///< of the member

    double x(double along) const { return left + (right - left) * along / length; }
};

Columns columns_of(const MemberResultsSubject& subject, ui::Size sheet)
{
    const double scale = ui::Theme(subject.options.theme).symbol_scale();
    Columns columns{.scale = scale};
    columns.top = 24.0 * scale;
    columns.bottom = sheet.height - 22.0 * scale;
    columns.left = 165.0 * scale;
    columns.formulas = sheet.width - std::min(430.0 * scale, 0.42 * sheet.width);
    columns.right = columns.formulas - 72.0 * scale;
    columns.length = subject.results.geometry(subject.member).length;
    return columns;
}

double largest(const femoop::Extremes& extremes)
{
    return std::max(std::abs(extremes.max.value), std::abs(extremes.min.value));
}

/// The components that are shown: bars of a truss carry no V and M unless they are loaded between their ends.
std::vector<MemberComponent> shown_components(const MemberResultsSubject& subject)
{
    const femoop::AnalysisKind kind = subject.model.analysis;
    std::vector<MemberComponent> all = femoop::section_force_components(kind);
    for (const MemberComponent component : femoop::local_displacement_components(kind))
        if (component != MemberComponent::u) all.push_back(component);
    if (!femoop::is_truss(kind)) return all;
    const Curve curve = subject.results[subject.options.load_case].curve(subject.member);
    const double force = largest(curve.extremes(MemberComponent::N));
    std::erase_if(all, [&](MemberComponent component) {
        const bool is_transverse = component != MemberComponent::N && !femoop::is_displacement(component);
        return is_transverse && largest(curve.extremes(component)) <= 1e-9 * force * curve.length();
    });
    return all;
}

Role role(MemberComponent component)
{
    return femoop::is_displacement(component) ? Role::Deformed : role_of(component);
}

/// Draws the picture.
class Drawing {
public:
    Drawing(ui::Painter& painter, const MemberResultsSubject& subject)
        : painter_(painter),
          subject_(subject),
          theme_(subject.options.theme),
          units_(display_units(subject.model, subject.options)),
          result_(subject.results[subject.options.load_case]),
          curve_(result_.curve(subject.member)),
          numbers_(result_, units_),
          columns_(columns_of(subject, painter.size()))
    {}

    void draw()
    {
        const std::vector<MemberComponent> components = shown_components(subject_);
        const double height = (columns_.bottom - columns_.top) / static_cast<double>(components.size());
        write_title();
        draw_axis();
        if (subject_.cursor) draw_cursor(*subject_.cursor);
        for (std::size_t i = 0; i < components.size(); ++i) {
            const double top = columns_.top + height * static_cast<double>(i);
            draw_row(components[i], {{0.0, top}, {painter_.size().width, top + height}});
        }
    }

private:
    /// One diagram: a height for each value.
    struct Row {
        MemberComponent component;
        ui::Box box;
        double zero = 0.0;  ///< height of the axis
        double scale = 0.0; ///< pixels for one unit, negative where positive values hang below
        bool is_zero = false;

        double y(double value) const { return zero - scale * value; }
    };

    double px(double logical) const { return logical * columns_.scale; }

    ui::TextStyle style(Role role, ui::Anchor anchor, ui::Weight weight = ui::Weight::Regular) const
    {
        ui::TextStyle style = theme_.text(role, anchor);
        style.weight = weight;
        return style;
    }

    bool hangs(MemberComponent component) const
    {
        const bool is_bending = component == MemberComponent::Mz || component == MemberComponent::My;
        return is_bending && subject_.options.moment_side == MomentSide::Tension;
    }

    std::string number(double value, MemberComponent component) const
    {
        return numbers_.number(value, measure_of(component));
    }

    Row row_of(MemberComponent component, const ui::Box& box) const
    {
        const femoop::Extremes extremes = curve_.extremes(component);
        Row row{component, box};
        row.is_zero = number(extremes.max.value, component) == "0" && number(extremes.min.value, component) == "0";
        double high = std::max(0.0, extremes.max.value), low = std::min(0.0, extremes.min.value);
        const double sign = hangs(component) ? -1.0 : 1.0;
        if (sign < 0.0) std::tie(high, low) = std::pair(-low, -high);
        const double pad = px(8.0);
        const double room = box.height() - 2.0 * pad;
        if (row.is_zero || !(high - low > 0.0)) {
            row.zero = box.center().y;
            return row;
        }
        row.scale = sign * room / (high - low);
        row.zero = box.min.y + pad + room * high / (high - low);
        return row;
    }

    void write_title()
    {
        const ui::Catalogue& tr = subject_.options.tr;
        const std::string name = tr("Member {id}", {{"id", subject_.model[subject_.member].id}});
        const std::string of = tr("Case {case}", {{"case", result_.name()}});
        const ui::Point at{px(10.0), px(12.0)};
        const ui::TextStyle bold = style(Role::Label, ui::Anchor::Left, ui::Weight::Bold);
        painter_.text(at, name, bold);
        const double width = painter_.measure(name, bold).width;
        painter_.text({at.x + width + px(10.0), at.y}, of, style(Role::FaintLabel, ui::Anchor::Left));
    }

    // Where the loads change, a fine line runs through all diagrams.
    void draw_axis()
    {
        const double y = columns_.bottom + px(4.0);
        painter_.line({columns_.left, y}, {columns_.right, y}, theme_.stroke(Role::Dimension));
        double free_from = -1e9;
        const std::vector<double> breaks = curve_.breaks();
        for (std::size_t i = 0; i < breaks.size(); ++i) {
            const double x = columns_.x(breaks[i]);
            painter_.line({x, y - px(3.0)}, {x, y + px(3.0)}, theme_.stroke(Role::Dimension));
            const ui::LayerScope layer(painter_, ui::Layer::Grid);
            painter_.line({x, columns_.top}, {x, y}, theme_.stroke(Role::Grid));
            const bool is_last = i + 1 == breaks.size();
            const std::string text = is_last ? numbers_.text(breaks[i], Measure::Length)
                                             : numbers_.number(breaks[i], Measure::Length);
            const ui::TextStyle look = style(Role::Label, ui::Anchor::Top);
            const double half = 0.5 * painter_.measure(text, look).width;
            const double last = columns_.x(columns_.length) -
                                painter_.measure(numbers_.text(columns_.length, Measure::Length), look).width;
            if (x - half < free_from || (!is_last && x + half > last - px(4.0))) continue;
            free_from = x + half + px(4.0);
            painter_.text({x, y + px(4.0)}, text, look);
        }
    }

    void draw_cursor(double at)
    {
        const double x = columns_.x(at);
        const ui::Stroke thin{.color = theme_.stroke(Role::Selection).color, .width = px(1.2)};
        painter_.line({x, columns_.top - px(4.0)}, {x, columns_.bottom + px(4.0)}, thin);
        painter_.text({x, px(12.0)}, "x = " + numbers_.text(at, Measure::Length),
                      style(Role::Label, ui::Anchor::Center, ui::Weight::Bold));
    }

    void draw_row(MemberComponent component, const ui::Box& box)
    {
        const Row row = row_of(component, box);
        Sketch sketch({.painter = &painter_,
                       .theme = &theme_,
                       .room = {{columns_.left, box.min.y}, {columns_.right, box.max.y}}});
        if (!row.is_zero) draw_curve(sketch, row);
        sketch.line({columns_.left, row.zero}, {columns_.right, row.zero}, sketch.thin(Role::Member));
        if (!row.is_zero) mark_extremes(sketch, row);
        if (!row.is_zero) write_ends(row);
        sketch.write_captions();
        write_name(row);
        write_formulas(row);
    }

    std::vector<ui::Point> points(const Row& row) const
    {
        std::vector<ui::Point> points;
        const std::vector<double> breaks = curve_.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            for (int k = 0; k <= n_steps; ++k) {
                const double x = breaks[i] + (breaks[i + 1] - breaks[i]) * k / n_steps;
                const femoop::Side side = k == n_steps ? femoop::Side::Before : femoop::Side::After;
                points.push_back({columns_.x(x), row.y(curve_.value(row.component, x, side))});
            }
        }
        return points;
    }

    void draw_curve(Sketch& sketch, const Row& row)
    {
        std::vector<ui::Point> outline = points(row);
        outline.insert(outline.begin(), {columns_.left, row.zero});
        outline.push_back({columns_.right, row.zero});
        {
            const ui::LayerScope layer(painter_, ui::Layer::Areas);
            painter_.polygon(outline, theme_.fill(role(row.component)));
        }
        ui::Stroke stroke = theme_.stroke(role(row.component));
        stroke.dash = {};
        sketch.polyline(outline, stroke);
    }

    // Those inside that can be told from the axis.
    void mark_extremes(Sketch& sketch, const Row& row) const
    {
        const femoop::Extremes extremes = curve_.extremes(row.component);
        const double L = columns_.length;
        for (const femoop::Extreme& extreme : {extremes.max, extremes.min}) {
            const bool is_inside = extreme.x > 1e-9 * L && extreme.x < (1.0 - 1e-9) * L;
            const bool is_seen = std::abs(extreme.value) > 0.01 * largest(extremes);
            if (is_inside && is_seen) mark(sketch, row, extreme);
        }
    }

    void mark(Sketch& sketch, const Row& row, const femoop::Extreme& extreme) const
    {
        const ui::Point at{columns_.x(extreme.x), row.y(extreme.value)};
        sketch.disc(at, px(2.5), theme_.stroke(role(row.component)).color);
        sketch.caption({.text = number(extreme.value, row.component),
                        .role = role(row.component),
                        .target = at,
                        .toward = {0.0, at.y <= row.zero ? -1.0 : 1.0},
                        .rank = Rank::Extreme,
                        .reach = 60.0});
    }

    // Beside the diagram, where nothing else stands.
    void write_ends(const Row& row)
    {
        const double start = curve_.value(row.component, 0.0);
        const double end = curve_.value(row.component, columns_.length, femoop::Side::Before);
        const auto height = [&](double value) {
            const double half = 0.6 * theme_.type().normal;
            return std::clamp(row.y(value), row.box.min.y + half, row.box.max.y - half);
        };
        painter_.text({columns_.left - px(6.0), height(start)}, number(start, row.component),
                      style(role(row.component), ui::Anchor::Right));
        painter_.text({columns_.right + px(6.0), height(end)}, number(end, row.component),
                      style(role(row.component), ui::Anchor::Left));
    }

    void write_name(const Row& row)
    {
        const std::string symbol(femoop::name(row.component, subject_.model.analysis));
        const double line = 1.35 * theme_.type().normal;
        const bool has_two = subject_.cursor.has_value();
        const double y = row.box.center().y - (has_two ? 0.5 * line : 0.0);
        painter_.text({px(10.0), y}, units_.label(symbol, measure_of(row.component)),
                      style(role(row.component), ui::Anchor::Left));
        if (!has_two) return;
        const double value = curve_.value(row.component, *subject_.cursor);
        painter_.text({px(10.0), y + line}, number(value, row.component),
                      style(Role::Label, ui::Anchor::Left, ui::Weight::Bold));
        if (!row.is_zero)
            painter_.disc({columns_.x(*subject_.cursor), row.y(value)}, px(3.0), theme_.stroke(Role::Selection).color);
    }

    // Those that find room, smaller where they are many or long; with a cursor, that of its stretch among them.
    void write_formulas(const Row& row)
    {
        const double least = row.is_zero ? largest(curve_.extremes(row.component)) : least_that_counts(row.component);
        const std::vector<ExpressionLine> lines = expression_lines(curve_, row.component, units_, least);
        const double least_step = least_formula_share * line_step * theme_.type().normal;
        const auto n_fit = static_cast<std::size_t>(std::max(1.0, std::floor(row.box.height() / least_step)));
        const std::size_t n = std::min(lines.size(), n_fit);
        std::size_t first = 0;
        while (subject_.cursor && first + n < lines.size() && lines[first + n - 1].to <= *subject_.cursor) ++first;
        std::vector<std::string> texts;
        for (std::size_t i = first; i < first + n; ++i) texts.push_back(formula_text(row, lines[i]));
        if (first + n < lines.size()) texts.back() += "  …";
        const double size = formula_size(row, texts);
        const double step = line_step * size;
        const double top = row.box.center().y - 0.5 * step * static_cast<double>(n - 1);
        const ui::ClipScope clip(painter_, {{columns_.formulas, row.box.min.y}, row.box.max});
        for (std::size_t i = 0; i < n; ++i) {
            ui::TextStyle look = style(row.is_zero ? Role::FaintLabel : Role::Label, ui::Anchor::Left);
            if (lines.size() > 1 && is_under_cursor(lines[first + i])) look.weight = ui::Weight::Bold;
            look.size = size;
            painter_.text({columns_.formulas, top + step * static_cast<double>(i)}, texts[i], look);
        }
    }

    // At which all of them fit into their place; bold letters are the wider ones.
    double formula_size(const Row& row, const std::vector<std::string>& texts) const
    {
        const double normal = theme_.type().normal;
        double size = std::min(normal, row.box.height() / (line_step * static_cast<double>(texts.size())));
        const double room = painter_.size().width - columns_.formulas - px(6.0);
        const ui::TextStyle widest = style(Role::Label, ui::Anchor::Left, ui::Weight::Bold);
        for (const std::string& text : texts)
            size = std::min(size, normal * room / painter_.measure(text, widest).width);
        return std::max(size, 0.8 * least_formula_share * normal);
    }

    double least_that_counts(MemberComponent component) const { return 1e-9 * largest(curve_.extremes(component)); }

    bool is_under_cursor(const ExpressionLine& line) const
    {
        return subject_.cursor && *subject_.cursor >= line.from && *subject_.cursor <= line.to;
    }

    std::string formula_text(const Row& row, const ExpressionLine& line) const
    {
        const std::string symbol(femoop::name(row.component, subject_.model.analysis));
        const std::string formula = symbol + "(x) = " + line.formula;
        const bool is_whole = line.from <= 0.0 && line.to >= columns_.length * (1.0 - 1e-12);
        if (is_whole) return formula;
        const auto place = [&](double x) { return numbers_.number(x, Measure::Length); };
        return place(line.from) + " … " + place(line.to) + ":  " + formula;
    }

    ui::Painter& painter_;
    const MemberResultsSubject& subject_;
    ui::Theme theme_;
    ui::DisplayUnits units_;
    femoop::CaseResult result_;
    Curve curve_;
    CaseNumbers numbers_;
    Columns columns_;
};

} // namespace

void draw_member_results(ui::Painter& painter, const MemberResultsSubject& subject)
{
    Drawing(painter, subject).draw();
}

std::optional<double> section_at(const MemberResultsSubject& subject, ui::Size sheet, ui::Point place)
{
    const Columns columns = columns_of(subject, sheet);
    if (place.x < columns.left - 20.0 || place.x > columns.right + 20.0) return std::nullopt;
    const double share = std::clamp((place.x - columns.left) / (columns.right - columns.left), 0.0, 1.0);
    return share * columns.length;
}

double pixels_per_length(const MemberResultsSubject& subject, ui::Size sheet)
{
    const Columns columns = columns_of(subject, sheet);
    return (columns.right - columns.left) / columns.length;
}

double least_height(const MemberResultsSubject& subject)
{
    const double scale = ui::Theme(subject.options.theme).symbol_scale();
    return scale * (least_row * static_cast<double>(shown_components(subject).size()) + 46.0);
}

} // namespace drawing
