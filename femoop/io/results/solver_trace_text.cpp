#include "femoop/io/results/solver_trace_text.h"

#include <algorithm>

#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/solver/index.h"
#include "femoop/solver/trace/front_matrix.h"
#include "femoop/tabular/plain_text.h"

namespace femoop {

namespace {

constexpr std::size_t label_indent = 2;
constexpr std::size_t most_names = 8;    // of a list that stands in a table
constexpr std::size_t most_letters = 40; // of a matrix in letters

std::string titled_table(const std::string& title, const tabular::Table& table, const Translator& tr)
{
    return table.is_empty() ? std::string()
                            : "\n" + title + "\n" + tabular::plain_text(table, {label_indent, decimal_mark(tr)});
}

std::size_t count_of(double number) { return static_cast<std::size_t>(number); }

/// The words of one order's walk.
class WalkText {
public:
    WalkText(const SolverTrace& trace, Ordering ordering, const Translator& tr)
        : trace_(trace), walk_(trace.walk(ordering)), tr_(tr), words_(ordering_text(ordering, tr))
    {}

    std::string fronts() const
    {
        tabular::Table table({tr_("step"), tr_("eliminated"), tr_("left in the front"), tr_("children"), tr_("rows"),
                              tr_("columns of L"), tr_("update matrix"), tr_("all that wait"), tr_("parent")});
        for (std::size_t f = 0; f < walk_.fronts.size(); ++f) {
            const EliminationWalk::Front& front = walk_.fronts[f];
            std::vector<std::string> children;
            for (const std::int32_t child : walk_.children_of(static_cast<std::int32_t>(f)))
                children.push_back(std::to_string(child + 1));
            table.add_row({std::to_string(f + 1), names(eliminated(front)), names(left(front)), joined(children),
                           front.n_rows(), front.n_entries(), front.n_update_entries(), front.n_waiting,
                           front.parent == EliminationWalk::none ? "-" : std::to_string(front.parent + 1)});
        }
        return titled_table(fill(tr_("The front walks, in {0} order"), {words_}), table, tr_);
    }

    std::string factor() const
    {
        const bool by_unknowns = walk_.counts.n_unknowns <= most_letters;
        if (!by_unknowns && walk_.order.size() > most_letters)
            return "\n" + tr_("L has too many columns to be written in letters; draw it with -o.") + "\n";
        std::string text =
            "\n" +
            fill(by_unknowns
                     ? tr_("L in {0} order: an x where K has an entry, an o where elimination fills one in")
                     : tr_("L by blocks, in {0} order: an x where K has entries, an o where elimination fills some in"),
                 {words_}) +
            "\n";
        std::vector<std::string> labels;
        std::vector<std::size_t> block_of; // of each line: place in the order
        for (std::size_t place = 0; place < walk_.order.size(); ++place) {
            const SolverTrace::Block& block = block_at(place);
            if (by_unknowns) labels.insert(labels.end(), block.unknowns.begin(), block.unknowns.end());
            else labels.push_back(block.name);
            block_of.resize(labels.size(), place);
        }
        return text + triangle(labels, [&](std::size_t row, std::size_t column) {
                   return letter(block_of[row], block_of[column]);
               });
    }

    std::string front_matrix(std::size_t step) const
    {
        const FrontMatrix matrix = femoop::front_matrix(walk_, step);
        std::vector<std::string> labels;
        for (std::size_t i = 0; i < matrix.places.size(); ++i)
            labels.push_back((i < matrix.n_eliminated ? "* " : "  ") + block_at(at(matrix.places[i])).name);
        const std::string title = fill(
            tr_("The matrix of front {0} by blocks, * eliminated: "
                "K from K, u from the update matrices of children, o filled in by its own elimination"),
            {std::to_string(step + 1)});
        if (labels.size() > most_letters)
            return "\n" + tr_("The front has too many blocks to be written in letters; draw it with -o.") + "\n";
        return "\n" + title + "\n" + triangle(labels, [&](std::size_t row, std::size_t column) {
                   switch (matrix.at(row, column)) {
                   case FrontEntry::FromK: return 'K';
                   case FrontEntry::FromChildren: return 'u';
                   case FrontEntry::Made: break;
                   }
                   return 'o';
               });
    }

private:
    const SolverTrace::Block& block_at(std::size_t place) const { return trace_.blocks[at(walk_.order[place])]; }

    std::vector<std::int32_t> eliminated(const EliminationWalk::Front& front) const
    {
        std::vector<std::int32_t> places;
        for (std::int32_t place = front.first; place < front.end; ++place) places.push_back(place);
        return places;
    }
    std::vector<std::int32_t> left(const EliminationWalk::Front& front) const
    {
        std::vector<std::int32_t> places;
        for (const EliminationWalk::Entry& entry : walk_.left(front)) places.push_back(entry.row);
        return places;
    }
    std::string names(const std::vector<std::int32_t>& places) const
    {
        std::vector<std::string> list;
        for (const std::int32_t place : places) list.push_back(printable(block_at(at(place)).name));
        return joined(list);
    }
    std::string joined(const std::vector<std::string>& list) const
    {
        std::string text;
        for (std::size_t i = 0; i < std::min(list.size(), most_names); ++i) text += (i > 0 ? " " : "") + list[i];
        if (list.size() > most_names) text += fill(tr_(" and {0} more"), {std::to_string(list.size() - most_names)});
        return text.empty() ? "-" : text;
    }

