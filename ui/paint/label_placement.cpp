#include "ui/paint/label_placement.h"

#include "ui/paint/label/cells.h"
#include "ui/paint/label/full_cells.h"
#include "ui/paint/label/obstacle_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

namespace ui {

namespace {

constexpr std::size_t n_directions = 16;
constexpr int most_asked = 6;               // labels asked to move aside for one that finds no place
constexpr std::size_t most_effort = 20'000; // places tried in a run, before labels look nearby alone
constexpr double cell_side = 48.0;          // [px] of the grid that labels are looked up in
constexpr double most_cells_a_side = 512.0; // of that grid

/// One place that a label could take.
struct Candidate {
    OrientedBox box;
    std::optional<Leader> leader;
    double rotation = 0.0;
    bool is_over_soft = false;
};

/// Directions of a ring, the most readable ones first: diagonals, then above, below and beside, then the rest.
std::array<Point, n_directions> ring_directions()
{
    constexpr std::array<int, n_directions> order = {2, 6, 14, 10, 4, 12, 0, 8, 1, 7, 15, 9, 3, 5, 13, 11};
    std::array<Point, n_directions> directions;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double angle = 2.0 * std::numbers::pi * order[i] / double{n_directions};
        directions[i] = {std::cos(angle), -std::sin(angle)};
    }
    return directions;
}

/// The places of a label in the order in which it likes them: its wishes, then ring by ring. What lies there is looked
/// up when it is first asked for, and kept.
class Candidates {
public:
    /// \param labels  all of the run, of which it is the one at `own`
    Candidates(std::span<const Label> labels, std::size_t own, const LabelPlacer::Options& options,
               const ObstacleMap& obstacles)
        : labels_(labels),
          label_(&labels[own]),
          options_(&options),
          obstacles_(&obstacles),
          step_(std::max(4.0, 0.7 * label_->size.height))
    {
        const Label& label = *label_;
        const Box bounds = OrientedBox(label.target, label.size, label.rotation).bounds();
        half_ = {0.5 * bounds.width(), 0.5 * bounds.height()};
        if (label.reach >= label.clearance)
            n_rings_ = static_cast<std::size_t>((label.reach - label.clearance) / step_) + 1;
    }

    std::size_t n() const { return n_wishes() + n_rings_ * n_directions; }
    /// How many are near: the wishes and the first ring.
    std::size_t n_near() const { return std::min(n(), n_wishes() + n_directions); }

    /// Taken as well where the box leaves the room.
    Ground ground(std::size_t index)
    {
        while (grounds_.size() <= index) grounds_.push_back(ground_at(grounds_.size()));
        return grounds_[index];
    }

    Candidate operator[](std::size_t index)
    {
        Candidate place{box(index), std::nullopt, rotation(index), ground(index) == Ground::Soft};
        if (index < n_wishes()) return place;
        const double away = distance(place.box.nearest(label_->target), label_->target);
        if (away > options_->leader_after || needs_leader(place.box))
            place.leader = Leader{leader_start(place.box), label_->target};
        return place;
    }

private:
    /// Lest it seem to speak of something else.
    bool needs_leader(const OrientedBox& box)
    {
        if (!label_->needs_sight) return false;
        const auto is_hidden = [&](Point place) { return is_cut_off(box.nearest(place), place); };
        const bool is_behind = is_hidden(label_->target) &&
                               std::all_of(label_->others.begin(), label_->others.end(), is_hidden);
        return is_behind || (label_->others.empty() && is_nearer_to_another(box.center));
    }
    static double distance_of(const Label& label, Point middle)
    {
        double least = distance(label.target, middle);
        for (const Point other : label.others) least = std::min(least, distance(other, middle));
        return least;
    }
    bool is_nearer_to_another(Point middle)
    {
        constexpr double rounding = 1.0; // [px]
        if (!rivals_) find_rivals();
        const double own = distance(label_->target, middle) - rounding;
        return std::any_of(rivals_->begin(), rivals_->end(),
                           [&](const Label* rival) { return distance_of(*rival, middle) < own; });
    }
    /// The other such labels whose targets may be nearer to one of its places.
    void find_rivals()
    {
        const double reach = 2.0 * (label_->reach + length({label_->size.width, label_->size.height}));
        rivals_.emplace();
        for (const Label& rival : labels_)
            if (&rival != label_ && rival.needs_sight && distance_of(rival, label_->target) < reach)
                rivals_->push_back(&rival);
    }
    bool is_cut_off(Point border, Point place) const
    {
        const Point way = place - border;
        const double open = length(way) - label_->clearance;
        if (open <= 1.0) return false;
        const Point middle = border + 0.5 * open * direction(way);
        return obstacles_->ground_of({middle, {open, 1.0}, std::atan2(-way.y, way.x)}) == Ground::Taken;
    }

