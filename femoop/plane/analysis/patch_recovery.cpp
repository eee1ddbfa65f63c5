#include "femoop/plane/analysis/patch_recovery.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

constexpr double told_apart = 1e-3; // of a term: what the terms before it leave of it
constexpr int most_terms = 8;       // of a polynomial of a patch
constexpr int most_values = 8;      // of a row of samples

using RowOfTerms = Eigen::Matrix<double, 1, most_terms>;
using RowOfValues = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, most_values>;

/// The terms 1, x, y, x y, x^2, y^2, x^2 y, x y^2 of a point.
RowOfTerms all_terms(const Eigen::Vector2d& p)
{
    const double x = p.x(), y = p.y();
    RowOfTerms terms;
    terms << 1.0, x, y, x * y, x * x, y * y, x * x * y, x * y * y;
    return terms;
}

/// A polynomial that is fitted to values at points, of those terms that the points can tell apart, low ones first.
///
/// Method  the terms made orthonormal one after the other, twice, so that least squares ask for no equations:
///         terms = Q R, R c = Q' values
class PatchFit {
public:
    PatchFit(const Eigen::Vector2d& middle, double size, const ValueTable& places, const ValueTable& values,
             std::span<const int> wanted)
        : middle_(middle), size_(size)
    {
        const Eigen::Index n = places.rows();
        Eigen::Matrix<double, Eigen::Dynamic, most_terms> all(n, most_terms), Q(n, most_terms);
        for (Eigen::Index i = 0; i < n; ++i) all.row(i) = terms(places.row(i).transpose());
        Eigen::Matrix<double, most_terms, most_terms> R = R.Zero();
        for (const int term : wanted) {
            const Eigen::Index k = n_kept_;
            if (k == n) break;
            auto rest = Q.col(k);
            rest = all.col(term);
            for (int twice = 0; twice < 2; ++twice) {
                const SmallVector along = Q.leftCols(k).transpose().lazyProduct(rest);
                rest -= Q.leftCols(k).lazyProduct(along);
                R.col(k).head(k) += along;
            }
            R(k, k) = rest.norm();
            if (R(k, k) <= told_apart * all.col(term).norm()) {
                R.col(k).setZero();
                continue;
            }
            rest /= R(k, k);
            kept_[static_cast<std::size_t>(n_kept_++)] = term;
        }
        coefficients_ = Q.leftCols(n_kept_).transpose().lazyProduct(values);
        R.topLeftCorner(n_kept_, n_kept_).triangularView<Eigen::Upper>().solveInPlace(coefficients_);
    }

    RowOfValues at(const Eigen::Vector2d& place) const
    {
        const RowOfTerms here = terms(place);
        RowOfValues sum = RowOfValues::Zero(coefficients_.cols());
        for (Eigen::Index i = 0; i < n_kept_; ++i)
            sum += here[kept_[static_cast<std::size_t>(i)]] * coefficients_.row(i);
        return sum;
    }

private:
    using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_terms, 1>;

    RowOfTerms terms(const Eigen::Vector2d& place) const { return all_terms((place - middle_) / size_); }

    Eigen::Vector2d middle_;
    double size_;
    Eigen::Index n_kept_ = 0;
    std::array<int, most_terms> kept_{}; ///< indices of all_terms
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_terms, most_values> coefficients_;
};

/// The terms that a patch of such elements is fitted by, those first that come first.
std::span<const int> wanted_terms(ShapeKind kind)
{
    static constexpr std::array<int, most_terms> low_ones_first{0, 1, 2, 3, 4, 5, 6, 7};
    const std::span<const int> all(low_ones_first);
    switch (kind) {
    case ShapeKind::T3: return all.first(3);
    case ShapeKind::Q4: return all.first(4);
    case ShapeKind::T6: return all.first(6);
    default: return all;
    }
}

} // namespace

std::span<const ShapeAtPoint> recovery_points(ShapeKind kind)
{
    const auto of_plane_shapes = [] {
        std::array<std::vector<ShapeAtPoint>, 7> tables;
        for (const ShapeKind each : shape_kinds()) {
            const Shape& shape = shape_of(each);
            const IntegrationRule in_triangle = symmetric_triangle(shape.degree() == 1 ? 1 : 3);
            if (shape.edge_kind())
                tables[static_cast<std::size_t>(each)] = tabulated(
                    shape, shape.domain() == Domain::Triangle ? in_triangle : gauss_quadrilateral(2));
        }
        return tables;
    };
    static const std::array<std::vector<ShapeAtPoint>, 7> tables = of_plane_shapes();
    return tables[static_cast<std::size_t>(kind)];
}

