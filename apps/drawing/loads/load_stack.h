#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace drawing {

/// A part of a member, as lengths from its first end; a point where both are equal.
struct Reach {
    double from = 0.0, to = 0.0;

    /// Loads that merely touch stand side by side; a point belongs to both.
    bool meets(const Reach& other) const
    {
        const double apart = std::max(from, other.from) - std::min(to, other.to);
        const double tiny = 1e-9 * std::max(std::abs(to), std::abs(other.to));
        return from == to || other.from == other.to ? apart <= tiny : apart < -tiny;
    }
};

/// How high the loads on one member stand already on each side, so that the next ones stand on top of them.
class LoadStack {
public:
    /// Pixels taken over a part of the member on the side that `away` points to.
    double height(const Eigen::Vector3d& away, const Reach& over) const
    {
        double most = 0.0;
        for (const Taken& one : taken_)
            if (one.side.dot(away) > 0.5 && one.over.meets(over)) most = std::max(most, one.height);
        return most;
    }
    void raise(const Eigen::Vector3d& away, const Reach& over, double height)
    {
        taken_.push_back({away, over, height});
    }

private:
    struct Taken {
        Eigen::Vector3d side;
        Reach over;
        double height = 0.0;
    };
    std::vector<Taken> taken_;
};

} // namespace drawing
