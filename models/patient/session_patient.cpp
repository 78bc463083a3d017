#include "models/patient/session_patient.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/set_hash.h"
#include "models/errors/error_text.h"

namespace carina
{
namespace
{

QString text(const std::string& words) { return QString::fromStdString(words); }

int megabytes(std::uint64_t bytes) { return static_cast<int>((bytes + 500'000) / 1'000'000); }

} // namespace

bool liesAt(const SessionState& state, StationId station, const PatientModel& patient)
{
    const auto found = state.stations().find(station);
    return found != state.stations().end()
           && (found->second.anatomyHash.empty()
               || found->second.anatomyHash == patient.contentHash());
}

SessionPatient::SessionPatient(const SessionNode& node, StationId station, SharedPatientModel first,
                               std::filesystem::path cacheFolder, int licenceShown_ms)
    : m_node{node},
      m_station{station},
      m_patient{std::move(first)},
      m_cacheFolder{std::move(cacheFolder)}
{
    m_maker.setMaxThreadCount(1);
    m_licenceShown.setSingleShot(true);
    m_licenceShown.setInterval(licenceShown_ms);
    m_tick.callOnTimeout(this, &SessionPatient::look);
}

SessionPatient::~SessionPatient()
{
    m_maker.clear();
    m_maker.waitForDone();
}

void SessionPatient::follow(Lay lay)
{
    m_lay = std::move(lay);
    m_tick.start(kInterval_ms);
    look();
}

void SessionPatient::setStation(StationId station)
{
    m_station = station;
    if (m_lay)
        look();
}

void SessionPatient::look()
{
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    if (station == state->stations().end() || station->second.anatomyHash.empty())
        return;
    if (station->second.anatomyHash != m_wanted)
        want(station->second.anatomyHash, station->second.anatomyName);
    else if (m_step == Step::Waiting)
        fetch();
    else if (m_step == Step::Fetching)
        watchFetch();
}

void SessionPatient::want(const std::string& contentHash, const std::string& name)
{
    m_wanted = contentHash;
    m_wantedName = name;
    m_fetch.reset();
    m_status = {};
    m_fault.reset();
    m_step = Step::Settled;
    if (contentHash != m_patient->contentHash())
        make([contentHash, name,
              folder = m_cacheFolder] { return patientHere(contentHash, name, folder); },
             true);
}

void SessionPatient::make(const Make& make, bool fetchElse)
{
    m_step = Step::Making;
    m_maker.start([this, make, wanted = m_wanted, fetchElse] {
        QMetaObject::invokeMethod(
            this, [this, wanted, fetchElse, patient = make()] { made(wanted, patient, fetchElse); },
            Qt::QueuedConnection);
    });
}

void SessionPatient::made(const std::string& contentHash, const Result<SharedPatientModel>& patient,
                          bool fetchElse)
{
    if (contentHash != m_wanted)
        return; // the session has another one by now
    if (!patient && fetchElse)
        return fetch();
    if (!patient)
        return goWithout(patient.error());
    if (const auto laid = m_lay(*patient); !laid)
        return goWithout(laid.error());
    m_patient = *patient;
    m_step = Step::Settled;
    showLicence();
}

void SessionPatient::showLicence()
{
    if (!m_status.set.licence.empty())
        m_licenceShown.start();
}

void SessionPatient::fetch()
{
    if (!isSetHash(m_wanted)) // one that is built into another version
        return goWithout(Error{Errc::VersionMismatch, m_wantedName});
    m_step = Step::Waiting;
    const auto door = m_node.door();
    if (!door)
        return;
    m_fetch = std::make_unique<SetFetch>(*door, m_wanted, m_cacheFolder);
    m_step = Step::Fetching;
}

void SessionPatient::watchFetch()
{
    const bool wasKnown = !m_status.set.licence.empty();
    m_status = m_fetch->status();
    if (!wasKnown)
        showLicence();
    if (m_status.state == FetchStatus::State::Failed)
        return goWithout(m_status.fault);
    if (m_status.state != FetchStatus::State::Here)
        return;
    m_fetch.reset();
    make([digest = m_status.set.digest, wanted = m_wanted, name = m_wantedName,
          folder = m_cacheFolder] { return patientCarried(digest, wanted, name, folder); },
         false);
}

void SessionPatient::goWithout(std::optional<Error> fault)
{
    m_fetch.reset();
    m_fault = std::move(fault);
    m_step = Step::Without;
}

void SessionPatient::stop() { goWithout(std::nullopt); }

void SessionPatient::fetchAgain()
{
    m_status = {};
    m_fault.reset();
    fetch();
}

QString SessionPatient::notice() const
{
    if (m_step == Step::Settled)
        return m_licenceShown.isActive() ? withLicence(
                   tr("The session's patient “%1” has arrived").arg(text(m_patient->name())))
                                         : QString{};
    const QString shown = parametersOfHash(m_patient->contentHash())
                              ? tr("The built-in patient “%1” is shown")
                              : tr("The patient “%1” is shown");
    return withLicence(tr("%1. %2", "which patient is shown; what the session's is doing")
                           .arg(shown.arg(text(m_patient->name())), progress()));
}

QString SessionPatient::progress() const
{
    const QString name = text(m_wantedName);
    if (m_step == Step::Without)
        return m_fault ? tr("The session's patient “%1” cannot be loaded. %2")
                             .arg(name, errorText(*m_fault))
                       : tr("The transfer of the session's patient “%1” was stopped").arg(name);
    if (m_step == Step::Making)
        return tr("The session's patient “%1” is being prepared …").arg(name);
    if (m_status.state == FetchStatus::State::Receiving)
        return tr("The session's patient “%1” is being received: %2 of %3\u00a0MB (Esc: menu, to "
                  "stop it)")
            .arg(name, QString::number(megabytes(m_status.received)),
                 QString::number(megabytes(m_status.set.bytes)));
    if (m_status.fault)
        return tr("The session's patient “%1” is requested again. %2")
            .arg(name, errorText(*m_status.fault));
    return tr("The session's patient “%1” is requested …").arg(name);
}

QString SessionPatient::withLicence(const QString& text) const
{
    return m_licenceShown.isActive() && !m_status.set.licence.empty()
               ? text + QLatin1Char('\n') + carina::text(m_status.set.licence).simplified()
               : text;
}

} // namespace carina
