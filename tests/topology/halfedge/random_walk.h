#pragma once

#include <cstdint>
#include <random>

#include "topology/halfedge/operators/euler_operator.h"

/// Applies operators at random to a solid, legal ones, of every kind and in every corner case.
class RandomWalk {
public:
    explicit RandomWalk(std::uint32_t seed) : random_(seed), make_(solid, journal) {}

    /// One more step; kinds that make are `growth` times as likely as those that kill.
    topology::OperatorKind step(double growth = 1.0);
    bool attempt(topology::OperatorKind kind); ///< once, at a random place; false if it is refused there

    topology::Solid solid;
    topology::Journal journal;
    topology::EulerOperator& op() { return make_; }
    std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(random_() % n); }

private:
    bool attempt_on_edges(topology::OperatorKind kind);
    bool attempt_on_faces(topology::OperatorKind kind);
    topology::OperatorKind any_kind(double growth);
    topology::HalfEdgeId any_half_edge();
    topology::FaceId any_face();
    topology::LoopId any_loop();
    topology::HalfEdgeId some_in_fan(topology::HalfEdgeId h);
    topology::HalfEdgeId some_in_chain(topology::HalfEdgeId h);
    topology::Point any_point();

    std::mt19937 random_;
    topology::EulerOperator make_;
};
