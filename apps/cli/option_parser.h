#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): the name that its authors gave it
class App;
class Option;
} // namespace CLI

namespace cli {

/// An option that a command has declared.
class DeclaredOption {
public:
    explicit DeclaredOption(CLI::Option* option) : option_(option) {}

    DeclaredOption& option_text(const std::string& text);     ///< what help calls its value: `ID`
    DeclaredOption& one_value_each();                         ///< that may be given again, with another value
    DeclaredOption& last_value();                             ///< the same, of whose values the last one counts
    DeclaredOption& add_description(const std::string& text); ///< behind a semicolon
    std::vector<std::string> results() const;                 ///< all values that were given

private:
    CLI::Option* option_;
};

/// What a command declares its options with: each is bound to a member of the command, which must outlive this. Alone
/// knows CLI11, which takes long to compile.
class OptionParser {
public:
    explicit OptionParser(CLI::App& app) : app_(app) {}

    DeclaredOption add_option(const std::string& name, std::string& value, const std::string& description);
    DeclaredOption add_option(const std::string& name, std::optional<std::string>& value,
                              const std::string& description);
    DeclaredOption add_option(const std::string& name, std::vector<std::string>& values,
                              const std::string& description);
    void add_flag(const std::string& name, bool& value, const std::string& description);

    DeclaredOption option(const std::string& name); ///< \pre it is declared

private:
    CLI::App& app_;
};

} // namespace cli
