#include "femoop/plane/result/trajectories.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <unordered_map>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

using Eigen::Vector2d;

constexpr double step_share = 0.1;         // of the spacing
constexpr double least_distance = 0.5;     // of the spacing, between two lines
constexpr double least_length = 0.8;       // of the spacing: shorter ones say nothing
constexpr double isotropic = 1e-3;         // of the largest difference of principal stresses
constexpr double sharpest_turn = 0.5;      // cosine, in one step
constexpr std::size_t most_steps = 20000;  // of one line
constexpr std::size_t own_neighbours = 12; // points of a line back from its end that do not count as close

/// The direction of one principal stress at every place of the body.
class DirectionField {
public:
    DirectionField(const PlaneResults& results, const PlaneCase& result, PrincipalFamily family)
        : mesh_(results.model()), locator_(results.locator()), result_(result), family_(family)
    {
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
            const PrincipalStress s = principal(
                result.smoothed_stress({ElementId(e), centroid(shape_of(mesh_.elements[e].kind).domain())}));
            largest_ = std::max(largest_, s.s1 - s.s2);
        }
    }

    bool has_material(const Vector2d& at) { return locate(at).has_value(); }

    /// A unit vector, the way that `heading` goes; nothing outside and at isotropic points.
    std::optional<Vector2d> direction(const Vector2d& at, const Vector2d& heading)
    {
        const auto place = locate(at);
        if (!place) return std::nullopt;
        const PrincipalStress s = principal(result_.smoothed_stress(*place));
        if (!(s.s1 - s.s2 > isotropic * largest_)) return std::nullopt;
        Vector2d d(std::cos(s.angle), std::sin(s.angle));
        if (family_ == PrincipalFamily::Second) d = Vector2d(-d.y(), d.x());
        return d.dot(heading) < 0.0 ? Vector2d(-d) : d;
    }

private:
    /// Mostly in the element that held the last place.
    std::optional<Location> locate(const Vector2d& at)
    {
        if (last_) {
            const PlaneElement& element = mesh_[*last_];
            const NaturalPlace near = natural_place(shape_of(element.kind), positions_of(mesh_, element), at);
            if (near.distance == 0.0) return Location{*last_, near.at};
        }
        for (const Location& place : locator_.find(at)) {
            const PlaneElement& element = mesh_[place.element];
            if (natural_place(shape_of(element.kind), positions_of(mesh_, element), at).distance > 1e-9) continue;
            last_ = place.element;
            return place;
        }
        return std::nullopt;
    }

    const PlaneModel& mesh_;
    const Locator& locator_;
    const PlaneCase& result_;
    PrincipalFamily family_;
    double largest_ = 0.0;
    std::optional<ElementId> last_;
};

/// Points of the lines that are there, in cells as wide as the spacing.
class LinePoints {
public:
    explicit LinePoints(double spacing) : spacing_(spacing) {}

    void add(const Vector2d& at) { cells_[key(at)].push_back(at); }
    bool is_free(const Vector2d& at, double distance) const
    {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const auto cell = cells_.find(key(at + spacing_ * Vector2d(dx, dy)));
                if (cell == cells_.end()) continue;
                for (const Vector2d& other : cell->second)
                    if ((other - at).squaredNorm() < distance * distance) return false;
            }
        return true;
    }

private:
    std::int64_t key(const Vector2d& at) const
    {
        const auto x = static_cast<std::int64_t>(std::floor(at.x() / spacing_)),
                   y = static_cast<std::int64_t>(std::floor(at.y() / spacing_));
        return x * 1000003 + y;
    }
    double spacing_;
    std::unordered_map<std::int64_t, std::vector<Vector2d>> cells_;
};

class TrajectoryWeb {
public:
    TrajectoryWeb(DirectionField& field, double spacing) : field_(field), spacing_(spacing), points_(spacing) {}

