#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "topology/modeling/sweep.h"
#include "topology/script/script_fault.h"
#include "topology/script/script_runner.h"

namespace topology {

/// One line while it is run. Everything is found and checked before anything changes.
class ScriptLine {
public:
    ScriptLine(ScriptRunner& runner, const std::vector<std::string_view>& words, Observer* observer)
        : runner_(runner), words_(words), observer_(observer)
    {}

    LineKind run(); ///< \throws LineError

private:
    struct Operation {
        std::string_view usage; ///< the line's form; a last word in brackets may be left out
        void (ScriptLine::*run)();
        bool is_step = true;

        std::string_view word() const { return usage.substr(0, usage.find(' ')); }
        bool takes(std::size_t n) const
        {
            const auto wanted = static_cast<std::size_t>(std::count(usage.begin(), usage.end(), ' ')) + 1;
            return n == wanted || (usage.ends_with(']') && n + 1 == wanted);
        }
    };
    static const std::array<Operation, 20> operations;

    void mvfs();
    void kvfs();
    void mev();
    void split();
    void kev();
    void mef();
    void kef();
    void kemr();
    void mekr();
    void kfmrh();
    void mfkrh();
    void mvr();
    void kvr();
    void semv();
    void jekv();
    void ringmv();
    void move();
    void sweep();
    void undo_or_redo();

    /// The solid that the line's second word names, which every operator but mvfs needs.
    NamedSolid& solid()
    {
        if (!place_) place_ = runner_.find(words_[1]);
        if (!place_) throw error(ScriptFault::NoSolid, {std::string(words_[1])});
        return runner_.solids_[*place_];
    }
    FaceId face(std::size_t i) { return find_face(solid().named(), words_[i]); }
    VertexId vertex(std::size_t i) { return find_vertex(solid().named(), words_[i]); }
    HalfEdgeId corner(FaceId f, std::size_t i) { return find_corner(solid().named(), f, words_[i]); }
    HalfEdgeId half_edge(std::optional<FaceId> f, std::size_t from, std::size_t to)
    {
        return find_half_edge(solid().named(), f, words_[from], words_[to]);
    }
    std::string new_vertex(std::size_t i);
    std::string new_face(std::size_t i);
    Point point(std::size_t i) const;

    EulerOperator observed(NamedSolid& in) const
    {
        EulerOperator op(in.solid, in.journal);
        if (observer_ != nullptr) op.observe(*observer_);
        return op;
    }

    /// Applies one operator to the solid, as one step.
    template <class Act> auto apply(const Act& act)
    {
        EulerOperator op = observed(solid());
        try {
            if constexpr (std::is_void_v<decltype(act(op))>) {
                act(op);
                runner_.commit(*place_, 1);
            } else {
                const auto made = act(op);
                runner_.commit(*place_, 1);
                return made;
            }
        } catch (const EulerError& refused) {
            throw description(refused.refusal());
        }
    }
    LineError description(const Refusal& refusal)
    {
        std::vector<std::string> names;
        for (const Entity& entity : refusal.entities) names.push_back(solid().names.of(entity, solid().solid));
        return {pattern(refusal.kind), names};
    }
    void name_vertex(VertexId v, std::string name) { solid().names.vertices.give(v, std::move(name)); }
    void name_face(FaceId f, std::string name) { solid().names.faces.give(f, std::move(name)); }
    void name_sweep(const Sweep& made, const std::string& face_name);

    ScriptRunner& runner_;
    const std::vector<std::string_view>& words_;
    Observer* observer_;
    std::optional<std::size_t> place_;
};

} // namespace topology
