#include "femoop/io/cross/stage_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "femoop/io/reader/place.h"
#include "femoop/methods/cross/props.h"
#include "femoop/methods/cross/symmetry.h"
#include "femoop/methods/cross/virtual_work.h"

namespace femoop::cross {

namespace {

constexpr double same_direction = 1e-9;

std::string place_of(std::size_t stage, std::string_view key)
{
    return "cross.stages[" + std::to_string(stage) + "]." + std::string(key);
}

std::string words_of(const Block::Prop& prop)
{
    std::string words = prop.node.value_or("");
    if (prop.dof) words += " " + std::string(name(*prop.dof));
    return words;
}

/// Where the sways can be held: "B ux, C ux".
std::string choices(const Model& model, const Problem& problem)
{
    constexpr std::size_t most = 12;
    std::vector<std::string> found;
    for (std::size_t n = 0; n < model.nodes.size() && found.size() < most; ++n)
        for (const std::size_t axis : {0U, 1U})
            if (moves(problem, {NodeId(n), prop_axes(model, NodeId(n))[axis]}))
                found.push_back(model.nodes[n].id + (axis == 0 ? " ux" : " uy"));
    std::string list;
    for (const std::string& one : found) list += (list.empty() ? "" : ", ") + one;
    return list;
}

/// "B ux + E ux": props that hold every sway.
std::string own_props(const Model& model, const Problem& problem)
{
    std::string words;
    for (const Sway& sway : problem.sways) {
        const bool is_along = std::abs(sway.direction.dot(prop_axes(model, sway.prop)[0])) > 0.5;
        words += (words.empty() ? "" : " + ") + model[sway.prop].id + (is_along ? " ux" : " uy");
    }
    return words;
}

[[noreturn]] void refuse(const Model& model, const Problem& problem, const std::string& place, const Block::Prop& prop)
{
    throw ModelError({{FaultKind::UnknownChoice, {place, words_of(prop), choices(model, problem)}}});
}

/// Where a file's prop stands; without a direction of its own along that in which the node moves.
Prop prop_of(const Model& model, const Problem& problem, const Block::Prop& wanted, const std::string& place)
{
    if (!wanted.node && problem.sways.size() == 1) return {problem.sways[0].prop, problem.sways[0].direction};
    const std::optional<NodeId> node = wanted.node ? model.find_node(*wanted.node) : std::nullopt;
    if (!node) refuse(model, problem, place, wanted);
    if (wanted.direction && !wanted.dof) {
        if (const Prop prop{*node, wanted.direction->normalized()}; moves(problem, prop)) return prop;
        refuse(model, problem, place, wanted);
    }
    const auto axes = prop_axes(model, *node);
    for (const std::size_t axis : {0U, 1U})
        if (!wanted.dof || *wanted.dof == (axis == 0 ? Dof::ux : Dof::uy))
            if (const Prop prop{*node, axes[axis]}; moves(problem, prop)) return prop;
    refuse(model, problem, place, wanted);
}

bool is_at(const Sway& sway, const Prop& prop)
{
    return sway.prop == prop.node && (sway.direction - prop.direction).norm() < same_direction;
}

/// The props that the file names, then as many of our own as hold the rest: of those the file of a half is silent.
std::vector<Prop> all_props(std::vector<Prop> named, const Problem& whole)
{
    for (const Sway& sway : whole.sways) {
        if (named.size() == whole.sways.size()) break;
        std::vector<Prop> more = named;
        more.push_back({sway.prop, sway.direction});
        if (hold_apart(whole, more)) named = std::move(more);
    }
    return named;
}

class StageCheck {
public:
    StageCheck(SheetCheck& check)
        : check_(check), problem_(check.problem()), stages_(check.block().stages), tr_(check.tr())
    {}

    void run()
    {
        std::size_t n_sways = 0;
        for (number_ = 0; number_ < stages_.size(); ++number_) {
            stage_ = &stages_[number_];
            whose_ = fill(tr_("cross: stage {0}"), {std::to_string(number_ + 1)});
            if (stage_->sway) check_sway(sway_named(*stage_->sway));
            else if (stage_->is_propped || number_ == 0) check_held();
            else check_sway(sway_in_order(n_sways));
            n_sways += stage_->is_propped || number_ == 0 ? 0 : 1;
        }
    }

private:
    std::size_t sway_in_order(std::size_t n) const
    {
        if (n < problem_.sways.size()) return n;
        refuse(check_.model(), problem_, place_of(number_, "sway"), {});
    }

    /// The sway that moves the node: its prop's, or the only one.
    std::size_t sway_named(const Block::Prop& wanted) const
    {
        const std::string place = place_of(number_, "sway");
        const Prop prop = prop_of(check_.model(), problem_, wanted, place);
        std::vector<std::size_t> found;
        for (std::size_t k = 0; k < problem_.sways.size(); ++k) {
            if (is_at(problem_.sways[k], prop)) return k;
            Problem alone = problem_;
            alone.sways = {problem_.sways[k]};
            if (moves(alone, prop)) found.push_back(k);
        }
        if (found.size() == 1) return found.front();
        refuse(check_.model(), problem_, place, wanted);
    }

    void check_held()
    {
        const Sheet sheet = check_sheet(problem_.of_sheet(0), problem_.loading);
        const Moments total{sheet.end.moments, sheet.end.rotations};
        check_props(holding_forces(problem_, total), largest_force(sheet.end.moments));
        if (!is_exact_wanted()) return;
        find_exact();
        check_exact(strained_->loaded(), unstrained_->loaded());
    }

