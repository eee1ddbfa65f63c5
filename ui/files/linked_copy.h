#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "ui/files/link.h"

namespace ui {

/// A document that has a copy in another program: what changes in one is offered to the other, and nothing is copied
/// until somebody takes it over.
class LinkedCopy {
public:
    /// What a linked document can do, given as functions so that every app links its own.
    struct Document {
        std::function<std::string()> text;                     ///< what the other end is told of it
        std::function<bool(const std::string& other)> is_news; ///< taking this over would change it
    };

    /// \param text  what both have at the beginning
    LinkedCopy(Link link, std::string text) : link_(std::move(link)), sent_(std::move(text)), shared_(sent_) {}

    /// Time goes by: twice a second it tells the other end what has changed here, and looks what has changed there.
    void tick(double seconds, const Document& document);
    /// What the other end has and this one has not; nothing once its program has ended.
    const std::optional<std::string>& offered() const { return offered_; }
    /// What is offered lacks lines that have changed here since both ends had the same.
    bool would_undo_own_change() const { return offered_ && would_undo_own_change_; }
    const std::string& sent() const { return sent_; }     ///< the document here, as the other end knows it
    const std::string& shared() const { return shared_; } ///< the document here when both ends had the same last
    /// It stays as it is here; what is offered next is another change.
    void keep() { offered_.reset(); }
    /// It is here from now on. \pre something is offered
    std::string accept();
    bool is_cut() const { return link_.is_cut(); }
    const std::filesystem::path& folder() const { return link_.folder(); }

private:
    static constexpr double pause = 0.5; ///< s

    void look_for_news(const Document& document);
    bool undoes_own_change(const std::string& offered) const;

    Link link_;
    std::string sent_;      ///< of the document here
    std::string shared_;    ///< likewise, when both ends had the same last
    bool is_taken_ = false; ///< from the other end, since it was told last
    std::optional<std::string> offered_;
    bool would_undo_own_change_ = false; ///< what is offered
    double waited_ = 0.0;
};

} // namespace ui
