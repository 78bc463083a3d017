#pragma once

#include "models/patient/laryngoscopy.h"
#include "models/patient/patient_source.h"

#include <QObject>
#include <QThreadPool>

#include <filesystem>
#include <optional>
#include <string>

namespace carina
{

/// Whether a patient is one that is made from figures: its surfaces are those of an airway that is
/// held open for a tube (Posture::Laryngoscopy). An imported patient is as it was scanned.
[[nodiscard]] bool hasRestingPatient(const std::string& contentHash);

/// The same patient as no laryngoscope holds it, mouth shut and tongue and larynx at rest: what jaw
/// and blade then move. Takes seconds the first time; may be called from any thread.
/// @param cacheFolder usually AnatomyCache::defaultFolder()
/// @returns FileNotFound for one that is not made from figures; the errors of patientFor and
///          PatientModel::of
[[nodiscard]] Result<SharedPatientModel> restingPatient(const std::string& contentHash,
                                                        const std::filesystem::path& cacheFolder);

/// What scripted hands do with a laryngoscope in this patient: in the resting one where there is
/// one, as a blade lifts what nothing holds. Nothing where the larynx is not known.
[[nodiscard]] std::optional<LaryngoscopyScript>
scriptAtRest(const PatientModel& patient, const std::filesystem::path& cacheFolder);

/// The same patient, made on another thread.
class RestingPatient : public QObject
{
    Q_OBJECT

public:
    RestingPatient();
    ~RestingPatient() override;

    /// The patient at rest, or the patient itself where there is no other one or it cannot be made;
    /// nullptr while it is made, which begins with the first call.
    /// @pre the patient outlives what is returned
    [[nodiscard]] const PatientModel* of(const PatientModel& patient);

Q_SIGNALS:
    /// What was asked for last is there.
    void made();

private:
    void take(const std::string& contentHash, SharedPatientModel patient);

    std::string m_wanted;
    SharedPatientModel m_made;
    bool m_isImpossible = false;
    QThreadPool m_maker;
};

} // namespace carina
