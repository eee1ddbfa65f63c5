#include "apps/euler/document/challenge/reach.h"

#include <algorithm>
#include <random>

#include "topology/halfedge/check/isomorphism.h"
#include "topology/modeling/construction.h"
#include "topology/modeling/lamina.h"
#include "topology/modeling/primitives.h"
#include "topology/modeling/revolve.h"
#include "topology/script/script_writer.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::EulerCounts;
using topology::EulerOperator;
using topology::Solid;
using ui::Message;
using ui::translatable;

struct Target {
    Message name;
    Solid solid;
    topology::Journal journal; ///< of how it was made
};

template <class Make> Target target(const Message& name, const Make& make)
{
    Target made{name, {}, {}};
    EulerOperator op(made.solid, made.journal);
    make(op);
    return made;
}

Target easy(std::uint32_t kind, int n)
{
    const Message::Argument corners("n", std::to_string(n));
    if (kind % 2 == 0)
        return target({translatable("a lamina of {n} corners"), {corners}},
                      [&](EulerOperator& op) { lamina(op, topology::regular_polygon(n, 2.0)); });
    return target({translatable("a lamina of {n} corners with a lone vertex in its front"), {corners}},
                  [&](EulerOperator& op) {
                      const topology::Lamina made = lamina(op, topology::regular_polygon(n, 2.0));
                      op.mvr(made.front, {});
                  });
}

Target middle(std::uint32_t kind, int n)
{
    const Message::Argument corners("n", std::to_string(n));
    if (kind % 2 == 0)
        return target({translatable("a pyramid over {n} corners"), {corners}},
                      [&](EulerOperator& op) { add_cone(op, n, 2.0, 3.0); });
    return target({translatable("a prism over {n} corners"), {corners}},
                  [&](EulerOperator& op) { add_prism(op, n, 2.0, 3.0); });
}

Target hard(std::uint32_t kind, int n)
{
    const Message::Argument corners("n", std::to_string(n));
    if (kind % 3 == 0)
        return target(translatable("a torus of one vertex, two edges and one face"), [](EulerOperator& op) {
            const topology::LoneVertex first = op.mvfs({});
            const topology::NewFace disk = op.mef(first.half_edge, first.half_edge);
            op.kfmrh(first.face, disk.face);
            op.mekr(disk.plus, disk.minus);
        });
    if (kind % 3 == 1)
        return target({translatable("a profile of {n} corners, turned in three steps to a torus"), {corners}},
                      [&](EulerOperator& op) {
                          std::vector<topology::Point> profile;
                          for (const topology::Point& p : topology::regular_polygon(n, 1.0))
                              profile.push_back({3.0 + p.x, 0.0, -p.y});
                          revolve_closed(op, profile, 3);
                      });
    return target({translatable("a prism over {n} corners and, inside it, a void like a block"), {corners}},
                  [&](EulerOperator& op) {
                      add_prism(op, n, 4.0, 3.0);
                      add_void(op, {-1, -1, 1}, {1, 1, 1});
                  });
}

/// The first count that is not the target's, and the operator that changes it.
Message difference(const EulerCounts& now, const EulerCounts& wanted)
{
    if (now.S < wanted.S) return translatable("a shell is missing: MVFS opens one");
    if (now.G < wanted.G) return translatable("a handle is missing: KFMRH of two faces of one shell makes one");
    if (now.V < wanted.V) return translatable("vertices are missing: MEV makes one with its edge");
    if (now.F < wanted.F) return translatable("faces are missing: MEF divides one");
    if (now.V > wanted.V) return translatable("there are too many vertices: go back, or kill one with KEV");
    if (now.F > wanted.F) return translatable("there are too many faces: go back, or kill one with KEF");
    if (now.L < wanted.L) return translatable("a ring is missing: MVR or KEMR makes one");
    if (now.L > wanted.L) return translatable("there are too many rings: MEKR joins one to another loop");
    if (now.S > wanted.S) return translatable("there are too many shells: KFMRH joins two");
    if (now.G > wanted.G) return translatable("there are too many handles: MFKRH takes one away");
    return translatable("the counts agree, but not the structure: compare how many edges each face has");
}

struct Path {
    std::string script;
    std::size_t n_operators;
};

/// As it was made, or by inversion: the one knows MVR, the other needs no detour.
Path shortest_way(const Target& made)
{
    const std::size_t n_made = made.journal.n_done(), n_inverted = construction(made.solid).journal.n_done();
    const topology::NamedSolid solid{.name = "s1", .solid = made.solid, .journal = made.journal, .names = {}};
    if (n_made < n_inverted) return {journal_script(solid), n_made};
    return {construction_script(solid), n_inverted};
}

} // namespace

ReachChallenge reach_challenge(std::uint32_t seed, Level level)
{
    std::mt19937 random(seed);
    const auto kind = static_cast<std::uint32_t>(random());
    const int n = 3 + static_cast<int>(random() % 4);
    Target made = level == Level::Easy ? easy(kind, n) : level == Level::Middle ? middle(kind, n) : hard(kind, n);
    Path way = shortest_way(made);
    Message task(translatable("Make {what} with at most {n} operators."),
                 {{"what", std::move(made.name)}, {"n", std::to_string(way.n_operators)}});
    return {.task = std::move(task),
            .target = std::move(made.solid),
            .way = std::move(way.script),
            .most_operators = way.n_operators};
}

ReachState judged(const ReachChallenge& challenge, const Stepper& attempt)
{
    ReachState state;
    for (std::size_t i = 1; i <= attempt.place(); ++i) state.n_operators += attempt.n_operators(i);
    const auto& solids = attempt.runner().solids();
    const auto made = std::find_if(solids.begin(), solids.end(), [](const auto& solid) { return solid.is_alive(); });
    if (made == solids.end()) {
        state.hint = translatable("nothing is there yet: begin with MVFS");
        return state;
    }
    const EulerCounts now = euler_counts(made->solid), wanted = euler_counts(challenge.target);
    state.is_reached = now == wanted && are_alike(made->solid, challenge.target);
    state.is_won = state.is_reached && state.n_operators <= challenge.most_operators;
    if (!state.is_reached) state.hint = difference(now, wanted);
    else if (!state.is_won) state.hint = translatable("the solid is right; it takes fewer operators");
    return state;
}

} // namespace euler