RecoveryWeights extrapolation(ShapeKind kind, NaturalPoint at)
{
    if (kind == ShapeKind::T3) return RecoveryWeights::Ones(1);
    const std::span<const ShapeAtPoint> points = recovery_points(kind);
    if (kind == ShapeKind::T6) {
        Eigen::Matrix3d A;
        for (int i = 0; i < 3; ++i)
            A.row(i) << 1.0, points[static_cast<std::size_t>(i)].at.xi, points[static_cast<std::size_t>(i)].at.eta;
        return (Eigen::RowVector3d(1.0, at.xi, at.eta) * A.inverse()).transpose();
    }
    RecoveryWeights weights(4);
    for (int i = 0; i < 4; ++i) {
        const auto [xi, eta] = points[static_cast<std::size_t>(i)].at; // of +- 1 / sqrt 3
        weights[i] = 0.25 * (1.0 + at.xi / xi) * (1.0 + at.eta / eta);
    }
    return weights;
}

SampleNumbers::SampleNumbers(const PlaneModel& model)
{
    first_.reserve(model.elements.size() + 1);
    first_.push_back(0);
    for (const PlaneElement& element : model.elements)
        first_.push_back(first_.back() + recovery_points(element.kind).size());
}

PatchRecovery::PatchRecovery(const PlaneModel& model) : model_(model), samples_(model), first_slot_{0}
{
    for (const PlaneElement& element : model.elements)
        first_slot_.push_back(first_slot_.back() + element.points.size());
    number_slots();
    find_borders();
    list_elements();
}

void PatchRecovery::number_slots()
{
    std::vector<std::vector<std::pair<RegionId, std::uint32_t>>> of_node(model_.points.size());
    slots_.reserve(first_slot_.back());
    for (const PlaneElement& element : model_.elements) {
        const auto n_corners = static_cast<std::size_t>(shape_of(element.kind).n_corners());
        for (std::size_t i = 0; i < element.points.size(); ++i) {
            auto& known = of_node[element.points[i].index];
            auto found = std::ranges::find(known, element.region, [](const auto& entry) { return entry.first; });
            if (found == known.end()) {
                known.emplace_back(element.region, static_cast<std::uint32_t>(slot_nodes_.size()));
                found = known.end() - 1;
                slot_nodes_.push_back(element.points[i]);
                slot_regions_.push_back(element.region);
                is_corner_.push_back(false);
            }
            slots_.push_back(found->second);
            if (i < n_corners) is_corner_[found->second] = true;
        }
    }
}

/// An edge that one element of the region alone has lies on its border.
void PatchRecovery::find_borders()
{
    struct Side {
        std::uint32_t a, b;
        std::size_t element;
        int edge;
    };
    std::vector<Side> sides;
    for (std::size_t e = 0; e < model_.elements.size(); ++e)
        for (int i = 0; const Shape::Edge edge : shape_of(model_.elements[e].kind).edges()) {
            const auto a = static_cast<std::uint32_t>(slot(ElementId(e), static_cast<std::size_t>(edge[0])));
            const auto b = static_cast<std::uint32_t>(slot(ElementId(e), static_cast<std::size_t>(edge[1])));
            sides.push_back({std::min(a, b), std::max(a, b), e, i++});
        }
    std::ranges::sort(sides, {}, [](const Side& side) { return std::pair(side.a, side.b); });
    is_on_border_.assign(slot_nodes_.size(), false);
    const auto same = [&](std::size_t i, std::size_t j) {
        return j < sides.size() && sides[i].a == sides[j].a && sides[i].b == sides[j].b;
    };
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (same(i, i + 1) || (i > 0 && same(i, i - 1))) continue;
        const PlaneElement& element = model_.elements[sides[i].element];
        for (const int node : shape_of(element.kind).edges()[static_cast<std::size_t>(sides[i].edge)])
            is_on_border_[slot(ElementId(sides[i].element), static_cast<std::size_t>(node))] = true;
    }
}

void PatchRecovery::list_elements()
{
    elements_start_.assign(slot_nodes_.size() + 1, 0);
    for (const std::uint32_t slot : slots_) ++elements_start_[slot + 1];
    std::partial_sum(elements_start_.begin(), elements_start_.end(), elements_start_.begin());
    elements_of_.resize(slots_.size());
    std::vector<std::uint32_t> next(elements_start_.begin(), elements_start_.end() - 1);
    for (std::size_t e = 0; e < model_.elements.size(); ++e)
        for (std::size_t i = 0; i < model_.elements[e].points.size(); ++i)
            elements_of_[next[slot(ElementId(e), i)]++] = static_cast<std::uint32_t>(e);
}

/// Goes from patch to patch and adds up what they say of nodes.
class PatchSweep {
public:
    PatchSweep(const PlaneModel& model, const PatchRecovery& recovery, const ValueTable& samples,
               const ValueTable& places)
        : model_(model),
          recovery_(recovery),
          samples_(samples),
          places_(places),
          sums_(ValueTable::Zero(static_cast<Eigen::Index>(recovery.n_values()), samples.cols())),
          counts_(recovery.n_values(), 0)
    {}

