#pragma once

#include <cstddef>
#include <string>

#include "apps/plane/outline/curve.h"
#include "apps/plane/outline/outline.h"

namespace outline {

/// What a reader has found so far.
class Gathering {
public:
    /// \throws topology::LineError where there are more than most_pieces
    void add(const Curve& curve, const Affine& map);
    void leave_out(const std::string& kind) { ++outline_.left_out[kind]; }
    void set_unit(femoop::LengthUnit unit) { outline_.unit = unit; }

    Outline take() { return std::move(outline_); }

private:
    Outline outline_;
    std::size_t n_pieces_ = 0;
};

/// A number of a file. \throws topology::LineError where it is none
double number(std::string_view word);

/// Coordinates beyond this [in the file's units] are no drawing's.
inline constexpr double largest_coordinate = 1e15;

} // namespace outline
