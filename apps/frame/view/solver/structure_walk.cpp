#include <algorithm>
#include <limits>
#include <map>

#include "apps/drawing/draw.h"
#include "apps/drawing/geometry/projection.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/view/solver/solver_scene.h"
#include "femoop/solver/index.h"
#include "femoop/solver/trace/front_matrix.h"

namespace frame {

using femoop::FrontEntry;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

constexpr std::size_t first_series = 3; // of separators: hues that no state of a block has
constexpr double bulge = 0.14;          // of an arc's length

/// The structure on the sheet with the front on it.
class StructureWalk {
public:
    StructureWalk(const SolverScene& scene, const ui::Box& box) : scene_(scene), painter_(scene.painter()), box_(box)
    {
        place_blocks();
        radius_ = std::clamp(0.17 * spacing(), scene.px(2.5), scene.px(7.0));
    }

    void draw() const
    {
        if (scene_.look().ordering == femoop::Ordering::NestedDissection) draw_separators();
        draw_members();
        draw_couplings();
        for (std::size_t b = 0; b < places_.size(); ++b)
            scene_.draw_mark(scene_.state(static_cast<std::int32_t>(b)), places_[b], radius_);
        if (spacing() > 2.2 * scene_.theme().type().small) draw_names();
    }

private:
    const femoop::SolverTrace& trace() const { return scene_.trace(); }

    void place_blocks()
    {
        const auto& positions = trace().graph.positions;
        const ui::Margins margins{20.0, 20.0, 20.0, 20.0};
        Camera camera;
        if (is_seen_in_space(trace().kind)) {
            std::vector<ui::World3> points;
            for (const Eigen::Vector3d& p : positions) points.push_back({p.x(), p.y(), p.z()});
            ui::OrbitCamera orbit;
            orbit.fit(points, box_.size(), margins);
            camera = orbit;
        } else {
            std::vector<ui::World2> points;
            for (const Eigen::Vector3d& p : positions) points.push_back({p.x(), p.y()});
            ui::PlaneCamera plane;
            plane.fit(points, box_.size(), margins);
            camera = plane;
        }
        const Projection projection(camera, box_.min);
        for (const Eigen::Vector3d& position : positions) places_.push_back(projection(position));
        // A member's own unknowns are drawn on it.
        for (std::size_t clique = 0; clique < trace().graph.n_cliques(); ++clique)
            if (const auto blocks = trace().graph.clique(clique); blocks.size() > 2)
                places_[femoop::at(blocks[2])] = 0.65 * places_[femoop::at(blocks[0])] +
                                                 0.35 * places_[femoop::at(blocks[1])];
    }

    /// The mean distance of neighbours.
    double spacing() const
    {
        double sum = 0.0;
        std::size_t n = 0;
        for (std::size_t clique = 0; clique < trace().graph.n_cliques(); ++clique, ++n)
            sum += distance(end(clique, 0), end(clique, 1));
        return n == 0 ? std::min(box_.width(), box_.height()) : sum / static_cast<double>(n);
    }
    Point end(std::size_t clique, std::size_t i) const { return places_[femoop::at(trace().graph.clique(clique)[i])]; }

    void draw_separators() const
    {
        std::map<std::int32_t, std::vector<std::size_t>> separators;
        for (std::size_t b = 0; b < trace().blocks.size(); ++b)
            if (trace().blocks[b].separator) separators[trace().blocks[b].piece].push_back(b);
        for (const auto& [piece, blocks] : separators) draw_separator(blocks);
    }

    // Broad below everything else, with the number of the cut, so that its hue need not be known.
    void draw_separator(std::vector<std::size_t> blocks) const
    {
        const auto level = static_cast<std::size_t>(*trace().blocks[blocks.front()].separator);
        const ui::RoleStyle& style = scene_.theme().series(first_series + level);
        const ui::Color color = scene_.on_paper(mixed(style.stroke.color, scene_.theme().background(), 0.45), 0.6);
        std::ranges::sort(blocks, [&](std::size_t a, std::size_t b) {
            const Point p = places_[a], q = places_[b];
            return p.y != q.y ? p.y < q.y : p.x < q.x;
        });
        std::vector<Point> line;
        for (const std::size_t b : blocks) line.push_back(places_[b]);
        const ui::LayerScope layer(painter_, ui::Layer::Areas);
        for (const Point& p : line) painter_.disc(p, 2.1 * radius_, color);
        const bool is_line = !is_seen_in_space(trace().kind) && line.size() > 1;
        if (is_line)
            painter_.polyline(line,
                              {.color = color, .width = 2.4 * radius_, .cap = ui::Cap::Round, .join = ui::Join::Round});
        ui::TextStyle number = scene_.small(Role::Label, Anchor::BottomRight);
        number.color = style.text;
        number.weight = ui::Weight::Bold;
        painter_.set_layer(ui::Layer::Labels);
        painter_.text(line.front() + Point{-1.5 * radius_, -1.5 * radius_}, std::to_string(level + 1), number);
    }

