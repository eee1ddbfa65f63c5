#include "apps/frame/virtual_work/asked_work.h"

#include <algorithm>

#include "apps/drawing/results/diagram.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "femoop/model/fault/fault.h"
#include "femoop/result/components.h"

namespace frame {

using femoop::Dof;
using femoop::MemberComponent;
using femoop::MovingEffect;

namespace {

/// That of the list which was asked for last, else one that is meant first, else the first.
template <class T> T chosen(const std::vector<T>& all, const std::optional<T>& last, T first)
{
    if (last && std::ranges::find(all, *last) != all.end()) return *last;
    return std::ranges::find(all, first) != all.end() ? first : all.front();
}

MovingEffect displacement_of(femoop::NodeId node, Dof dof)
{
    return {.quantity = femoop::ExpectedQuantity::Displacement, .node = node, .dof = dof};
}

} // namespace

void AskedWork::clear()
{
    const std::size_t next = number_ + 1;
    *this = {};
    number_ = next;
}

void AskedWork::ask(const femoop::Model& model, const MovingEffect& displacement)
{
    asked_ = NamedEffect(model, displacement);
    last_component_ = displacement.component ? displacement.component : last_component_;
    last_dof_ = displacement.dof ? displacement.dof : last_dof_;
    subject_.reset();
    ++number_;
}

void AskedWork::ask(const femoop::Model& model, const drawing::Cut& cut)
{
    const double length = femoop::geometry_of(model, model[cut.member]).length;
    const auto axes = femoop::local_displacement_components(model.analysis);
    const MemberComponent across = femoop::is_plane(model.analysis) ? MemberComponent::v : MemberComponent::w;
    ask(model, drawing::number_at_section(cut, chosen(axes, last_component_, across), length));
}

void AskedWork::ask(const femoop::Model& model, femoop::NodeId node)
{
    const Dof upright = femoop::is_plane(model.analysis) ? Dof::uy : Dof::uz;
    ask(model, displacement_of(node, chosen(femoop::dof_list(model.analysis), last_dof_, upright)));
}

void AskedWork::choose(const MovingEffect& displacement)
{
    asked_->effect.component = last_component_ = displacement.component;
    asked_->effect.dof = last_dof_ = displacement.dof;
    subject_.reset();
    ++number_;
}

std::optional<MovingEffect> AskedWork::displacement(const femoop::Model& model) const
{
    const auto wanted = asked_ ? effect_in(model, *asked_) : std::nullopt;
    if (!wanted) return std::nullopt;
    const std::vector<MovingEffect> all = choices(model);
    return std::ranges::find(all, *wanted) != all.end() ? wanted : std::nullopt; // another kind of model may lack it
}

std::vector<MovingEffect> AskedWork::choices(const femoop::Model& model) const
{
    std::vector<MovingEffect> all;
    auto effect = asked_ ? effect_in(model, *asked_) : std::nullopt;
    if (!effect) return all;
    if (effect->node)
        for (const Dof dof : femoop::dof_list(model.analysis)) all.push_back(displacement_of(*effect->node, dof));
    else
        for (const MemberComponent axis : femoop::local_displacement_components(model.analysis)) {
            effect->component = axis;
            all.push_back(*effect);
        }
    return all;
}

const drawing::WorkPicture* AskedWork::picture(const femoop::Model& model, const Solution& solution,
                                               std::uint64_t generation, const drawing::DrawOptions& options) const
{
    const Subject subject{generation, options.load_case, options.tr.language()};
    if (subject_ != subject) find(model, solution, options);
    subject_ = subject;
    return picture_ ? &*picture_ : nullptr;
}

void AskedWork::find(const femoop::Model& model, const Solution& solution, const drawing::DrawOptions& options) const
{
    picture_.reset();
    why_none_.clear();
    const auto wanted = displacement(model);
    if (!wanted || options.load_case.index >= solution.results->n_cases()) return;
    try {
        picture_ = drawing::WorkPicture{femoop::virtual_work::displacement_by_work(
            solved_model(model, solution), *solution.results, options.load_case, *wanted)};
    } catch (const femoop::ModelError& error) { // the unit load moves what nothing holds
        if (wanted->dof && femoop::is_rotation(*wanted->dof)) {
            why_none_ = femoop::virtual_work::free_rotation_text(model, *wanted->node, options.tr);
            return;
        }
        for (const femoop::Fault& fault : error.faults())
            why_none_ += (why_none_.empty() ? "" : "; ") + femoop::message(fault, options.tr);
    }
}

} // namespace frame
