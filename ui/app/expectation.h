#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/app/app.h"
#include "ui/paint/picture.h"
#include "ui/text/catalogue.h"

namespace ui {

/// What was found instead of what a scenario expects, and what was wanted; nothing where it is as expected.
using Mismatch = std::optional<std::string>;

Mismatch compared(std::string_view what, const std::string& found, const std::string& wanted);

/// The first word and what follows the blank after it.
std::pair<std::string_view, std::string_view> first_word(std::string_view words);

/// The expectations of every app:
///
///     drawn "58.52"     not drawn "58.52"          a whole string of the picture
///     written all.csv "Node;x"     not written …   a file that was written, with this in it
///     ends yes                                     the program would end now
///
/// \returns nothing for words that are none of these, else the complaint
std::optional<Mismatch> common_mismatch(std::string_view expectation, const App& app,
                                        const std::optional<Picture>& picture);
inline constexpr std::string_view common_expectations = "drawn, not drawn, written, not written, ends";

/// A word that stands for something of an app, or of its session: "step" for how many turns are done.
template <class Subject> struct Fact {
    std::string_view name;
    std::string (*found)(const Subject&);
};

inline std::string yes_or_no(bool is) { return is ? "yes" : "no"; }

/// The facts of an app: `own` and, of the document that is seen,
///
///     notice nothing     file cube.eul     changed no
///
/// \param own  "wanted one of" these \param more  further words that the app itself understands
template <class Subject> class Facts {
public:
    Facts(std::vector<Fact<Subject>> own, std::string more) : facts_(std::move(own)), more_(std::move(more))
    {
        facts_.push_back({"notice", [](const Subject& s) {
                              const auto& notice = session(s).notice;
                              return notice ? Catalogue()(notice->sentence) : std::string("nothing");
                          }});
        facts_.push_back({"file", [](const Subject& s) { return session(s).file_name(); }});
        facts_.push_back({"changed", [](const Subject& s) { return yes_or_no(session(s).is_dirty()); }});
    }

    /// \param expectation  "step 3"
    Mismatch mismatch(std::string_view expectation, const Subject& subject) const
    {
        const auto [what, rest] = first_word(expectation);
        std::string names = std::string(common_expectations) + more_;
        for (const Fact<Subject>& fact : facts_) {
            if (fact.name == what) return compared(what, fact.found(subject), std::string(rest));
            names += ", " + std::string(fact.name);
        }
        return "expect: found \"" + std::string(what) + "\", wanted one of " + names;
    }

private:
    static const auto& session(const Subject& subject)
    {
        if constexpr (requires { subject.session(); }) return subject.session();
        else return subject;
    }

    std::vector<Fact<Subject>> facts_;
    std::string more_;
};

} // namespace ui
