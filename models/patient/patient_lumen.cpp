#include "models/patient/patient_lumen.h"

#include "engine/airway/lumen/measured_lumen.h"

#include <QThread>

#include <utility>

namespace carina
{
namespace
{

/// What is measured, which another thread can hold: the meshes are shared.
struct Measurable {
    std::vector<AnatomyPart> parts; ///< without meshes
    std::vector<std::shared_ptr<const TriangleMesh>> meshes;
    AirwayLandmarks landmarks;
    Length tubeRadius;
};

Measurable measurable(const PatientModel& patient, Length outerDiameter)
{
    Measurable it{{}, {}, patient.landmarks(), 0.5 * outerDiameter};
    for (const PatientSurface& surface : patient.surfaces()) {
        const AnatomyPart& part = surface.description;
        if (surface.body == SurfaceBody::Tube || !tellsLumen(part.role))
            continue;
        it.parts.push_back(
            {.name = part.name, .role = part.role, .conceptId = part.conceptId, .levels = {}});
        it.meshes.push_back(surface.levels.front());
    }
    return it;
}

std::shared_ptr<const AirwayLumen> lumenIn(const Measurable& patient)
{
    std::vector<AnatomyPart> parts = patient.parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].levels.push_back(*patient.meshes[i]);
    auto lumen = measuredLumen(parts, patient.landmarks, patient.tubeRadius);
    return lumen ? std::make_shared<const AirwayLumen>(*std::move(lumen)) : nullptr;
}

} // namespace

PatientLumen::PatientLumen()
{
    m_maker.setMaxThreadCount(1);
    m_maker.setThreadPriority(QThread::LowPriority);
}

PatientLumen::~PatientLumen()
{
    m_maker.clear();
    m_maker.waitForDone();
}

void PatientLumen::want(const PatientModel& patient, Length outerDiameter)
{
    const Wanted wanted{patient.contentHash(), outerDiameter};
    if (m_wanted == wanted)
        return;
    m_wanted = wanted;
    m_lumen.reset();
    m_isImpossible = false;
    m_maker.clear(); // who lay there before is not waited for
    m_maker.start([this, wanted, patient = measurable(patient, outerDiameter)] {
        QMetaObject::invokeMethod(
            this, [this, wanted, lumen = lumenIn(patient)] { take(wanted, lumen); },
            Qt::QueuedConnection);
    });
}

void PatientLumen::take(const Wanted& of, std::shared_ptr<const AirwayLumen> lumen)
{
    if (m_wanted != of)
        return;
    m_isImpossible = lumen == nullptr;
    m_lumen = std::move(lumen);
    Q_EMIT measured();
}

} // namespace carina
