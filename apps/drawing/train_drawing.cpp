#include "apps/drawing/train_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/drawing/sketch/scene.h"

namespace drawing {

using femoop::Train;
using ui::Anchor;
using ui::Measure;
using ui::Point;
using ui::Role;

namespace {

/// The distance behind an axle.
struct Gap {
    double least = 0.0, most = 0.0;
    bool varies() const { return most > least; }
};

std::vector<Gap> gaps_of(const Train& train)
{
    std::vector<Gap> gaps;
    for (const femoop::Quantity& spacing : train.spacings) gaps.push_back({spacing.value(), spacing.value()});
    for (const femoop::SpacingRange& range : train.spacing_ranges)
        if (range.spacing < gaps.size()) gaps[range.spacing] = {range.min.value(), range.max.value()};
    return gaps;
}

class TrainSheet {
public:
    TrainSheet(ui::Painter& painter, const Train& train, const TrainLook& look)
        : painter_(painter), train_(train), look_(look), gaps_(gaps_of(train))
    {
        for (const Gap& gap : gaps_) length_ += gap.most;
        for (const femoop::Quantity& axle : train.axles) largest_ = std::max(largest_, std::abs(axle.value()));
        if (train.uniform && train.uniform_extent == femoop::UniformExtent::Outside && !train.axles.empty())
            free_ = train.gap ? train.gap->value() : 0.0;
        const double room = painter.size().width - 2.0 * side(), length = length_ + 2.0 * free_;
        scale_ = length > 0.0 ? room / length : 0.0;
        ground_ = painter.size().height - px(44);
        if (n_rows_of_distances() > 1) ground_ -= row_height();
    }

    void draw()
    {
        painter_.set_layer(ui::Layer::Background);
        painter_.rectangle(painter_.sheet(), look_.theme.background());
        painter_.set_layer(ui::Layer::Lines);
        const double right = painter_.size().width;
        painter_.line({0.0, ground_}, {right, ground_}, look_.theme.stroke(Role::Member));
        if (train_.uniform) draw_uniform(train_.uniform->value());
        double x = first();
        for (std::size_t i = 0; i < train_.axles.size(); ++i) {
            draw_axle(x, i);
            places_.push_back(x);
            if (i >= gaps_.size()) break;
            const double next = x - scale_ * gaps_[i].least, farthest = x - scale_ * gaps_[i].most;
            draw_gap(x, next, farthest, gaps_[i]);
            x = next;
        }
        draw_forces();
        write_distances();
        draw_direction();
    }

private:
    double px(double pixels) const { return look_.theme.type().normal / ui::TypeSizes{}.normal * pixels; }
    double side() const { return px(44); } ///< kept free beside the outer axles
    double first() const
    {
        return train_.axles.size() > 1 ? painter_.size().width - side() - scale_ * free_ : middle();
    }
    double last() const
    {
        double x = first();
        for (const Gap& gap : gaps_) x -= scale_ * gap.least;
        return x;
    }
    double middle() const { return 0.5 * painter_.size().width; }
    double wheel() const { return px(5); }
    double strip_top() const { return px(22); }
    double strip_foot() const { return px(36); }
    double most_height() const { return ground_ - 2.0 * wheel() - strip_foot() - px(24); }

    void text(Point at, const std::string& words, Role role, Anchor anchor)
    {
        const ui::LayerScope labels(painter_, ui::Layer::Labels);
        ui::TextStyle style = look_.theme.text(role, anchor);
        style.size = look_.theme.type().small;
        painter_.text(at, words, style);
    }
    std::string words(double value, Measure measure) const { return with_minus(look_.units.text(value, measure)); }

    void arrow(Point from, Point to, ui::Stroke stroke)
    {
        const Point along = ui::direction(to - from), across = ui::left_normal(along);
        painter_.line(from, to - px(5) * along, stroke);
        painter_.polygon({to, to - px(8) * along + px(3) * across, to - px(8) * along - px(3) * across}, stroke.color);
    }

    void draw_axle(double x, std::size_t i)
    {
        const double force = train_.axles[i].value();
        const ui::Stroke wheel_line = look_.theme.stroke(Role::Member);
        painter_.disc({x, ground_ - wheel()}, wheel(), wheel_line.color);
        const Point foot{x, ground_ - 2.0 * wheel()}, top{x, top_of(i)};
        const ui::Stroke stroke = look_.theme.stroke(Role::Load);
        if (force != 0.0) arrow(force > 0.0 ? top : foot, force > 0.0 ? foot : top, stroke);
    }

