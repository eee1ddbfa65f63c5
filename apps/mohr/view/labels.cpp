#include "apps/mohr/view/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace mohr {

namespace {

/// The lines, marks and words of a picture, as labels have to keep clear of them: the grid lies below everything, and a
/// ring about what is under the pointer moves no word.
class Drawing final : public ui::Surface {
public:
    Drawing(ui::LabelObstacles& obstacles, const ui::Fonts& fonts, const ui::Theme& theme)
        : obstacles_(obstacles),
          fonts_(fonts),
          grid_(theme.stroke(ui::Role::Grid)),
          hover_(theme.stroke(ui::Role::Hover))
    {}

    void clip(const ui::Box&) override {}
    void stroke(const ui::Path& path, const ui::Stroke& stroke) override
    {
        if (!counts(stroke)) return;
        obstacles_.add_polyline(path.points, stroke.width, ui::Firmness::Soft);
        if (path.ends == ui::PathEnds::Closed)
            obstacles_.add_segment(path.points.back(), path.points.front(), stroke.width, ui::Firmness::Soft);
    }
    void stroke_arc(const ui::Arc& arc, const ui::Stroke& stroke) override
    {
        if (!counts(stroke)) return;
        const int n = std::max(2, static_cast<int>(std::ceil(std::abs(arc.sweep) / (2.0 * std::numbers::pi) * 96.0)));
        std::vector<ui::Point> points;
        for (int i = 0; i <= n; ++i) points.push_back(arc.at(arc.start + arc.sweep * i / n));
        obstacles_.add_polyline(points, stroke.width, ui::Firmness::Soft);
    }
    void fill(std::span<const ui::Point> polygon, ui::Color) override
    {
        if (is_small(polygon)) obstacles_.add_polygon(polygon, ui::Firmness::Soft); // an arrow's head
    }
    void fill_disc(ui::Point center, double radius, ui::Color) override
    {
        if (radius < most_of_mark) obstacles_.add_disc(center, radius);
    }
    void text(ui::Point at, std::string_view utf8, const ui::TextStyle& style) override
    {
        obstacles_.add_box(ui::text_box(fonts_, at, utf8, style));
    }

private:
    static constexpr double most_of_mark = 24.0; ///< px: what is larger is an area, where words may stand

    bool counts(const ui::Stroke& stroke) const { return stroke != grid_ && stroke != hover_; }
    static bool is_small(std::span<const ui::Point> polygon)
    {
        ui::Box box{polygon.front(), polygon.front()};
        for (const ui::Point p : polygon) box = ui::united(box, {p, p});
        return std::max(box.width(), box.height()) < most_of_mark;
    }

    ui::LabelObstacles& obstacles_;
    const ui::Fonts& fonts_;
    ui::Stroke grid_, hover_;
};

/// Of a box that touches the end of `side` with its nearest side or corner, or lies about the target.
ui::Point middle_of_box(ui::Point target, ui::Point side, ui::Size size)
{
    const auto beyond = [](double part, double half) { return part == 0.0 ? 0.0 : part + std::copysign(half, part); };
    return target + ui::Point{beyond(side.x, 0.5 * size.width), beyond(side.y, 0.5 * size.height)};
}

/// Middle of a box that stands in that direction, its nearest side or corner at the distance where it can.
ui::Point middle_beside(ui::Point target, ui::Point along, ui::Size size)
{
    const double a = 0.5 * size.width, b = 0.5 * size.height, distance = std::max(8.0, 0.8 * b); // marks grow with type
    const ui::Point about{along.x * (a + distance), along.y * (b + distance)}; // on an ellipse: near where it is askew
    const double away = std::hypot(std::max(std::abs(about.x) - a, 0.0), std::max(std::abs(about.y) - b, 0.0));
    return target + about + std::max(0.0, distance - away) * along;
}

void add_wishes_about(const Labels::Place& place, ui::Label& label)
{
    const double start = std::atan2(place.away.y, place.away.x);
    for (const double turn : {0.0, 0.6, -0.6, 1.2, -1.2, 1.9, -1.9, 2.6, -2.6})
        label.wishes.push_back(
            middle_beside(place.target, {std::cos(start + turn), std::sin(start + turn)}, label.size));
}

} // namespace

void Labels::add(ui::Point target, ui::Point away, std::string text, const ui::TextStyle& style, double priority,
                 std::vector<Place> others)
{
    free_.push_back({{target, away}, {std::move(text), style}, priority, std::move(others)});
}

