#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A form of a word or a phrase: its words in lower case. A last hyphen stands for any ending.
using Form = std::vector<std::string>;

/// One row of courseware/glossary.md.
struct Term {
    std::string name;                 ///< as it stands in the row
    bool is_everyday = false;         ///< it has a remark in brackets, so its translation is free
    std::vector<Form> english;        ///< of which any is the term
    std::vector<Form> not_english;    ///< in no English sentence
    std::vector<Form> portuguese;     ///< of which one stands where the term stands
    std::vector<Form> not_portuguese; ///< in no Portuguese sentence
};

/// The rows of all tables of a page in Markdown, table by table.
std::vector<std::vector<Term>> read_glossary(std::string_view page);

/// What a sentence and its translation do against the glossary, one line a word; empty if nothing.
std::string breaches(const std::vector<Term>& terms, std::string_view english, std::string_view portuguese);