    /// What is written over an axle or below a distance.
    struct Note {
        Point at;
        std::string words;
        double length = 0.0; ///< of the distance [px]
    };

    /// Of several alike that are too near for one each "4 × 80" over their middle.
    std::vector<Note> joined(const std::vector<Note>& notes) const
    {
        std::vector<Note> joined;
        for (std::size_t i = 0; i < notes.size();) {
            const Note& first = notes[i];
            std::size_t last = i;
            double length = first.length;
            while (last + 1 < notes.size() && notes[last + 1].words == first.words &&
                   touches(notes[last], notes[last + 1]))
                length += notes[++last].length;
            joined.push_back({{0.5 * (first.at.x + notes[last].at.x), first.at.y},
                              last > i ? std::to_string(last - i + 1) + " × " + first.words : first.words,
                              length});
            i = last + 1;
        }
        return joined;
    }

    static constexpr std::size_t n_rows = 2; // of distances

    /// The row of each distance, from right to left: the first one that has room beside what stands there, for one that
    /// is wider than its distance the second one; none where none has.
    std::vector<std::optional<std::size_t>> rows_of(const std::vector<Note>& notes) const
    {
        std::array<double, n_rows> free_to; // of the last one in it
        free_to.fill(painter_.size().width);
        std::vector<std::optional<std::size_t>> found;
        for (const Note& note : notes) {
            const double width = width_of(note.words);
            const bool is_wide = notes.size() > 1 && width > note.length;
            found.emplace_back();
            for (const std::size_t row :
                 is_wide ? std::array<std::size_t, n_rows>{1, 0} : std::array<std::size_t, n_rows>{0, 1}) {
                if (found.back() || note.at.x + 0.5 * width > free_to[row]) continue;
                free_to[row] = note.at.x - 0.5 * width - px(4);
                found.back() = row;
            }
        }
        return found;
    }

    void write_distances()
    {
        const std::vector<Note> all = joined(distances_);
        const auto rows = rows_of(all);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (rows[i])
                text(all[i].at + Point{0.0, static_cast<double>(*rows[i]) * row_height()}, all[i].words,
                     Role::Dimension, Anchor::Top);
    }
    double row_height() const { return 1.15 * look_.theme.type().small; }

    std::size_t n_rows_of_distances() const
    {
        std::vector<Note> notes;
        double x = first();
        for (const Gap& gap : gaps_) {
            const double next = x - scale_ * gap.least;
            notes.push_back({{0.5 * (x + next), 0.0}, distance_text(gap), x - next});
            x = next;
        }
        const auto rows = rows_of(joined(notes));
        return std::ranges::any_of(rows, [](const auto& row) { return row && *row > 0; }) ? 2 : 1;
    }

    double width_of(const std::string& words) const
    {
        ui::TextStyle style = look_.theme.text(Role::Load, Anchor::Bottom);
        style.size = look_.theme.type().small;
        return painter_.measure(words, style).width;
    }
    bool touches(const Note& a, const Note& b) const { return std::abs(a.at.x - b.at.x) < width_of(a.words) + px(4); }

    // The largest first, over their arrows; one that has no room there stands higher, and a line leads down from it.
    void draw_forces()
    {
        std::vector<Note> notes;
        for (std::size_t i = 0; i < places_.size(); ++i)
            notes.push_back({{places_[i], top_of(i) - px(2)},
                             with_minus(look_.units.number(train_.axles[i].value(), Measure::Force))});
        std::vector<Note> all = joined(notes);
        std::ranges::stable_sort(all, {}, [](const Note& note) { return note.at.y; });
        std::vector<ui::Box> taken;
        for (const Note& note : all) write_force(note, taken);
    }

    void write_force(const Note& note, std::vector<ui::Box>& taken)
    {
        constexpr int most_rows = 4;
        const double half = 0.5 * width_of(note.words), height = look_.theme.type().small;
        const double top = train_.uniform ? strip_foot() : 0.0;
        for (int row = 0; row < most_rows; ++row) {
            const Point at = note.at - Point{0.0, row * row_height()};
            const ui::Box box{{at.x - half - px(2), at.y - height}, {at.x + half + px(2), at.y}};
            if (row > 0 && box.min.y < top) return;
            if (std::ranges::any_of(taken, [&](const ui::Box& other) { return box.overlaps(other); })) continue;
            taken.push_back(box);
            text(at, note.words, Role::Load, Anchor::Bottom);
            if (row > 0) painter_.line(at, note.at, look_.theme.stroke(Role::Dimension));
            return;
        }
    }
    double top_of(std::size_t i) const
    {
        const double share = largest_ > 0.0 ? std::abs(train_.axles[i].value()) / largest_ : 0.0;
        return ground_ - 2.0 * wheel() - std::max(px(14), share * most_height());
    }

