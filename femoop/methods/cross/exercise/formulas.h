#pragma once

#include <vector>

#include "femoop/methods/cross/exercise/figure.h"
#include "femoop/methods/cross/exercise/form.h"

namespace femoop::cross {

/// Works cells out of the figures that stand before them.
class Formulas {
public:
    /// \param figures  of the first blanks of the form, as many as there are yet; both outlive the formulas
    Formulas(const Form& form, const std::vector<Figure>& figures) : form_(form), figures_(figures) {}

    /// What belongs in a cell. A balance has two: of what came to the joint since its last balance, and of everything
    /// in its columns, which differ by what rounding left.
    std::vector<Figure> of(BlankId id) const;

    Figure stiffness(EndId end) const;
    Figure factor(EndId end) const;
    Figure fixed_end(std::size_t sheet, EndId end) const;
    Figure sum(std::size_t sheet, EndId end) const;
    Figure holding(std::size_t sheet, std::size_t sway) const;
    Figure multiplier(std::size_t sway) const;

    /// A number of a joint's columns before a turn.
    struct Line {
        Asked asked = Asked::FixedEnd; ///< or Balance or CarryOver
        std::size_t step = 0;
        EndId end;
        Figure figure;
    };
    /// \param first  turns before it are left out, and with them the fixed-end moments unless it is 0
    std::vector<Line> lines(std::size_t sheet, EndId end, std::size_t first, std::size_t last) const;
    /// All that acts on a joint when its turn comes, its columns together, since its last balance or since the start.
    struct Unbalance {
        std::vector<Line> lines;
        double joint_load = 0.0; ///< from outside, if it is not balanced yet
        bool is_first = true;    ///< the joint was not balanced before
        Figure total() const;
    };
    Unbalance unbalance(const Blank& balance) const;
    Unbalance whole_unbalance(const Blank& balance) const;
    /// The ends whose balance is carried over to a blank's end.
    EndId near_end(const Blank& carry_over) const { return *form_.problem[carry_over.end].far; }

private:
    Figure figure(Asked asked, std::size_t sheet, std::size_t step, std::size_t which, double otherwise) const;
    Figure fixed_end_formula(const Blank& blank) const;
    Figure holding_formula(const Blank& blank) const;
    Figure multiplier_formula(const Blank& blank) const;
    Figure final_formula(const Blank& blank) const;
    std::size_t turn_before(const Blank& balance) const; ///< one past the joint's last turn; 0 where it had none

    const Form& form_;
    const std::vector<Figure>& figures_;
};

} // namespace femoop::cross