    std::size_t n_wishes() const { return label_->wishes.size() + label_->turned.size(); }
    double rotation(std::size_t index) const
    {
        const bool is_turned = index >= label_->wishes.size() && index < n_wishes();
        return is_turned ? label_->rotation + label_->turn : label_->rotation;
    }
    OrientedBox box(std::size_t index) const { return {center(index), label_->size, rotation(index)}; }

    // At the middle of the text's height a level line reads as a minus sign, so leaders begin above or below it: on the
    // side of the target, unless they would run nearly level along the text's edge.
    Point leader_start(const OrientedBox& box) const
    {
        constexpr double least_slope = 0.3;
        const Point own = box.to_own(label_->target);
        const double aside = std::max(0.0, std::abs(own.x) - box.half.x);
        const bool is_level = std::abs(own.y) - box.half.y < least_slope * aside;
        const bool is_above = (own.y < 0.0) != is_level;
        const double y = is_above ? -box.half.y : box.half.y;
        return box.from_own({std::clamp(own.x, -box.half.x, box.half.x), y});
    }

    Point center(std::size_t index) const
    {
        static const auto directions = ring_directions();
        const std::size_t n_level = label_->wishes.size();
        if (index < n_level) return label_->wishes[index];
        if (index < n_wishes()) return label_->turned[index - n_level];
        const std::size_t on_rings = index - n_wishes();
        const Point direction = directions[on_rings % n_directions];
        const std::size_t ring = on_rings / n_directions;
        const double away = label_->clearance + step_ * static_cast<double>(ring);
        const double own_reach = std::abs(direction.x) * half_.x + std::abs(direction.y) * half_.y;
        return label_->target + (away + own_reach) * direction;
    }

    Ground ground_at(std::size_t index)
    {
        const OrientedBox place = box(index);
        const bool is_in_room = is_finite(place.center) && options_->room.contains(place.bounds());
        const bool is_on_side = !label_->side || label_->side->contains(place.center);
        if (!is_in_room || !is_on_side || (index < n_wishes() && needs_leader(place))) return Ground::Taken;
        return obstacles_->ground_of(place.grown(options_->gap));
    }

    std::span<const Label> labels_;
    const Label* label_;
    const LabelPlacer::Options* options_;
    const ObstacleMap* obstacles_;
    std::optional<std::vector<const Label*>> rivals_; ///< found when they are first asked for
    double step_;
    Point half_{};
    std::size_t n_rings_ = 0;
    std::vector<Ground> grounds_;
};

/// The labels that have a place, looked up through a grid.
class Placed {
public:
    Placed(std::size_t n_labels, const LabelPlacer::Options& options)
        : places_(n_labels),
          corner_(options.room.min),
          gap_(options.gap),
          n_columns_(n_cells(options.room.width(), cell_side, most_cells_a_side)),
          n_rows_(n_cells(options.room.height(), cell_side, most_cells_a_side)),
          cells_(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_))
    {}

    const std::optional<Candidate>& operator[](std::size_t label) const { return places_[label]; }

    void put(std::size_t label, const Candidate& place)
    {
        places_[label] = place;
        for_each_cell(place, [&](std::vector<std::size_t>& cell) { cell.push_back(label); });
    }

    Candidate take_away(std::size_t label)
    {
        const Candidate place = *places_[label];
        for_each_cell(place, [&](std::vector<std::size_t>& cell) { std::erase(cell, label); });
        places_[label].reset();
        return place;
    }

