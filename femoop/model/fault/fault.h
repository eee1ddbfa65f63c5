#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/fault/fault_kind.h"
#include "femoop/model/fault/translator.h"

namespace femoop {

enum class Severity : std::uint8_t { Error, Warning };

/// One thing wrong with a model: what kind, and the words that fill its sentence.
///
/// `message(fault)` is its English sentence, `message(fault, tr)` that of another language. An argument is a name, a
/// number, a key of the file or (`is_word`) a word of ours, such as the name of a dimension, which is translated too. A
/// number that was computed (`is_computed`) gets the reader's decimal mark; one that stands in the file stays as it is.
struct Fault {
    FaultKind kind;
    std::vector<std::string> arguments;

    friend bool operator==(const Fault&, const Fault&) = default;
};

bool is_word(FaultKind kind, std::size_t argument);
bool is_computed(FaultKind kind, std::size_t argument);
std::string_view pattern(FaultKind kind); ///< English sentence with places {0}, {1} ... for the arguments
Severity severity(FaultKind kind);
inline bool is_error(const Fault& fault) { return severity(fault.kind) == Severity::Error; }

/// An argument that lists several names: `fill` writes them as "A, B and C".
std::string listed(const std::vector<std::string>& names);

/// A file's own words for a terminal, which its control characters must not reach: they are written as JSON writes
/// them.
std::string printable(std::string_view text);

/// Puts the arguments into a pattern; `conjunction` stands before the last name of a list.
std::string fill(std::string_view pattern, const std::vector<std::string>& arguments,
                 std::string_view conjunction = "and");
std::string message(const Fault& fault, const Translator& tr = english);

/// A model that cannot be used, with every reason. `what()` is the sentences, one a line.
class ModelError : public std::runtime_error {
public:
    explicit ModelError(std::vector<Fault> faults);
    const std::vector<Fault>& faults() const { return faults_; }

private:
    std::vector<Fault> faults_;
};

} // namespace femoop
