#pragma once

#include "tests/engine/session/facts/sample_session.h"

#include <QByteArray>
#include <QMetaType>
#include <map>

namespace carina::test
{

inline constexpr SessionTime kNow = SessionTime{std::chrono::seconds{100}};
inline constexpr Duration kNear = std::chrono::milliseconds{1};

/// What an authority makes of a proposal at kNow, everybody near.
inline Result<Fact> judgeBy(const SessionAuthority& authority, ParticipantId author, FactBody body,
                            StationId station = kSampleStation)
{
    return authority.judge({ProposalId{5}, author, station, std::move(body)}, kNow, kNear);
}

/// "fine", or the error as words.
inline QByteArray verdict(const Result<Fact>& fact)
{
    static const std::map<Errc, QByteArray> kWords{{Errc::NotPermitted, "not permitted"},
                                                   {Errc::SessionEnded, "session ended"},
                                                   {Errc::OutOfRange, "out of range"},
                                                   {Errc::NotFinite, "not finite"},
                                                   {Errc::OwnerChanged, "owner changed"},
                                                   {Errc::NameUnclear, "name unclear"},
                                                   {Errc::SessionFull, "session full"},
                                                   {Errc::Muted, "muted"},
                                                   {Errc::Banned, "banned"},
                                                   {Errc::SessionLocked, "session locked"},
                                                   {Errc::StationUnknown, "station unknown"},
                                                   {Errc::StationOccupied, "station occupied"},
                                                   {Errc::StationCount, "station count"}};
    return fact ? QByteArray{"fine"} : kWords.at(fact.error().code);
}

inline SessionAuthority sampleAuthority() { return SessionAuthority{sampleSession().log()}; }

} // namespace carina::test
