#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/show.h"
#include "apps/frame/document/drawing_names.h"

namespace frame {

/// The part of a plane model that is looked at, whatever the window's size.
struct Region {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double height = 1.0; ///< from the lower to the upper edge of the picture [length], > 0

    friend bool operator==(const Region& a, const Region& b) { return a.centre == b.centre && a.height == b.height; }
};

/// A way to look at the document, under a name: what a presenter walks through with PageDown and PageUp.
struct NamedView {
    std::string name;
    ShowSet show;
    std::optional<std::string> load_case; ///< its id; an envelope when absent
    std::vector<std::string> envelope{};  ///< ids of the cases that it is of; of all when empty
    double diagrams = 1.0, loads = 1.0;   ///< factors on their sizes, > 0
    std::optional<double> displacements;  ///< factor on them; automatic when absent
    std::optional<Region> region;         ///< the whole model when absent

    friend bool operator==(const NamedView&, const NamedView&) = default;
};

} // namespace frame
