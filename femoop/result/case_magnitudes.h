#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "femoop/model/model.h"
#include "femoop/result/magnitudes.h"
#include "femoop/result/results.h"

namespace femoop {

/// How large the numbers of each case are that is asked about, found once. \pre the results outlive it
class CaseMagnitudes {
public:
    explicit CaseMagnitudes(const Results& results) : results_(results) {}

    const Magnitudes& operator[](CaseId id)
    {
        const auto found = known_.find(id.index);
        return found != known_.end() ? found->second
                                     : known_.emplace(id.index, results_[id].magnitudes()).first->second;
    }
    const Results& results() const { return results_; }

private:
    const Results& results_;
    std::map<std::size_t, Magnitudes> known_;
};

/// Of sums over the whole structure, whose moments are about the origin.
inline Magnitudes of_sums(Magnitudes most, const Model& model)
{
    double reach = 0.0;
    for (const Node& node : model.nodes) reach = std::max(reach, std::hypot(node.at[0], node.at[1], node.at[2]));
    most.moment = std::max(most.moment, most.force * reach);
    return most;
}

} // namespace femoop
