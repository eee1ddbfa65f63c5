// Every sentence of the programs has a translation, every translation is of a sentence, and both have the same places.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "apps/euler/document/gallery/gallery.h"
#include "apps/euler/document/stepper.h"
#include "femoop/load/design_code.h"
#include "femoop/model/fault/fault.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"
#include "topology/embedding/embedding.h"
#include "topology/halfedge/check/validate.h"
#include "topology/halfedge/operators/refusal.h"
#include "topology/mesh/mesh.h"
#include "topology/script/script_fault.h"
#include "ui/text/catalogue.h"

namespace {

namespace fs = std::filesystem;

// The string literals, adjacent ones joined, from `place` on; empty if none stands there.
std::string literal(const std::string& source, std::size_t place)
{
    std::string text;
    const auto skip_blanks = [&] {
        while (place < source.size() && std::isspace(static_cast<unsigned char>(source[place])) != 0) ++place;
    };
    skip_blanks();
    while (place < source.size() && source[place] == '"') {
        for (++place; place < source.size() && source[place] != '"'; ++place) {
            if (source[place] == '\\') ++place;
            const bool is_newline = source[place] == 'n' && source[place - 1] == '\\';
            text += is_newline ? '\n' : source[place];
        }
        ++place;
        skip_blanks();
    }
    return text;
}

bool is_word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

void collect(const std::string& source, const std::string& opening, std::set<std::string>& sentences)
{
    for (std::size_t at = source.find(opening); at != std::string::npos; at = source.find(opening, at + 1)) {
        const bool is_whole_word = at == 0 || !is_word_letter(source[at - 1]);
        const std::string sentence = is_whole_word ? literal(source, at + opening.size()) : "";
        if (!sentence.empty()) sentences.insert(sentence);
    }
}

// Comments are left out: they may show `tr("...")` as an example.
std::string without_comments(const std::string& source)
{
    std::string code;
    std::size_t begin = 0;
    while (begin < source.size()) {
        const std::size_t end = std::min(source.find('\n', begin), source.size());
        const std::string line = source.substr(begin, end - begin);
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == std::string::npos || line.compare(first, 2, "//") != 0) code += line + '\n';
        begin = end + 1;
    }
    return code;
}

// What the scripts of the gallery say of themselves and of their steps.
void collect_comments(std::set<std::string>& sentences)
{
    for (const euler::GalleryItem& item : euler::gallery()) {
        const euler::Stepper lesson(item.script);
        sentences.insert(lesson.heading().sentence);
        for (std::size_t step = 1; step <= lesson.n_steps(); ++step)
            sentences.insert(lesson.report(step).explanation.sentence);
    }
    sentences.erase("");
}

std::set<std::string> sentences_in_sources()
{
    std::set<std::string> sentences;
    for (const char* folder : {"femoop", "ui", "apps"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_folder()) / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".cpp" && extension != ".h") continue;
            const std::string source = without_comments(text_of(entry.path()));
            for (const char* opening : {"tr(", "tr_(", "tr()(", "translatable("}) collect(source, opening, sentences);
        }
    }
    for (int kind = 0; !femoop::pattern(static_cast<femoop::FaultKind>(kind)).empty(); ++kind)
        sentences.emplace(femoop::pattern(static_cast<femoop::FaultKind>(kind)));
    for (int kind = 0; kind < topology::n_refusal_kinds; ++kind)
        sentences.emplace(topology::pattern(static_cast<topology::RefusalKind>(kind)));
    for (int invariant = 0; invariant < topology::n_invariants; ++invariant)
        sentences.emplace(topology::pattern(static_cast<topology::Invariant>(invariant)));
    for (int fault = 0; fault < topology::n_embedding_faults; ++fault)
        sentences.emplace(topology::pattern(static_cast<topology::EmbeddingFault>(fault)));
    for (int fault = 0; fault < topology::n_script_faults; ++fault)
        sentences.emplace(topology::pattern(static_cast<topology::ScriptFault>(fault)));
    for (int fault = 0; fault < topology::n_mesh_faults; ++fault)
        sentences.emplace(topology::pattern(static_cast<topology::MeshFault>(fault)));
    for (const femoop::DesignCode code : femoop::design_codes()) {
        for (const femoop::LimitState state : limit_states(code)) sentences.emplace(short_name(code, state));
        for (const femoop::ActionKind& kind : action_kinds(code)) {
            sentences.emplace(kind.label);
            sentences.emplace(kind.table);
        }
    }
    collect_comments(sentences);
    sentences.emplace("line"); // before a line's number
    return sentences;
}

} // namespace

