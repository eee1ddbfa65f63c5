#include "apps/plane/discretize/edge_divisions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "apps/plane/discretize/entry_name.h"

namespace discretize {

namespace {

using femoop::FaultKind;
using topology::EdgeId;
using topology::FlatPoint;
using topology::HalfEdgeId;

/// Equal parts, or such that the last is `ratio` times the first.
EdgeShares geometric(std::size_t n, double ratio)
{
    EdgeShares shares{0.0};
    const double factor = n > 1 ? std::pow(ratio, 1.0 / static_cast<double>(n - 1)) : 1.0;
    double part = 1.0;
    for (std::size_t i = 0; i < n; ++i) {
        shares.push_back(shares.back() + part);
        part *= factor;
    }
    for (double& share : shares) share /= shares.back();
    for (std::size_t i = 0; ratio == 1.0 && i <= n; ++i) shares[i] = static_cast<double>(i) / static_cast<double>(n);
    shares.back() = 1.0;
    return shares;
}

EdgeShares backwards(const EdgeShares& shares)
{
    EdgeShares result;
    for (auto each = shares.rbegin(); each != shares.rend(); ++each) result.push_back(1.0 - *each);
    return result;
}

/// The shares from one index to another, as of a length of their own.
EdgeShares part_of(const EdgeShares& shares, std::size_t from, std::size_t to)
{
    EdgeShares part;
    for (std::size_t i = from; i <= to; ++i) part.push_back((shares[i] - shares[from]) / (shares[to] - shares[from]));
    return part;
}

/// Of the points that have a size of their own.
topology::SizeField field_of_points(const PlaneModel& model)
{
    std::vector<topology::SizeField::Sample> samples;
    for (const auto& point : model.points)
        if (point.size) samples.push_back({{point.at[0], point.at[1]}, *point.size});
    return {std::move(samples), topology::usual_growth};
}

constexpr double most_parts = 1e7; // of an edge, more than a mesh may have

/// The least whole number of parts that are no longer than wanted, but for rounding.
std::size_t least_parts(double wanted)
{
    return static_cast<std::size_t>(std::clamp(std::ceil(wanted * (1.0 - 1e-9)), 1.0, most_parts));
}

} // namespace

EdgeDivisions::EdgeDivisions(const Drawing& drawing, const std::vector<FaceOutline>& outlines,
                             const std::vector<MeshSettings>& settings)
    : drawing_(drawing), outlines_(outlines), settings_(settings), mapped_(outlines.size())
{
    const topology::PlanarSubdivision& plane = drawing.subdivision();
    const std::size_t n_edges = plane.solid().edges().n_rows();
    lengths_.assign(n_edges, 0.0);
    sizes_.assign(n_edges, 0.0);
    for (const EdgeId e : plane.solid().edges())
        lengths_[e.index] = plane.curve(plane.part(e).curve).length(plane.part(e).span);
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const auto add = [&](EdgeId e) {
            double& size = sizes_[e.index];
            size = size > 0.0 ? std::min(size, settings[i].size) : settings[i].size;
        };
        for (const OutlineLoop& loop : outlines[i].loops)
            for (const HalfEdgeId h : loop) add(*plane.solid().edge(h));
        for (const EdgeId e : outlines[i].inner_edges) add(e);
    }
    field_ = given_field() != nullptr ? *given_field() : field_of_points(drawing.model());
    find_mapped();
    do {
        shares_.assign(n_edges, std::nullopt);
        divide_as_written();
    } while (!spread());
    divide_rest();
}

void EdgeDivisions::find_mapped()
{
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
        const bool is_asked = settings_[i].is_map();
        if (!is_asked && (settings_[i].method != "auto" || given_field() != nullptr)) continue;
        MappedAttempt attempt = mapped_outline(drawing_, outlines_[i], settings_[i]);
        mapped_[i] = std::move(attempt.sides);
        if (attempt.fault && is_asked) faults_.push_back(*attempt.fault);
    }
}

/// In place of what the drawing says; null: none. All settings have the same.
const topology::SizeField* EdgeDivisions::given_field() const
{
    return settings_.empty() ? nullptr : settings_.front().field.get();
}

