#include "femoop/model/quantity/quantity_parser.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "femoop/model/check/suggestion.h"
#include "femoop/model/quantity/double_double.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"

namespace femoop {

namespace {

/// numerator / denominator x 10^ten, in m, N, s, K and rad. The three parts stay exact.
struct Scale {
    DoubleDouble numerator = 1.0;
    DoubleDouble denominator = 1.0;
    int ten = 0;

    bool is_power_of_ten() const { return numerator.hi == 1.0 && denominator.hi == 1.0; }
};

Scale operator*(const Scale& a, const Scale& b)
{
    return {a.numerator * b.numerator, a.denominator * b.denominator, a.ten + b.ten};
}

Scale power(const Scale& base, int exponent)
{
    const int size = std::abs(exponent);
    const Scale raised{power(base.numerator, size), power(base.denominator, size), base.ten * size};
    return exponent >= 0 ? raised : Scale{raised.denominator, raised.numerator, -raised.ten};
}

struct Unit {
    std::string_view name;
    Dimension dimension;
    Scale scale;
};

constexpr double lbf_e13 = 44482216152605.0; // 1 lbf = 0.45359237 kg x 9.80665 m/s^2
const DoubleDouble pi{3.141592653589793, 1.2246467991473532e-16};

const std::array<Unit, 31>& unit_table()
{
    static const std::array<Unit, 31> units{{
        {"m", dimension::length, {1.0, 1.0, 0}},
        {"mm", dimension::length, {1.0, 1.0, -3}},
        {"cm", dimension::length, {1.0, 1.0, -2}},
        {"km", dimension::length, {1.0, 1.0, 3}},
        {"in", dimension::length, {254.0, 1.0, -4}},
        {"ft", dimension::length, {3048.0, 1.0, -4}},
        {"N", dimension::force, {1.0, 1.0, 0}},
        {"kN", dimension::force, {1.0, 1.0, 3}},
        {"MN", dimension::force, {1.0, 1.0, 6}},
        {"lbf", dimension::force, {lbf_e13, 1.0, -13}},
        {"kip", dimension::force, {lbf_e13, 1.0, -10}},
        {"tf", dimension::force, {980665.0, 1.0, -2}},
        {"kgf", dimension::force, {980665.0, 1.0, -5}},
        {"Pa", dimension::stress, {1.0, 1.0, 0}},
        {"kPa", dimension::stress, {1.0, 1.0, 3}},
        {"MPa", dimension::stress, {1.0, 1.0, 6}},
        {"GPa", dimension::stress, {1.0, 1.0, 9}},
        {"psi", dimension::stress, {lbf_e13, 254.0 * 254.0, -5}},
        {"ksi", dimension::stress, {lbf_e13, 254.0 * 254.0, -2}},
        {"kg", dimension::mass, {1.0, 1.0, 0}},
        {"g", dimension::mass, {1.0, 1.0, -3}},
        {"t", dimension::mass, {1.0, 1.0, 3}},
        {"lb", dimension::mass, {45359237.0, 1.0, -8}},
        {"s", {.time = 1}, {1.0, 1.0, 0}},
        {"ms", {.time = 1}, {1.0, 1.0, -3}},
        {"Hz", dimension::frequency, {1.0, 1.0, 0}},
        {"deg", dimension::angle, {pi, 180.0, 0}},
        {"rad", dimension::angle, {1.0, 1.0, 0}},
        {"K", dimension::temperature, {1.0, 1.0, 0}},
        {"degC", dimension::temperature, {1.0, 1.0, 0}},
        {"degF", dimension::temperature, {5.0, 9.0, 0}},
    }};
    return units;
}

const Unit* find_unit(std::string_view name)
{
    for (const Unit& unit : unit_table())
        if (unit.name == name) return &unit;
    return nullptr;
}

std::optional<std::string> nearest_unit(std::string_view name)
{
    std::vector<std::string_view> names;
    for (const Unit& unit : unit_table()) names.push_back(unit.name);
    return nearest(name, names);
}

/// A unit as it was typed: what it measures, and how large it is.
struct Measure {
    Dimension dimension;
    Scale scale;
    bool has_unit = false;
};

/// A decimal as it was typed: its digits as an integer and the power of ten behind them.
struct Decimal {
    std::string_view text;
    double value = 0.0;
    std::uint64_t digits = 0;
    int ten = 0;
    bool is_negative = false;
    bool is_exact = true; ///< digits hold the whole number
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool ends_name(char c)
{
    return is_blank(c) || is_digit(c) || c == '*' || c == '/' || c == '^' || c == '-' || c == ',';
}

class Parser {
public:
    /// \pre `text` is `typed` with the signs of files
    Parser(std::string_view text, std::string_view typed, Dimension wanted, const Units& units, AngleUnit angle)
        : text_(text), typed_(typed), wanted_(wanted), units_(units), angle_(angle)
    {}

