#pragma once

#include <cstdint>
#include <vector>

namespace ui {

/// The places that Tab goes through in the order in which they are shown, and Shift+Tab back; after the last comes the
/// first. Number fields tell of themselves (ui/widgets/number_field.h), of any other widget the window tells with `add`.
/// A window that has them goes round in itself: in Dear ImGui's own order there are fields of text alone, and it ends at
/// the edge of what is scrolled.
///
/// Of a row of buttons of which one is chosen, that one is a place: arrows go on from there, the space bar chooses.
class TabStops {
public:
    enum class Kind : std::uint8_t {
        Widget, ///< a list, a tick box, a button: it is framed, and the space bar presses it
        Text    ///< a field of text: what stands in it is selected
    };

    /// Around all that a window shows. \pre not within another's
    void begin_window();
    void end_window();
    /// The widget that was shown last is a place. \pre between the two above
    void add(Kind kind = Kind::Widget);

    /// A place of another making is shown now. \returns whether Tab has come to it
    bool arrives(unsigned id);
    void stand(unsigned id); ///< it has the keyboard
    void leave(unsigned id); ///< in it Tab was pressed
    void stay();             ///< Tab was pressed, yet what was typed is to be mended

private:
    /// What Tab goes round in: a window, or all panels together.
    struct Round {
        unsigned window = 0;
        int last_shown = 0;
        std::vector<unsigned> places{};
        std::vector<unsigned> places_before{}; ///< of the last frame, so all of them
        unsigned current = 0;                  ///< the place that has the keyboard, or had it last
    };
    Round& round();
    void leave_for_neighbour(Round& round);

    std::vector<Round> rounds_{};
    unsigned window_ = 0;
    unsigned wanted_ = 0; ///< the place that Tab has opened the way for
    int pressed_ = -1;    ///< the frame in which it did
};

} // namespace ui
