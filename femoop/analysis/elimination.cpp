#include "femoop/analysis/elimination.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace femoop {

namespace {

/// Gaussian elimination of sparse rows, one pivot unknown a row.
class Eliminator {
public:
    Eliminator(std::size_t n_unknowns, const Eigen::VectorXd& scale) : pivot_of_(n_unknowns, -1), scale_(scale) {}

    /// Reduces a row by those before it and keeps it, or reports what it contradicts.
    void add(const ConstraintRow& row, std::vector<Elimination::Conflict>& conflicts)
    {
        Reduced reduced{.terms = {}, .value = row.value, .member = row.member, .used = {}};
        for (const ConstraintRow::Term& term : row.terms) reduced.terms[term.unknown] += term.coefficient;
        double size = 0.0;
        for (const auto& [unknown, c] : reduced.terms) size = std::max(size, std::abs(c) * scale_[unknown]);
        double value_size = reduced.value.cwiseAbs().size() > 0 ? reduced.value.cwiseAbs().maxCoeff() : 0.0;
        value_size = std::max(value_size, substitute(reduced));
        drop_below(reduced, 1e-11 * size);
        if (!reduced.terms.empty()) {
            keep(std::move(reduced));
            return;
        }
        for (Eigen::Index c = 0; c < reduced.value.size(); ++c)
            if (std::abs(reduced.value[c]) > 1e-9 * value_size)
                conflicts.push_back({.load_case = static_cast<std::size_t>(c), .members = members_behind(reduced)});
    }

    Elimination result(std::size_t n_cases);

private:
    struct Reduced {
        std::map<std::int32_t, double> terms; ///< of unknowns without the pivot, once kept
        Eigen::VectorXd value;
        MemberId member;
        std::vector<std::int32_t> used; ///< rows that took part in its reduction
        std::int32_t pivot = -1;
    };

    /// The members of a row and of all that it was reduced by.
    std::vector<MemberId> members_behind(const Reduced& row) const
    {
        std::set<MemberId> members{row.member};
        std::set<std::int32_t> known(row.used.begin(), row.used.end());
        std::vector<std::int32_t> open(row.used);
        while (!open.empty()) {
            const Reduced& next = rows_[static_cast<std::size_t>(open.back())];
            open.pop_back();
            members.insert(next.member);
            for (const std::int32_t used : next.used)
                if (known.insert(used).second) open.push_back(used);
        }
        return {members.begin(), members.end()};
    }

    /// Replaces unknowns that are pivots of earlier rows; returns the largest value met on the way.
    double substitute(Reduced& row) const
    {
        double largest = 0.0;
        for (bool found = true; found;) {
            found = false;
            for (const auto& [unknown, coefficient] : row.terms) {
                const std::int32_t pivot = pivot_of_[static_cast<std::size_t>(unknown)];
                if (pivot < 0) continue;
                const double c = coefficient;
                const Reduced& known = rows_[static_cast<std::size_t>(pivot)];
                row.terms.erase(unknown);
                for (const auto& [other, k] : known.terms) row.terms[other] -= c * k;
                row.value -= c * known.value;
                if (known.value.size() > 0)
                    largest = std::max(largest, std::abs(c) * known.value.cwiseAbs().maxCoeff());
                row.used.push_back(pivot);
                found = true;
                break;
            }
        }
        return largest;
    }

    void drop_below(Reduced& row, double size) const
    {
        std::erase_if(row.terms, [&](const auto& term) { return std::abs(term.second) * scale_[term.first] <= size; });
    }

    void keep(Reduced row)
    {
        const auto weight = [&](const auto& term) { return std::abs(term.second) * scale_[term.first]; };
        const auto largest = std::max_element(row.terms.begin(), row.terms.end(), [&](const auto& a, const auto& b) {
            return weight(a) < weight(b) * (1.0 - 1e-9);
        });
        row.pivot = largest->first;
        const double c = largest->second;
        row.terms.erase(largest);
        for (auto& [unknown, coefficient] : row.terms) coefficient /= c;
        row.value /= c;
        pivot_of_[static_cast<std::size_t>(row.pivot)] = static_cast<std::int32_t>(rows_.size());
        rows_.push_back(std::move(row));
    }

    std::vector<std::int32_t> pivot_of_; ///< row of which an unknown is the pivot, or -1
    std::vector<Reduced> rows_;
    const Eigen::VectorXd& scale_;
};

Elimination Eliminator::result(std::size_t n_cases)
{
    Elimination e;
    std::vector<Eigen::Triplet<double>> triplets;
    std::vector<std::int32_t> column(pivot_of_.size(), -1);
    std::int32_t n_free = 0;
    for (std::size_t i = 0; i < pivot_of_.size(); ++i) {
        if (pivot_of_[i] >= 0) continue;
        column[i] = n_free++;
        triplets.emplace_back(static_cast<int>(i), column[i], 1.0);
    }
    e.x0 = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(pivot_of_.size()), static_cast<Eigen::Index>(n_cases));
    // A row knows only pivots of later rows: from the last to the first every one becomes free of pivots.
    for (std::size_t r = rows_.size(); r-- > 0;) {
        Reduced& row = rows_[r];
        substitute(row);
        for (const auto& [unknown, c] : row.terms)
            triplets.emplace_back(row.pivot, column[static_cast<std::size_t>(unknown)], -c);
        e.x0.row(row.pivot) = row.value.transpose();
        e.dependent.push_back(row.pivot);
    }
    e.T.resize(static_cast<Eigen::Index>(pivot_of_.size()), n_free);
    e.T.setFromTriplets(triplets.begin(), triplets.end());
    return e;
}

} // namespace

Elimination eliminate(const std::vector<ConstraintRow>& rows, std::size_t n_unknowns, std::size_t n_cases,
                      const Eigen::VectorXd& scale)
{
    Eliminator eliminator(n_unknowns, scale);
    std::vector<Elimination::Conflict> conflicts;
    for (const ConstraintRow& row : rows) eliminator.add(row, conflicts);
    Elimination e = eliminator.result(n_cases);
    e.conflicts = std::move(conflicts);
    return e;
}

} // namespace femoop
