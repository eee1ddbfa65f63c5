#include "topology/modeling/revolve.h"

#include <cmath>
#include <numbers>

#include "topology/modeling/band.h"
#include "topology/modeling/lamina.h"
#include "topology/modeling/sweep.h"

namespace topology {

namespace {

Point turned(const Point& p, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// The half-edges of a wire in its direction, from the one at `first` on.
std::vector<HalfEdgeId> along(const Solid& solid, HalfEdgeId first, std::size_t n)
{
    std::vector<HalfEdgeId> chain{first};
    while (chain.size() < n) chain.push_back(solid.next(chain.back()));
    return chain;
}

/// One step: the chain's image beside it, on its left. \returns the image's half-edges
std::vector<HalfEdgeId> step(EulerOperator& op, const std::vector<HalfEdgeId>& chain, const std::vector<Point>& image)
{
    const Solid& solid = op.solid();
    const HalfEdgeId end = solid.next(chain.back());
    std::vector<HalfEdgeId> back; // from each image to its original
    for (std::size_t i = 1; i < chain.size(); ++i) back.push_back(op.mev(chain[i], image[i]).plus);
    std::vector<HalfEdgeId> made{op.mef(chain.front(), back.front()).plus};
    for (std::size_t i = 1; i < back.size(); ++i) made.push_back(op.mef(back[i - 1], back[i]).plus);
    made.push_back(op.mef(back.back(), end).plus);
    return made;
}

} // namespace

FaceId revolve(EulerOperator& op, const std::vector<Point>& profile, int n)
{
    const Solid& solid = op.solid();
    const LoneVertex pole = op.mvfs(profile.front());
    wire(op, pole.half_edge, {profile.begin() + 1, profile.end()});
    const std::vector<HalfEdgeId> first = along(solid, pole.half_edge, profile.size() - 1);
    std::vector<HalfEdgeId> chain = first;
    for (int i = 1; i < n; ++i) {
        std::vector<Point> image;
        for (const Point& p : profile) image.push_back(turned(p, -2.0 * std::numbers::pi * i / n));
        chain = step(op, chain, image);
    }
    // The face that is left lies between the last chain and the other side of the first.
    for (std::size_t i = 1; i < chain.size(); ++i) op.mef(solid.mate(first[i - 1]), chain[i]);
    return pole.face;
}

void revolve_closed(EulerOperator& op, const std::vector<Point>& profile, int k)
{
    const double angle = 2.0 * std::numbers::pi / k;
    const Lamina made = lamina(op, profile);
    const HalfEdgeId back = op.solid().mate(made.first);
    HalfEdgeId front = made.first;
    for (int i = 1; i < k; ++i) {
        const VertexId v = op.solid().start(front);
        const Sweep swept = sweep(op, made.front, [&](const Point& p) { return turned(p, angle); });
        for (const SweptVertex& moved : swept.vertices)
            for (const HalfEdgeId h : op.solid().chain(op.solid().outer(made.front)))
                if (moved.from == v && op.solid().start(h) == moved.image) front = h;
    }
    op.kfmrh(made.front, made.back);
    // `back` runs from the second point to the first one; the corner at the first is its next.
    add_band(op, front, op.solid().next(back));
}

} // namespace topology
