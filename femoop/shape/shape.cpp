#include "femoop/shape/shape.h"

#include <array>

#include "femoop/shape/line2.h"
#include "femoop/shape/line3.h"
#include "femoop/shape/q4.h"
#include "femoop/shape/q8.h"
#include "femoop/shape/t3.h"
#include "femoop/shape/t6.h"

namespace femoop {

namespace {

constexpr std::array all_shape_kinds{ShapeKind::Line2, ShapeKind::Line3, ShapeKind::T3,
                                     ShapeKind::T6,    ShapeKind::Q4,    ShapeKind::Q8};
constexpr std::array<std::string_view, all_shape_kinds.size()> shape_names{"Line2", "Line3", "T3", "T6", "Q4", "Q8"};

template <class S> const Shape& the_one()
{
    static const S shape;
    return shape;
}

} // namespace

std::string_view name(ShapeKind kind) { return shape_names[static_cast<std::size_t>(kind)]; }

std::span<const ShapeKind> shape_kinds() { return all_shape_kinds; }

const Shape& shape_of(ShapeKind kind)
{
    switch (kind) {
    case ShapeKind::Line2: return the_one<Line2>();
    case ShapeKind::Line3: return the_one<Line3>();
    case ShapeKind::T3: return the_one<T3>();
    case ShapeKind::T6: return the_one<T6>();
    case ShapeKind::Q4: return the_one<Q4>();
    case ShapeKind::Q8: break;
    }
    return the_one<Q8>();
}

} // namespace femoop
