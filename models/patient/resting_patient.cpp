#include "models/patient/resting_patient.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/builtin_cache.h"

#include <QThread>

namespace carina
{

bool hasRestingPatient(const std::string& contentHash)
{
    return parametersOfHash(contentHash).has_value();
}

Result<SharedPatientModel> restingPatient(const std::string& contentHash,
                                          const std::filesystem::path& cacheFolder)
{
    const auto parameters = parametersOfHash(contentHash);
    if (!parameters)
        return fail(Errc::FileNotFound, contentHash);
    const auto dimensions = dimensionsFor(*parameters);
    if (!dimensions)
        return tl::unexpected(dimensions.error());
    return cachedPatient(*parameters, cacheFolder, Posture::Rest)
        .and_then([&](Anatomy&& anatomy) {
            return PatientModel::of(std::move(anatomy), dimensions->tubeInnerDiameter);
        })
        .map([](PatientModel&& model) -> SharedPatientModel {
            return std::make_shared<const PatientModel>(std::move(model));
        });
}

std::optional<LaryngoscopyScript> scriptAtRest(const PatientModel& patient,
                                               const std::filesystem::path& cacheFolder)
{
    const auto resting = restingPatient(patient.contentHash(), cacheFolder);
    const auto laryngoscopy = Laryngoscopy::of(resting ? **resting : patient, bladeOf(kUsualBlade));
    return laryngoscopy ? std::optional{laryngoscopy->script()} : std::nullopt;
}

RestingPatient::RestingPatient()
{
    m_maker.setMaxThreadCount(1);
    m_maker.setThreadPriority(QThread::LowPriority);
}

RestingPatient::~RestingPatient()
{
    m_maker.clear();
    m_maker.waitForDone();
}

const PatientModel* RestingPatient::of(const PatientModel& patient)
{
    const std::string& hash = patient.contentHash();
    if (!hasRestingPatient(hash))
        return &patient;
    if (m_wanted != hash) {
        m_wanted = hash;
        m_made.reset();
        m_isImpossible = false;
        m_maker.clear(); // who lay there before is not waited for
        m_maker.start([this, hash] {
            auto patientAtRest =
                restingPatient(hash, AnatomyCache::defaultFolder()).value_or(nullptr);
            QMetaObject::invokeMethod(
                this, [this, hash, made = std::move(patientAtRest)] { take(hash, made); },
                Qt::QueuedConnection);
        });
    }
    return m_isImpossible ? &patient : m_made.get();
}

void RestingPatient::take(const std::string& contentHash, SharedPatientModel patient)
{
    if (m_wanted != contentHash)
        return;
    m_isImpossible = patient == nullptr;
    m_made = std::move(patient);
    Q_EMIT made();
}

} // namespace carina