/// Where two curves run along one edge the greater number is taken.
void EdgeDivisions::divide_as_written()
{
    if (given_field() != nullptr) return;
    const auto pieces = pieces_of_curves(drawing_);
    for (std::size_t c = 0; c < pieces.size(); ++c) {
        const auto& shape = drawing_.model().curves[c].shape;
        if (!shape || shape->divide.empty()) continue;
        for (std::size_t i = 0; i < pieces[c].size(); ++i) {
            const auto& division = shape->divide[shape->is_divided_by_piece ? i : 0];
            EdgeShares shares = geometric(static_cast<std::size_t>(division.n),
                                          division.ratio ? division.ratio->value() : 1.0);
            auto& known = shares_[pieces[c][i].edge.index];
            if (known && known->size() >= shares.size()) continue;
            known = pieces[c][i].is_forward ? std::move(shares) : backwards(shares);
        }
    }
}

const std::optional<EdgeShares>& EdgeDivisions::edge_shares(HalfEdgeId h) const
{
    return shares_[drawing_.subdivision().solid().edge(h)->index];
}

bool EdgeDivisions::is_known(const OutlineLoop& side) const
{
    return std::all_of(side.begin(), side.end(), [&](HalfEdgeId h) { return is_known(h); });
}

std::size_t EdgeDivisions::n_parts(const OutlineLoop& side) const
{
    std::size_t n = 0;
    for (const HalfEdgeId h : side) {
        const auto& known = edge_shares(h);
        n += (known ? known->size() : usual(*drawing_.subdivision().solid().edge(h)).size()) - 1;
    }
    return n;
}

EdgeShares EdgeDivisions::along(const OutlineLoop& side) const
{
    EdgeShares all{0.0};
    double before = 0.0;
    const topology::Solid& solid = drawing_.subdivision().solid();
    for (const HalfEdgeId h : side) {
        const EdgeShares& of_edge = *edge_shares(h);
        const EdgeShares shares = solid.plus(*solid.edge(h)) == h ? of_edge : backwards(of_edge);
        for (std::size_t i = 1; i < shares.size(); ++i) all.push_back(before + shares[i] * length(h));
        before += length(h);
    }
    for (double& share : all) share /= before;
    return all;
}

void EdgeDivisions::set(HalfEdgeId h, EdgeShares shares)
{
    const topology::Solid& solid = drawing_.subdivision().solid();
    const EdgeId e = *solid.edge(h);
    shares_[e.index] = solid.plus(e) == h ? std::move(shares) : backwards(shares);
}

std::vector<EdgeDivisions::OppositeSides> EdgeDivisions::opposite_sides() const
{
    std::vector<OppositeSides> all;
    for (std::size_t i = 0; i < mapped_.size(); ++i) {
        if (!mapped_[i]) continue;
        const MappedOutline& sides = *mapped_[i];
        if (sides.size() == 3)
            for (std::size_t k = 0; k < 3; ++k) all.push_back({i, &sides[k], &sides[(k + 1) % 3]});
        else
            for (const std::size_t k : {0U, 1U}) all.push_back({i, &sides[k], &sides[k + 2]});
    }
    return all;
}

/// Divides the edges of a side that are not divided yet, so that it has as many parts as the one opposite, at the same
/// places where all of it is to be divided. False where it cannot have.
bool EdgeDivisions::copy(const OutlineLoop& from, const OutlineLoop& to)
{
    std::vector<HalfEdgeId> open;
    std::size_t n_known = 0;
    double open_length = 0.0;
    for (const HalfEdgeId h : to) {
        if (is_known(h)) {
            n_known += edge_shares(h)->size() - 1;
            continue;
        }
        open.push_back(h);
        open_length += length(h);
    }
    const EdgeShares wanted = backwards(along(from));
    const std::size_t n = wanted.size() - 1;
    if (n < n_known + open.size()) return false;
    const EdgeShares places = n_known == 0 ? wanted : geometric(n - n_known, 1.0);
    std::size_t before = 0;
    double reached = 0.0;
    for (std::size_t i = 0; i < open.size(); ++i) {
        reached += length(open[i]) / open_length;
        const std::size_t last = places.size() - (open.size() - i); // as many are left for those that follow
        std::size_t here = i + 1 == open.size() ? places.size() - 1 : before + 1;
        while (here < last && std::abs(places[here + 1] - reached) < std::abs(places[here] - reached)) ++here;
        set(open[i], part_of(places, before, here));
        before = here;
    }
    return true;
}

