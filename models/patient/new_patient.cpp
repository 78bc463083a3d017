#include "models/patient/new_patient.h"

#include "engine/anatomy/patient/patient_build.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/session/respiration/introduced_patient.h"
#include "models/objects/liftables.h"
#include "models/patient/shared_patient.h"

#include <QCoreApplication>

namespace carina
{

void introducePatient(SessionNode& node, StationId station, const std::string& contentHash,
                      const std::string& name, const PatientDimensions& dimensions)
{
    node.propose(station, fact::AnatomyChosen{contentHash, name});
    for (const FactBody& told : introducedPatient(buildOf(dimensions)))
        node.propose(station, told);
}

void layNewPatient(SessionNode& node, StationId station, const PatientParameters& parameters)
{
    if (const auto dimensions = dimensionsFor(parameters))
        introducePatient(node, station, madeHash(parameters), nameOf(parameters), *dimensions);
    sharePatient(node, station,
                 QCoreApplication::translate("Patient", "Virtual patient").toStdString());
    shareLiftables(node, station);
}

} // namespace carina
