#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "apps/frame/session/session.h"
#include "ui/command/argument.h"

namespace frame {

/// Whether moment distribution can work on the selection in the case that is shown. Every frame that shows the command
/// asks, so an answer is kept until something that it depends on changes.
class DistributionCheck {
public:
    /// Nothing where it can, and of a structure of more than 200 members, which is looked at only when it is handed
    /// over.
    ui::Reason why_not(const Session& session) const;

private:
    struct Question {
        std::uint64_t session, generation;
        ui::Language language;
        femoop::CaseId load_case;
        std::vector<femoop::MemberId> members;

        friend bool operator==(const Question&, const Question&) = default;
    };
    mutable std::optional<Question> asked_;
    mutable ui::Reason answer_;
};

} // namespace frame