/// From sides that are known to those opposite, as long as that divides something.
bool EdgeDivisions::spread_known()
{
    bool has_spread = true;
    while (std::exchange(has_spread, false))
        for (const auto& [outline, a, b] : opposite_sides()) {
            const bool knows_a = is_known(*a), knows_b = is_known(*b);
            if (knows_a == knows_b) continue;
            has_spread = true;
            if (copy(knows_a ? *a : *b, knows_a ? *b : *a)) continue;
            if (settings_[outline].method == "auto") {
                mapped_[outline].reset();
                return false;
            }
            for (const HalfEdgeId h : knows_a ? *b : *a) divide_as_usual(h);
        }
    return true;
}

void EdgeDivisions::divide_as_usual(HalfEdgeId h)
{
    const EdgeId e = *drawing_.subdivision().solid().edge(h);
    if (!shares_[e.index]) shares_[e.index] = usual(e);
}

/// Of opposite sides that are both not known, those with the most parts are divided as usual. False where there are none.
bool EdgeDivisions::settle_greatest()
{
    std::size_t most = 0;
    const OutlineLoop* side = nullptr;
    for (const auto& [outline, a, b] : opposite_sides())
        for (const OutlineLoop* const each : {a, b})
            if (!is_known(*a) && !is_known(*b) && n_parts(*each) > most) {
                most = n_parts(*each);
                side = each;
            }
    if (side == nullptr) return false;
    const bool is_known_in_part = std::any_of(side->begin(), side->end(), [&](HalfEdgeId h) { return is_known(h); });
    for (const HalfEdgeId h : *side) divide_as_usual(h);
    if (wants_even() && !is_known_in_part) make_even(*side);
    return true;
}

/// Whether a trilateral region of quadrilaterals may take the number of parts that another region settles.
bool EdgeDivisions::wants_even() const
{
    return std::any_of(settings_.begin(), settings_.end(), [](const MeshSettings& settings) {
        return settings.is_trilateral() && !settings.is_triangle();
    });
}

void EdgeDivisions::make_even(const OutlineLoop& side)
{
    if (n_parts(side) % 2 == 0) return;
    const auto longest = std::max_element(side.begin(), side.end(),
                                          [&](HalfEdgeId a, HalfEdgeId b) { return length(a) < length(b); });
    const EdgeId e = *drawing_.subdivision().solid().edge(*longest);
    shares_[e.index] = usual(e, 1);
}

bool EdgeDivisions::spread()
{
    do {
        if (!spread_known()) return false;
    } while (settle_greatest());
    return agree();
}

/// Whether opposite sides have equally many parts. One that is mapped of itself is so no longer where they have not.
bool EdgeDivisions::agree()
{
    for (const auto& [outline, a, b] : opposite_sides()) {
        if (!mapped_[outline]) continue; // its other sides have told it already
        const std::size_t n_a = n_parts(*a), n_b = n_parts(*b);
        const MeshSettings& settings = settings_[outline];
        const std::string entry = entry_of("regions", drawing_.model().regions, outlines_[outline].region.index);
        const bool is_odd = settings.is_trilateral() && !settings.is_triangle() && n_a % 2 == 1;
        if (n_a == n_b && !is_odd) continue;
        const bool is_auto = settings.method == "auto";
        if (n_a == n_b)
            faults_.push_back(
                {FaultKind::TrilateralOdd, {entry, std::string(name(settings.element)), std::to_string(n_a)}});
        else if (!is_auto)
            faults_.push_back(
                {settings.is_trilateral() ? FaultKind::TrilateralSidesDiffer : FaultKind::MappedSidesDiffer,
                 {entry, curves_of(*a), std::to_string(n_a), curves_of(*b), std::to_string(n_b)}});
        mapped_[outline].reset();
        if (is_auto) return false;
    }
    return true;
}

