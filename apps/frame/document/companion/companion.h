#pragma once

#include <vector>

#include "apps/drawing/dimension.h"
#include "apps/frame/document/companion/named_view.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/document/named_sets.h"

namespace frame {

/// What a document holds beside its model: nothing that a solution depends on. A plain value, saved in a file of its
/// own (companion_file.h), since the model file is for every program that solves.
struct Companion {
    std::vector<DimensionLine> dimensions;
    std::vector<NamedSet> sets;   ///< supports and loads under names
    std::vector<NamedView> views; ///< in the order of a walk through them

    bool is_empty() const { return *this == Companion{}; }
    friend bool operator==(const Companion&, const Companion&) = default;
};

/// Goes on from one state of a model to the next. A node that has another name at its old place in the list was
/// renamed; one that is gone is the one that now lies where it lay, as after a merge; where there is none it is taken
/// out, and with it a dimension line that has less than two left or that has become the same as another. A view follows
/// the load cases and combinations that it shows to their new names.
void follow(Companion& companion, const femoop::Model& before, const femoop::Model& after);

} // namespace frame
