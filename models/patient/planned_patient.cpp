#include "models/patient/planned_patient.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/builtin_cache.h"
#include "models/errors/error_text.h"

namespace carina
{
namespace
{

Result<ReadyPatient> readyPatient(const PatientParameters& parameters,
                                  const std::filesystem::path& cacheFolder)
{
    const auto dimensions = dimensionsFor(parameters);
    if (!dimensions)
        return tl::unexpected(dimensions.error());
    return cachedPatient(parameters, cacheFolder)
        .and_then(patientOf)
        .map([&](SharedPatientModel model) {
            return ReadyPatient{std::move(model), *dimensions};
        });
}

} // namespace

PlannedPatient::PlannedPatient(std::filesystem::path cacheFolder)
    : m_cacheFolder{std::move(cacheFolder)}
{
    m_maker.setMaxThreadCount(1);
}

PlannedPatient::~PlannedPatient()
{
    m_maker.clear();
    m_maker.waitForDone();
}

void PlannedPatient::want(const QString& words)
{
    if (words == m_words && (m_isBeingMade || m_patient))
        return;
    m_words = words;
    m_patient.reset();
    m_fault.clear();
    const auto parameters = patientFromWords(words.toStdString());
    m_isBeingMade = parameters.has_value();
    if (parameters) {
        m_maker.clear(); // who was named before is not waited for
        m_maker.start([this, words, parameters = *parameters] {
            QMetaObject::invokeMethod(
                this,
                [this, words, patient = readyPatient(parameters, m_cacheFolder)] {
                    made(words, patient);
                },
                Qt::QueuedConnection);
        });
    } else {
        m_fault = errorText(parameters.error());
    }
    Q_EMIT changed();
}

void PlannedPatient::drop()
{
    m_words.clear();
    m_isBeingMade = false;
    m_fault.clear();
    m_patient.reset();
    Q_EMIT changed();
}

void PlannedPatient::take(const ReadyPatient& patient)
{
    m_words.clear();
    m_isBeingMade = false;
    m_fault.clear();
    m_patient = patient;
    Q_EMIT changed();
}

void PlannedPatient::made(const QString& words, const Result<ReadyPatient>& patient)
{
    if (words != m_words)
        return; // another one is wanted by now
    m_isBeingMade = false;
    if (patient)
        m_patient = *patient;
    else
        m_fault = errorText(patient.error());
    Q_EMIT changed();
}

} // namespace carina