/// "bottom, right"
std::string EdgeDivisions::curves_of(const OutlineLoop& side) const
{
    std::string names;
    femoop::plane::CurveId last;
    for (const HalfEdgeId h : side) {
        const topology::PlanarSubdivision& plane = drawing_.subdivision();
        const auto curve = drawing_.owner(plane.part(*plane.solid().edge(h)).curve);
        if (!names.empty() && curve == last) continue;
        names += (names.empty() ? "\"" : ", \"") + drawing_.model()[curve].id + "\"";
        last = curve;
    }
    return names;
}

double EdgeDivisions::size_at(EdgeId e, double share) const
{
    const topology::PlanarSubdivision& plane = drawing_.subdivision();
    const topology::CurvePart& part = plane.part(e);
    const topology::Curve& curve = plane.curve(part.curve);
    const FlatPoint at = share == 0.0 ? curve.at(part.span.from) : curve.at(curve.at_share(part.span, share));
    return std::max(std::min(sizes_[e.index], field_.at(at)), lengths_[e.index] / most_parts);
}

/// Shares of an edge's length, so dense that the size that is wanted changes little from one to the next.
std::vector<double> EdgeDivisions::samples_of(EdgeId e) const
{
    constexpr int n_even = 256, most_halvings = 12;
    constexpr double most_of_size = 0.5; // between two of them
    std::vector<double> samples{0.0};
    const auto add_up_to = [&](const auto& self, double to, int n_left) -> void {
        const double from = samples.back();
        const bool is_dense = n_left == 0 || (to - from) * lengths_[e.index] <= most_of_size * size_at(e, to);
        if (is_dense) return samples.push_back(to);
        self(self, 0.5 * (from + to), n_left - 1);
        self(self, to, n_left - 1);
    };
    for (int i = 1; i <= n_even; ++i) add_up_to(add_up_to, static_cast<double>(i) / n_even, most_halvings);
    return samples;
}

/// Parts of the size that is wanted where the edge runs.
EdgeShares EdgeDivisions::usual(EdgeId e, std::size_t n_more) const
{
    const topology::PlanarSubdivision& plane = drawing_.subdivision();
    const topology::CurvePart& part = plane.part(e);
    const double length = lengths_[e.index];
    std::vector<double> wanted{0.0}; // parts up to each sample
    const std::vector<double> samples = field_.is_empty() ? std::vector<double>{0.0, 1.0} : samples_of(e);
    double before = size_at(e, 0.0);
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double here = size_at(e, samples[i]);
        wanted.push_back(wanted.back() + 0.5 * (1.0 / before + 1.0 / here) * length * (samples[i] - samples[i - 1]));
        before = here;
    }
    const topology::Solid& solid = plane.solid();
    const bool is_closed = solid.start(solid.plus(e)) == solid.end(solid.plus(e));
    const std::size_t n = std::max({least_parts(wanted.back()),
                                    least_parts(plane.curve(part.curve).turning(part.span) / (0.25 * std::numbers::pi)),
                                    std::size_t{is_closed ? 3U : 1U}}) +
                          n_more;
    if (field_.is_empty()) return geometric(n, 1.0);
    EdgeShares shares{0.0};
    for (std::size_t i = 1, at = 0; i < n; ++i) {
        const double sought = wanted.back() * static_cast<double>(i) / static_cast<double>(n);
        while (wanted[at + 1] < sought) ++at;
        shares.push_back(samples[at] +
                         (sought - wanted[at]) / (wanted[at + 1] - wanted[at]) * (samples[at + 1] - samples[at]));
    }
    shares.push_back(1.0);
    return shares;
}

void EdgeDivisions::divide_rest()
{
    for (const EdgeId e : drawing_.subdivision().solid().edges())
        if (!shares_[e.index] && sizes_[e.index] > 0.0) shares_[e.index] = usual(e);
}

} // namespace discretize
