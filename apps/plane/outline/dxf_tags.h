#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "apps/plane/outline/curve.h"

namespace outline {

/// A group of a DXF file: two lines, what is told and the value.
struct DxfTag {
    int code = 0;
    std::string_view value;
    std::size_t line = 0; ///< of the value, from 1
};

/// All groups of a file. \throws topology::LineError
std::vector<DxfTag> dxf_tags(std::string_view text);

double number(const DxfTag& tag); ///< \throws topology::LineError naming its line

/// What a file says of one thing, from its group 0 to the next.
struct DxfEntity {
    std::string_view type;
    std::size_t line = 0;
    std::vector<DxfTag> tags{};

    bool has(int code) const { return find(code) != nullptr; }
    std::string_view text(int code) const; ///< "" where there is none
    double number(int code, double absent) const;
    int flags(int code) const;   ///< 0 where there is none
    Place place(int code) const; ///< x of this code and y of the one ten further on, 0 where there is none
    std::vector<double> numbers(int code) const; ///< in their order
    std::vector<Place> places(int code) const;

private:
    const DxfTag* find(int code) const;
};

} // namespace outline
