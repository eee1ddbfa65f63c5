#include <algorithm>

#include "apps/frame/view/solver/solver_scene.h"
#include "femoop/solver/index.h"

namespace frame {

using femoop::EliminationWalk;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

/// The fronts as a tree, its roots at the top and its leaves from left to right as they are eliminated.
class TreePicture {
public:
    TreePicture(const SolverScene& scene, const ui::Box& box)
        : scene_(scene), fronts_(scene.walk().fronts), columns_(fronts_.size(), 0.0), depths_(fronts_.size(), 0)
    {
        arrange();
        const double n_columns = std::max(1.0, n_leaves_), n_rows = static_cast<double>(deepest_ + 1);
        step_ = {box.width() / n_columns, std::min(box.height() / n_rows, scene.px(70.0))};
        corner_ = box.min;
        right_ = box.max.x;
        radius_ = std::clamp(0.32 * std::min(step_.x, step_.y), scene.px(1.5), scene.px(8.0));
    }

    void draw() const
    {
        ui::Painter& painter = scene_.painter();
        for (std::size_t f = 0; f < fronts_.size(); ++f) {
            if (fronts_[f].parent == EliminationWalk::none) continue;
            const ui::LayerScope layer(painter, ui::Layer::Lines);
            const bool is_path = is_above_or_at(f);
            const ui::Color color = is_path ? scene_.left().stroke.color : scene_.theme().stroke(Role::Leader).color;
            painter.line(place(f), place(femoop::at(fronts_[f].parent)),
                         {.color = color, .width = scene_.px(is_path ? 2.6 : 1.0)});
        }
        for (std::size_t f = 0; f < fronts_.size(); ++f) {
            scene_.draw_mark(state(f), place(f), radius_);
            draw_name(f);
        }
    }

private:
    void arrange()
    {
        for (std::size_t f = fronts_.size(); f-- > 0;) {
            if (fronts_[f].parent != EliminationWalk::none) depths_[f] = depths_[femoop::at(fronts_[f].parent)] + 1;
            deepest_ = std::max(deepest_, depths_[f]);
        }
        std::vector<double> sum(fronts_.size(), 0.0);
        std::vector<int> n_children(fronts_.size(), 0);
        for (std::size_t f = 0; f < fronts_.size(); ++f) {
            columns_[f] = n_children[f] == 0 ? n_leaves_++ : sum[f] / n_children[f];
            if (fronts_[f].parent == EliminationWalk::none) continue;
            sum[femoop::at(fronts_[f].parent)] += columns_[f];
            ++n_children[femoop::at(fronts_[f].parent)];
        }
    }

    Point place(std::size_t f) const
    {
        return corner_ + Point{(columns_[f] + 0.5) * step_.x, (static_cast<double>(depths_[f]) + 0.5) * step_.y};
    }

    BlockState state(std::size_t f) const
    {
        if (f == scene_.step()) return BlockState::Eliminated;
        if (f > scene_.step()) return is_above_or_at(f) ? BlockState::Left : BlockState::Untouched;
        const std::int32_t parent = fronts_[f].parent;
        const bool waits = parent != EliminationWalk::none && femoop::at(parent) > scene_.step();
        return waits ? BlockState::Waiting : BlockState::Done;
    }

    /// On the path from the present front to its root: all that its update matrix will touch lies there.
    bool is_above_or_at(std::size_t f) const
    {
        for (std::size_t above = scene_.step();;) {
            if (above == f) return true;
            if (fronts_[above].parent == EliminationWalk::none) return false;
            above = femoop::at(fronts_[above].parent);
        }
    }

    void draw_name(std::size_t f) const
    {
        const ui::TextStyle style = scene_.small(state(f) == BlockState::Done ? Role::FaintLabel : Role::Label,
                                                 Anchor::Left);
        const double room = n_leaves_ > 1.0 ? step_.x - 2.0 * radius_ : 20.0 * style.size;
        const auto fits = [&](const std::string& text) {
            const double width = scene_.painter().measure(text, style).width;
            return width < room && place(f).x + 1.5 * radius_ + width < right_;
        };
        std::string text = scene_.names(fronts_[f].first, fronts_[f].end);
        if (!fits(text)) text = scene_.name_at(fronts_[f].first) + " …";
        if (!fits(text) || step_.y < 1.1 * style.size) return;
        const ui::LayerScope layer(scene_.painter(), ui::Layer::Labels);
        scene_.painter().text(place(f) + Point{1.5 * radius_, 0.0}, text, style);
    }

    const SolverScene& scene_;
    const std::vector<EliminationWalk::Front>& fronts_;
    std::vector<double> columns_; ///< of each front, in leaves
    std::vector<int> depths_;     ///< of each front below its root
    double n_leaves_ = 0.0;
    int deepest_ = 0;
    Point step_, corner_;
    double radius_ = 0.0, right_ = 0.0;
};

} // namespace

void draw_elimination_tree(const SolverScene& scene, const ui::Box& box)
{
    const ui::Catalogue& tr = scene.tr();
    const femoop::EliminationCounts& counts = scene.walk().counts;
    const ui::Box room = scene.draw_title(
        box, tr("Elimination tree"),
        tr("{fronts} fronts on {levels} levels; small squares wait",
           {{"fronts", std::to_string(scene.walk().fronts.size())}, {"levels", std::to_string(counts.n_levels)}}));
    TreePicture(scene, room).draw();
}

} // namespace frame
