#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/document/typical.h"
#include "apps/frame/session/session.h"

namespace frame {

/// Where a typical structure goes.
enum class Setting : std::uint8_t { Beside, InPlace };

/// A typical structure while its numbers are chosen: the document shows it already, as a gesture that is under way.
/// Insert settles it as one step, cancel takes it back.
class TypicalDraft {
public:
    bool is_open() const { return is_open_; }
    /// With the structure that was chosen last, or with the first one of the document's kind where it is of another.
    void open(Session& session);
    void choose(Session& session, std::size_t structure);
    /// \pre why_not(number, value) gives no reason
    void set(Session& session, std::size_t place, double value);
    void set_distance(Session& session, double metres);
    void set_setting(Session& session, Setting setting);
    void insert(Session& session);
    void cancel(Session& session);

    std::size_t chosen() const { return chosen_; }
    const TypicalStructure& structure() const { return typical_structures()[chosen_]; }
    std::span<const double> numbers() const { return numbers_[chosen_]; } ///< [m, kN]
    double distance() const { return distance_; }                         ///< from what is there [m]
    /// What is there already can stay only beside a structure of the same analysis.
    Setting setting() const { return can_stand_beside_ ? setting_ : Setting::InPlace; }
    bool can_stand_beside() const { return can_stand_beside_; }

    /// What a scenario says: "choose warren", "set panels 8", "set distance 2", "insert", "cancel". \returns the
    /// complaint
    std::optional<std::string> run_command(Session& session, std::string_view verb, std::string_view argument);

private:
    void choose_of_kind(femoop::AnalysisKind kind);
    /// \returns why it cannot be shown with these numbers
    std::optional<ui::Message> show(Session& session);
    std::optional<std::string> choose_named(Session& session, std::string_view id);
    std::optional<std::string> set_named(Session& session, std::string_view argument);

    bool is_open_ = false;
    std::size_t chosen_ = 0;
    std::vector<std::vector<double>> numbers_; ///< of every structure: what was set is kept
    double distance_ = 6.0;
    Setting setting_ = Setting::Beside;
    bool can_stand_beside_ = false;
    ShowSet show_before_; ///< what the picture showed: a truss has no moments
};

} // namespace frame
