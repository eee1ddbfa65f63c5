#include "femoop/io/cross/half_text.h"

#include <algorithm>

#include "femoop/methods/cross/rounding.h"
#include "femoop/methods/cross/symmetry.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop::cross {

namespace {

constexpr int digits_of_mirror = 4;
constexpr std::size_t most_named = 8;

class HalfText {
public:
    HalfText(const Model& model, const Problem& half, const Translator& tr)
        : model_(model), half_(half), tr_(tr), is_symmetric_(half.mirror->kind == SymmetryKind::Symmetric)
    {}

    std::vector<std::string> write() const
    {
        std::vector<std::string> sentences{about_joints()};
        if (!crossing_ends(half_).empty()) sentences.push_back(about_crossing());
        if (const auto held = held_on_axis(); !held.empty())
            sentences.push_back(
                written(translatable("On the axis nothing turns, nothing is balanced: {0}."), {named(held)}));
        return sentences;
    }

private:
    std::string about_joints() const
    {
        const std::string axis = localized(
            quantity_text(rounded(half_.mirror->x, digits_of_mirror) + 0.0, dimension::length, model_.units), tr_);
        const std::vector<std::string> joints = joint_names(model_, half_);
        if (joints.empty())
            return written(is_symmetric_ ? translatable("Symmetric about x = {0}: no joint turns.")
                                         : translatable("Antisymmetric about x = {0}: there is no joint to balance."),
                           {axis});
        return written(is_symmetric_
                           ? translatable("Symmetric about x = {0}: it is enough to balance {1}; "
                                          "what stands on the other side turns by as much the other way round.")
                           : translatable("Antisymmetric about x = {0}: it is enough to balance {1}; "
                                          "what stands on the other side turns by as much the same way."),
                       {axis, named(joints)});
    }

    std::string about_crossing() const
    {
        std::vector<std::string> names;
        for (const EndId end : crossing_ends(half_)) names.push_back(half_[end].label);
        return written(is_symmetric_ ? translatable("Members that cross the axis turn their ends against one another: "
                                                    "they take {0} and carry nothing over: {1}.")
                                     : translatable("Members that cross the axis turn both ends the same way: "
                                                    "they take {0} and carry nothing over: {1}."),
                       {stiffness(), named(names)});
    }

    /// "2EI/L" where every one of them is prismatic; else by the stiffness s and the carry-over C of each.
    std::string stiffness() const
    {
        const std::string_view usual = is_symmetric_ ? "2EI/L" : "6EI/L";
        const auto is_usual = [&](EndId end) { return formula(half_, end) == usual; };
        if (std::ranges::all_of(crossing_ends(half_), is_usual)) return std::string(usual);
        return is_symmetric_ ? "s - C s" : "s + C s";
    }

    std::vector<std::string> held_on_axis() const
    {
        std::vector<std::string> held;
        for (std::size_t j = 0; j < half_.joints.size(); ++j)
            if (!half_.balanced_for(JointId(j))) held.push_back(model_[half_.joints[j].node].id);
        return held;
    }

    std::string named(std::vector<std::string> names) const
    {
        if (names.size() <= most_named) return listed(names);
        const std::string n = std::to_string(names.size() - most_named);
        names.resize(most_named);
        names.push_back(fill(tr_("{0} more"), {n}));
        return listed(names);
    }

    std::string written(std::string_view pattern, const std::vector<std::string>& arguments) const
    {
        return fill(tr_(pattern), arguments, tr_(translatable("and")));
    }

    const Model& model_;
    const Problem& half_;
    const Translator& tr_;
    bool is_symmetric_;
};

} // namespace

std::vector<std::string> half_text(const Model& model, const Problem& half, const Translator& tr)
{
    return HalfText(model, half, tr).write();
}

} // namespace femoop::cross
