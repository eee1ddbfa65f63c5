#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "femoop/model/quantity/quantity.h"

namespace femoop::plane {

/// A value that may vary in the plane, as a file gives it: of a load, a temperature or a settlement.
///
///      5                          the same everywhere
///      [a, b]                     linear in the length along a curve, from its start to its end
///      polynomial [[c, i, j]..]   sum of c x^i y^j
///      table along x, y, r or s   linear between places that ascend, constant beyond the first and the last
struct Field {
    struct Ends {
        Quantity start, end;
        friend bool operator==(const Ends&, const Ends&) = default;
    };

    static constexpr int highest_power = 12;
    struct Term {
        Quantity factor; ///< [value / length^(i + j)]
        int i = 0, j = 0;
        friend bool operator==(const Term&, const Term&) = default;
    };
    using Polynomial = std::vector<Term>;

    enum class Along : std::uint8_t {
        x,
        y,
        r, ///< the distance from `about`
        s  ///< the length from the start of the curve
    };
    struct Table {
        Along along = Along::x;
        std::vector<Quantity> about;                     ///< x and y; the origin when empty
        std::vector<std::pair<Quantity, Quantity>> rows; ///< place, value
        friend bool operator==(const Table&, const Table&) = default;
    };

    std::variant<Quantity, Ends, Polynomial, Table> form;

    friend bool operator==(const Field&, const Field&) = default;
};

/// Where a field is asked for its value.
struct FieldPlace {
    double x = 0.0, y = 0.0;
    double s = 0.0;      ///< the length from the start of the curve
    double length = 0.0; ///< of the curve
};

double value(const Field& field, const FieldPlace& at);

/// Where a place lies along a table.
double place_along(const Field::Table& table, const FieldPlace& at);

/// Does it vary along a curve, so that it means nothing without one?
bool needs_curve(const Field& field);

} // namespace femoop::plane
