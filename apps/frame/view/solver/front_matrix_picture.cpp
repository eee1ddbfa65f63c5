#include <algorithm>

#include "apps/frame/view/solver/solver_scene.h"
#include "femoop/solver/trace/front_matrix.h"

namespace frame {

using femoop::FrontEntry;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

/// A front's matrix, block by block in the size of their unknowns.
class MatrixPicture {
public:
    MatrixPicture(const SolverScene& scene, const ui::Box& box)
        : scene_(scene), painter_(scene.painter()), matrix_(front_matrix(scene.walk(), scene.step()))
    {
        starts_.push_back(0.0);
        for (const std::int32_t place : matrix_.places)
            starts_.push_back(starts_.back() +
                              scene.trace().graph.block_sizes[static_cast<std::size_t>(scene.block_at(place))]);
        name_style_ = scene.small(Role::Label, Anchor::Right);
        for (const std::int32_t place : matrix_.places)
            margin_ = std::max(margin_, painter_.measure(scene.name_at(place), name_style_).width + scene.px(6.0));
        const double side = std::min(box.width() - margin_, box.height() - scene.px(8.0));
        cell_ = std::min(side / starts_.back(), scene.px(14.0));
        corner_ = {box.min.x + margin_, box.min.y + scene.px(4.0)};
        has_names_ = starts_.back() / static_cast<double>(matrix_.places.size()) * cell_ > 0.9 * name_style_.size;
    }

    void draw() const
    {
        for (std::size_t row = 0; row < matrix_.places.size(); ++row) {
            for (std::size_t column = 0; column <= row; ++column) draw_block(row, column);
            if (has_names_) draw_name(row);
        }
        draw_frames();
    }

private:
    ui::Box block(std::size_t row, std::size_t column) const
    {
        return {corner_ + cell_ * Point{starts_[column], starts_[row]},
                corner_ + cell_ * Point{starts_[column + 1], starts_[row + 1]}};
    }

    void draw_block(std::size_t row, std::size_t column) const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Areas);
        const ui::Box box = block(row, column).grown(-scene_.px(0.7));
        switch (matrix_.at(row, column)) {
        case FrontEntry::FromK: painter_.rectangle(box, scene_.theme().stroke(Role::Member).color); return;
        case FrontEntry::FromChildren: draw_hatched(box); return;
        case FrontEntry::Made: draw_rings(box); return;
        }
    }

    void draw_hatched(const ui::Box& box) const
    {
        painter_.rectangle(box, scene_.left().fill);
        const ui::ClipScope clip(painter_, box);
        const ui::Stroke stroke{.color = scene_.left().stroke.color, .width = scene_.px(1.2)};
        const double gap = scene_.px(5.0), run = box.width() + box.height();
        for (double at = 0.5 * gap; at < run; at += gap)
            painter_.line({box.min.x + at, box.min.y}, {box.min.x + at - box.height(), box.max.y}, stroke);
    }

    void draw_rings(const ui::Box& box) const
    {
        painter_.rectangle(box, scene_.filled().fill);
        const double radius = std::min(0.28 * std::min(box.width(), box.height()), scene_.px(9.0));
        painter_.circle(box.center(), radius, {.color = scene_.filled().stroke.color, .width = scene_.px(1.6)});
    }

    void draw_name(std::size_t row) const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Labels);
        ui::TextStyle style = name_style_;
        const bool is_eliminated = row < matrix_.n_eliminated;
        if (is_eliminated) style.weight = ui::Weight::Bold;
        style.color = is_eliminated ? scene_.eliminated().text : scene_.left().text;
        painter_.text({corner_.x - scene_.px(4.0), block(row, row).center().y}, scene_.name_at(matrix_.places[row]),
                      style);
    }

    // Round what is eliminated, which becomes columns of L, and round the update matrix.
    void draw_frames() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Symbols);
        const std::size_t n = matrix_.places.size(), p = matrix_.n_eliminated;
        painter_.polyline(outline(0, p),
                          {.color = scene_.eliminated().stroke.color, .width = scene_.px(2.4), .join = ui::Join::Round},
                          ui::PathEnds::Closed);
        if (p == n) return;
        painter_.polyline(
            outline(p, n),
            {.color = scene_.left().stroke.color, .width = scene_.px(2.0), .dash = {5.0, 3.0}, .join = ui::Join::Round},
            ui::PathEnds::Closed);
    }
    /// Round the columns of some blocks, down to the last row.
    std::vector<Point> outline(std::size_t first, std::size_t end) const
    {
        std::vector<Point> stairs;
        for (std::size_t i = first; i < end; ++i) {
            stairs.push_back(block(i, i).min);
            stairs.push_back({block(i, i).max.x, block(i, i).min.y});
        }
        const double bottom = block(matrix_.places.size() - 1, 0).max.y;
        stairs.push_back({stairs.back().x, bottom});
        stairs.push_back({stairs.front().x, bottom});
        return stairs;
    }

    const SolverScene& scene_;
    ui::Painter& painter_;
    const femoop::FrontMatrix matrix_;
    std::vector<double> starts_; ///< of each block, in unknowns, and the end
    ui::TextStyle name_style_;
    double margin_ = 0.0, cell_ = 0.0;
    Point corner_;
    bool has_names_ = false;
};

} // namespace

void draw_front_matrix(const SolverScene& scene, const ui::Box& box)
{
    const ui::Catalogue& tr = scene.tr();
    const femoop::EliminationWalk::Front& front = scene.front();
    const std::string note = tr("{rows} rows, {pivots} eliminated; update matrix {update}, waiting {waiting} entries",
                                {{"rows", std::to_string(front.n_rows())},
                                 {"pivots", std::to_string(front.n_pivots)},
                                 {"update", std::to_string(front.n_update_entries())},
                                 {"waiting", std::to_string(front.n_waiting)}});
    MatrixPicture(scene, scene.draw_title(box, tr("Matrix of the front"), note)).draw();
}

} // namespace frame
