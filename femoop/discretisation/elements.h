#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/element/straight_member.h"

namespace femoop {

/// The elements of a structure: its members, in order, then its bodies, then its foundations. To be used while the
/// discretisation lives.
class Elements {
public:
    explicit Elements(const Discretisation& structure);

    std::size_t size() const { return all_.size(); }
    const Element& operator[](std::size_t i) const { return *all_[i]; }
    const StraightMember& operator[](MemberId member) const { return (*members_)[member.index]; }

private:
    std::unique_ptr<const MemberBlock> members_;
    std::vector<const Element*> all_; ///< the members first
};

} // namespace femoop
