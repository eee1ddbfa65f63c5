#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace topology {

/// The lines of a text, one after another; the mark that some editors begin a file with is passed over.
class Lines {
public:
    explicit Lines(std::string_view text);

    bool next(); ///< goes on to the next line; false at the end
    std::string_view line() const { return line_; }
    std::size_t number() const { return number_; } ///< from 1

private:
    std::string_view rest_, line_;
    std::size_t number_ = 0;
};

/// The words of a line: separated by blanks, up to a word that begins with #.
std::vector<std::string_view> words(std::string_view line);

/// Is the word well-formed UTF-8, so that it may stand in JSON?
bool is_utf8(std::string_view word);

/// A number that is the whole word, with a point for the decimals whatever the locale; none if it is not finite.
std::optional<double> finite_number(std::string_view word);

/// The fewest digits that read back as the same number.
std::string written(double value);

} // namespace topology
