#include "femoop/io/counting/counting_text.h"

#include <cstdlib>
#include <string_view>

#include "femoop/model/fault/fault.h"
#include "femoop/result/structure_words.h"

namespace femoop::counting {

namespace {

std::string signed_text(int n) { return (n < 0 ? "−" : "") + std::to_string(std::abs(n)); }
std::string summand(int n) { return (n < 0 ? "−" : "+") + std::to_string(std::abs(n)); }

template <class Ids> std::string names_text(const Ids& ids, const Model& model)
{
    std::string text;
    for (const auto id : ids) text += (text.empty() ? "" : ", ") + model[id].id;
    return text;
}

/// The terms of the sum, each with what it counts.
class Terms {
public:
    Terms(const Counting& counting, const Translator& tr) : counting_(counting), tr_(tr) {}

    std::string total() const { return is_truss(counting_.kind) ? truss_total() : frame_total(); }
    std::string external() const { return reactions() + " − " + parts(); }
    std::string internal() const
    {
        if (!is_truss(counting_.kind)) return rings() + releases();
        return members() + releases() + " − (" + joints() + " − " + parts() + ")";
    }
    std::string reactions() const
    {
        return counted(static_cast<std::size_t>(counting_.n_reactions()), tr_("{0} reaction"), tr_("{0} reactions"));
    }

private:
    std::string frame_total() const { return rings() + releases() + " + " + reactions() + " − " + parts(); }
    std::string truss_total() const { return members() + releases() + " + " + reactions() + " − " + joints(); }

    std::string rings() const
    {
        return counted(counting_.rings.size(), tr_("{0} ring"), tr_("{0} rings")) + times(counting_.forces_per_ring());
    }
    std::string members() const { return counted(counting_.n_members, tr_("{0} member"), tr_("{0} members")); }
    std::string joints() const
    {
        return counted(counting_.n_joints, tr_("{0} node"), tr_("{0} nodes")) + times(counting_.equations_per_joint());
    }
    std::string parts() const
    {
        return counted(counting_.n_parts, tr_("{0} part"), tr_("{0} parts")) + times(counting_.equations_per_part());
    }
    /// With its sign; nothing where nothing is released.
    std::string releases() const
    {
        const int n = counting_.n_released();
        const auto size = static_cast<std::size_t>(std::abs(n));
        if (n > 0) return " − " + counted(size, tr_("{0} release"), tr_("{0} releases"));
        if (n < 0) return " + " + counted(size, tr_("{0} free rotation"), tr_("{0} free rotations"));
        return {};
    }
    static std::string times(int n) { return " × " + std::to_string(n); }

    const Counting& counting_;
    const Translator& tr_;
};

std::string ring_text(std::size_t number, const Counting& counting, const Model& model, const Translator& tr)
{
    return fill(tr("ring {0} of {1}: {2}"),
                {std::to_string(number + 1), names_text(counting.rings[number].members, model),
                 summand(counting.forces_per_ring())});
}

std::string joint_text(const ReleasedJoint& joint, const Model& model, const Translator& tr)
{
    std::string ends;
    for (const ReleasedJoint::End& end : joint.ends)
        ends += (ends.empty() ? "" : ", ") + model[end.member].id + " " + std::to_string(end.n_released);
    if (joint.n_free_rotations > 0)
        ends += (ends.empty() ? "" : ", ") +
                fill(tr("less {0} that turns freely"), {std::to_string(joint.n_free_rotations)});
    return fill(tr("releases at {0} ({1}): {2}"), {model[joint.node].id, ends, summand(-joint.count())});
}

std::string support_text(const SupportReactions& support, const Model& model, const Translator& tr)
{
    return fill(support.n_springs == 0 ? tr("support {0}: {1}") : tr("support {0}, springs among it: {1}"),
                {model[support.node].id, summand(support.count())});
}

std::string motion_text(const Counting& counting, const Translator& tr)
{
    if (!counting.n_motions)
        return tr("It can move without strain in many ways, so that the count does not say what it holds");
    const std::size_t n = *counting.n_motions;
    const int total = counting.degree().total();
    if (counting.has_foundation)
        return fill(tr("It can move without strain in {0}"), {counted(n, tr("{0} way"), tr("{0} ways"))});
    const std::size_t n_states = static_cast<std::size_t>(total + static_cast<int>(n));
    return fill(tr("It can move without strain in {0}: {1} = {2} − {3}"),
                {counted(n, tr("{0} way"), tr("{0} ways")), signed_text(total),
                 counted(n_states, tr("{0} state of self-stress"), tr("{0} states of self-stress")),
                 counted(n, tr("{0} motion"), tr("{0} motions"))});
}

} // namespace

std::vector<std::string> sum_lines(const Counting& counting, const Model& model, const Translator& tr)
{
    const Terms terms(counting, tr);
    const Indeterminacy degree = counting.degree();
    const auto line = [&](std::string_view what, const std::string& sum, int value) {
        return std::string(what) + ": " + sum + " = " + signed_text(value);
    };
    std::vector<std::string> lines;
    if (degree.has_foundation) { // whose reactions have no number
        lines.push_back(tr(
            "Degree of indeterminacy: infinite, since a continuous foundation reacts at every place of its members"));
        lines.push_back(fill(tr("External: {0} and infinitely many of the foundation"), {terms.reactions()}));
    } else {
        lines.push_back(line(tr("Degree of indeterminacy"), terms.total(), degree.total()));
        lines.push_back(line(tr("External"), terms.external(), degree.external));
    }
    const std::string internal = line(tr("Internal"), terms.internal(), degree.internal);
    const bool is_taken = !degree.has_foundation && degree.internal < 0 && degree.total() >= 0;
    lines.push_back(is_taken ? fill(tr("{0}, taken from what the supports give"), {internal}) : internal);
    if (counting.n_motions != 0) lines.push_back(motion_text(counting, tr));
    if (!counting.loose_nodes.empty())
        lines.push_back(fill(tr("Nodes without members do not count: {0}"), {names_text(counting.loose_nodes, model)}));
    return lines;
}

std::vector<std::string> item_lines(const Counting& counting, const Model& model, const Translator& tr)
{
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < counting.rings.size(); ++i) lines.push_back(ring_text(i, counting, model, tr));
    for (const ReleasedJoint& joint : counting.releases) lines.push_back(joint_text(joint, model, tr));
    for (const SupportReactions& support : counting.reactions) lines.push_back(support_text(support, model, tr));
    return lines;
}

std::string counting_text(const Counting& counting, const Model& model, const Translator& tr)
{
    std::string text;
    for (const std::string& line : sum_lines(counting, model, tr)) text += line + "\n";
    for (const std::string& line : item_lines(counting, model, tr)) text += "  " + line + "\n";
    return text;
}

} // namespace femoop::counting
