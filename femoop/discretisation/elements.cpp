#include "femoop/discretisation/elements.h"

#include <utility>

namespace femoop {

namespace {

/// Numbers that are equal where members that follow one another have the same stiffness: most structures repeat
/// themselves.
class StiffnessGroups {
public:
    std::uint32_t next(const Discretisation::MemberRow& row, const Eigen::Vector3d& span)
    {
        const bool is_alike = group_ > 0 && row.properties == last_.properties &&
                              row.end_conditions == last_.end_conditions && span == span_;
        if (!is_alike) ++group_;
        last_ = row;
        span_ = span;
        return group_;
    }

private:
    std::uint32_t group_ = 0;
    Discretisation::MemberRow last_{};
    Eigen::Vector3d span_ = Eigen::Vector3d::Zero();
};

std::unique_ptr<const MemberBlock> members_of(const Discretisation& structure)
{
    StiffnessGroups groups;
    return make_members(structure.kind, structure.members.size(), [&](std::size_t i) {
        MemberData data = structure.data(MemberId(i));
        data.stiffness_group = groups.next(structure.members[i], *data.positions[1] - *data.positions[0]);
        return data;
    });
}

} // namespace

Elements::Elements(const Discretisation& structure, std::vector<std::unique_ptr<const Element>> others)
    : members_(members_of(structure)), others_(std::move(others))
{
    all_.reserve(members_->size() + others_.size());
    for (std::size_t i = 0; i < members_->size(); ++i) all_.push_back(&(*members_)[i]);
    for (const auto& other : others_) all_.push_back(other.get());
}

} // namespace femoop
