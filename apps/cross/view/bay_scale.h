#pragma once

#include <vector>

namespace cross {

/// How places along a beam are drawn where its sketch is not to scale: piecewise linear and growing from node to node,
/// to scale beyond the ends.
class BayScale {
public:
    BayScale() = default; ///< to scale

    /// \param places  of the nodes, ascending  \param drawn  where they are drawn, ascending; as many
    BayScale(std::vector<double> places, std::vector<double> drawn);

    bool is_to_scale() const { return places_.size() < 2; }
    double operator()(double place) const;
    double inverse(double drawn) const;

private:
    std::vector<double> places_, drawn_;
};

/// Breadths of bays beside each other that fill a breadth: each at least what it needs, and beyond that in proportion
/// to its length.
/// \pre the needs are no more than the breadth, the lengths positive
std::vector<double> breadths(const std::vector<double>& lengths, const std::vector<double>& needs, double breadth);

} // namespace cross
