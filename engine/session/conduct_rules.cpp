#include "engine/session/conduct_rules.h"

#include "engine/session/participant_limits.h"

#include <algorithm>
#include <string>

namespace carina
{
namespace
{

constexpr ParticipantId kSessionHost{0};

std::optional<ParticipantId> namedBy(const FactBody& body)
{
    if (const auto* muted = std::get_if<fact::ParticipantMuted>(&body))
        return muted->participant;
    if (const auto* removed = std::get_if<fact::ParticipantRemoved>(&body))
        return removed->participant;
    if (const auto* lifted = std::get_if<fact::BanLifted>(&body))
        return lifted->participant;
    if (const auto* replaced = std::get_if<fact::TokenReplaced>(&body))
        return replaced->participant;
    return std::nullopt;
}

/// Whom a fact keeps from taking part.
std::optional<ParticipantId> silencedBy(const FactBody& body)
{
    const auto* muted = std::get_if<fact::ParticipantMuted>(&body);
    const bool silences =
        std::holds_alternative<fact::ParticipantRemoved>(body) || (muted && muted->muted);
    return silences ? namedBy(body) : std::nullopt;
}

} // namespace

bool isAboutConduct(const FactBody& body)
{
    return namedBy(body) || std::holds_alternative<fact::SessionLocked>(body)
           || std::holds_alternative<fact::RoleCodeChanged>(body);
}

Result<void> checkNamed(const SessionState& state, const FactBody& body)
{
    const auto named = namedBy(body);
    if (named && !state.participants().contains(*named))
        return fail(Errc::OutOfRange, "participant " + std::to_string(named->value));
    return {};
}

bool hasPlace(const Participant& participant, SessionTime now)
{
    if (participant.present)
        return true;
    if (!participant.left || participant.removal)
        return false;
    const Duration stayed = *participant.left - participant.since;
    return now < *participant.left + std::min(stayed, kPlaceKept);
}

Result<void> checkEntry(const SessionState& state, const FactBody& body)
{
    const auto* joined = std::get_if<fact::ParticipantJoined>(&body);
    if (!joined)
        return {};
    const auto known = state.participants().find(joined->participant);
    if (known == state.participants().end())
        return state.isLocked() ? fail(Errc::SessionLocked) : Result<void>{};
    const auto& removal = known->second.removal;
    if (removal && removal->banned)
        return fail(Errc::Banned, removalText(state, *removal));
    return {};
}

Result<void> checkConduct(const SessionState& state, const FactBody& body)
{
    const auto whom = silencedBy(body);
    if (!whom)
        return {};
    if (*whom == kSessionHost)
        return fail(Errc::NotPermitted, "the host of the session");
    if (state.participants().at(*whom).role != Role::Instructor)
        return {};
    const bool anotherInstructs = std::ranges::any_of(state.participants(), [&](const auto& entry) {
        const Participant& other = entry.second;
        return other.id != *whom && other.present && !other.muted && other.role == Role::Instructor;
    });
    return anotherInstructs ? Result<void>{} : fail(Errc::NotPermitted, "the last instructor");
}

} // namespace carina