    std::variant<double, Fault> run()
    {
        const auto number = decimal();
        if (!number) return fault_;
        const auto measure = unit();
        if (!measure || !has_wanted_dimension(*measure)) return fault_;
        const double value = measure->has_unit ? convert(*number, *measure) : number->value;
        if (std::isfinite(value)) return value;
        return refuse(FaultKind::QuantityTooLarge, {});
    }

private:
    Fault refuse(FaultKind kind, std::vector<std::string> details)
    {
        fault_ = {kind, {"", std::string(typed_)}};
        fault_.arguments.insert(fault_.arguments.end(), details.begin(), details.end());
        return fault_;
    }

    std::string wanted_unit() const
    {
        if (wanted_ == dimension::density) return "kg/m^3"; // which nobody writes in forces
        const bool is_degrees = angle_ == AngleUnit::Degrees && wanted_ == dimension::angle;
        return is_degrees ? "deg" : unit_text(wanted_, units_);
    }
    std::string example() const { return wanted_ == dimension::none ? "0.3" : "12.5 " + wanted_unit(); }

    void skip_blanks()
    {
        while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    }
    bool is_at_end() const { return at_ == text_.size(); }
    bool takes(char wanted)
    {
        if (is_at_end() || text_[at_] != wanted) return false;
        ++at_;
        return true;
    }

    std::optional<Decimal> decimal()
    {
        skip_blanks();
        Decimal number;
        number.is_negative = takes('-');
        if (!number.is_negative) takes('+');
        const std::size_t begin = at_;
        const bool begins_well = !is_at_end() && (is_digit(text_[at_]) || text_[at_] == '.');
        const char* const last = text_.data() + text_.size();
        const auto [end, error] = std::from_chars(text_.data() + begin, last, number.value);
        if (begins_well && error == std::errc::result_out_of_range) {
            refuse(FaultKind::QuantityTooLarge, {});
            return std::nullopt;
        }
        if (const auto plain = with_hyphen(text_.substr(begin))) {
            refuse(FaultKind::QuantityWithTypographicMinus, {*plain});
            return std::nullopt;
        }
        if (!begins_well || error != std::errc()) {
            refuse(FaultKind::QuantityWithoutNumber, {example()});
            return std::nullopt;
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        number.text = text_.substr(begin, at_ - begin);
        if (number.is_negative) number.value = -number.value;
        split(number);
        return number;
    }

    static void split(Decimal& number)
    {
        bool is_past_point = false;
        std::size_t i = 0;
        for (; i < number.text.size() && number.text[i] != 'e' && number.text[i] != 'E'; ++i) {
            if (number.text[i] == '.') {
                is_past_point = true;
                continue;
            }
            number.is_exact = number.is_exact && number.digits < 100'000'000'000'000'000U;
            if (!number.is_exact) return;
            number.digits = number.digits * 10 + static_cast<std::uint64_t>(number.text[i] - '0');
            if (is_past_point) --number.ten;
        }
        if (i == number.text.size()) return;
        const std::size_t begin = number.text[i + 1] == '+' ? i + 2 : i + 1;
        int exponent = 0;
        std::from_chars(number.text.data() + begin, number.text.data() + number.text.size(), exponent);
        number.is_exact = std::abs(exponent) < 400;
        number.ten += exponent;
    }

    std::optional<Measure> unit()
    {
        skip_blanks();
        Measure measure;
        if (is_at_end()) return measure;
        if (text_[at_] == ',') {
            refuse(FaultKind::QuantityWithComma, {});
            return std::nullopt;
        }
        measure.has_unit = true;
        if (text_[at_] != '/' && !multiply(measure, 1)) return std::nullopt;
        for (skip_blanks(); !is_at_end(); skip_blanks()) {
            const bool divides = takes('/');
            if (!divides && !takes('*')) {
                refuse(FaultKind::QuantityBadUnit, {std::string(text_.substr(at_))});
                return std::nullopt;
            }
            if (!multiply(measure, divides ? -1 : 1)) return std::nullopt;
        }
        return measure;
    }

    bool multiply(Measure& measure, int sign)
    {
        skip_blanks();
        if (takes('1') && (is_at_end() || is_blank(text_[at_]) || text_[at_] == '/' || text_[at_] == '*')) return true;
        const std::size_t begin = at_;
        while (!is_at_end() && !ends_name(text_[at_])) ++at_;
        const std::string_view name = text_.substr(begin, at_ - begin);
        const Unit* unit = find_unit(name);
        if (unit == nullptr) return refuse_unit(name, begin);
        const auto exponent = power_of(sign);
        return exponent && raise(measure, *unit, *exponent);
    }

    bool refuse_unit(std::string_view name, std::size_t begin)
    {
        if (name.empty()) refuse(FaultKind::QuantityBadUnit, {std::string(text_.substr(begin))});
        else if (const auto near = nearest_unit(name))
            refuse(FaultKind::QuantityUnknownUnitNear, {std::string(name), *near});
        else refuse(FaultKind::QuantityUnknownUnit, {std::string(name)});
        return false;
    }

    std::optional<int> power_of(int sign)
    {
        skip_blanks();
        if (!takes('^')) return sign;
        skip_blanks();
        int exponent = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), exponent);
        if (error != std::errc() || std::abs(exponent) > 9) {
            refuse(FaultKind::QuantityBadUnit, {std::string(text_.substr(at_))});
            return std::nullopt;
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        return sign * exponent;
    }

