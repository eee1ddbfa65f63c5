#pragma once

#include <string>

#include "femoop/methods/truss/joint_method.h"
#include "femoop/methods/truss/section_method.h"
#include "femoop/model/fault/translator.h"

namespace femoop::truss {

/// "N(AB)": the force of a bar in equations.
std::string force_symbol(MemberId bar, const Model& model);

/// An equation of equilibrium, one term after the other: "75 - 93.75·0.8 + N(L1U1) = 0". Terms of 0 are left out.
class EquationText {
public:
    explicit EquationText(const Translator& tr) : tr_(tr) {}
    void add(double size, double factor); ///< a force that is known, and its arm or cosine
    void add_unknown(const std::string& symbol, double factor);
    std::string text() const;

private:
    void append(bool is_negative, const std::string& term);

    const Translator& tr_;
    std::string text_;
};

/// The equation of a joint along x or y.
enum class Along : std::uint8_t { X, Y };
std::string joint_equation(const Step& step, Along along, const Model& model, const Translator& tr);

std::string cut_equation(const CutEquation& equation, const Model& model, const Translator& tr);

} // namespace femoop::truss
