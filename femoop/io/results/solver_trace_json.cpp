#include "femoop/io/json/json_writer.h"
#include "femoop/io/results/solver_trace_text.h"
#include "femoop/solver/index.h"

namespace femoop {

namespace {

using Layout = JsonWriter::Layout;

class SolverTraceWriter {
public:
    explicit SolverTraceWriter(const SolverTrace& trace) : trace_(trace) {}

    std::string write()
    {
        json_.begin_object(Layout::Block).member("cremona", 1);
        json_.key("solver_trace").begin_object(Layout::Block);
        json_.member("solver", name(trace_.solver)).key("ordering");
        if (trace_.ordering) json_.value(name(*trace_.ordering));
        else json_.null();
        json_.member("is_constrained", trace_.has_constraints)
            .member("unknowns", trace_.n_unknowns())
            .member("entries_of_K", trace_.walks.front().counts.n_entries_of_K);
        write_blocks();
        json_.key("orderings").begin_object(Layout::Block);
        for (const Ordering ordering : all_orderings) write_walk(ordering);
        json_.end().end().end();
        return json_.take();
    }

private:
    void write_blocks()
    {
        json_.key("blocks").begin_array(Layout::Block);
        for (std::size_t b = 0; trace_.has_details() && b < trace_.blocks.size(); ++b) {
            const SolverTrace::Block& block = trace_.blocks[b];
            json_.begin_object().member(block.is_member ? "member" : "node", block.name);
            json_.key("unknowns").begin_array();
            for (const std::string& unknown : block.unknowns) json_.value(unknown);
            json_.end();
            if (block.separator) json_.member("separator", *block.separator);
            json_.end();
        }
        json_.end();
    }

    void write_walk(Ordering ordering)
    {
        const EliminationWalk& walk = trace_.walk(ordering);
        const EliminationCounts& counts = walk.counts;
        json_.key(name(ordering)).begin_object(Layout::Block);
        json_.member("entries_of_L", counts.n_entries)
            .member("fill_in", counts.n_fill())
            .member("operations", counts.n_operations)
            .member("largest_front", counts.largest_front)
            .member("levels", counts.n_levels)
            .member("most_waiting", counts.most_waiting)
            .member("profile_entries", counts.n_profile_entries)
            .member("profile_operations", counts.n_profile_operations);
        if (trace_.has_details()) write_details(walk);
        json_.end();
    }

    void write_details(const EliminationWalk& walk)
    {
        json_.key("order").begin_array();
        for (const std::int32_t block : walk.order) json_.value(trace_.blocks[at(block)].name);
        json_.end();
        json_.key("parent").begin_array(); // by name, of each of the order
        for (const std::int32_t parent : walk.parent) write_name(walk, parent);
        json_.end();
        json_.key("fill_in_at").begin_array(); // pairs of blocks: row, column
        for (std::size_t column = 0; column < walk.columns.size(); ++column)
            for (const EliminationWalk::Entry& entry : walk.columns[column]) {
                if (!entry.is_fill) continue;
                json_.begin_array();
                write_name(walk, entry.row);
                write_name(walk, static_cast<std::int32_t>(column));
                json_.end();
            }
        json_.end();
        json_.key("fronts").begin_array(Layout::Block);
        for (std::size_t f = 0; f < walk.fronts.size(); ++f) write_front(walk, static_cast<std::int32_t>(f));
        json_.end();
    }

    void write_front(const EliminationWalk& walk, std::int32_t f)
    {
        const EliminationWalk::Front& front = walk.fronts[at(f)];
        json_.begin_object().key("eliminated").begin_array();
        for (std::int32_t place = front.first; place < front.end; ++place) write_name(walk, place);
        json_.end().key("left").begin_array();
        for (const EliminationWalk::Entry& entry : walk.left(front)) write_name(walk, entry.row);
        json_.end().key("children").begin_array();
        for (const std::int32_t child : walk.children_of(f)) json_.value(child + 1);
        json_.end().key("parent");
        if (front.parent == EliminationWalk::none) json_.null();
        else json_.value(front.parent + 1);
        json_.member("pivots", front.n_pivots)
            .member("rows", front.n_rows())
            .member("entries_of_L", front.n_entries())
            .member("update_entries", front.n_update_entries())
            .member("waiting", front.n_waiting)
            .end();
    }

    void write_name(const EliminationWalk& walk, std::int32_t place)
    {
        if (place == EliminationWalk::none) json_.null();
        else json_.value(trace_.blocks[at(walk.order[at(place)])].name);
    }

    const SolverTrace& trace_;
    JsonWriter json_;
};

} // namespace

std::string solver_trace_json(const SolverTrace& trace) { return SolverTraceWriter(trace).write(); }

} // namespace femoop