    void grow_from(const Vector2d& seed)
    {
        try_seed(seed);
        while (!queue_.empty()) {
            const std::size_t i = queue_.front();
            queue_.pop_front();
            const Trajectory line = lines_[i]; // the list grows
            for (std::size_t k = 0; k + 1 < line.size(); k += 3) {
                const Vector2d along = (line[k + 1] - line[k]).normalized();
                const Vector2d across = spacing_ * Vector2d(-along.y(), along.x());
                try_seed(line[k] + across);
                try_seed(line[k] - across);
            }
        }
    }
    std::vector<Trajectory> take() { return std::move(lines_); }

private:
    void try_seed(const Vector2d& seed)
    {
        if (!points_.is_free(seed, 0.999 * spacing_) || !field_.has_material(seed)) return;
        const auto start = field_.direction(seed, {1.0, 0.0});
        if (!start) return;
        Trajectory line{seed};
        const bool is_closed = grow(line, *start);
        if (!is_closed) {
            std::ranges::reverse(line);
            grow(line, -*start);
        }
        if (static_cast<double>(line.size()) * step_share < least_length) return;
        for (const Vector2d& at : line) points_.add(at);
        queue_.push_back(lines_.size());
        lines_.push_back(std::move(line));
    }

    /// Goes on from the last point. \returns whether the line has come back to its beginning
    bool grow(Trajectory& line, Vector2d heading)
    {
        const double h = step_share * spacing_;
        for (std::size_t i = 0; i < most_steps; ++i) {
            const Vector2d at = line.back();
            const auto first = field_.direction(at, heading);
            if (!first) return false;
            const auto middle = field_.direction(at + 0.5 * h * *first, *first);
            if (!middle || middle->dot(heading) < sharpest_turn) return false;
            const Vector2d next = at + h * *middle;
            if (!field_.has_material(next)) {
                reach_border(line, at, h * *middle);
                return false;
            }
            if (!points_.is_free(next, least_distance * spacing_)) return false;
            if (has_come_back(line, next)) {
                line.push_back(line.front());
                return true;
            }
            if (is_near_itself(line, next)) return false;
            line.push_back(next);
            heading = *middle;
        }
        return false;
    }

    /// As far as there is material.
    void reach_border(Trajectory& line, const Vector2d& at, const Vector2d& step)
    {
        double inside = 0.0, outside = 1.0;
        for (int i = 0; i < 12; ++i) {
            const double t = 0.5 * (inside + outside);
            (field_.has_material(at + t * step) ? inside : outside) = t;
        }
        if (inside > 0.01) line.push_back(at + inside * step);
    }

    bool has_come_back(const Trajectory& line, const Vector2d& next) const
    {
        return line.size() > 2 * own_neighbours && (next - line.front()).norm() < step_share * spacing_;
    }
    bool is_near_itself(const Trajectory& line, const Vector2d& next) const
    {
        const double least = least_distance * spacing_;
        for (std::size_t i = 0; i + own_neighbours < line.size(); ++i)
            if ((line[i] - next).squaredNorm() < least * least &&
                // its own beginning may be met
                (i > own_neighbours || (next - line.front()).squaredNorm() > 4.0 * least * least))
                return true;
        return false;
    }

    DirectionField& field_;
    double spacing_;
    LinePoints points_;
    std::deque<std::size_t> queue_;
    std::vector<Trajectory> lines_;
};

} // namespace

std::vector<Trajectory> trajectories(const PlaneResults& results, const PlaneCase& result, PrincipalFamily family,
                                     double spacing)
{
    DirectionField field(results, result, family);
    TrajectoryWeb web(field, spacing);
    // one seed in each element reaches every part of the body; most find a line nearby
    const PlaneModel& mesh = results.model();
    for (const PlaneElement& element : mesh.elements)
        web.grow_from(
            positions_of(mesh, element).topRows(shape_of(element.kind).n_corners()).colwise().mean().transpose());
    return web.take();
}

} // namespace femoop::plane
