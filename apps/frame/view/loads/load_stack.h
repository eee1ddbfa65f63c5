#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>
#include <vector>

namespace frame {

/// How high the loads on one member stand already on each side, so that the next ones stand on top of them.
class LoadStack {
public:
    /// Pixels taken on the side that `away` points to.
    double height(const Eigen::Vector3d& away) const
    {
        double most = 0.0;
        for (const auto& [side, taken] : sides_)
            if (side.dot(away) > 0.5) most = std::max(most, taken);
        return most;
    }
    void raise(const Eigen::Vector3d& away, double height) { sides_.emplace_back(away, height); }

private:
    std::vector<std::pair<Eigen::Vector3d, double>> sides_;
};

} // namespace frame
