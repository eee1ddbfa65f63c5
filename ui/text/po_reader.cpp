#include "ui/text/po_reader.h"

#include <set>
#include <utility>

namespace ui {

namespace {

class PoReader {
public:
    explicit PoReader(std::string_view text) : rest_(text) {}

    std::vector<PoEntry> entries()
    {
        while (!rest_.empty()) read_line(take_line());
        finish_entry();
        return std::move(entries_);
    }

private:
    enum class Field { None, Id, Text };

    [[noreturn]] void fail(const std::string& what) const
    {
        throw PoError("line " + std::to_string(line_) + ": " + what);
    }

    std::string_view take_line()
    {
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++line_;
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        return line;
    }

    void read_line(std::string_view line)
    {
        if (line.empty() || line.front() == '#') return;
        if (line.starts_with("msgid \"")) {
            finish_entry();
            entry_.line = line_;
            field_ = Field::Id;
            entry_.id = unquoted(line.substr(6));
        } else if (line.starts_with("msgstr \"")) {
            if (field_ != Field::Id) fail("msgstr without a msgid before it");
            field_ = Field::Text;
            entry_.text = unquoted(line.substr(7));
        } else if (line.front() == '"' && field_ != Field::None) {
            (field_ == Field::Id ? entry_.id : entry_.text) += unquoted(line);
        } else {
            fail("expected msgid, msgstr, a string in quotes or a comment, found: " + std::string(line));
        }
    }

    std::string unquoted(std::string_view quoted) const
    {
        if (quoted.size() < 2 || quoted.back() != '"') fail("a string without its closing quote");
        std::string text;
        for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
            if (quoted[i] == '"') fail("a quote inside a string; write \\\"");
            text += quoted[i] == '\\' ? escaped(quoted, ++i) : quoted[i];
        }
        return text;
    }

    char escaped(std::string_view quoted, std::size_t place) const
    {
        if (place + 1 >= quoted.size()) fail("a string without its closing quote");
        switch (quoted[place]) {
        case 'n': return '\n';
        case 't': return '\t';
        case '"': return '"';
        case '\\': return '\\';
        default: fail(std::string("unknown escape \\") + quoted[place]);
        }
    }

    void finish_entry()
    {
        if (field_ == Field::None) return;
        if (field_ == Field::Id) fail("msgid \"" + entry_.id + "\" without a msgstr");
        if (!entry_.id.empty()) {
            if (entry_.text.empty()) fail("msgid \"" + entry_.id + "\" has an empty translation");
            if (!seen_.insert(entry_.id).second) fail("msgid \"" + entry_.id + "\" stands twice");
            entries_.push_back(std::move(entry_));
        }
        entry_ = {};
        field_ = Field::None;
    }

    std::string_view rest_;
    std::size_t line_ = 0;
    Field field_ = Field::None;
    PoEntry entry_;
    std::vector<PoEntry> entries_;
    std::set<std::string> seen_;
};

} // namespace

std::vector<PoEntry> read_po(std::string_view text) { return PoReader(text).entries(); }

} // namespace ui
