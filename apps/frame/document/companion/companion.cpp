#include "apps/frame/document/companion/companion.h"

#include <algorithm>
#include <optional>

#include "femoop/edit/member_line.h"
#include "femoop/geometry/member_geometry.h"

namespace frame {

using namespace femoop;

namespace {

class NodeFollower {
public:
    NodeFollower(const Model& before, const Model& after) : before_(before), after_(after) {}

    /// The name that the node has now.
    std::optional<std::string> operator()(const std::string& name) const
    {
        if (after_.find_node(name)) return name;
        const auto was = before_.find_node(name);
        if (!was) return std::nullopt;
        if (const auto renamed = renamed_at(*was)) return renamed;
        return at_place_of(*was);
    }

private:
    std::optional<std::string> renamed_at(NodeId was) const
    {
        if (before_.nodes.size() != after_.nodes.size() || before_.find_node(after_[was].id)) return std::nullopt;
        return after_[was].id;
    }
    std::optional<std::string> at_place_of(NodeId was) const
    {
        const Eigen::Vector3d place = position_of(before_, was);
        const double near = nearness_of(before_);
        for (std::size_t i = 0; i < after_.nodes.size(); ++i)
            if ((position_of(after_, NodeId(i)) - place).norm() <= near) return after_.nodes[i].id;
        return std::nullopt;
    }

    const Model& before_;
    const Model& after_;
};

/// The id that a load case or combination has now. One that is gone keeps its name: another may have it again.
std::string case_now(const std::string& id, const Model& before, const Model& after)
{
    const auto was = before.find_case(id);
    const bool is_same_list = before.load_cases.size() == after.load_cases.size() &&
                              before.combinations.size() == after.combinations.size();
    if (!was || !is_same_list || after.find_case(id)) return id;
    const std::string now = after.case_name(*was);
    return before.find_case(now) ? id : now;
}

} // namespace

void follow(Companion& companion, const Model& before, const Model& after)
{
    const NodeFollower follower(before, after);
    for (DimensionLine& dimension : companion.dimensions) {
        std::vector<std::string> found;
        for (const std::string& name : dimension.nodes) {
            const auto now = follower(name);
            if (now && std::ranges::find(found, *now) == found.end()) found.push_back(*now);
        }
        if (found == dimension.nodes) continue;
        dimension.nodes = std::move(found);
        if (std::ranges::count(companion.dimensions, dimension) > 1) dimension.nodes.clear(); // what it lies on stays
    }
    std::erase_if(companion.dimensions, [](const DimensionLine& dimension) { return dimension.nodes.size() < 2; });
    for (NamedView& view : companion.views) {
        if (view.load_case) view.load_case = case_now(*view.load_case, before, after);
        for (std::string& id : view.envelope) id = case_now(id, before, after);
    }
}

} // namespace frame
