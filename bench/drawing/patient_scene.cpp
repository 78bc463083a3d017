#include "bench/drawing/patient_scene.h"

#include "engine/geometry/rotation.h"
#include "engine/io/anatomy_set/anatomy_set.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "ui/scene/scene_parts.h"

namespace carina::bench
{

PatientScene::PatientScene(SharedPatientModel patient)
    : m_patient{std::move(patient)}, m_parts{sceneParts(*m_patient)}
{
    m_timeline.setRunning(SessionTime{}, true);
}

Result<PatientScene> PatientScene::of(const std::filesystem::path& folder, bool fromCache)
{
    auto loaded = loadAnatomySet(folder, AnatomyCache::defaultFolder());
    if (!loaded)
        return tl::unexpected(loaded.error());
    if (fromCache && !loaded->fromCache)
        return fail(Errc::FileNotFound, "the set is not in the cache");
    return patientOf(std::move(loaded->set.anatomy)).map([](SharedPatientModel patient) {
        return PatientScene{std::move(patient)};
    });
}

Box PatientScene::framed() const
{
    Box framed;
    for (const ScenePart& part : m_parts)
        if (part.framed)
            framed.include(boundsOf(*part.levels.back()));
    return framed;
}

PartLooks PatientScene::solid() const
{
    PartLooks looks;
    for (const ScenePart& part : m_parts)
        looks[part.id] = {.style = PartStyle::Solid};
    return looks;
}

SceneFrame PatientScene::frameAt(double seconds, int level) const
{
    StationMoment moment;
    moment.time += fromSeconds(seconds);
    moment.breathing = m_breathing.at(m_timeline, moment.time).shape();
    moment.pose = drawnPose(m_patient->lungs(), moment.breathing, static_cast<std::size_t>(level));
    return sceneFrame(moment, m_patient->lungs().field());
}

FollowingThroat PatientScene::openThroat() const
{
    return m_patient->throat(
        RigidTransform{rotationFromVector(degrees(15.0).si * Vec3::UnitX()), Vec3::Zero()});
}

} // namespace carina::bench
