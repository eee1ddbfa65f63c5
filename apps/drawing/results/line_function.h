#pragma once

#include "femoop/result/curve.h"

#include <optional>
#include <vector>

namespace drawing {

/// A function of the place along a line of the structure, which a diagram is drawn of: a section force of a member, an
/// influence line, whatever has ordinates. Between two of its breaks it is smooth; it jumps at breaks alone.
///
/// Units  places in the model's unit of length, from the line's start
class LineFunction {
public:
    virtual ~LineFunction() = default;

    virtual double length() const = 0;
    virtual std::vector<double> breaks() const = 0; ///< ascending: the first is 0, the last is length()
    virtual double value(double x, femoop::Side side = femoop::Side::After) const = 0;
    /// Both sides of jumps counted; of equal values the first.
    virtual femoop::Extremes extremes() const = 0;
    /// Where the slope is known, it tells kinks worth a number.
    virtual std::optional<double> slope(double x, femoop::Side side) const = 0;
    virtual std::vector<double> level_places() const = 0; ///< where the slope passes through zero, ascending
};

/// A section force of a solved case, along a member. Of bending moments the slope is the shear force; that of others is
/// not asked for: their kinks and level places say nothing to who reads a diagram.
class SectionForce final : public LineFunction {
public:
    /// \pre the curve outlives it
    SectionForce(const femoop::Curve& curve, femoop::MemberComponent component);

    double length() const override { return curve_.length(); }
    std::vector<double> breaks() const override { return curve_.breaks(); }
    double value(double x, femoop::Side side = femoop::Side::After) const override
    {
        return curve_.value(component_, x, side);
    }
    femoop::Extremes extremes() const override { return extremes_; }
    std::optional<double> slope(double x, femoop::Side side) const override;
    std::vector<double> level_places() const override;

private:
    const femoop::Curve& curve_;
    femoop::MemberComponent component_;
    femoop::Extremes extremes_;
};

} // namespace drawing
