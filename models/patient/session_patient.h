#pragma once

#include "engine/net/anatomy_transfer/set_fetch.h"
#include "engine/net/node/session_node.h"
#include "models/patient/patient_source.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

namespace carina
{

/// Whether a patient lies at the station, or none was chosen for it: then its parts have the
/// numbers of which a lesson there speaks.
[[nodiscard]] bool liesAt(const SessionState& state, StationId station,
                          const PatientModel& patient);

/// The patient that a program draws at a station: the session's patient as soon as it is available,
/// until then the one that the program started with.
///
/// The session identifies its patient by content hash. A built-in or previously imported patient is
/// taken from this computer; any other is fetched from the host. The progress is described in
/// words, for some seconds with the licence of the set, and a person can stop the transfer.
class SessionPatient : public QObject
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 200;
    /// When it becomes known, and again when the set has arrived; it covers the patient meanwhile.
    static constexpr int kLicenceShown_ms = 15'000;

    /// Draws another patient from now on. @returns why it cannot; then the former patient stays.
    using Lay = std::function<Result<void>(const SharedPatientModel&)>;

    /// @param cacheFolder usually AnatomyCache::defaultFolder() @pre `node` outlives this.
    SessionPatient(const SessionNode& node, StationId station, SharedPatientModel first,
                   std::filesystem::path cacheFolder, int licenceShown_ms = kLicenceShown_ms);
    ~SessionPatient() override;

    /// Another station's patient is drawn from now on, as soon as it is available.
    void setStation(StationId station);
    /// Starts to follow the session; `lay` is called, on this object's thread, for each new
    /// patient.
    void follow(Lay lay);

    [[nodiscard]] const SharedPatientModel& patient() const { return m_patient; }
    /// One or more translated lines on the state of the patient; empty when the session's patient
    /// is drawn and no licence has to be shown.
    [[nodiscard]] QString notice() const;

    /// Whether a transfer is running that stop() ends.
    [[nodiscard]] bool canStop() const { return m_fetch != nullptr; }
    void stop();
    /// Whether the transfer was stopped or has failed.
    [[nodiscard]] bool canFetchAgain() const { return m_step == Step::Without; }
    void fetchAgain();

private:
    enum class Step : std::uint8_t {
        Settled, ///< the session's patient is drawn, or none is named
        Making,  ///< being built on the other thread
        Waiting, ///< for the host to admit this program
        Fetching,
        Without, ///< the session's patient is not available
    };
    /// Builds a patient.
    using Make = std::function<Result<SharedPatientModel>()>;

    void look();
    void want(const std::string& contentHash, const std::string& name);
    void make(const Make& make, bool fetchElse);
    void made(const std::string& contentHash, const Result<SharedPatientModel>& patient,
              bool fetchElse);
    void fetch();
    void watchFetch();
    void showLicence();
    void goWithout(std::optional<Error> fault);
    [[nodiscard]] QString progress() const;
    [[nodiscard]] QString withLicence(const QString& text) const;

    const SessionNode& m_node;
    StationId m_station;
    SharedPatientModel m_patient;
    std::filesystem::path m_cacheFolder;
    Lay m_lay;
    Step m_step = Step::Settled;
    std::string m_wanted; // content hash and name of the session's patient
    std::string m_wantedName;
    std::unique_ptr<SetFetch> m_fetch;
    FetchStatus m_status;         // of the last one
    std::optional<Error> m_fault; // without one a person stopped it
    QTimer m_tick;
    QTimer m_licenceShown; // runs as long
    QThreadPool m_maker;
};

} // namespace carina
