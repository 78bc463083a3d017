#pragma once

#include "engine/session/session_state.h"

#include <QString>

#include <vector>

namespace carina
{

/// One thing that is told of a session that has ended.
struct SummaryLine {
    QString name{};
    QString value{};

    friend bool operator==(const SummaryLine&, const SummaryLine&) = default;
};

/// What happened in a session, told by the participant who hosted it.
/// @param file that it is stored in
[[nodiscard]] std::vector<SummaryLine> summaryOf(const SessionState& state, SessionTime now,
                                                 ParticipantId self, const QString& file);

/// What closing the host's program means for whom, while the session goes on; empty where nobody
/// would lose anything.
[[nodiscard]] QString leavingText(const SessionState& state, SessionTime now, ParticipantId self);

} // namespace carina