    bool raise(Measure& measure, const Unit& unit, int exponent)
    {
        bool fits = true;
        const auto add = [&](std::int8_t& total, std::int8_t part) {
            const int sum = total + part * exponent;
            fits = fits && std::abs(sum) <= 36;
            if (fits) total = static_cast<std::int8_t>(sum);
        };
        add(measure.dimension.length, unit.dimension.length);
        add(measure.dimension.force, unit.dimension.force);
        add(measure.dimension.time, unit.dimension.time);
        add(measure.dimension.temperature, unit.dimension.temperature);
        add(measure.dimension.angle, unit.dimension.angle);
        measure.scale = measure.scale * power(unit.scale, exponent);
        if (!fits) refuse(FaultKind::QuantityBadUnit, {std::string(text_)});
        return fits;
    }

    bool has_wanted_dimension(const Measure& measure)
    {
        if (!measure.has_unit) {
            if (wanted_ == dimension::none) return true;
            refuse(FaultKind::QuantityWithoutUnit, {example()});
            return false;
        }
        Dimension found = measure.dimension;
        if (found.angle == 0 && wanted_ != dimension::angle) found.angle = wanted_.angle;
        if (found == wanted_) return true;
        if (wanted_ == dimension::none) refuse(FaultKind::QuantityUnwantedUnit, {description(measure.dimension)});
        else
            refuse(FaultKind::QuantityWrongDimension,
                   {description(measure.dimension), description(wanted_), wanted_unit()});
        return false;
    }

    Scale base() const
    {
        const Scale turn = angle_ == AngleUnit::Degrees ? find_unit("deg")->scale : Scale{};
        return power(find_unit(name(units_.length))->scale, wanted_.length) *
               power(find_unit(name(units_.force))->scale, wanted_.force) * power(turn, wanted_.angle);
    }

    double convert(const Decimal& number, const Measure& measure) const
    {
        const Scale scale = measure.scale * power(base(), -1);
        if (!number.is_exact) return with_scale(number.value, scale);
        if (scale.is_power_of_ten()) return shifted(number, scale.ten);
        const DoubleDouble ten = power(DoubleDouble(10.0), std::abs(number.ten + scale.ten));
        const auto high = static_cast<double>(number.digits);
        const auto low = static_cast<double>(static_cast<std::int64_t>(number.digits) -
                                             static_cast<std::int64_t>(high));
        DoubleDouble value = DoubleDouble(high, low) * scale.numerator;
        value = number.ten + scale.ten >= 0 ? value * ten / scale.denominator : value / (scale.denominator * ten);
        return number.is_negative ? -value.rounded() : value.rounded();
    }

    static double with_scale(double value, const Scale& scale)
    {
        return (DoubleDouble(value) * (scale.numerator / scale.denominator)).rounded() * std::pow(10.0, scale.ten);
    }

    // "1140 cm^4" in m is the decimal 1140e-8: the standard library rounds it once, correctly.
    static double shifted(const Decimal& number, int ten)
    {
        const std::string text = std::to_string(number.digits) + "e" + std::to_string(number.ten + ten);
        double value = 0.0;
        const auto error = std::from_chars(text.data(), text.data() + text.size(), value).ec;
        if (error != std::errc()) value = number.ten + ten > 0 ? HUGE_VAL : 0.0;
        return number.is_negative ? -value : value;
    }

    std::string_view text_, typed_;
    Dimension wanted_;
    Units units_;
    AngleUnit angle_;
    std::size_t at_ = 0;
    Fault fault_{FaultKind::QuantityBadUnit, {}};
};

Scale base_scale(Dimension dimension, const Units& units)
{
    return power(find_unit(name(units.length))->scale, dimension.length) *
           power(find_unit(name(units.force))->scale, dimension.force);
}

} // namespace

std::variant<double, Fault> parse_quantity(std::string_view text, Dimension wanted, const Units& units, AngleUnit angle)
{
    const bool is_plain = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
    const std::string in_file = is_plain ? std::string() : with_file_signs(text);
    return Parser(is_plain ? text : in_file, text, wanted, units, angle).run();
}

double converted(double value, Dimension dimension, const Units& from, const Units& to)
{
    const Scale scale = base_scale(dimension, from) * power(base_scale(dimension, to), -1);
    const DoubleDouble ten = power(DoubleDouble(10.0), std::abs(scale.ten));
    const DoubleDouble scaled = DoubleDouble(value) * scale.numerator;
    return (scale.ten >= 0 ? scaled * ten / scale.denominator : scaled / (scale.denominator * ten)).rounded();
}

} // namespace femoop
