#include "apps/drawing/sketch/sketch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/text/shortened.h"

namespace drawing {

namespace {

constexpr double same_place = 14.0;      // [px] within which one string stands for two
constexpr double crowded_reach = 20.0;   // [px]: farther off nobody could tell which of many parts is meant
constexpr double near_reach = 14.0;      // [px]: without a leader
constexpr double long_label = 13.0;      // of its height: with a name behind its number
constexpr std::size_t most_letters = 60; // of a caption: longer names would push the structure off the sheet

/// Middle of a box whose border lies `gap` from the target, seen along `toward`.
ui::Point center_beside(ui::Point target, ui::Point toward, double gap, ui::Size size)
{
    const ui::Point d = ui::direction(toward);
    // The box touches the target's gap with its nearest side or corner.
    const double half = std::abs(d.x) * 0.5 * size.width + std::abs(d.y) * 0.5 * size.height;
    const ui::Point center = target + (gap + half) * d;
    if (size.width < long_label * size.height || std::abs(d.y) < 0.5) return center;
    // A long one would float far above what it speaks of: it slides along there instead.
    return target + ui::Point{0.5 * size.width * d.x, std::copysign(gap + 0.5 * size.height, d.y)};
}

ui::Point turned(ui::Point d, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * d.x + s * d.y, -s * d.x + c * d.y};
}

} // namespace

Sketch::Sketch(const Setup& setup)
    : painter_(setup.painter),
      theme_(setup.theme),
      symbol_scale_(setup.theme->symbol_scale() * setup.symbol_factor),
      room_(setup.room),
      is_crowded_(setup.is_reduced),
      is_measured_(setup.is_measured),
      placer_({.room = setup.room})
{
    if (is_crowded_ && !is_measured_) crowd_.emplace(room_);
}

double Sketch::lesser_value_size() const
{
    const bool is_read_from_afar = theme_->name() == ui::ThemeName::Projector;
    return is_read_from_afar ? theme_->type().normal : theme_->type().small;
}

ui::Stroke Sketch::stroke(ui::Role role) const
{
    ui::Stroke stroke = theme_->stroke(role);
    if (!is_crowded_) return stroke;
    stroke.width *= 0.75;
    stroke.cap = ui::Cap::Butt;
    stroke.join = ui::Join::Miter;
    return stroke;
}

ui::Stroke Sketch::thin(ui::Role role) const
{
    ui::Stroke stroke = this->stroke(role);
    stroke.width *= 0.7;
    stroke.dash = {};
    return stroke;
}

ui::Firmness Sketch::firmness(Clearance clearance)
{
    return clearance == Clearance::Hard ? ui::Firmness::Hard : ui::Firmness::Soft;
}

void Sketch::include(ui::Point point)
{
    if (!ui::is_finite(point)) return;
    for (auto* const bounds : {&bounds_, &tight_bounds_, &mark_bounds_}) unite(*bounds, {point, point});
}

void Sketch::unite(std::optional<ui::Box>& bounds, const ui::Box& box)
{
    bounds = bounds ? ui::united(*bounds, box) : box;
}

void Sketch::line(ui::Point a, ui::Point b, const ui::Stroke& stroke, Clearance clearance)
{
    painter_->line(a, b, stroke);
    include(a);
    include(b);
    if (is_obstacle(clearance)) placer_.obstacles().add_segment(a, b, stroke.width, firmness(clearance));
}

void Sketch::polyline(const std::vector<ui::Point>& points, const ui::Stroke& stroke, Clearance clearance,
                      ui::PathEnds ends)
{
    if (points.size() < 2) return;
    painter_->polyline(points, stroke, ends);
    for (const ui::Point p : points) include(p);
    if (is_obstacle(clearance)) placer_.obstacles().add_polyline(points, stroke.width, firmness(clearance));
}

void Sketch::polygon(const std::vector<ui::Point>& points, ui::Color fill, Clearance clearance)
{
    if (points.size() < 3) return;
    painter_->polygon(points, fill);
    for (const ui::Point p : points) include(p);
    if (!is_obstacle(clearance)) return;
    if (clearance == Clearance::Inside) placer_.obstacles().add_inside(points, ui::Firmness::Soft);
    else placer_.obstacles().add_polygon(points, firmness(clearance));
}

void Sketch::disc(ui::Point center, double radius, ui::Color fill, Clearance clearance)
{
    painter_->disc(center, radius, fill);
    include(center);
    if (is_obstacle(clearance)) placer_.obstacles().add_disc(center, radius, firmness(clearance));
}

void Sketch::ring(ui::Point center, double radius, const ui::Stroke& stroke, Clearance clearance)
{
    painter_->circle(center, radius, stroke);
    include(center - ui::Point{radius, radius});
    include(center + ui::Point{radius, radius});
    if (is_obstacle(clearance)) placer_.obstacles().add_disc(center, radius, firmness(clearance));
}

void Sketch::keep_clear(const std::vector<ui::Point>& area)
{
    for (const ui::Point p : area) include(p);
    if (is_obstacle(Clearance::Hard)) placer_.obstacles().add_polygon(area);
}

