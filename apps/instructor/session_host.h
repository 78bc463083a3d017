#pragma once

#include "apps/instructor/console_options.h"
#include "apps/program/options/patient_option.h"
#include "engine/net/discovery/session_beacon.h"

#include <memory>

namespace carina
{

/// A session that is hosted here, and what is known of it outside.
struct HostedSession {
    std::unique_ptr<SessionNode> node;
    std::unique_ptr<SessionBeacon> beacon; ///< null where another program has its port
    QString file;                          ///< that it is stored in
    SessionReach reach = SessionReach::ThisComputer;
};

/// How a session is hosted.
struct HostRequest {
    QString name;
    QString file;
    SessionReach reach = SessionReach::ThisComputer;
    bool servesSets = false; ///< it has an imported patient
};

/// A file for a new session: named by the time at which it begins, and never moved.
/// @returns FileUnwritable for a folder that cannot be made.
[[nodiscard]] Result<QString> newSessionFile(const QString& folder);

/// Hosts the session in a file, which is begun if there is none.
/// @returns the errors of openFactStore and SessionNode::host.
[[nodiscard]] Result<HostedSession> hostSession(const HostRequest& request,
                                                const ConsoleOptions& options);

/// The session that was stored last, or a new one where that was asked for, nothing is stored, or
/// what is stored has ended, or cannot be read and a person wants to begin anew; it stays where it
/// is.
/// @returns Cancelled where the person does not; the errors of hostSession.
[[nodiscard]] Result<HostedSession> hostByOptions(const ConsoleOptions& options, bool servesSets);

/// The patient that lies at the first station, so that a resumed session goes on with it; nothing
/// in a new session, and where it is not on this computer any more.
[[nodiscard]] std::optional<SharedPatientModel> presentPatient(const SessionNode& node);

/// Tells the session which patient lies at its first station and how it breathes at rest, unless it
/// has one and no other is asked for, and makes it something to act on; and what can be lifted out
/// at the stations.
void introduceFirst(SessionNode& node, const program::ChosenPatient& patient, bool isAskedFor);

} // namespace carina