    PatchFit fit(std::span<const std::uint32_t> elements, NodeId around) const
    {
        Eigen::Index n = 0;
        for (const std::uint32_t e : elements) n += n_samples(e);
        ValueTable places(n, 2), values(n, samples_.cols());
        ShapeKind kind = model_.elements[elements.front()].kind;
        for (Eigen::Index row = 0; const std::uint32_t e : elements) {
            const auto first = static_cast<Eigen::Index>(recovery_.samples().first(ElementId(e)));
            places.middleRows(row, n_samples(e)) = places_.middleRows(first, n_samples(e));
            values.middleRows(row, n_samples(e)) = samples_.middleRows(first, n_samples(e));
            row += n_samples(e);
            kind = std::min(kind, model_.elements[e].kind);
        }
        const Eigen::Vector2d middle = position(model_[around]);
        const double size = (places.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
        return {middle, size, places, values, wanted_terms(kind)};
    }

    void add(std::size_t slot, const PatchFit& patch)
    {
        sums_.row(static_cast<Eigen::Index>(slot)) += patch.at(position(model_[recovery_.node_of(slot)]));
        ++counts_[slot];
    }
    bool has(std::size_t slot) const { return counts_[slot] > 0; }

    ValueTable means() const
    {
        ValueTable means = sums_;
        for (std::size_t i = 0; i < counts_.size(); ++i)
            if (counts_[i] > 0) means.row(static_cast<Eigen::Index>(i)) /= counts_[i];
        return means;
    }

private:
    Eigen::Index n_samples(std::uint32_t e) const
    {
        return static_cast<Eigen::Index>(recovery_points(model_.elements[e].kind).size());
    }

    const PlaneModel& model_;
    const PatchRecovery& recovery_;
    const ValueTable &samples_, &places_;
    ValueTable sums_;
    std::vector<int> counts_;
};

ValueTable PatchRecovery::nodal_values(const ValueTable& samples, const ValueTable& places) const
{
    PatchSweep sweep(model_, *this, samples, places);
    const auto around = [&](std::size_t slot) {
        return std::span(elements_of_)
            .subspan(elements_start_[slot], elements_start_[slot + 1] - elements_start_[slot]);
    };
    const auto others_of = [&](std::span<const std::uint32_t> elements, auto&& wanted) {
        std::vector<std::size_t> slots;
        for (const std::uint32_t e : elements)
            for (std::size_t i = 0; i < model_.elements[e].points.size(); ++i)
                if (const std::size_t other = slot(ElementId(e), i); wanted(other)) slots.push_back(other);
        std::ranges::sort(slots);
        slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
        return slots;
    };
    const auto with_neighbours = [&](std::uint32_t e) {
        std::set<std::uint32_t> elements;
        for (std::size_t i = 0; i < model_.elements[e].points.size(); ++i)
            for (const std::uint32_t other : around(slot(ElementId(e), i))) elements.insert(other);
        return std::vector<std::uint32_t>(elements.begin(), elements.end());
    };
    for (std::size_t i = 0; i < n_values(); ++i) { // patches inside
        if (!is_corner_[i] || is_on_border_[i]) continue;
        const std::span<const std::uint32_t> elements = around(i);
        const PatchFit patch = sweep.fit(elements, node_of(i));
        sweep.add(i, patch);
        for (const std::size_t other :
             others_of(elements, [&](std::size_t j) { return !is_corner_[j] || is_on_border_[j]; }))
            sweep.add(other, patch);
    }
    std::vector<std::pair<std::size_t, std::vector<std::size_t>>> own; // patches of corners of the border
    for (std::size_t i = 0; i < n_values(); ++i)
        if (is_corner_[i] && !sweep.has(i))
            own.emplace_back(i, others_of(around(i), [&](std::size_t j) { return !is_corner_[j] && !sweep.has(j); }));
    const auto patch_of = [&](std::size_t corner) {
        const std::span<const std::uint32_t> elements = around(corner);
        return sweep.fit(elements.size() == 1 ? with_neighbours(elements.front()) : elements, node_of(corner));
    };
    for (const auto& [corner, middles] : own) {
        const PatchFit patch = patch_of(corner);
        sweep.add(corner, patch);
        for (const std::size_t middle : middles) sweep.add(middle, patch);
    }
    for (std::size_t i = 0; i < n_values();
         ++i) { // between corners that other patches reach, such as from border to border
        if (sweep.has(i)) continue;
        for (const std::size_t corner : others_of(around(i), [&](std::size_t j) { return is_corner_[j]; }))
            sweep.add(i, patch_of(corner));
    }
    return sweep.means();
}

} // namespace femoop::plane
