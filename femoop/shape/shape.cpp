#include "femoop/shape/shape.h"

#include <array>

#include "femoop/shape/line2.h"
#include "femoop/shape/line3.h"
#include "femoop/shape/q4.h"
#include "femoop/shape/q8.h"
#include "femoop/shape/q9.h"
#include "femoop/shape/t3.h"
#include "femoop/shape/t6.h"

namespace femoop {

namespace {

template <class S> const Shape& the_one()
{
    static const S shape;
    return shape;
}

struct ShapeEntry {
    ShapeKind kind;
    std::string_view name;
    const Shape& (*shape)();
};

/// In the order of ShapeKind.
constexpr std::array shape_entries{
    ShapeEntry{ShapeKind::Line2, "Line2", the_one<Line2>}, ShapeEntry{ShapeKind::Line3, "Line3", the_one<Line3>},
    ShapeEntry{ShapeKind::T3, "T3", the_one<T3>},          ShapeEntry{ShapeKind::T6, "T6", the_one<T6>},
    ShapeEntry{ShapeKind::Q4, "Q4", the_one<Q4>},          ShapeEntry{ShapeKind::Q8, "Q8", the_one<Q8>},
    ShapeEntry{ShapeKind::Q9, "Q9", the_one<Q9>}};

constexpr auto all_shape_kinds = [] {
    std::array<ShapeKind, shape_entries.size()> kinds{};
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = shape_entries[i].kind;
    return kinds;
}();

const ShapeEntry& shape_entry(ShapeKind kind) { return shape_entries[static_cast<std::size_t>(kind)]; }

} // namespace

std::string_view name(ShapeKind kind) { return shape_entry(kind).name; }

std::span<const ShapeKind> shape_kinds() { return all_shape_kinds; }

const Shape& shape_of(ShapeKind kind) { return shape_entry(kind).shape(); }

} // namespace femoop
