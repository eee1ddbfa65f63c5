#pragma once

#include <cstddef>
#include <cstdint>

#include "topology/geometry/flat_point.h"

namespace fuzz {

/// Numbers out of the input; 0 when it is used up.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
    std::uint8_t next()
    {
        if (left_ == 0) return 0;
        --left_;
        return *data_++;
    }
    std::size_t left() const { return left_; }

private:
    const std::uint8_t* data_;
    std::size_t left_;
};

/// In the unit square, on a lattice, so that places often are in line or on one circle, or moved off it by very little.
inline topology::FlatPoint place(Bytes& bytes)
{
    const std::uint8_t x = bytes.next(), y = bytes.next();
    const int column = x / 16;
    const double off = x % 16 == 15 ? 1e-9 * (y % 16) : 0.0;
    return {(column + off) / 16.0, y / 256.0};
}

} // namespace fuzz