bool Sketch::is_free(const ui::Box& box)
{
    return placer_.obstacles().ground_of({box.center(), box.size()}) == ui::Ground::Free;
}

void Sketch::shade(const std::vector<ui::Point>& area)
{
    if (!is_measured_ && area.size() > 2) placer_.obstacles().add_inside(area, ui::Firmness::Soft);
}

ui::TextStyle Sketch::style_of(const Caption& caption) const
{
    ui::TextStyle style = theme_->text(caption.role);
    if (caption.size > 0.0) style.size = caption.size;
    style.weight = caption.weight;
    return style;
}

bool Sketch::is_said_beside(const Caption& caption)
{
    std::vector<Said>& said_at = said_[caption.text];
    const auto is_near = [&](const Said& other) {
        const ui::Point apart = other.second - caption.target;
        return other.first == caption.role && dot(apart, apart) < same_place * same_place;
    };
    if (std::any_of(said_at.begin(), said_at.end(), is_near)) return true;
    said_at.emplace_back(caption.role, caption.target);
    return false;
}

void Sketch::caption(Caption caption)
{
    if (caption.text.empty() || !ui::is_finite(caption.target)) return;
    if (is_full_at(caption.target, caption.rank)) return leave_out(caption.target);
    caption.text = ui::shortened(caption.text, most_letters);
    if (is_said_beside(caption)) return;
    if (crowd_) crowd_->add(caption.target, caption.rank);
    const ui::TextStyle style = style_of(caption);
    const ui::Size size = ui::label_size(painter_->fonts(), caption.text, style);
    const ui::Point center = center_beside(caption.target, caption.toward, caption.gap, size);
    const ui::Point half = 0.5 * ui::Point{size.width, size.height};
    unite(bounds_, {center - half, center + half});
    unite(tight_bounds_, {{caption.target.x, center.y - half.y}, {caption.target.x, center.y + half.y}});
    requests_.push_back({std::move(caption), style, size});
}

std::size_t Sketch::mark(LoadMark mark)
{
    grips_.loads.push_back(std::move(mark));
    return grips_.loads.size() - 1;
}

void Sketch::mark_value(std::size_t load_mark, const ui::Box& box)
{
    LoadMark value = grips_.loads[load_mark];
    value.area = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    grips_.loads.push_back(std::move(value));
}

void Sketch::mark_number(const Request& request, const ui::PlacedLabel& place)
{
    if (!request.caption.number) return;
    const double c = std::abs(std::cos(place.rotation)), s = std::abs(std::sin(place.rotation));
    const auto [width, height] = request.size;
    const ui::Point half = 0.5 * ui::Point{c * width + s * height, s * width + c * height};
    mark(NumberMark{{place.center - half, place.center + half}, *request.caption.number, request.caption.end});
}

void Sketch::sign(SignMark mark)
{
    if (std::all_of(mark.places.begin(), mark.places.end(), ui::is_finite)) signs_.push_back(std::move(mark));
}

std::vector<Sketch::PlacedSign> Sketch::placed_signs()
{
    std::vector<PlacedSign> placed;
    for (SignMark& mark : signs_) {
        const double side = 2.0 * mark.radius + 2.0;
        const auto is_free = [&](ui::Point p) {
            return placer_.obstacles().ground_of({p, {side, side}}) != ui::Ground::Taken;
        };
        const auto free = std::find_if(mark.places.begin(), mark.places.end(), is_free);
        const ui::Point center = free == mark.places.end() ? mark.places.front() : *free;
        placer_.obstacles().add_disc(center, mark.radius);
        placed.push_back({std::move(mark), center});
    }
    signs_.clear();
    return placed;
}

void Sketch::draw(const PlacedSign& sign)
{
    const auto& [mark, center] = sign;
    const ui::Stroke stroke = thin(mark.role);
    painter_->disc(center, mark.radius, theme_->background());
    painter_->circle(center, mark.radius, stroke);
    const double d = 0.55 * mark.radius;
    painter_->line(center - ui::Point{d, 0.0}, center + ui::Point{d, 0.0}, stroke);
    if (mark.is_positive) painter_->line(center - ui::Point{0.0, d}, center + ui::Point{0.0, d}, stroke);
}

