#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace topology {

/// Turns an English pattern into the reader's language.
using PatternTranslator = std::function<std::string(std::string_view)>;

/// A line of a text that cannot be used. Its sentence is a pattern with places {0} {1} {2} and the words for them.
class LineError : public std::runtime_error {
public:
    /// \pre `pattern` lives as long as the program
    LineError(std::string_view pattern, const std::vector<std::string>& words);

    /// "line 7: mef s1 f1 v1 v9 f3: v9 is not in face f1"; the reason alone while no line is known.
    std::string sentence(const PatternTranslator& tr) const;
    std::string_view pattern() const { return pattern_; } ///< of the reason, without its line
    const std::vector<std::string>& words() const { return words_; }
    std::size_t number() const { return number_; }                 ///< of the line, from 1; 0 while none is known
    LineError at(std::size_t number, std::string_view line) const; ///< the same fault with its place

private:
    LineError(const LineError& fault, std::size_t number, std::string line);

    std::string_view pattern_;
    std::vector<std::string> words_;
    std::size_t number_ = 0;
    std::string line_;
};

} // namespace topology
