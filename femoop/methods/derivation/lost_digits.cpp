#include "femoop/methods/derivation/lost_digits.h"

#include <algorithm>
#include <cmath>

namespace femoop::derivation {

namespace {

constexpr int most_digits = 12, most_more = 8;
constexpr double usual_loss = 5.0; ///< units of the last digit that a product may be off without more digits

int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

double to_digits(double value, int digits)
{
    if (value == 0.0) return 0.0;
    const double scale = std::pow(10.0, std::min(digits, most_digits) - 1 - exponent_of(value));
    return std::round(value * scale) / scale;
}

Eigen::MatrixXd to_digits(const Eigen::MatrixXd& matrix, int digits)
{
    return matrix.unaryExpr([digits](double value) { return to_digits(value, digits); });
}

/// How many digits more than usual the factors of A x have, or need.
struct MoreDigits {
    int of_A = 0, of_x = 0;
};

/// A product A x of a step, or of two.
struct Product {
    const Eigen::MatrixXd& A;
    const Eigen::VectorXd& x;
    int more_of_result = 0;

    /// By how many units of its last written digit an entry is off at most, if numbers have so many digits; entries
    /// that are small beside others need fewer of their own.
    double error(MoreDigits more, int digits) const
    {
        const Eigen::VectorXd exact = A * x;
        const Eigen::VectorXd written = to_digits(A, digits + more.of_A) * to_digits(x, digits + more.of_x);
        const double size = exact.cwiseAbs().maxCoeff();
        double worst = 0.0;
        for (Eigen::Index i = 0; i < exact.size(); ++i) {
            const double own = std::max(std::abs(exact[i]), 1e-3 * size);
            if (own == 0.0) continue;
            const double unit = std::pow(10.0, exponent_of(own) + 1 - std::min(digits + more_of_result, most_digits));
            worst = std::max(worst, std::abs(written[i] - exact[i]) / unit);
        }
        return worst;
    }

    /// With as many digits as the window writes, and as texts do.
    bool comes_out(MoreDigits more, double tolerance) const
    {
        return error(more, 4) <= tolerance && error(more, 6) <= tolerance;
    }

    MoreDigits needed() const
    {
        if (comes_out({}, usual_loss)) return {};
        for (int sum = 1; sum <= 2 * most_more; ++sum)
            for (int of_A = 0; of_A <= sum / 2; ++of_A)
                if (const MoreDigits more{of_A, sum - of_A}; more.of_x <= most_more && comes_out(more, 1.0))
                    return more;
        return {0, most_more};
    }
};

void note(NamedMatrix& A, NamedMatrix& x, int more_of_result = 0)
{
    if (A.values.size() == 0 || A.values.cols() != x.values.rows() || x.values.cols() != 1) return;
    const Eigen::VectorXd factor = x.values;
    const MoreDigits more = Product{A.values, factor, more_of_result}.needed();
    A.more_digits = std::max(A.more_digits, more.of_A);
    x.more_digits = std::max(x.more_digits, more.of_x);
}

NamedMatrix* find(std::vector<Step>& steps, const Step& of, StepKind kind, std::size_t matrix)
{
    const bool is_loaded = kind == StepKind::EndDisplacements;
    const auto found = std::ranges::find_if(steps, [&](const Step& step) {
        return step.kind == kind && step.member == of.member && (!is_loaded || step.load_case == of.load_case);
    });
    return found == steps.end() || found->matrices.size() <= matrix ? nullptr : &found->matrices[matrix];
}

void note_product(std::vector<Step>& steps, const Step& of, NamedMatrix* A, std::size_t displacements)
{
    NamedMatrix* const x = find(steps, of, StepKind::EndDisplacements, displacements);
    if (A != nullptr && x != nullptr) note(*A, *x);
}

/// k' is the last matrix of its step, behind what it is made of.
NamedMatrix* local_stiffness(std::vector<Step>& steps, const Step& of)
{
    NamedMatrix* const first = find(steps, of, StepKind::LocalStiffness, 0);
    if (first == nullptr || first->symbol == "k'") return first;
    return find(steps, of, StepKind::LocalStiffness, 1);
}

} // namespace

void note_lost_digits(std::vector<Step>& steps)
{
    for (Step& step : steps) {
        if (step.kind == StepKind::EndForces) note_product(steps, step, local_stiffness(steps, step), 1);
        if (step.kind == StepKind::NodeForces) note_product(steps, step, find(steps, step, StepKind::Stiffness, 0), 0);
    }
    for (Step& step : steps) {
        if (step.kind != StepKind::EndDisplacements) continue;
        NamedMatrix &u = step.matrices[0], &turned = step.matrices[1]; // which has the digits of what it is turned to
        NamedMatrix* const T = find(steps, step, StepKind::Transformation, 0);
        if (turned.more_digits > 0 && T != nullptr) note(*T, u, turned.more_digits);
    }
}

} // namespace femoop::derivation
