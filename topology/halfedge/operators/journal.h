#pragma once

#include <cstddef>
#include <vector>

#include "topology/halfedge/operators/step.h"

namespace topology {

/// Every operator that was applied to a solid, oldest first, with what its inverse needs: 32 bytes a step. Steps that
/// were undone wait for redo, until another operator takes their place.
/// A journal belongs to the solid that it was written with, and is copied beside it.
class Journal {
public:
    std::size_t n_done() const { return n_done_; }
    std::size_t n_undone() const { return steps_.size() - n_done_; }
    const Step& operator[](std::size_t i) const { return steps_[i]; } ///< done, then undone ones
    const Point& moved_from() const { return points_.back(); }        ///< \pre a MOVE was done last of all MOVEs
    std::size_t bytes() const { return steps_.capacity() * sizeof(Step) + points_.capacity() * sizeof(Point); }

    friend bool operator==(const Journal&, const Journal&) = default;

private:
    friend class EulerOperator;
    void add(const Step& step)
    {
        if (n_undone() != 0) forget_undone();
        steps_.push_back(step);
        ++n_done_;
    }
    void forget_undone()
    {
        steps_.resize(n_done_);
        undone_points_.clear();
    }

    std::vector<Step> steps_;
    std::size_t n_done_ = 0;
    std::vector<Point> points_;        ///< where the vertices of done MOVEs were before
    std::vector<Point> undone_points_; ///< which redo gives the vertices that it makes or moves again
};

} // namespace topology
