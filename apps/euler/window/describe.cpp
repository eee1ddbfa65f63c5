#include "apps/euler/window/describe.h"

#include "apps/euler/window/step_panel.h"
#include "topology/halfedge/check/validate.h"

namespace euler {

namespace {

ui::Message sentence(const topology::Breach& breach, const Snapshot& in)
{
    return {topology::pattern(breach.invariant),
            {{"0", in.names->of(breach.entities[0], *in.solid)}, {"1", in.names->of(breach.entities[1], *in.solid)}}};
}

// "s1: V = 8, E = 12, F = 6, L = 6, S = 1, G = 0"
std::string counts_text(const std::string& solid, const topology::EulerCounts& n)
{
    const auto s = [](std::size_t count) { return std::to_string(count); };
    return solid + ": V = " + s(n.V) + ", E = " + s(n.E) + ", F = " + s(n.F) + ", L = " + s(n.L) + ", S = " + s(n.S) +
           ", G = " + s(n.G);
}

std::string solid_text(const Snapshot& in, const ui::Catalogue& tr)
{
    const topology::EulerCounts n = topology::euler_counts(*in.solid);
    const std::string words = counts_text(in.name, n) + "\n    " + formula_text(n) + "\n    ";
    const auto breach = topology::why_not_valid(*in.solid);
    return words + (breach ? tr(sentence(*breach, in)) : tr("every link is sound")) + '\n';
}

} // namespace

std::string description(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    const std::string place = std::to_string(session.place()), count = std::to_string(session.n_steps());
    std::string words = tr("step {place} of {count}", {{"place", place}, {"count", count}}) + '\n';
    for (std::size_t i = 1; i <= session.place(); ++i) {
        const StepSummary step = session.stepper().summary(i);
        words += std::to_string(i) + ". " + step.line + "    " + deltas(step) + '\n';
    }
    for (const Snapshot& in : session.present())
        if (in.is_alive()) words += solid_text(in, tr);
    return words;
}

std::string status_text(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    std::string text;
    for (std::size_t i = 0; i < session.present().size(); ++i) {
        const Snapshot& in = session.present()[i];
        if (!in.is_alive()) continue;
        // Asked for in every frame, so of a script they are not counted anew.
        const auto counts = session.is_exhibiting() ? topology::euler_counts(*in.solid) : session.stepper().counts(i);
        text += (text.empty() ? "" : "   ·   ") + counts_text(in.name, counts);
    }
    return text.empty() ? tr("no solid") : text;
}

} // namespace euler