    /// The labels that a new place would disturb, counted up to two, since nobody asks for more.
    struct Disturbed {
        std::size_t n = 0;
        std::size_t first = 0;
    };
    Disturbed disturbed_by(const Candidate& place) const
    {
        Disturbed found;
        const CellRange range = cells(place);
        for (int y = range.y0; y <= range.y1; ++y) {
            for (int x = range.x0; x <= range.x1; ++x) {
                for (const std::size_t label : cells_[index(x, y)]) {
                    const bool is_known = found.n > 0 && label == found.first;
                    if (is_known || !clash(place, *places_[label])) continue;
                    if (found.n == 1) return {2, found.first};
                    found = {1, label};
                }
            }
        }
        return found;
    }

private:
    struct CellRange {
        int x0, y0, x1, y1;
    };

    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * n_columns_ + x); }

    /// Cells near the label and its leader; what lies outside the room is counted to the cells along its border.
    CellRange cells(const Candidate& place) const
    {
        Box bounds = place.box.bounds();
        if (place.leader) bounds = united(bounds, {place.leader->to, place.leader->to});
        const Box wide = bounds.grown(3.0 * gap_);
        const auto at = [](double v, int n) {
            return static_cast<int>(std::clamp(std::floor(v / cell_side), 0.0, static_cast<double>(n - 1)));
        };
        return {at(wide.min.x - corner_.x, n_columns_), at(wide.min.y - corner_.y, n_rows_),
                at(wide.max.x - corner_.x, n_columns_), at(wide.max.y - corner_.y, n_rows_)};
    }

    template <class Act> void for_each_cell(const Candidate& place, const Act& act)
    {
        const CellRange range = cells(place);
        for (int y = range.y0; y <= range.y1; ++y)
            for (int x = range.x0; x <= range.x1; ++x) act(cells_[index(x, y)]);
    }

    bool clash(const Candidate& a, const Candidate& b) const
    {
        const OrientedBox wide = a.box.grown(gap_);
        if (wide.overlaps(b.box)) return true;
        if (b.leader && clear_of_leaders(a.box).meets_segment(b.leader->from, b.leader->to)) return true;
        if (a.leader && clear_of_leaders(b.box).meets_segment(a.leader->from, a.leader->to)) return true;
        return a.leader && b.leader && do_cross(*a.leader, *b.leader);
    }

    /// A leader that ended just before another text would read as its minus sign.
    OrientedBox clear_of_leaders(const OrientedBox& box) const
    {
        OrientedBox wide = box.grown(gap_);
        wide.half.x += 2.0 * gap_;
        return wide;
    }

    static bool do_cross(const Leader& a, const Leader& b)
    {
        const auto side = [](const Leader& l, Point p) { return cross(l.to - l.from, p - l.from) > 0.0; };
        return side(a, b.from) != side(a, b.to) && side(b, a.from) != side(b, a.to);
    }

    std::vector<std::optional<Candidate>> places_;
    Point corner_;
    double gap_;
    int n_columns_;
    int n_rows_;
    std::vector<std::vector<std::size_t>> cells_;
};

/// One run over a set of labels.
class Run {
public:
    Run(std::span<const Label> labels, const LabelPlacer::Options& options, const LabelObstacles& obstacles)
        : labels_(labels), room_(options.room), obstacles_(obstacles), placed_(labels.size(), options)
    {
        candidates_.reserve(labels.size());
        for (std::size_t i = 0; i < labels.size(); ++i) candidates_.emplace_back(labels, i, options, obstacles_);
    }

    LabelPlacement result()
    {
        std::vector<std::size_t> homeless = by_priority();
        for (const Ground worst : {Ground::Free, Ground::Soft}) {
            put_each(homeless, [&](std::size_t label) { return put_where_free(label, worst); });
            put_each(homeless, [&](std::size_t label) { return put_by_moving_one(label, worst, Rank::Counts); });
        }
        if (effort_ < most_effort)
            put_each(homeless,
                     [&](std::size_t label) { return put_by_moving_one(label, Ground::Soft, Rank::IsNothing); });
        LabelPlacement placement;
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            placement.labels.emplace_back();
            if (const auto& place = placed_[i])
                placement.labels.back() = PlacedLabel{place->box.center, place->rotation, place->leader,
                                                      place->is_over_soft};
            else ++placement.n_left_out;
        }
        return placement;
    }

