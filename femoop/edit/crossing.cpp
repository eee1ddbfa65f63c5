#include "femoop/edit/crossing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace femoop {

namespace {

/// Tells which crossings are new.
class Crossroads {
public:
    Crossroads(const Model& model, const MovedParts& moved, std::size_t n_copies)
        : moved_(moved), nearness_(nearness_of(model))
    {
        std::size_t n_new = 0;
        for (const Member& member : model.members) {
            lines_.push_back(line_of(model, member));
            boxes_.push_back(box_around(lines_.back()));
            origins_.push_back({moved.former(member), n_new});
            if (!origins_.back().former) ++n_new;
        }
        copy_size_ = std::max<std::size_t>(n_new / n_copies, 1);
        for (std::size_t i = 0; i < lines_.size(); ++i) likes_.push_back(origins_[like_of(model, i)]);
    }

    std::optional<Eigen::Vector3d> between(std::size_t i, std::size_t j) const
    {
        if (!boxes_[i].intersects(boxes_[j])) return std::nullopt; // of most pairs, and told soon
        const std::optional<Eigen::Vector3d> place = crossing(lines_[i], lines_[j], nearness_);
        const bool is_new = place && !is_on_purpose(origins_[i], origins_[j]) && !is_on_purpose(likes_[i], likes_[j]);
        return is_new ? place : std::nullopt;
    }

private:
    struct Origin {
        std::optional<MemberId> former;
        std::size_t number; ///< among the new ones
    };

    Eigen::AlignedBox3d box_around(const MemberLine& line) const
    {
        const Eigen::Vector3d margin = Eigen::Vector3d::Constant(nearness_), end = line.at(line.length);
        return {line.start.cwiseMin(end) - margin, line.start.cwiseMax(end) + margin};
    }

    /// The member that stayed where this one has come to lie, and will be one with it; itself where there is none.
    std::size_t like_of(const Model& model, std::size_t i) const
    {
        if (!moved_.is_moved(model, MemberId(i))) return i;
        for (std::size_t j = 0; j < lines_.size(); ++j)
            if (are_alike(i, j) && !moved_.is_moved(model, MemberId(j))) return j;
        return i;
    }

    bool are_alike(std::size_t i, std::size_t j) const
    {
        const MemberLine &a = lines_[i], &b = lines_[j];
        const auto are_near = [this](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
            return (p - q).squaredNorm() <= nearness_ * nearness_;
        };
        const Eigen::Vector3d end = a.at(a.length), other_end = b.at(b.length);
        return (are_near(a.start, b.start) && are_near(end, other_end)) ||
               (are_near(a.start, other_end) && are_near(end, b.start));
    }

    bool is_on_purpose(const Origin& a, const Origin& b) const
    {
        if (!a.former && !b.former) return a.number / copy_size_ == b.number / copy_size_;
        if (!a.former || !b.former) return false;
        const Model& before = moved_.before();
        return crossing(line_of(before, before[*a.former]), line_of(before, before[*b.former]), nearness_of(before))
            .has_value();
    }

    const MovedParts& moved_;
    double nearness_;
    std::vector<MemberLine> lines_;
    std::vector<Eigen::AlignedBox3d> boxes_;
    std::vector<Origin> origins_, likes_; ///< its own, and that of what it has come to lie on
    std::size_t copy_size_ = 1;
};

} // namespace

std::optional<Eigen::Vector3d> crossing(const MemberLine& a, const MemberLine& b, double nearness)
{
    const Eigen::Vector3d r = b.start - a.start;
    const double cosine = a.direction.dot(b.direction), sine_squared = 1.0 - cosine * cosine;
    if (sine_squared < 1e-12) return std::nullopt;
    const double s = (r.dot(a.direction) - cosine * r.dot(b.direction)) / sine_squared;
    const double t = (cosine * r.dot(a.direction) - r.dot(b.direction)) / sine_squared;
    const bool is_inside = s > nearness && s < a.length - nearness && t > nearness && t < b.length - nearness;
    if (!is_inside || (a.at(s) - b.at(t)).norm() > nearness) return std::nullopt;
    return b.at(t);
}

std::vector<Eigen::Vector3d> new_crossings(const Model& model, const MovedParts& moved, std::size_t n_copies)
{
    const Crossroads crossroads(model, moved, n_copies);
    std::vector<bool> is_moved;
    for (std::size_t i = 0; i < model.members.size(); ++i) is_moved.push_back(moved.is_moved(model, MemberId(i)));
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        if (!is_moved[i]) continue;
        for (std::size_t j = 0; j < model.members.size(); ++j) {
            if (j == i || (is_moved[j] && j > i)) continue; // each pair once
            if (const std::optional<Eigen::Vector3d> place = crossroads.between(i, j)) places.push_back(*place);
        }
    }
    return places;
}

} // namespace femoop
