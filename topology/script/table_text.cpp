#include "topology/script/table_text.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace topology {

namespace {

template <class Id> std::size_t number(Id id) { return id == nothing<Id> ? 0 : std::size_t{id.index} + 1; }

struct Neighbours {
    std::size_t older = 0, newer = 0;
};

std::ostream& operator<<(std::ostream& out, const Neighbours& beside)
{
    return out << " N = " << beside.older << " P = " << beside.newer << '\n';
}

template <class Table> std::size_t oldest(const Table& table)
{
    return table.n_living() == 0 ? 0 : number(*table.begin());
}

/// Calls `line(id, neighbours)` for each living entity, oldest first.
template <class Table, class Line> void in_order(const Table& table, const Line& line)
{
    std::size_t older = 0;
    for (auto it = table.begin(); !(it == table.end());) {
        const auto id = *it;
        ++it;
        line(id, Neighbours{older, it == table.end() ? 0 : number(*it)});
        older = number(id);
    }
}

class Printer {
public:
    Printer(const Solid& solid, const SolidPlace& place) : solid_(solid), place_(place) {}

    std::string take()
    {
        vertices();
        half_edges();
        edges();
        loops();
        faces();
        out_ << "S = " << place_.number << " (V = " << oldest(solid_.vertices()) << ", F = " << oldest(solid_.faces())
             << ", E = " << oldest(solid_.edges()) << ")" << Neighbours{place_.older, place_.newer};
        return out_.str();
    }

private:
    void vertices()
    {
        in_order(solid_.vertices(), [&](VertexId v, const Neighbours& beside) {
            out_ << "V = " << number(v) << " (H = " << number(solid_.half_edge(v)) << ")" << beside;
        });
    }
    void half_edges()
    {
        for (const HalfEdgeId i : solid_.half_edges()) {
            const HalfEdge& h = solid_.half_edges()[i];
            const Neighbours beside = solid_.edge(i) ? Neighbours{number(h.next), number(h.prev)} : Neighbours{};
            out_ << "H = " << number(i) << " (V = " << number(h.start) << ", E = " << number(h.edge)
                 << ", L = " << number(h.loop) << ")" << beside;
        }
    }
    void edges()
    {
        if (solid_.edges().n_living() == 0) out_ << "E = 0 (H1 = 0, H2 = 0)" << Neighbours{};
        in_order(solid_.edges(), [&](EdgeId e, const Neighbours& beside) {
            out_ << "E = " << number(e) << " (H1 = " << number(solid_.plus(e)) << ", H2 = " << number(solid_.minus(e))
                 << ")" << beside;
        });
    }
    void loops()
    {
        for (const LoopId l : solid_.loops())
            out_ << "L = " << number(l) << " (H = " << number(solid_.half_edge(l)) << ", F = " << number(solid_.face(l))
                 << ")" << beside_in_face(l);
    }
    Neighbours beside_in_face(LoopId l) const
    {
        const std::vector<LoopId> all = loops_of(solid_.face(l));
        const auto at = std::find(all.begin(), all.end(), l);
        return {at == all.begin() ? 0 : number(*(at - 1)), at + 1 == all.end() ? 0 : number(*(at + 1))};
    }
    std::vector<LoopId> loops_of(FaceId f) const
    {
        std::vector<LoopId> all;
        for (const LoopId l : solid_.loops(f)) all.push_back(l);
        std::sort(all.begin(), all.end());
        return all;
    }
    void faces()
    {
        in_order(solid_.faces(), [&](FaceId f, const Neighbours& beside) {
            out_ << "F = " << number(f) << " (S = " << place_.number
                 << ", LOUT = " << (is_bounded(f) ? number(solid_.outer(f)) : 0)
                 << " / LOOPS = " << number(loops_of(f).front()) << ")" << beside;
        });
    }
    /// Does another loop lie beyond some edge of the outer one?
    bool is_bounded(FaceId f) const
    {
        for (const HalfEdgeId h : solid_.chain(solid_.outer(f)))
            if (solid_.loop(solid_.mate(h)) != solid_.outer(f)) return true;
        return false;
    }

    const Solid& solid_;
    SolidPlace place_;
    std::ostringstream out_;
};

} // namespace

std::string table_text(const Solid& solid, const SolidPlace& place) { return Printer(solid, place).take(); }

} // namespace topology