    // A member's stiffness enters K in the front that eliminates the first of its blocks.
    void draw_members() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Lines);
        const ui::Color ink = scene_.theme().stroke(Role::Member).color;
        const ui::Color faint = scene_.theme().stroke(Role::Undeformed).color;
        for (std::size_t clique = 0; clique < trace().graph.n_cliques(); ++clique) {
            bool is_done = false, is_new = false;
            for (const std::int32_t block : trace().graph.clique(clique)) {
                is_done = is_done || scene_.state(block) == BlockState::Done;
                is_new = is_new || scene_.state(block) == BlockState::Eliminated;
            }
            const double width = is_done ? 0.8 : is_new ? 3.0 : 1.4;
            painter_.line(end(clique, 0), end(clique, 1),
                          {.color = is_done ? faint : ink, .width = scene_.px(width), .cap = ui::Cap::Round});
        }
    }

    /// What elimination couples without a member, as arcs: those that are new in this front, and those from before.
    void draw_couplings() const
    {
        const femoop::FrontMatrix matrix = front_matrix(scene_.walk(), scene_.step());
        const ui::LayerScope layer(painter_, ui::Layer::Lines);
        for (std::size_t i = matrix.n_eliminated; i < matrix.places.size(); ++i)
            for (std::size_t j = matrix.n_eliminated; j < i; ++j) {
                if (is_in_K(matrix.places[j], matrix.places[i])) continue;
                const bool is_new = matrix.at(i, j) == FrontEntry::Made;
                const ui::RoleStyle& style = is_new ? scene_.filled() : scene_.left();
                draw_arc(place_of(matrix.places[j]), place_of(matrix.places[i]),
                         {.color = style.stroke.color,
                          .width = scene_.px(is_new ? 1.8 : 1.1),
                          .dash = is_new ? ui::DashPattern{6.0, 3.0} : ui::DashPattern{1.5, 2.5}});
            }
    }
    bool is_in_K(std::int32_t column, std::int32_t row) const
    {
        const auto& entries = scene_.walk().columns[femoop::at(column)];
        const auto found = std::ranges::find(entries, row, &femoop::EliminationWalk::Entry::row);
        return found != entries.end() && !found->is_fill;
    }
    Point place_of(std::int32_t place) const { return places_[femoop::at(scene_.block_at(place))]; }

    void draw_arc(Point a, Point b, const ui::Stroke& stroke) const
    {
        constexpr int n = 12;
        const Point side = bulge * left_normal(b - a);
        std::vector<Point> points;
        for (int i = 0; i <= n; ++i) {
            const double t = static_cast<double>(i) / n;
            points.push_back(a + t * (b - a) + (4.0 * t * (1.0 - t)) * side);
        }
        painter_.polyline(points, stroke);
    }

    void draw_names() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Labels);
        for (std::size_t b = 0; b < places_.size(); ++b) {
            const BlockState state = scene_.state(static_cast<std::int32_t>(b));
            if (state == BlockState::Held) continue;
            ui::TextStyle style = scene_.small(state == BlockState::Done ? Role::FaintLabel : Role::Label,
                                               Anchor::BottomLeft);
            if (state == BlockState::Eliminated || state == BlockState::Left) style.weight = ui::Weight::Bold;
            painter_.text(places_[b] + Point{0.9 * radius_, -0.9 * radius_},
                          scene_.name_of(static_cast<std::int32_t>(b)), style);
        }
    }

    const SolverScene& scene_;
    ui::Painter& painter_;
    const ui::Box box_;
    std::vector<Point> places_; ///< of each block
    double radius_ = 0.0;
};

} // namespace

void draw_walk_on_structure(const SolverScene& scene, const ui::Box& box)
{
    const ui::Catalogue& tr = scene.tr();
    const std::string note = scene.look().ordering == femoop::Ordering::NestedDissection
                                 ? tr("broad lines: separators, numbered as they cut")
                                 : tr("dashed: coupled by this step; dotted: before");
    const ui::Box room = scene.draw_title(box, tr("The front on the structure"), note);
    const ui::ClipScope clip(scene.painter(), room.grown(scene.px(8.0)));
    StructureWalk(scene, room).draw();
}

} // namespace frame
