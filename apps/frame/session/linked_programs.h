#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/session/commands.h"
#include "ui/files/linked_copy.h"

namespace frame {

/// The programs that this one has handed something to, and what they offer back: of moment distribution the structure,
/// of Mohr's circle the section. Nothing is copied until it is taken over; a link sleeps while another tab is shown.
class LinkedPrograms {
public:
    /// \param handed  to a program of the present session, by the selection, the pin and the pointer that it has now
    void add(ui::Link link, const Session& session, const ui::ExportToApp& handed);
    void tick(double seconds, const Workspace& workspace); ///< time goes by
    /// Says what the first program offers that offers something; "" where none does.
    std::string_view offering(const Workspace& workspace) const;
    void adopt(Workspace& workspace); ///< as a step, or a notice says why not. \pre something is offered
    void keep(const Workspace& workspace);

private:
    /// What was handed over, by names, so that it is found again after the model has changed.
    struct Handed {
        std::uint64_t session = 0;
        std::string program;
        std::vector<std::string> members; ///< empty: all
        double x = 0.0;                   ///< of the section, on the only member
        std::string load_case;
    };
    struct Linked {
        Handed handed;
        ui::LinkedCopy copy;
        std::uint64_t generation = 0; ///< of the solution that `text` is of
        std::string text;
        std::optional<std::string> declined{}; ///< what was offered last and not taken over
    };
    struct NewSection {
        femoop::SectionId id;
        femoop::Section section;
    };
    static std::optional<NewSection> section_from(const Session& session, const Handed& handed,
                                                  const std::string& text);
    static std::string text_now(const Linked& linked, const Session& session);
    static bool is_news(const Linked& linked, const Session& session, const std::string& other);
    static bool is_declined(Linked& linked, const std::string& other);
    static void adopt_section(Session& session, const Handed& handed, const std::string& text);
    static void adopt_structure(Session& session, const Handed& handed, const std::string& text);
    const Linked* offering_one(const Workspace& workspace) const;

    std::vector<Linked> all_;
};

} // namespace frame
