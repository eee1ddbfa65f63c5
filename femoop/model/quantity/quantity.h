#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace femoop {

/// A number as the user gave it: its value in the model's base units, and the text if it was typed with a unit.
///
/// A bare number is kept bit for bit; `"-25 kN/m"` keeps its text until the value is edited, so that nothing
/// that was converted is ever saved. Assigning a number drops the text.
class Quantity {
public:
    Quantity() = default;
    Quantity(double value) : value_(value) {} // NOLINT: a number is a quantity in base units
    Quantity(double value, std::string text) : value_(value), text_(std::make_unique<std::string>(std::move(text))) {}

    Quantity(const Quantity& other) : value_(other.value_), text_(copy(other.text_)) {}
    Quantity(Quantity&&) noexcept = default;
    Quantity& operator=(const Quantity& other) { return *this = Quantity(other); }
    Quantity& operator=(Quantity&&) noexcept = default;
    ~Quantity() = default;

    operator double() const { return value_; } // NOLINT: formulas read the value in base units
    double value() const { return value_; }    ///< in the model's base units
    bool has_text() const { return text_ != nullptr; }
    std::string_view text() const { return text_ ? std::string_view(*text_) : std::string_view(); } ///< as typed

    friend bool operator==(const Quantity& a, const Quantity& b)
    {
        return a.value_ == b.value_ && a.text() == b.text();
    }

private:
    using Text = std::unique_ptr<const std::string>; // one pointer: large models hold millions of bare numbers
    static Text copy(const Text& text) { return text ? std::make_unique<const std::string>(*text) : nullptr; }

    double value_ = 0.0;
    Text text_;
};

} // namespace femoop