    // The least distance, and dashed behind it how much farther off the axle may be.
    void draw_gap(double from, double to, double farthest, const Gap& gap)
    {
        const double y = ground_ + px(14);
        ui::Stroke stroke = look_.theme.stroke(Role::Dimension);
        painter_.line({to, y}, {from, y}, stroke);
        for (const double end : {from, to}) {
            painter_.line({end, y - px(4)}, {end, y + px(4)}, stroke);
            painter_.line({end - px(3), y + px(3)}, {end + px(3), y - px(3)}, stroke);
        }
        if (gap.varies()) {
            stroke.dash = {4.0, 3.0};
            painter_.line({farthest, y}, {to, y}, stroke);
            painter_.line({farthest, ground_ - 2.0 * wheel()}, {farthest, y + px(4)}, stroke);
        }
        distances_.push_back({{0.5 * (from + to), y + px(4)}, distance_text(gap), from - to});
    }

    std::string distance_text(const Gap& gap) const
    {
        const std::string least = look_.units.number(gap.least, Measure::Length);
        return gap.varies() ? least + " … " + look_.units.number(gap.most, Measure::Length) : least;
    }

    /// Over the whole length, or before and behind what it leaves free beside the axles.
    void draw_uniform(double load)
    {
        const double left = px(8), right = painter_.size().width - px(8);
        if (free_ > 0.0) {
            draw_strip(load, left, last() - scale_ * free_);
            draw_strip(load, first() + scale_ * free_, right);
        } else draw_strip(load, left, right);
        text({left, strip_top() - px(2)}, words(load, Measure::ForcePerLength), Role::Load, Anchor::BottomLeft);
    }

    void draw_strip(double load, double left, double right)
    {
        const double top = strip_top(), foot = strip_foot();
        const ui::Stroke stroke = look_.theme.stroke(Role::Load);
        painter_.line({left, top}, {right, top}, stroke);
        painter_.line({left, foot}, {right, foot}, stroke);
        const double step = px(16);
        for (double x = left; x <= right; x += step)
            load >= 0.0 ? arrow({x, top}, {x, foot}, stroke) : arrow({x, foot}, {x, top}, stroke);
    }

    // Which way it runs, the unit of the numbers, and what its forces are multiplied by.
    void draw_direction()
    {
        const double right = painter_.size().width - px(10), y = ground_ - px(14);
        const ui::Stroke stroke = look_.theme.stroke(Role::Dimension);
        arrow({right - px(20), y}, {right, y}, stroke);
        if (train_.both_directions) arrow({right - px(4), y + px(7)}, {right - px(24), y + px(7)}, stroke);
        std::string units = look_.tr("units {units}", {{"units", look_.units.summary()}});
        if (train_.impact != 1.0)
            units += "  ·  " +
                     look_.tr("axles × {factor}", {{"factor", look_.units.number(train_.impact, Measure::Plain)}});
        for (const femoop::ConcentratedForce& force : train_.concentrated) {
            units += "  ·  + " + look_.units.number(force.for_moments, Measure::Force);
            if (force.for_others) units += " / " + look_.units.number(*force.for_others, Measure::Force);
        }
        text({px(8), painter_.size().height - px(3)}, units, Role::FaintLabel, Anchor::BottomLeft);
    }

    ui::Painter& painter_;
    const Train& train_;
    const TrainLook& look_;
    std::vector<Gap> gaps_;
    std::vector<double> places_;  ///< of the axles that are drawn
    std::vector<Note> distances_; ///< between them
    double free_ = 0.0;           ///< length beside the outer axles that the uniform load leaves out
    double length_ = 0.0, largest_ = 0.0, scale_ = 0.0, ground_ = 0.0;
};

} // namespace

void draw_train(ui::Painter& painter, const Train& train, const TrainLook& look)
{
    TrainSheet(painter, train, look).draw();
}

} // namespace drawing