private:
    std::vector<std::size_t> by_priority() const
    {
        std::vector<std::size_t> order(labels_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return labels_[a].priority > labels_[b].priority; });
        std::erase_if(order, [&](std::size_t i) { return !is_finite(labels_[i].target); });
        return order;
    }

    /// Leaves those for which `put` found no place.
    template <class Put> void put_each(std::vector<std::size_t>& homeless, const Put& put) const
    {
        FullCells full(room_);
        std::erase_if(homeless, [&](std::size_t i) {
            const Label& label = labels_[i];
            if (full.has_no_room(label.target, label.size)) return false;
            const bool is_put = put(i);
            if (!is_put) full.found_no_room(label.target, label.size);
            return is_put;
        });
    }

    /// How many of its places a label may try: all of them until the run has taken long, then those nearby.
    std::size_t n_tries(Candidates& candidates)
    {
        const std::size_t n = effort_ < most_effort ? candidates.n() : candidates.n_near();
        effort_ += n;
        return n;
    }

    enum class Leaders : std::uint8_t { Allowed, None };

    bool put_where_free(std::size_t label, Ground worst, Leaders leaders = Leaders::Allowed)
    {
        Candidates& candidates = candidates_[label];
        const std::size_t n = n_tries(candidates);
        for (std::size_t i = 0; i < n; ++i) {
            if (candidates.ground(i) > worst) continue;
            const Candidate place = candidates[i];
            if (leaders == Leaders::None && place.leader) continue;
            if (placed_.disturbed_by(place).n > 0) continue;
            effort_ -= n - i - 1;
            placed_.put(label, place);
            return true;
        }
        return false;
    }

    /// Whether one of higher priority that stands near its target is not moved far from it.
    enum class Rank : std::uint8_t { Counts, IsNothing };

    bool put_by_moving_one(std::size_t label, Ground worst, Rank rank)
    {
        Candidates& candidates = candidates_[label];
        const std::size_t n = n_tries(candidates);
        int n_asked = 0;
        for (std::size_t i = 0; i < n && n_asked < most_asked; ++i) {
            if (candidates.ground(i) > worst) continue;
            const Candidate place = candidates[i];
            const auto in_the_way = placed_.disturbed_by(place);
            if (in_the_way.n != 1) continue;
            ++n_asked;
            if (swap(label, place, in_the_way.first, worst, rank)) return true;
        }
        return false;
    }

    /// Puts `label` at a place from which `other` finds another one; changes nothing if it finds none.
    bool swap(std::size_t label, const Candidate& place, std::size_t other, Ground worst, Rank rank)
    {
        const Candidate before = placed_.take_away(other);
        placed_.put(label, place);
        const bool is_higher = rank == Rank::Counts && labels_[other].priority > labels_[label].priority;
        const bool keeps_near = is_higher && !before.leader;
        if (put_where_free(other, worst, keeps_near ? Leaders::None : Leaders::Allowed)) return true;
        placed_.take_away(label);
        placed_.put(other, before);
        return false;
    }

    std::span<const Label> labels_;
    Box room_;
    ObstacleMap obstacles_;
    Placed placed_;
    std::vector<Candidates> candidates_;
    std::size_t effort_ = 0; // places tried
};

} // namespace

LabelPlacer::LabelPlacer(const Options& options) : options_(options), obstacles_(options.room) {}

LabelPlacement LabelPlacer::place(std::span<const Label> labels) const
{
    return Run(labels, options_, obstacles_).result();
}

Size label_size(const Fonts& fonts, std::string_view utf8, const TextStyle& style)
{
    const TextExtent extent = fonts.measure(utf8, style);
    return {extent.width, extent.height()};
}

void draw_label(Painter& painter, const PlacedLabel& place, std::string_view utf8, const TextStyle& style)
{
    TextStyle centered = style;
    centered.anchor = Anchor::Center;
    centered.rotation = place.rotation;
    const TextExtent extent = painter.measure(utf8, style);
    const double baseline_of_box = 0.5 * (extent.ascent - extent.descent);           // below the box's middle
    const double baseline_of_text = 0.5 * painter.fonts().cap_height() * style.size; // below the anchor
    const Point down{std::sin(place.rotation), std::cos(place.rotation)};
    painter.text(place.center + (baseline_of_box - baseline_of_text) * down, utf8, centered);
}

} // namespace ui
