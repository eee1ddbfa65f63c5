#include "femoop/io/truss/truss_equation.h"

#include <cmath>

#include "femoop/model/quantity/six_digits.h"

namespace femoop::truss {

namespace {

constexpr double no_factor = 1e-12; // a cosine or arm that is round-off

} // namespace

std::string force_symbol(MemberId bar, const Model& model) { return "N(" + model[bar].id + ")"; }

void EquationText::append(bool is_negative, const std::string& term)
{
    if (text_.empty()) text_ = (is_negative ? "−" : "") + term;
    else text_ += (is_negative ? " − " : " + ") + term;
}

void EquationText::add(double size, double factor)
{
    if (size == 0.0 || std::abs(factor) < no_factor) return;
    const std::string number = six_digits(std::abs(size), tr_), other = six_digits(std::abs(factor), tr_);
    append((size < 0.0) != (factor < 0.0), other == "1" ? number : number + "·" + other);
}

void EquationText::add_unknown(const std::string& symbol, double factor)
{
    if (std::abs(factor) < no_factor) return;
    const std::string number = six_digits(std::abs(factor), tr_);
    append(factor < 0.0, number == "1" ? symbol : number + " " + symbol);
}

std::string EquationText::text() const { return (text_.empty() ? "0" : text_) + " = 0"; }

std::string joint_equation(const Step& step, Along along, const Model& model, const Translator& tr)
{
    EquationText equation(tr);
    const auto part = [&](const Eigen::Vector2d& vector) { return along == Along::X ? vector.x() : vector.y(); };
    for (const JointForce& force : step.forces) {
        if (force.is_found) equation.add_unknown(force_symbol(*force.bar, model), part(force.away));
        else if (force.bar) equation.add(force.value, part(force.away));
        else equation.add(part(force.on_joint), 1.0);
    }
    return (along == Along::X ? "ΣFx: " : "ΣFy: ") + equation.text();
}

std::string cut_equation(const CutEquation& equation, const Model& model, const Translator& tr)
{
    EquationText text(tr);
    for (const Share& share : equation.shares) text.add(share.size, share.factor);
    text.add_unknown(force_symbol(equation.bar, model), equation.factor);
    return (equation.ritter_point ? "ΣM: " : "ΣF: ") + text.text();
}

} // namespace femoop::truss