    void check_sway(std::size_t k)
    {
        const Sway sway = scaled(problem_.sways[k]);
        // A half that is worked by symmetry is that of the sway itself.
        const Sheet sheet = check_sheet(problem_.of_sheet(k + 1), sway.loading);
        const Moments total{sheet.end.moments, sheet.end.rotations};
        check_props(holding_forces(problem_, total, sway), largest_force(sheet.end.moments));
        if (!is_exact_wanted()) return;
        find_exact();
        check_exact(strained_->moved(k, sway.scale), unstrained_->moved(k, sway.scale), k);
    }

    Sheet check_sheet(const Problem& half, const Loading& loading)
    {
        check_.row(fill(tr_("{0}: fixed-end moments"), {whose_}), stage_->fixed_end, loading.fixed_end,
                   check_.of_sheet());
        Sheet sheet = check_.worked(half, loading, stage_->sheet);
        if (!stage_->sheet.empty()) check_.sheet(stage_->sheet, half, sheet, {place_of(number_, "sheet"), whose_});
        return sheet;
    }

    /// As the file moves it.
    Sway scaled(Sway sway) const
    {
        const Labelled& wanted = stage_->fixed_end.empty() && !stage_->sheet.empty() ? stage_->sheet.front().values
                                                                                     : stage_->fixed_end;
        double over = 0.0, under = 0.0;
        for (const auto& [end, value] : by_end(problem_, wanted, "cross.stages")) {
            over += value * sway.loading.fixed_end[end.index];
            under += sway.loading.fixed_end[end.index] * sway.loading.fixed_end[end.index];
        }
        const double times = over == 0.0 || under == 0.0 ? 1.0 : over / under;
        sway.scale *= times;
        for (double& moment : sway.loading.fixed_end) moment *= times;
        return sway;
    }

    /// What a force is small beside: the shears of the members and the forces on nodes.
    double largest_force(const std::vector<double>& moments) const
    {
        double largest = 0.0;
        for (const Eigen::Vector2d& force : problem_.node_force) largest = std::max(largest, force.norm());
        for (const MemberAction& action : problem_.members)
            for (const auto& end : action.ends)
                if (end) largest = std::max(largest, std::abs(moments[end->index]) / action.length);
        return largest;
    }

    /// Of a prop that the problem's half leaves out by symmetry: 0.
    double force_at(const Prop& prop, const std::vector<double>& forces) const
    {
        for (std::size_t k = 0; k < problem_.sways.size(); ++k)
            if (is_at(problem_.sways[k], prop)) return forces[k];
        return 0.0;
    }

    Prop prop_at(std::size_t i) const
    {
        return prop_of(check_.model(), problem_, stage_->props[i], place_of(number_, "prop"));
    }

    void check_props(const std::vector<double>& forces, double largest)
    {
        for (std::size_t i = 0; i < stage_->props.size(); ++i)
            if (const auto reaction = stage_->props[i].reaction)
                check_.number(fill(tr_("{0}: force of the prop"), {whose_}), *reaction, force_at(prop_at(i), forces),
                              largest);
    }

    bool is_exact_wanted() const { return !stage_->last.empty() || !stage_->reactions.empty(); }

    void find_exact()
    {
        if (strained_) return;
        strained_.emplace(check_.model(), problem_);
        unstrained_.emplace(inextensible_copy(check_.model()), problem_);
    }

    /// \param sway  whose own force is meant by one number
    void check_exact(const PropState& strained, const PropState& unstrained, std::optional<std::size_t> sway = {})
    {
        check_.row(fill(tr_("{0}: final"), {whose_}), stage_->last, {strained.moments, unstrained.moments});
        const std::vector<double>& wanted = stage_->reactions;
        const std::string what = fill(tr_("{0}: exact force of the prop"), {whose_});
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const bool is_own = sway && wanted.size() == 1;
            const auto force = [&](const PropState& state) {
                return is_own ? state.forces[*sway] : force_of_prop(i, state.forces);
            };
            check_.number(what, wanted[i], nearer_to(wanted[i], force(strained), force(unstrained)),
                          largest_force(strained.moments));
        }
    }

    double force_of_prop(std::size_t i, const std::vector<double>& forces) const
    {
        if (i < stage_->props.size()) return force_at(prop_at(i), forces);
        return i < forces.size() ? forces[i] : 0.0;
    }

    SheetCheck& check_;
    const Problem& problem_;
    const std::vector<Block::Stage>& stages_;
    const Translator& tr_;
    std::optional<ProppedStructure> strained_, unstrained_;
    std::size_t number_ = 0;
    const Block::Stage* stage_ = nullptr;
    std::string whose_;
};

} // namespace

Problem propped_as_in(const Block& block, const Model& model, const Problem& whole)
{
    const auto stage = std::ranges::find_if(block.stages, [](const auto& one) { return !one.props.empty(); });
    if (stage == block.stages.end()) return whole;
    const auto number = static_cast<std::size_t>(stage - block.stages.begin());
    std::vector<Prop> props;
    std::string found;
    for (const Block::Prop& wanted : stage->props) {
        props.push_back(prop_of(model, whole, wanted, place_of(number, "prop")));
        found += (found.empty() ? "" : " + ") + words_of(wanted);
    }
    if (block.is_by_halves) props = all_props(std::move(props), whole);
    if (auto problem = propped_at(whole, props)) return std::move(*problem);
    throw ModelError({{FaultKind::UnknownChoice, {place_of(number, "props"), found, own_props(model, whole)}}});
}

void check_stages(SheetCheck& check) { StageCheck(check).run(); }

} // namespace femoop::cross
