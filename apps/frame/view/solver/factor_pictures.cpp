#include <algorithm>

#include "apps/frame/view/solver/solver_scene.h"
#include "femoop/io/results/solver_trace_text.h"
#include "femoop/solver/index.h"

namespace frame {

using femoop::EliminationWalk;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

/// Of the name over a pattern.
double head_height(const SolverScene& scene) { return 1.6 * scene.theme().type().small; }

/// The pattern of L in one order, with what it costs.
class FactorPicture {
public:
    FactorPicture(const SolverScene& scene, femoop::Ordering ordering, const ui::Box& box)
        : scene_(scene), painter_(scene.painter()), ordering_(ordering), walk_(scene.trace().walk(ordering)), box_(box)
    {
        starts_.push_back(0.0);
        for (const std::int32_t block : walk_.order)
            starts_.push_back(starts_.back() + scene.trace().graph.block_sizes[femoop::at(block)]);
        const double head = head_height(scene);
        const double side = std::min(box.width(), box.height() - head);
        cell_ = std::max(side, 0.0) / starts_.back();
        corner_ = box.min + Point{0.0, head};
    }

    void draw() const
    {
        draw_text();
        if (is_shown()) draw_progress();
        const ui::LayerScope layer(painter_, ui::Layer::Areas);
        for (std::size_t column = 0; column < walk_.columns.size(); ++column) {
            draw_diagonal(column);
            for (const EliminationWalk::Entry& entry : walk_.columns[column])
                draw_entry(femoop::at(entry.row), column, entry.is_fill);
        }
    }

private:
    bool is_shown() const { return ordering_ == scene_.look().ordering; }
    Point at(double column, double row) const { return corner_ + cell_ * Point{column, row}; }

    void draw_text() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Labels);
        ui::TextStyle title = scene_.small(Role::Label, Anchor::TopLeft);
        if (is_shown()) title.weight = ui::Weight::Bold;
        const std::string chosen = !scene_.trace().has_constraints && scene_.trace().ordering == ordering_ ? " ✓" : "";
        const std::string name = femoop::ordering_text(ordering_, scene_.tr()) + chosen;
        painter_.text(box_.min, name, scene_.fitted(name, title, 0.97 * box_.width()));
        const femoop::EliminationCounts& counts = walk_.counts;
        write_count(0, ui::translatable("{n} entries"), counts.n_entries);
        write_count(1, ui::translatable("{n} filled in"), counts.n_fill());
        write_count(2, ui::translatable("{n} operations"), static_cast<std::size_t>(counts.n_operations));
    }
    /// In the empty half of the pattern, above the diagonal.
    void write_count(int line, std::string_view sentence, std::size_t n) const
    {
        const std::string words = scene_.tr()(sentence, {{"n", std::to_string(n)}});
        const ui::TextStyle style = scene_.small(Role::FaintLabel, Anchor::TopRight);
        const double top = 1.3 * line * style.size;
        const double room = box_.width() - top - 1.7 * style.size;
        painter_.text({box_.max.x, corner_.y + top}, words, scene_.fitted(words, style, 0.97 * room));
    }
    // Columns that are eliminated before and in this step.
    void draw_progress() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Background);
        const double n = starts_.back(), done = starts_[femoop::at(scene_.front().first)],
                     now = starts_[femoop::at(scene_.front().end)];
        painter_.polygon({at(0, 0), at(done, done), at(done, n), at(0, n)}, scene_.theme().stroke(Role::Grid).color);
        painter_.set_layer(ui::Layer::Symbols);
        painter_.polyline({at(done, done), at(now, now), at(now, n), at(done, n)},
                          {.color = scene_.eliminated().stroke.color, .width = scene_.px(1.4)}, ui::PathEnds::Closed);
    }

    void draw_diagonal(std::size_t column) const
    {
        const ui::Color ink = scene_.theme().stroke(Role::Member).color;
        const double from = starts_[column], to = starts_[column + 1];
        std::vector<Point> stairs{at(from, to)}; // the lower triangle of the block
        for (double i = from; i < to; i += 1.0) {
            stairs.push_back(at(i, i));
            stairs.push_back(at(i + 1.0, i));
        }
        stairs.push_back(at(to, to));
        painter_.polygon(stairs, ink);
    }

    void draw_entry(std::size_t row, std::size_t column, bool is_fill) const
    {
        const ui::Box block{at(starts_[column], starts_[row]), at(starts_[column + 1], starts_[row + 1])};
        if (!is_fill) {
            painter_.rectangle(block, scene_.theme().stroke(Role::Member).color);
            return;
        }
        // Smaller than an entry of K and hollow, where there is room for it.
        const double inset = 0.12 * block.width();
        painter_.rectangle(block.grown(-inset), scene_.fill_color());
        if (block.width() > scene_.px(5.0)) painter_.rectangle(block.grown(-2.4 * inset), scene_.theme().background());
    }

    const SolverScene& scene_;
    ui::Painter& painter_;
    const femoop::Ordering ordering_;
    const EliminationWalk& walk_;
    const ui::Box box_;
    std::vector<double> starts_; ///< of each place, in unknowns, and the end
    double cell_ = 0.0;
    Point corner_;
};

} // namespace

void draw_factors(const SolverScene& scene, const ui::Box& box)
{
    const ui::Catalogue& tr = scene.tr();
    const std::string entries = std::to_string(scene.walk().counts.n_entries_of_K);
    const std::string note = scene.trace().has_constraints
                                 ? tr("{entries} entries of K, before constraints make unknowns follow others",
                                      {{"entries", entries}})
                                 : tr("{entries} entries of K; ✓ the solver's own order", {{"entries", entries}});
    const ui::Box room = scene.draw_title(box, tr("L in four orders"), note);
    const double gap = scene.px(10.0);
    const auto size_of = [&](std::size_t n_columns) {
        const auto columns = static_cast<double>(n_columns), rows = 4.0 / columns;
        return ui::Size{(room.width() - gap * (columns - 1.0)) / columns, (room.height() - gap * (rows - 1.0)) / rows};
    };
    const auto side_of = [&](ui::Size size) { return std::min(size.width, size.height - head_height(scene)); };
    const std::size_t n_columns = side_of(size_of(4)) > side_of(size_of(2)) ? 4 : 2;
    const ui::Size size = size_of(n_columns);
    for (std::size_t i = 0; i < femoop::all_orderings.size(); ++i) {
        const std::size_t row = i / n_columns, column = i % n_columns;
        const Point corner = room.min + Point{static_cast<double>(column) * (size.width + gap),
                                              static_cast<double>(row) * (size.height + gap)};
        FactorPicture(scene, femoop::all_orderings[i], ui::box_at(corner, size)).draw();
    }
}

} // namespace frame
