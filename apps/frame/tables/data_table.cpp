#include "apps/frame/tables/data_table.h"

#include <algorithm>

#include "apps/frame/tables/new_row.h"
#include "ui/text/catalogue.h"
#include "ui/text/trimmed.h"

namespace frame {

using femoop::Model;

namespace {

Heading heading_of(const Column& column, const Manner& manner)
{
    std::string label = manner.units.label(manner.tr(column.heading), column.measure);
    if (column.is_number) return number_heading(std::move(label), bool(column.write));
    return {{std::move(label), "", tabular::Alignment::Left}, bool(column.write)};
}

bool is_blank(const std::vector<std::string>& texts)
{
    return std::ranges::all_of(texts, [](const std::string& text) { return ui::trimmed(text).empty(); });
}

/// Fills the cells of a copy of the document, one line of texts after the other.
class Filling {
public:
    Filling(const Document& document, TableKind kind, const Target& target, const Manner& manner)
        : before_(document.model),
          next_(document),
          kind_(kind),
          target_(target),
          manner_(manner),
          columns_(columns(before_, kind)),
          parts_(parts_of(before_, kind))
    {}

    void take(const TextBlock& texts)
    {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const std::size_t row = target_.row + i;
            if (row < parts_.size()) change(row, texts[i]);
            else if (is_blank(texts[i])) continue;
            else if (can_grow(kind_)) add(row, texts[i]);
            else refuse(row, columns_.size(), manner_.tr("this table gets its rows from another one"));
        }
        refuse_double_names();
        if (faults_.empty()) move_loads(next_, moves_);
    }

    Filled result(const Document& document) &&
    {
        if (!faults_.empty()) next_ = document;
        return {std::move(next_), std::move(faults_)};
    }

private:
    struct Touched {
        std::size_t row;
        Part part;
    };

    void refuse(std::size_t row, std::size_t column, std::string reason)
    {
        faults_.push_back({row, column, std::move(reason)});
    }

    // Texts beyond the last column, unless they are blank.
    bool is_beyond(std::size_t row, std::size_t column, const std::string& text)
    {
        if (column < columns_.size()) return false;
        const bool is_first = faults_.empty() || faults_.back().row != row || faults_.back().column < columns_.size();
        if (!text.empty() && is_first) refuse(row, columns_.size(), manner_.tr("the table has no more columns"));
        return true;
    }

    void change(std::size_t row, const std::vector<std::string>& texts)
    {
        const Part part = parts_[target_.order.empty() ? row : target_.order.at(row)];
        for (std::size_t j = 0; j < texts.size(); ++j) {
            const std::size_t column = target_.column + j;
            const std::string text(ui::trimmed(texts[j]));
            if (is_beyond(row, column, text) || says_nothing_new(part, columns_[column], text)) continue;
            const bool is_beside_others = texts.size() > 1;
            if (columns_[column].write || !is_beside_others) write({row, column}, part, text);
        }
        if (auto reason = why_not_row(next_.model, part, manner_.tr)) refuse(row, target_.column, *reason);
        touched_.push_back({row, part});
    }

    bool says_nothing_new(const Part& part, const Column& column, const std::string& text) const
    {
        const Cell cell = cell_of(column.read(before_, part), column.measure, manner_);
        return text == exact_text(cell.value) || text == cell.typed;
    }

    struct Place {
        std::size_t row, column;
    };
    void write(Place at, const Part& part, const std::string& text)
    {
        const Column& column = columns_[at.column];
        Refusal reason = manner_.tr("this column follows from the others");
        if (column.write) reason = column.write(next_, part, {text, manner_, moves_});
        if (reason) refuse(at.row, at.column, *reason);
    }

    void add(std::size_t row, const std::vector<std::string>& texts)
    {
        const std::size_t n_faults = faults_.size();
        const Part part = append(next_, kind_);
        std::vector<std::string> line(columns_.size());
        for (std::size_t j = 0; j < texts.size(); ++j) {
            const std::size_t column = target_.column + j;
            const std::string text(ui::trimmed(texts[j]));
            if (!is_beyond(row, column, text)) line[column] = text;
        }
        for (std::size_t column = 0; column < line.size(); ++column) {
            const bool is_needed = columns_[column].need == Need::Required;
            if (!line[column].empty() && columns_[column].write) write({row, column}, part, line[column]);
            else if (line[column].empty() && is_needed) refuse(row, column, value_needed(manner_));
        }
        if (faults_.size() > n_faults) return;
        give_name(next_.model, part);
        if (auto reason = why_not_row(next_.model, part, manner_.tr)) refuse(row, columns_.size(), *reason);
        touched_.push_back({row, part});
    }

    void refuse_double_names()
    {
        for (const Touched& row : touched_) {
            if (const auto name = double_name(next_.model, row.part))
                refuse(row.row, 0, manner_.tr("the name \"{text}\" is taken", {{"text", *name}}));
        }
    }

    const Model& before_;
    Document next_;
    TableKind kind_;
    const Target& target_;
    const Manner& manner_;
    std::vector<Column> columns_;
    std::vector<Part> parts_;
    std::vector<Touched> touched_;
    std::vector<CaseMove> moves_;
    std::vector<CellFault> faults_;
};

} // namespace

Table data_table(const Model& model, TableKind kind, const Manner& manner)
{
    Table table;
    const std::vector<Column> all = columns(model, kind);
    for (const Column& column : all) table.headings.push_back(heading_of(column, manner));
    for (const Part& part : parts_of(model, kind)) {
        Row row{part, {}};
        for (const Column& column : all) row.cells.push_back(cell_of(column.read(model, part), column.measure, manner));
        table.rows.push_back(std::move(row));
    }
    return table;
}

namespace {

std::string place_text(const CellFault& fault, const Table& table, const ui::Catalogue& tr)
{
    const std::string row = std::to_string(fault.row + 1);
    if (fault.column >= table.headings.size()) return tr("row {row}", {{"row", row}});
    return tr("row {row}, {column}", {{"row", row}, {"column", table.headings[fault.column].column.label()}});
}

} // namespace

std::string sentence(const std::vector<CellFault>& faults, const Table& table, const ui::Catalogue& tr)
{
    const std::string first = place_text(faults.front(), table, tr) + ": " + faults.front().reason;
    std::string others;
    constexpr std::size_t most = 3;
    for (std::size_t i = 1; i < faults.size() && i <= most; ++i)
        others += (i > 1 ? "; " : "") + place_text(faults[i], table, tr);
    if (faults.size() > most + 1) others += "; …";
    return others.empty() ? first : tr("{sentence}. See also: {cells}", {{"sentence", first}, {"cells", others}});
}

Filled filled(const Document& document, TableKind kind, const Target& target, const TextBlock& texts,
              const Manner& manner)
{
    Filling filling(document, kind, target, manner);
    filling.take(texts);
    return std::move(filling).result(document);
}

TextBlock read_block(std::string_view tsv, const Table& table, std::size_t first_column)
{
    TextBlock block = tabular::read_separated(tsv, tabular::tabs.cell);
    if (block.empty()) return block;
    bool are_headings = true;
    for (std::size_t j = 0; j < block.front().size(); ++j) {
        const std::size_t column = first_column + j;
        are_headings = are_headings && column < table.headings.size() &&
                       ui::trimmed(block.front()[j]) == table.headings[column].column.label();
    }
    if (are_headings) block.erase(block.begin());
    return block;
}

} // namespace frame
