#pragma once

#include "models/patient/patient_lumen.h"

#include <QEventLoop>

namespace carina::test
{

/// The lumen of a patient for the tube that the patient has, once it is measured; null for one in
/// whom it cannot be.
inline std::shared_ptr<const AirwayLumen> lumenOf(const PatientModel& patient)
{
    PatientLumen lumen;
    QEventLoop until;
    QObject::connect(&lumen, &PatientLumen::measured, &until, &QEventLoop::quit);
    lumen.want(patient);
    until.exec();
    return lumen.lumen();
}

} // namespace carina::test
