#pragma once

#include "engine/net/carriage/set_fetch.h"
#include "engine/net/node/session_node.h"
#include "models/patient/patient_source.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

namespace carina
{

/// Which patient a program draws at a station: the session's, as soon as it is here, and until then
/// the one that the program began with.
///
/// The session names its patient by content hash. One that is built in or was imported here is
/// taken from this computer; any other is fetched from the host. What goes on is said in words, for
/// some seconds with the licence of what comes, and a person can stop it.
class SessionPatient : public QObject
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 200;
    /// Once it is known, and again when the set has come; it hides the patient meanwhile.
    static constexpr int kLicenceShown_ms = 15'000;

    /// Draws another patient from now on. @returns why it cannot; the one before is kept then.
    using Lay = std::function<Result<void>(const SharedPatientModel&)>;

    /// @param cacheFolder usually AnatomyCache::defaultFolder() @pre `node` outlives this.
    SessionPatient(const SessionNode& node, StationId station, SharedPatientModel first,
                   std::filesystem::path cacheFolder, int licenceShown_ms = kLicenceShown_ms);
    ~SessionPatient() override;

    /// From now on patients are laid by this, which is called on the thread this lives on.
    void follow(Lay lay);

    [[nodiscard]] const SharedPatientModel& patient() const { return m_patient; }
    /// What a person has to know of it, one or more translated lines; empty when the session's
    /// patient is drawn.
    [[nodiscard]] QString notice() const;

    /// Something comes that stop() stops.
    [[nodiscard]] bool canStop() const { return m_fetch != nullptr; }
    void stop();
    /// It was stopped, or has failed.
    [[nodiscard]] bool canFetchAgain() const { return m_step == Step::Without; }
    void fetchAgain();

private:
    enum class Step : std::uint8_t {
        Settled, ///< nothing else is to be drawn
        Making,  ///< on the other thread
        Waiting, ///< for the host to let us in
        Fetching,
        Without, ///< the session's patient is not to be had
    };
    /// What is being made, and from what.
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
