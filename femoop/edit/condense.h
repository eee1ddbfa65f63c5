#pragma once

#include "femoop/model/model.h"

namespace femoop {

/// Equal in all but their names. How a number was typed does not count: "210 GPa" is 210e6 kN/m^2.
bool are_alike(const Material& a, const Material& b);
bool are_alike(const Section& a, const Section& b);

/// What condensing a model takes out.
struct Condensed {
    std::size_t n_equal = 0;  ///< materials and sections that are like an earlier one
    std::size_t n_unused = 0; ///< those that no member has

    friend bool operator==(const Condensed&, const Condensed&) = default;
};

/// Makes one of materials that are alike, and of sections: the earlier stays, members of the later get it. Those that
/// no member has go. No result changes.
Condensed condense(Model& model);

} // namespace femoop
