#include "apps/instructor/session_host.h"

#include "apps/program/program.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/anatomy_set/set_hash.h"
#include "engine/io/fact_store/sql_fact_store.h"
#include "engine/net/entry/session_identity.h"
#include "engine/session/station_rules.h"
#include "models/objects/liftables.h"
#include "models/patient/new_patient.h"
#include "models/patient/shared_patient.h"
#include "models/session/stored_sessions.h"

#include <QApplication>
#include <QDateTime>
#include <QDir>

#include <algorithm>

namespace carina
{
namespace
{

QString hostWords(const char* text) { return QApplication::translate("Instructor", text); }

/// Codes, keys and tokens lie beside the session.
std::filesystem::path secretsOf(const QString& sessionFile)
{
    return std::filesystem::path{sessionFile.toStdString()}.replace_extension(".secrets");
}

Result<std::unique_ptr<SessionNode>> hostFile(const HostRequest& request,
                                              const ConsoleOptions& options)
{
    auto store = openFactStore(request.file.toStdString());
    if (!store)
        return tl::unexpected(store.error());
    return SessionNode::host({.sessionName = request.name.toStdString(),
                              .participantName = hostWords("Instructor").toStdString(),
                              .port = options.port,
                              .open = request.reach != SessionReach::ThisComputer,
                              .firstStation = hostWords("Station 1").toStdString(),
                              .strategy = options.strategy,
                              .secrets = secretsOf(request.file),
                              .certificate = options.certificate,
                              .anatomyCache = request.servesSets ? AnatomyCache::defaultFolder()
                                                                 : std::filesystem::path{}},
                             std::move(*store));
}

/// Lets those who look for sessions find this one. By link nobody does but who was in it.
Result<std::unique_ptr<SessionBeacon>> beaconOf(const SessionNode& node, SessionReach reach)
{
    const auto state = node.state();
    return SessionBeacon::open(
        {sessionKey(state->sessionId()), state->name(), node.port()}, node.isOpen(), kDiscoveryPort,
        reach == SessionReach::ByLink ? Announced::ToThoseWhoKnowIt : Announced::ToAll);
}

bool hasImportedPatient(const SessionState& state)
{
    return std::ranges::any_of(state.stations(), [](const auto& station) {
        return !station.second.closed && isSetHash(station.second.anatomyHash);
    });
}

bool hasEnded(const SessionNode& node)
{
    const auto now = node.now();
    return now && node.state()->phaseAt(*now) == SessionPhase::Ended;
}

/// Whether a person can be asked to begin anew, because what is stored cannot be read.
bool mayBeginAnew(const Error& error)
{
    return program::isSeenOnly()
           && (error.code == Errc::StoreCorrupt || error.code == Errc::StoreTooOld
               || error.code == Errc::UnknownFormat || error.code == Errc::FileMalformed);
}

} // namespace

Result<QString> newSessionFile(const QString& folder)
{
    if (!QDir{folder}.mkpath(QStringLiteral(".")))
        return fail(Errc::FileUnwritable, folder.toStdString());
    const QString began =
        QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-hhmmss-zzz"));
    return QDir{folder}.filePath(QStringLiteral("session-%1.sqlite").arg(began));
}

Result<HostedSession> hostSession(const HostRequest& request, const ConsoleOptions& options)
{
    auto node = hostFile(request, options);
    if (node && !request.servesSets && hasImportedPatient(*(*node)->state())) {
        // It was begun with surfaces, which who joins is to have.
        node->reset();
        HostRequest serving = request;
        serving.servesSets = true;
        node = hostFile(serving, options);
    }
    if (!node)
        return tl::unexpected(node.error());
    keepReach(request.file, request.reach);
    HostedSession hosted{*std::move(node), nullptr, request.file, request.reach};
    if (auto beacon = beaconOf(*hosted.node, request.reach))
        hosted.beacon = *std::move(beacon);
    else
        program::warn(beacon.error());
    return hosted;
}

Result<HostedSession> hostByOptions(const ConsoleOptions& options, bool servesSets)
{
    auto fresh = newSessionFile(options.folder);
    if (!fresh)
        return tl::unexpected(fresh.error());
    const QStringList stored = sessionFiles(options.folder);
    HostRequest request{hostWords("Routine intubation"),
                        options.isNew || stored.isEmpty() ? *fresh : stored.front(), options.reach,
                        servesSets};
    auto hosted = hostSession(request, options);
    if (hosted ? !hasEnded(*hosted->node) : !mayBeginAnew(hosted.error()))
        return hosted;
    if (!hosted && !program::askInstead(hosted.error(), hostWords("Start a new session")))
        return fail(Errc::Cancelled);
    if (hosted)
        *hosted = {}; // gives the port back
    request.file = *fresh;
    return hostSession(request, options);
}

std::optional<SharedPatientModel> presentPatient(const SessionNode& node)
{
    const auto state = node.state();
    const auto station = state->stations().find(firstOpenStation(*state));
    if (station == state->stations().end() || station->second.anatomyHash.empty())
        return std::nullopt;
    const auto patient = patientHere(station->second.anatomyHash, station->second.anatomyName,
                                     AnatomyCache::defaultFolder());
    return patient ? std::optional{*patient} : std::nullopt;
}

void introduceFirst(SessionNode& node, const program::ChosenPatient& patient, bool isAskedFor)
{
    const StationId first = firstOpenStation(*node.state());
    const std::string present = node.state()->stations().at(first).anatomyHash;
    if (present.empty() || (isAskedFor && present != patient.model->contentHash()))
        introducePatient(node, first, patient.model->contentHash(), patient.model->name(),
                         patient.dimensions);
    sharePatient(node, first, hostWords("Virtual patient").toStdString());
    const auto state = node.state();
    for (const auto& [id, station] : state->stations())
        if (!station.closed)
            shareLiftables(node, id); // which a session from before they existed lacks
}

} // namespace carina
