#include "apps/drawing/results/line_diagram.h"

#include "apps/drawing/results/marked_values.h"
#include "apps/drawing/results/ordinates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drawing {

namespace {

/// Draws the ordinates of one line.
class OrdinatePicture {
public:
    OrdinatePicture(const Scene& scene, const LineFunction& function, const LineDiagram& look)
        : scene_(scene), function_(function), look_(look)
    {}

    void draw() const
    {
        const femoop::Extremes extremes = function_.extremes();
        const double own = std::max(std::abs(extremes.max.value), std::abs(extremes.min.value));
        if (!(own > written_as_zero * look_.largest)) return;
        const std::vector<Ordinate> ordinates = ordinates_of(function_, 0.3 / look_.pixels_per_unit);
        std::vector<ui::Point> line{at(0.0, 0.0)};
        for (const Ordinate& o : ordinates) line.push_back(at(o.x, o.value));
        line.push_back(at(function_.length(), 0.0));
        {
            const ui::LayerScope layer(sketch().painter(), ui::Layer::Areas);
            sketch().polygon(line, sketch().theme().fill(look_.role), Clearance::Inside);
            if (!scene_.detail.is_reduced()) draw_hatching();
        }
        sketch().polyline(line, sketch().stroke(look_.role), Clearance::Hard);
        if (look_.has_signs) draw_signs(ordinates);
        if (scene_.shows(Show::Values)) write_values();
        else if (scene_.shows(Show::StepValues)) write_step_values({});
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point at(double x, double value) const
    {
        return look_.frame(x * scene_.projection.scale(), value * look_.pixels_per_unit);
    }

    void draw_hatching() const
    {
        const double step = sketch().px(8.0) / scene_.projection.scale();
        const int n = std::min(400, static_cast<int>(function_.length() / step));
        ui::Stroke stroke = sketch().thin(look_.role);
        stroke.width *= 0.55;
        stroke.color = ui::with_opacity(stroke.color, 0.55);
        for (int i = 1; i <= n; ++i) {
            const double x = (i - 0.5) * function_.length() / n;
            const double value = function_.value(x);
            if (std::abs(value) * look_.pixels_per_unit > 2.0)
                sketch().line(at(x, 0.0), at(x, value), stroke, Clearance::None);
        }
    }

    // A + or a - in the highest part of every area of one sign.
    void draw_signs(const std::vector<Ordinate>& ordinates) const
    {
        std::size_t begin = 0;
        while (begin < ordinates.size()) {
            const bool is_positive = ordinates[begin].value > 0.0;
            std::size_t end = begin;
            while (end < ordinates.size() && (ordinates[end].value > 0.0) == is_positive) ++end;
            mark_area(ordinates, begin, end);
            begin = end;
        }
    }

    void mark_area(const std::vector<Ordinate>& ordinates, std::size_t begin, std::size_t end) const
    {
        // An end that is zero but for rounding belongs to the area on either side of it.
        const double sign = ordinates[begin].value > 0.0 ? 1.0 : -1.0;
        const std::size_t first = begin > 0 ? begin - 1 : 0, last = std::min(end, ordinates.size() - 1);
        double area = 0.0;
        double moment = 0.0;
        for (std::size_t i = first; i < last; ++i) {
            const auto [a, b] = part_of_sign(sign, ordinates[i], ordinates[i + 1]);
            const double sum = sign * (a.value + b.value), width = b.x - a.x;
            if (!(sum > 0.0)) continue;
            area += 0.5 * sum * width;
            moment += 0.5 * sum * width * (a.x + width * (sign * a.value + 2.0 * sign * b.value) / (3.0 * sum));
        }
        if (area == 0.0) return;
        const double r = sketch().px(6.0);
        std::vector<ui::Point> places = sign_places(moment / area, sign, r, ordinates[first].x, ordinates[last].x);
        if (places.empty()) return;
        sketch().sign({.places = std::move(places), .radius = r, .is_positive = sign > 0.0, .role = look_.role});
    }

    // The straight piece from a to b, cut where it passes through zero.
    static std::pair<Ordinate, Ordinate> part_of_sign(double sign, Ordinate a, Ordinate b)
    {
        if (a.value * b.value >= 0.0) return {a, b};
        const Ordinate zero{a.x + (b.x - a.x) * a.value / (a.value - b.value), 0.0};
        return sign * a.value > 0.0 ? std::pair{a, zero} : std::pair{zero, b};
    }

    // Where the area is high enough for a sign of radius r: best about `middle`, else ever farther from it.
    std::vector<ui::Point> sign_places(double middle, double sign, double r, double from, double to) const
    {
        std::vector<ui::Point> places;
        const double step = 1.5 * r / scene_.projection.scale();
        const int n = std::min(24, static_cast<int>((to - from) / step) + 1);
        for (int i = 0; i < 2 * n; ++i) {
            const double x = middle + (i % 2 == 0 ? 0.5 : -0.5) * (i + i % 2) * step;
            if (x < from || x > to) continue;
            const double value = function_.value(x);
            const double height = sign * value * look_.pixels_per_unit;
            if (height < 2.6 * r) {
                if (i == 0) return {};
                continue;
            }
            places.push_back(at(x, 0.5 * value));
            if (height < 5.2 * r) continue;
            places.push_back(at(x, 0.27 * value));
            places.push_back(at(x, 0.73 * value));
        }
        return places;
    }

    void write_values() const
    {
        const std::vector<MarkedValue> marks = marked_values(function_, written_as_zero * look_.largest);
        for (const MarkedValue& marked : marks) {
            // In space small values of one plane would hide the large ones of the other.
            if (!scene_.is_flat() && std::abs(marked.value) < 0.02 * look_.largest) continue;
            const Rank rank = rank_of(marked);
            if (const ui::Point place = at(marked.x, marked.value); sketch().is_full_at(place, rank)) {
                sketch().leave_out(place);
                continue;
            }
            Caption caption = value_at(marked.x, marked.value);
            caption.rank = rank;
            for (const double x : marked.others) caption.others.push_back(at(x, marked.value));
            sketch().caption(std::move(caption));
        }
        if (scene_.shows(Show::StepValues)) write_step_values(marks);
    }

    // The largest value of a diagram is what one looks for first.
    Rank rank_of(const MarkedValue& marked) const
    {
        if (std::abs(marked.value) >= (1.0 - written_as_zero) * look_.largest) return Rank::Largest;
        return marked.is_peak ? Rank::Extreme : Rank::Value;
    }

    // On the line's other side it would be read as a value there.
    Caption value_at(double x, double value) const
    {
        const ui::Point toward = value < 0.0 ? -look_.frame.y : look_.frame.y;
        const ui::Point normal = ui::left_normal(look_.frame.x);
        return {.text = look_.text(value),
                .role = look_.role,
                .target = at(x, value),
                .toward = toward,
                .gap = 4.5,
                .side = ui::HalfPlane{at(x, 0.0), dot(normal, toward) < 0.0 ? -normal : normal},
                .number = look_.number ? std::optional(look_.number(x, value)) : std::nullopt};
    }

    // Where nothing stands yet, and not along a stretch of one value, which is written once.
    void write_step_values(const std::vector<MarkedValue>& marks) const
    {
        const int n = scene_.options.steps;
        const double length = function_.length();
        const auto says = [&](const MarkedValue& mark, double x) {
            const bool is_on_plateau = !mark.others.empty() && x >= mark.others.front() && x <= mark.others.back();
            return is_on_plateau || std::abs(mark.x - x) < 0.25 * length / n;
        };
        for (int i = 1; i < n; ++i) {
            const double x = i * length / n;
            const double value = function_.value(x);
            if (std::abs(value) <= written_as_zero * look_.largest) continue;
            if (std::ranges::any_of(marks, [&](const MarkedValue& mark) { return says(mark, x); })) continue;
            sketch().disc(at(x, value), sketch().px(2.0), sketch().stroke(look_.role).color, Clearance::None);
            Caption caption = value_at(x, value);
            caption.rank = Rank::Minor;
            caption.size = sketch().lesser_value_size();
            caption.reach = 14.0; // farther off it would seem to belong to another step
            sketch().caption(std::move(caption));
        }
    }

    const Scene& scene_;
    const LineFunction& function_;
    const LineDiagram& look_;
};

} // namespace

void draw(const Scene& scene, const LineFunction& function, const LineDiagram& look)
{
    OrdinatePicture(scene, function, look).draw();
}

} // namespace drawing