TEST_SUITE("ui text")
{
    TEST_CASE("Every sentence in the sources and every fault has a Portuguese translation")
    {
        const ui::Catalogue tr(ui::Language::Portuguese);
        const std::set<std::string> sentences = sentences_in_sources();
        REQUIRE(sentences.size() > 6);
        for (const std::string& sentence : sentences) {
            CAPTURE(sentence);
            CHECK(tr.has(sentence));
        }
    }

    TEST_CASE("A number that was computed has the reader's decimal mark, one of the file stays as it was typed")
    {
        const ui::Catalogue tr(ui::Language::Portuguese);
        using femoop::FaultKind;
        const auto has = [&](const femoop::Fault& fault, const char* part) {
            return femoop::message(fault, tr).find(part) != std::string::npos;
        };
        CHECK(has({FaultKind::MechanismMoveOblique, {"A.1", "(0.6, 0.8)"}},
                  "A.1 pode se deslocar ao longo de (0,6; 0,8)"));
        CHECK(has({FaultKind::MechanismTurn, {"A", "(2, 0, -1.25)"}}, "(2; 0; -1,25)"));
        CHECK(has({FaultKind::HugeDisplacement, {"A", "1.5e+09 m", "G"}}, "1,5e+09 m"));
        CHECK(has({FaultKind::MembersCross, {"members[1]", "B", "(0.5, 2) m"}}, "(0,5; 2) m"));
        CHECK(has({FaultKind::NotPositive, {"sections[0]", "A", "-0.5 m^2"}}, "-0.5 m^2"));
    }

    TEST_CASE("The words that fill a fault's sentence are translated with it, names and keys are not")
    {
        const ui::Catalogue tr(ui::Language::Portuguese);
        using femoop::FaultKind;
        CHECK(femoop::message(
                  {FaultKind::QuantityWrongDimension, {"a.E", "5 kN", "force", "stress or force per area", "Pa"}},
                  tr) == "a.E: \"5 kN\" mede força, esperado tensão ou força por área, por exemplo em Pa");
        CHECK(femoop::message({FaultKind::QuantityUnwantedUnit, {"nu", "5 kN^2*m", "force^2*length"}}, tr) ==
              "nu: \"5 kN^2*m\" mede força^2*comprimento, esperado um número puro; retire a unidade");
        CHECK(femoop::message({FaultKind::WrongType, {"nodes", "an object", "a list", "[...]"}}, tr) ==
              "nodes: encontrado um objeto, esperado uma lista; escreva como [...]");
        CHECK(femoop::message({FaultKind::WrongTypeText, {"nodes", "\"length\"", "a list", "[...]"}}, tr) ==
              "nodes: encontrado um texto \"length\", esperado uma lista; escreva como [...]");
        CHECK(femoop::message({FaultKind::NoSuchNode, {"members[0]", "length"}}, tr) ==
              "members[0]: não há nó \"length\"; acrescente o nó ou indique outro");
        CHECK(femoop::message({FaultKind::MechanismSwayX, {femoop::listed({"B", "and"})}}, tr)
                  .starts_with("a estrutura pode se mover sem se deformar: os nós B e and se deslocam"));
    }

    TEST_CASE("Every Portuguese translation is of a sentence that is still there, and stands once")
    {
        const std::set<std::string> sentences = sentences_in_sources();
        std::set<std::string> seen;
        for (const ui::PoEntry& entry : ui::compiled_entries(ui::Language::Portuguese)) {
            CAPTURE(entry.id);
            CHECK(sentences.contains(entry.id));
            CHECK(seen.insert(entry.id).second);
        }
    }

    TEST_CASE("A translation has the places of its sentence, no more and no fewer")
    {
        for (const ui::PoEntry& entry : ui::compiled_entries(ui::Language::Portuguese)) {
            CAPTURE(entry.id);
            CHECK(ui::places(entry.id) == ui::places(entry.text));
        }
    }

    TEST_CASE("The search for sentences joins literals, reads escapes and passes over other words")
    {
        std::set<std::string> found;
        collect("x = tr(\"say \\\"a\\\" \"\n \"b\"); str(\"no\"); tr(name);", "tr(", found);
        CHECK(found == std::set<std::string>{"say \"a\" b"});
    }
}
