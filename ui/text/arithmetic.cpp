#include "ui/text/arithmetic.h"

#include <charconv>
#include <cmath>
#include <string>

namespace ui {

namespace {

/// Recursive descent. What cannot be read is left where it stands: an operator without a right side is no part of the
/// calculation, and may begin a unit.
class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    std::optional<double> sum()
    {
        return chain("+-", &Reader::product, [](char sign, double a, double b) { return sign == '+' ? a + b : a - b; });
    }
    std::size_t place() const { return place_; }
    bool is_computed() const { return is_computed_; }
    bool divides_by_zero() const { return divides_by_zero_; }

private:
    using Part = std::optional<double> (Reader::*)();
    static constexpr int deepest = 100; ///< parentheses and powers within one another

    template <class Apply> std::optional<double> chain(std::string_view operators, Part part, Apply&& apply)
    {
        std::optional<double> value = (this->*part)();
        while (value) {
            const std::size_t before = place_;
            const char sign = take_any(operators);
            const std::optional<double> right = sign != '\0' ? (this->*part)() : std::nullopt;
            if (!right) {
                place_ = before;
                return value;
            }
            is_computed_ = true;
            value = apply(sign, *value, *right);
        }
        return value;
    }

    std::optional<double> product()
    {
        return chain("*/", &Reader::factor, [this](char sign, double a, double b) {
            divides_by_zero_ = divides_by_zero_ || (sign == '/' && b == 0.0);
            return sign == '*' ? a * b : a / b;
        });
    }

    std::optional<double> factor()
    {
        if (depth_ >= deepest) return std::nullopt;
        ++depth_;
        const char sign = take_any("+-");
        std::optional<double> value = power();
        if (value && sign == '-') value = -*value;
        --depth_;
        return value;
    }

    std::optional<double> power()
    {
        const std::optional<double> base = atom();
        const std::size_t before = place_;
        if (!base || take_any("^") == '\0') return base;
        const std::optional<double> exponent = factor();
        if (!exponent) {
            place_ = before;
            return base;
        }
        is_computed_ = true;
        return std::pow(*base, *exponent);
    }

    std::optional<double> atom()
    {
        const std::size_t before = place_;
        if (take_any("(") == '\0') return number();
        const std::optional<double> inside = sum();
        if (inside && take_any(")") != '\0') {
            is_computed_ = true;
            return inside;
        }
        place_ = before;
        return std::nullopt;
    }

    std::optional<double> number()
    {
        skip_blanks();
        std::string plain(text_.substr(place_));
        for (char& c : plain) {
            if (c == ',') c = '.';
        }
        if (plain.empty() || !(plain[0] == '.' || (plain[0] >= '0' && plain[0] <= '9'))) return std::nullopt;
        double value = 0.0;
        const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
        if (error != std::errc()) return std::nullopt;
        place_ += static_cast<std::size_t>(end - plain.data());
        return value;
    }

    void skip_blanks()
    {
        while (place_ < text_.size() && (text_[place_] == ' ' || text_[place_] == '\t')) ++place_;
    }

    /// The next character if it is one of these, else '\0' and nothing is taken.
    char take_any(std::string_view characters)
    {
        const std::size_t before = place_;
        skip_blanks();
        if (place_ < text_.size() && characters.find(text_[place_]) != std::string_view::npos) return text_[place_++];
        constexpr std::string_view minus = "−"; // as pictures write it
        if (text_.substr(place_).starts_with(minus) && characters.find('-') != std::string_view::npos) {
            place_ += minus.size();
            return '-';
        }
        place_ = before;
        return '\0';
    }

    std::string_view text_;
    std::size_t place_ = 0;
    int depth_ = 0;
    bool is_computed_ = false;
    bool divides_by_zero_ = false;
};

constexpr std::size_t longest = 1000; // of what a person types; each number copies the rest

bool mixes_marks(std::string_view text)
{
    return text.find('.') != std::string_view::npos && text.find(',') != std::string_view::npos;
}

} // namespace

std::optional<LeadingNumber> leading_number(std::string_view text)
{
    if (text.size() > longest) return std::nullopt;
    Reader reader(text);
    const std::optional<double> value = reader.sum();
    if (!value || !std::isfinite(*value) || mixes_marks(text.substr(0, reader.place()))) return std::nullopt;
    return LeadingNumber{*value, reader.place(), reader.is_computed()};
}

bool divides_by_zero(std::string_view text)
{
    if (text.size() > longest) return false;
    Reader reader(text);
    reader.sum();
    return reader.divides_by_zero();
}

} // namespace ui