    char letter(std::size_t row, std::size_t column) const
    {
        if (row == column) return 'x';
        const auto& entries = walk_.columns[column];
        const auto found = std::ranges::find(entries, static_cast<std::int32_t>(row), &EliminationWalk::Entry::row);
        if (found == entries.end()) return '.';
        return found->is_fill ? 'o' : 'x';
    }

    template <class Letter> static std::string triangle(const std::vector<std::string>& labels, const Letter& letter)
    {
        std::size_t width = 0;
        for (const std::string& label : labels) width = std::max(width, tabular::shown_width(printable(label)));
        std::string text;
        for (std::size_t row = 0; row < labels.size(); ++row) {
            const std::string label = printable(labels[row]);
            text += std::string(label_indent, ' ') + label + std::string(width - tabular::shown_width(label), ' ') +
                    ' ';
            for (std::size_t column = 0; column <= row; ++column) text += {' ', letter(row, column)};
            text += '\n';
        }
        return text;
    }

    const SolverTrace& trace_;
    const EliminationWalk& walk_;
    const Translator& tr_;
    std::string words_;
};

std::string head(const SolverTrace& trace, const Translator& tr)
{
    const EliminationCounts& counts = trace.walks.front().counts;
    std::size_t n_blocks = trace.walks.front().order.size();
    std::string text = fill(tr("System: {0} unknowns in {1} blocks; K has {2} entries in its lower triangle"),
                            {std::to_string(counts.n_unknowns), std::to_string(n_blocks),
                             std::to_string(counts.n_entries_of_K)}) +
                       "\n" + tr("A block is what comes and goes together: the free displacements of a node.") + "\n";
    if (trace.has_constraints)
        text += tr("Constraints make some of the unknowns follow others, and the solver leaves these out; "
                   "the system is shown before that.") +
                "\n";
    return text;
}

std::string choice(const SolverTrace& trace, const Translator& tr)
{
    const std::string solver(name(trace.solver));
    if (trace.has_constraints) return {};
    if (!trace.ordering)
        return "\n" + fill(tr("Chosen: {0}, in an order of its own that is none of these."), {solver}) + "\n";
    const EliminationCounts& counts = trace.walk(*trace.ordering).counts;
    const double taken = trace.solver == SolverKind::Skyline ? counts.n_profile_operations : counts.n_operations;
    std::string text = "\n" + fill(tr("Chosen: {0}, in {1} order: {2} operations."),
                                   {solver, ordering_text(*trace.ordering, tr), std::to_string(count_of(taken))});
    if (trace.wanted != SolverKind::Automatic) return text + "\n";
    return text + "\n" +
           tr(trace.solver == SolverKind::Skyline
                  ? translatable("The profile is narrow enough: the skyline, "
                                 "which keeps no lists of places, is the fastest although it also keeps zeros.")
                  : translatable("The profile is wide: dense fronts up the tree are faster than the skyline.")) +
           "\n";
}

std::string comparison(const SolverTrace& trace, const Translator& tr)
{
    tabular::Table table({tr("order"), tr("entries of L"), tr("fill-in"), tr("operations"), tr("front"), tr("levels"),
                          tr("waiting"), tr("profile"), tr("its operations")});
    for (const Ordering ordering : all_orderings) {
        const EliminationCounts& counts = trace.walk(ordering).counts;
        table.add_row({ordering_text(ordering, tr), counts.n_entries, counts.n_fill(), count_of(counts.n_operations),
                       counts.largest_front, counts.n_levels, counts.most_waiting, counts.n_profile_entries,
                       count_of(counts.n_profile_operations)});
    }
    return titled_table(tr("Orders of elimination"), table, tr) +
           tr("Operations are multiplications and divisions. "
              "Of fronts the largest is counted in rows, the height of their\ntree in levels, "
              "what waits at one time in entries of update matrices. The profile is what the skyline keeps.") +
           "\n";
}

} // namespace

std::string ordering_text(Ordering ordering, const Translator& tr)
{
    switch (ordering) {
    case Ordering::Natural: return tr(translatable("natural"));
    case Ordering::CuthillMcKee: return tr(translatable("reverse Cuthill-McKee"));
    case Ordering::MinimumDegree: return tr(translatable("minimum degree"));
    case Ordering::NestedDissection: break;
    }
    return tr(translatable("nested dissection"));
}

Ordering usual_ordering(const SolverTrace& trace) { return trace.ordering.value_or(Ordering::NestedDissection); }

std::string solver_trace_text(const SolverTrace& trace, const SolverTraceRequest& request, const Translator& tr)
{
    std::string text = head(trace, tr);
    if (trace.n_unknowns() == 0)
        return text + tr("Every displacement is held by a support: there is nothing to eliminate.") + "\n";
    text += comparison(trace, tr) + choice(trace, tr);
    if (!trace.has_details())
        return text + "\n" +
               fill(tr("The walk of the front is told of systems of {0} unknowns or fewer."),
                    {std::to_string(SolverTrace::most_unknowns)}) +
               "\n";
    const WalkText walk(trace, request.ordering.value_or(usual_ordering(trace)), tr);
    text += walk.fronts();
    if (request.step) text += walk.front_matrix(*request.step);
    return text + walk.factor();
}

} // namespace femoop
