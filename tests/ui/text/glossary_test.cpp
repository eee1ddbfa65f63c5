// courseware/glossary.md decides what a word means, and the programs keep to it in both languages.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "tests/text_of.h"
#include "tests/ui/text/glossary.h"
#include "ui/text/catalogue.h"

namespace {

std::vector<std::vector<Term>> glossary_tables() { return read_glossary(text_of_source("courseware/glossary.md")); }

std::vector<Term> glossary_terms()
{
    std::vector<Term> terms;
    for (const std::vector<Term>& table : glossary_tables()) terms.insert(terms.end(), table.begin(), table.end());
    return terms;
}

const char* const small_glossary = "| term | not | em português | não | meaning |\n|---|---|---|---|---|\n"
                                   "| case (loads) | | caso | | short for load case |\n"
                                   "| load | | carga, carreg- | | force from outside |\n"
                                   "| load case | loading case | caso de carga | carregamento | loads together |\n";

std::string breaches_of_small(const char* english, const char* portuguese)
{
    return breaches(read_glossary(small_glossary).front(), english, portuguese);
}

} // namespace

TEST_SUITE("ui text glossary")
{
    TEST_CASE("Every sentence of the programs keeps to the glossary, in English and in Portuguese")
    {
        const std::vector<Term> terms = glossary_terms();
        REQUIRE(terms.size() > 100);
        for (const ui::PoEntry& entry : ui::compiled_entries(ui::Language::Portuguese)) {
            CAPTURE(entry.id);
            CAPTURE(entry.text);
            CHECK(breaches(terms, entry.id, entry.text) == "");
        }
    }

    TEST_CASE("The glossary's tables are sorted, and each form of a term stands once")
    {
        std::set<Form> seen;
        for (const std::vector<Term>& table : glossary_tables()) {
            CHECK(std::is_sorted(table.begin(), table.end(),
                                 [](const Term& a, const Term& b) { return a.english < b.english; }));
            for (const Term& term : table) {
                CAPTURE(term.name);
                CHECK(!term.portuguese.empty());
                for (const Form& form : term.english) CHECK(seen.insert(form).second);
            }
        }
    }

    TEST_CASE("A term that is translated otherwise is noticed, a plural or a listed form is not")
    {
        CHECK(breaches_of_small("two loads", "duas cargas") == "");
        CHECK(breaches_of_small("load the beam", "carregue a viga") == "");
        CHECK(breaches_of_small("two loads", "duas forças") == "load: not translated so\n");
    }

    TEST_CASE("Of two terms in one place the longer one counts")
    {
        CHECK(breaches_of_small("the load cases", "os casos de carga") == "");
        CHECK(breaches_of_small("the load cases", "as cargas") == "load case: not translated so\n");
        CHECK(breaches_of_small("in that case", "então") == ""); // a remark in brackets: an everyday word
    }

    TEST_CASE("A word that the glossary rules out is noticed in its own language")
    {
        CHECK(breaches_of_small("loading case 1", "caso de carga 1") ==
              "load case: an English word for it is ruled out\n");
        CHECK(breaches_of_small("load case 1", "caso de carga do CARREGAMENTO") ==
              "load case: a Portuguese word for it is ruled out\n");
    }

    TEST_CASE("What is typed into a program is no text")
    {
        CHECK(breaches_of_small("write \"load\" or `load` or loads,labels in {load}", "escreva assim") == "");
    }
}
