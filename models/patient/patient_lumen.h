#pragma once

#include "engine/airway/lumen/airway_lumen.h"
#include "models/patient/patient_model.h"

#include <QObject>
#include <QThreadPool>

#include <memory>
#include <optional>
#include <string>

namespace carina
{

/// The lumen of a patient's airway for the tube that the patient has (measuredLumen), measured on
/// another thread, as that takes longer than a frame.
class PatientLumen : public QObject
{
    Q_OBJECT

public:
    PatientLumen();
    ~PatientLumen() override;

    /// Measures that of this patient, unless it was wanted last: the same surfaces, and a tube that
    /// is as thick. The patient need not outlive the call.
    void want(const PatientModel& patient) { want(patient, patient.tube().outerDiameter); }
    /// The same for a tube that is so thick.
    void want(const PatientModel& patient, Length outerDiameter);

    /// Null while it is measured, and for a patient in whom none can be.
    [[nodiscard]] const std::shared_ptr<const AirwayLumen>& lumen() const { return m_lumen; }
    /// Whether the patient that was wanted last is one in whom none can be.
    [[nodiscard]] bool isImpossible() const { return m_isImpossible; }

Q_SIGNALS:
    /// What was wanted last has been measured, or cannot be.
    void measured();

private:
    struct Wanted {
        std::string contentHash;
        Length outerDiameter{};
        friend bool operator==(const Wanted&, const Wanted&) = default;
    };
    void take(const Wanted& of, std::shared_ptr<const AirwayLumen> lumen);

    std::optional<Wanted> m_wanted;
    std::shared_ptr<const AirwayLumen> m_lumen;
    bool m_isImpossible = false;
    QThreadPool m_maker;
};

} // namespace carina
