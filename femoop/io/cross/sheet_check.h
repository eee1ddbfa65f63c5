#pragma once

#include <string>
#include <vector>

#include "femoop/io/cross/cross_block.h"
#include "femoop/io/verify.h"

namespace femoop::cross {

/// The one of two values.
double nearer_to(double wanted, double a, double b);

/// Compares what a file's `cross` block says with what is worked here, and keeps the outcomes.
class SheetCheck {
public:
    struct Tolerance {
        double absolute = 0.0, relative = 0.0;
    };

    /// \pre they outlive it
    SheetCheck(const Model& model, const Block& block, const Problem& problem, const Translator& tr);

    const Model& model() const { return model_; }
    const Block& block() const { return block_; }
    const Problem& problem() const { return problem_; }
    const Procedure& procedure() const { return procedure_; }
    const Translator& tr() const { return tr_; }
    Tolerance of_sheet() const { return {.absolute = block_.sheet_atol}; }
    /// Of exact values; numbers that are 0 may be as far off as rounding leaves them beside the largest of their kind.
    Tolerance of_exact(double largest) const;

    /// One outcome for several values: that of the end which is furthest off.
    void row(const std::string& what, const Labelled& wanted, const std::vector<double>& values, Tolerance within);
    /// Exact values of two models of the same structure, with and without axial strain: each may be meant.
    struct Exact {
        std::vector<double> strained, unstrained;
    };
    void row(const std::string& what, const Labelled& wanted, const Exact& values);
    /// An exact value, \param largest  of its kind
    void number(const std::string& what, double wanted, double found, double largest);
    /// Which sheet of a file is meant: "cross.stages[1].sheet", "cross: stage 2".
    struct Place {
        std::string in_file, in_words;
    };
    /// Every row of a sheet. \throws ModelError (CrossSheetTooLong)
    void sheet(const std::vector<Block::Row>& wanted, const Problem& half, const Sheet& sheet, const Place& place);
    /// The sheet as far as the file's goes.
    Sheet worked(const Problem& half, const Loading& loading, const std::vector<Block::Row>& wanted) const;

    std::vector<CheckOutcome> take() { return std::move(outcomes_); }

private:
    CheckOutcome compared(const std::string& what, double wanted, double found, Tolerance within) const;
    double half_a_digit(double value) const;

    const Model& model_;
    const Block& block_;
    const Problem& problem_;
    const Translator& tr_;
    Procedure procedure_;
    std::vector<CheckOutcome> outcomes_;
};

} // namespace femoop::cross