ui::Label Sketch::label_of(const Request& request) const
{
    constexpr double pi = std::numbers::pi;
    const Caption& caption = request.caption;
    ui::Label label{.target = caption.target, .size = request.size};
    label.priority = static_cast<double>(caption.rank);
    label.reach = is_crowded_ ? std::min(caption.reach, crowded_reach) : caption.reach;
    if (caption.is_repeat) label.reach = std::min(label.reach, near_reach);
    label.clearance = caption.gap;
    label.side = caption.side;
    label.others = caption.others;
    const bool is_of_arrow = caption.rank == Rank::Largest && caption.of;
    // Beyond a member it reads as the load of that one, beside an arrow that goes the same way as the force of that.
    label.needs_sight = caption.role == ui::Role::Load || is_of_arrow;
    const auto wish = [&](ui::Point target, double angle, double gap) {
        label.wishes.push_back(center_beside(target, turned(caption.toward, angle), gap, request.size));
    };
    wish(caption.target, 0.0, caption.gap);
    for (const ui::Point other : caption.others) wish(other, 0.0, caption.gap);
    for (const double angle : {pi / 5, -pi / 5, pi / 3, -pi / 3}) wish(caption.target, angle, caption.gap);
    wish(caption.target, 0.0, caption.gap + 8.0);
    for (const double angle : {pi / 2, -pi / 2, pi, 3 * pi / 4, -3 * pi / 4}) wish(caption.target, angle, caption.gap);
    for (const ui::Point other : caption.others) wish(other, pi, caption.gap);
    add_turned(label, caption);
    return label;
}

void Sketch::add_turned(ui::Label& label, const Caption& caption)
{
    if (caption.along == ui::Point{}) return;
    const ui::Point along = (caption.along.x < 0.0 ? -1.0 : 1.0) * ui::direction(caption.along);
    if (std::abs(along.y) < 0.05) return; // level already
    label.turn = std::atan2(-along.y, along.x);
    std::vector<ui::Point> targets{caption.target};
    targets.insert(targets.end(), caption.others.begin(), caption.others.end());
    label.turned.reserve(2 * targets.size());
    const ui::Point away = (caption.gap + 0.5 * label.size.height) * ui::left_normal(along);
    for (const ui::Point target : targets) label.turned.push_back(target + away);
    for (const ui::Point target : targets) label.turned.push_back(target - away);
}

bool Sketch::is_in_sight(const Caption& caption) const
{
    const auto is_seen = [&](ui::Point target) { return is_in_sight(target); };
    return is_seen(caption.of.value_or(caption.target)) ||
           std::any_of(caption.others.begin(), caption.others.end(), is_seen);
}

void Sketch::write(const Request& request, const ui::PlacedLabel& place)
{
    ui::TextStyle style = request.style;
    if (place.is_over_soft) style.plate = ui::with_opacity(theme_->background(), 0.8);
    ui::draw_label(*painter_, place, request.caption.text, style);
    mark_number(request, place);
    const ui::Point half = 0.5 * ui::Point{request.size.width, request.size.height};
    if (request.caption.load_mark && place.rotation == 0.0)
        mark_value(*request.caption.load_mark, {place.center - half, place.center + half});
}

// Those that find no room look farther off.
ui::LabelPlacement Sketch::placed_captions() const
{
    constexpr double farther = 1.5;
    std::vector<ui::Label> labels;
    labels.reserve(requests_.size());
    for (const Request& request : requests_) labels.push_back(label_of(request));
    ui::LabelPlacement near = placer_.place(labels);
    if (is_crowded_ || near.n_left_out == 0) return near;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (const Caption& caption = requests_[i].caption; !near.labels[i] && !caption.is_repeat)
            labels[i].reach = farther * caption.reach;
    ui::LabelPlacement far = placer_.place(labels);
    return loss(far) < loss(near) ? far : near;
}

void Sketch::write_names_small()
{
    for (Request& request : requests_) {
        if (request.caption.rank != Rank::Name) continue;
        request.style.size = theme_->type().small;
        request.size = ui::label_size(painter_->fonts(), request.caption.text, request.style);
    }
}

Sketch::Loss Sketch::loss(const ui::LabelPlacement& placed) const
{
    Loss loss;
    for (std::size_t i = 0; i < requests_.size(); ++i) {
        const Caption& caption = requests_[i].caption;
        if (placed.labels[i] || caption.is_repeat) continue;
        ++loss.n_captions;
        if (caption.rank != Rank::Name) ++loss.n_values;
    }
    return loss;
}

// Where there is no room for all, names are the first to be written smaller; in a crowd that helps nobody.
ui::LabelPlacement Sketch::placed_at_best()
{
    ui::LabelPlacement placed = placed_captions();
    if (is_crowded_ || loss(placed).n_captions == 0) return placed;
    std::vector<Request> before = requests_;
    write_names_small();
    ui::LabelPlacement small = placed_captions();
    if (loss(small) < loss(placed)) return small;
    requests_ = std::move(before);
    return placed;
}

void Sketch::write_captions()
{
    const std::vector<PlacedSign> signs = placed_signs();
    std::erase_if(requests_, [&](const Request& request) { return !is_in_sight(request.caption); });
    const ui::LabelPlacement placed = placed_at_best();
    n_left_out_ += loss(placed).n_captions;
    const ui::LayerScope layer(*painter_, ui::Layer::Labels);
    for (const auto& place : placed.labels)
        if (place && place->leader)
            painter_->line(place->leader->from, place->leader->to, theme_->stroke(ui::Role::Leader));
    for (const PlacedSign& sign : signs) draw(sign);
    for (std::size_t i = 0; i < requests_.size(); ++i)
        if (placed.labels[i]) write(requests_[i], *placed.labels[i]);
    requests_.clear();
    said_.clear();
}

} // namespace drawing