ui::Label Labels::label(const Wish& wish) const
{
    const ui::Size size = ui::label_size(fonts_, wish.words.text, wish.words.style);
    constexpr double reach = 120.0; // px: a far place is better than one on a line
    ui::Label label{.target = wish.place.target, .size = size, .priority = wish.priority, .reach = reach};
    add_wishes_about(wish.place, label);
    for (const Place& other : wish.others) add_wishes_about(other, label);
    return label;
}

Labels::Group Labels::free_group(double largest) const
{
    Group group;
    for (Wish wish : free_) {
        wish.words.style.size = std::min(wish.words.style.size, largest);
        group.labels.push_back(label(wish));
        group.words.push_back(std::move(wish.words));
    }
    return group;
}

bool Labels::has_place_alone(const ui::Label& label) const
{
    return placer_.place(std::span(&label, 1)).n_left_out == 0;
}

// The more important ones choose first, but what one of them leaves may be taken by a less important one.
Labels::Group Labels::with_room(Group group) const
{
    for (;;) {
        const ui::LabelPlacement placed = placer_.place(group.labels);
        double most_homeless = -1.0;
        std::optional<std::size_t> least;
        for (std::size_t i = 0; i < group.labels.size(); ++i) {
            const ui::Label& label = group.labels[i];
            if (placed.labels[i]) {
                if (!least || label.priority <= group.labels[*least].priority) least = i;
            } else if (label.priority > most_homeless && has_place_alone(label)) {
                most_homeless = label.priority;
            }
        }
        if (!least || most_homeless <= group.labels[*least].priority) return group;
        group.labels.erase(group.labels.begin() + static_cast<std::ptrdiff_t>(*least));
        group.words.erase(group.words.begin() + static_cast<std::ptrdiff_t>(*least));
    }
}

std::size_t Labels::n_numbers_placed(const Group& group) const
{
    const ui::LabelPlacement placed = placer_.place(group.labels);
    std::size_t n = 0;
    for (std::size_t i = 0; i < group.labels.size(); ++i)
        if (placed.labels[i] && group.labels[i].priority >= least_number) ++n;
    return n;
}

Labels::Group Labels::free_with_room(double small) const
{
    Group usual = with_room(free_group(std::numeric_limits<double>::max()));
    const std::size_t n_usual = n_numbers_placed(usual);
    const auto n_numbers = std::ranges::count_if(free_, [](const Wish& wish) { return wish.priority >= least_number; });
    if (n_usual == static_cast<std::size_t>(n_numbers)) return usual;
    Group smaller = with_room(free_group(small));
    return n_numbers_placed(smaller) > n_usual ? smaller : usual;
}

void Labels::add_fixed(ui::Point target, const std::vector<ui::Point>& sides, std::string text,
                       const ui::TextStyle& style, double priority)
{
    const ui::Size size = ui::label_size(fonts_, text, style);
    ui::Label label{.target = target, .size = size, .priority = priority, .reach = 0.0};
    for (const ui::Point side : sides) label.wishes.push_back(middle_of_box(target, side, size));
    fixed_.labels.push_back(std::move(label));
    fixed_.words.push_back({std::move(text), style});
}

void Labels::keep_clear_of(const ui::Picture& picture, const ui::Theme& theme)
{
    Drawing drawing(obstacles(), fonts_, theme);
    picture.draw_on(drawing);
}

void Labels::draw(ui::Painter& painter, const ui::Theme& theme)
{
    keep_clear_of(painter.picture(), theme);
    draw(fixed_, painter, theme);
    draw(free_with_room(theme.type().small), painter, theme);
}

void Labels::draw(const Group& group, ui::Painter& painter, const ui::Theme& theme)
{
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    const ui::LabelPlacement placed = placer_.place(group.labels);
    for (std::size_t i = 0; i < group.labels.size(); ++i) {
        const auto& place = placed.labels[i];
        if (!place) continue;
        // Other words beside the title of an axis would read as a part of it.
        const bool is_title = &group == &fixed_ && group.labels[i].priority > 0.0;
        if (place->leader) painter.line(place->leader->from, place->leader->to, theme.stroke(ui::Role::Leader));
        ui::TextStyle style = group.words[i].style;
        if (place->is_over_soft) style.plate = ui::with_opacity(theme.background(), 0.8);
        ui::draw_label(painter, *place, group.words[i].text, style);
        const ui::Box box = ui::OrientedBox(place->center, group.labels[i].size).bounds();
        obstacles().add_box(is_title ? box.grown(0.4 * style.size) : box);
    }
}

} // namespace mohr
