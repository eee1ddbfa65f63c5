#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/model/check/check_parts.h"
#include "femoop/model/check/entry_checker.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"
#include "femoop/model/quantity/dimension.h"

namespace femoop {

/// Goes through a model part by part and writes down what is wrong with it.
class Checker : private EntryChecker {
public:
    Checker(const Model& model, const Unreadable& unreadable)
        : EntryChecker(model.units), model_(model), unreadable_(unreadable), is_incomplete_(unreadable.is_incomplete)
    {}
    std::vector<Fault> run(Thoroughness thoroughness);
    std::vector<Fault> run_line(const InfluenceLineDefinition& line, const Entry& place); ///< of this one alone
    std::vector<Fault> run_train(const Train& train, const Entry& place);                 ///< likewise
    std::vector<Fault> run_effect(const MovingEffect& effect, const Entry& place);        ///< likewise

private:
    using Point = std::array<double, 3>;
    struct Axis {
        Point start{}, end{};
        double length = 0.0;
    };
    enum class End : std::uint8_t { Start, Finish };

    // checker.cpp
    using EntryChecker::shown;
    std::string shown(Point point) const;
    std::string analysis() const { return std::string(name(model_.analysis)); }
    bool is_within_reach(NodeId id) const; ///< can its place be reckoned with?
    bool is_readable(NodeId id) const { return id.index < model_.nodes.size() && !flag(unreadable_.nodes, id.index); }
    bool is_readable(MemberId id) const
    {
        return id.index < model_.members.size() && !flag(unreadable_.members, id.index);
    }
    bool is_readable(MaterialId id) const
    {
        return id.index < model_.materials.size() && !flag(unreadable_.materials, id.index);
    }
    bool is_readable(SectionId id) const
    {
        return id.index < model_.sections.size() && !flag(unreadable_.sections, id.index);
    }
    bool is_located(const Member& member) const { return is_readable(member.nodes[0]) && is_readable(member.nodes[1]); }

    // structure_check.cpp
    void check_ids();
    void check_references(const Member& member, const Entry& place);
    void check_materials();
    void check_sections();
    void check_section(const Section& section, const Entry& place);
    void check_nodes();
    void check_node(const Node& node, const Entry& place);
    void check_support(const Support& support, const Entry& place);
    void check_members();
    void check_member(const Member& member, const Entry& place);
    void check_length(const Member& member, const Entry& place);
    void check_up(const Member& member, const Entry& place);
    void check_end(const Member& member, End which, const Entry& place);
    void check_truss_offset(const Member& member, End which, const Entry& place);
    void check_section_for(const Member& member);
    void check_use();
    static Axis with_length(Axis axis);
    Axis axis(const Member& member) const;      ///< of the part between the offsets
    Axis node_axis(const Member& member) const; ///< from node to node

    // foundation_check.cpp
    void check_foundation(const Member& member, const Entry& place);

    // taper_check.cpp
    void check_depths(const Member& member, const Entry& place);

    // shape_check.cpp
    void check_shape(const SectionShape& shape, const Entry& place);
    void check_profile(const std::string& profile, const Entry& place);

    // load_check.cpp
    void check_load_cases();
    void check_self_weight(const LoadCase& load_case, const Entry& place);
    void check_load(const NodeLoad& load, const Entry& place);
    void check_load(const Settlement& settlement, const Entry& place);
    void check_load(const MemberLoad& load, const Entry& place);
    void check_span(const DistributedLoad& load, const Member& member, const Entry& place);
    void check_span(const PointLoad& load, const Member& member, const Entry& place);
    void check_span(const EndLoads& load, const Member& member, const Entry& place);
    void check_span(const TemperatureLoad& load, const Member& member, const Entry& place);
    void check_span(const Misfit& load, const Member& member, const Entry& place);
    void check_torque(const Member& member, LoadAxes axes, const std::vector<Component>& parts, const Entry& place);
    void check_load_dof(Dof dof, LoadAxes axes, std::string_view component, const Entry& place);
    std::optional<double> check_position(const Position& position, std::string_view key, const Member& member,
                                         const Entry& place);

    // expected_check.cpp
    void check_expected();
    void check_expected(const Expected& check, const Entry& place);
    void check_asked(const Expected& check, const Entry& place); ///< what is asked for, whatever its value

    // moving_load_check.cpp
    void check_moving_loads();
    bool check_path(const std::vector<MemberId>& members, const Entry& place); ///< do they make one?
    void warn_of_bars(const std::vector<MemberId>& members, const Entry& place);
    void check_line(const InfluenceLineDefinition& line, const Entry& place);
    void check_effect(const MovingEffect& effect, const Entry& place);
    void check_moving_load(const LoadPathReference& path, const std::vector<Component>& load, const Entry& place);

    // train_check.cpp
    void check_trains();
    void check_train(const Train& train, const Entry& place);
    void check_spacings(const Train& train, const Entry& place);
    void check_envelope(const MovingEnvelope& envelope, const Entry& place);

    // geometry_check.cpp
    void check_coincident_nodes();
    void check_crossings();

    const Model& model_;
    const Unreadable& unreadable_;
    bool is_incomplete_ = false;                                ///< what looks unused may be meant where a fault is
    std::vector<bool> has_member_;                              ///< per node
    std::set<std::pair<std::uint32_t, std::string_view>> said_; ///< section and property that it lacks
};

} // namespace femoop
