#pragma once

#include <optional>
#include <vector>

#include "topology/halfedge/operators/step.h"
#include "topology/halfedge/tables.h"

namespace topology {

/// One entity became two, or two became one: of MEF the face and its loop, of SEMV the edge, of MEV the vertex whose
/// edges were divided, and the other way round for their inverses.
struct SplitOrJoin {
    Entity stays;
    Entity other; ///< made by a split, killed by a join

    friend bool operator==(const SplitOrJoin&, const SplitOrJoin&) = default;
};

/// What one operator did, told when it is done. An operator that is undone is told as its inverse.
struct Change {
    OperatorKind kind = OperatorKind::MVFS;
    std::vector<Entity> created;
    std::vector<Entity> killed;
    /// Entities that lived before and live on: all whose links became others, among some that only stand beside these.
    std::vector<Entity> changed;
    std::vector<SplitOrJoin> split, joined;
};

/// What the step did to the tables, which are as it left them.
Change change(const Tables& after, const Step& step);
Change reversed(Change change);

/// Something that follows a solid: a view, or attributes of its entities.
class Observer {
public:
    virtual ~Observer() = default;
    virtual void changed(const Change& change) = 0; ///< the operator is done, the solid is sound
};

} // namespace topology
