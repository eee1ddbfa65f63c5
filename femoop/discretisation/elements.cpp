#include "femoop/discretisation/elements.h"

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

Elements::Elements(const Discretisation& structure) : members_(members_of(structure))
{
    all_.reserve(members_->size() + structure.bodies.size() + structure.foundations.size());
    for (std::size_t i = 0; i < members_->size(); ++i) all_.push_back(&(*members_)[i]);
    for (const auto& body : structure.bodies) all_.push_back(body.get());
    for (const auto& foundation : structure.foundations) all_.push_back(foundation.get());
}

} // namespace femoop
