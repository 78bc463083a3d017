#include "ui/scene/station_scene.h"

#include "ui/scene/scene_parts.h"
#include "widgets/scene/view/scene_view.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

Lie lieOf(BodyPosition position)
{
    switch (position) {
    case BodyPosition::Supine:
        return Lie::OnBack;
    case BodyPosition::Sitting:
        return Lie::Upright;
    case BodyPosition::Prone:
        return Lie::OnFront;
    case BodyPosition::RightLateral:
        return Lie::OnRightSide;
    case BodyPosition::LeftLateral:
        return Lie::OnLeftSide;
    }
    return Lie::Upright;
}

} // namespace

StationScene::StationScene(SceneView& scene, const PatientModel& patient, const StationView& view)
    : m_scene{scene},
      m_patient{&patient},
      m_view{&view},
      m_laryngoscope{patient},
      m_standardHeadset{HeadsetView::standard()}
{
    m_distantTube.lieIn(patient);
    m_scene.setParts(sceneParts(patient), patient.reach());
    m_scene.nameSides(kPatientBody);
    m_scene.setFrameSource([this](int level, LocalTime lit) { return frameOf(level, lit); });
    steerHead();
    m_scene.onFrameDrawn([this](const DrawnFrame& frame) {
        for (const Listener& told : m_listeners)
            told(frame, m_moment);
    });
}

SceneFrame StationScene::frameOf(int level, LocalTime lit)
{
    m_moment = momentAt(lit, level);
    m_moment.ownHandsAreDrawn = drawsOwnHands(m_moment, m_output);
    m_scene.setLie(lieOf(m_moment.position));
    const FollowingThroat throat = throatAt(m_moment, *m_patient);
    SceneFrame frame = sceneFrame(m_moment, m_patient->lungs().field(), throat);
    bendTubes(frame, m_moment, *m_patient);
    frame.airway = m_laryngoscope.changesAt(m_moment);
    frame.blade = m_laryngoscope.at(m_moment, throat).tissue;
    m_moment.tubeDrawing = bendTubeAtWork(frame, m_moment);
    const auto contents = m_laryngoscope.contentsIn(m_moment, throat, frame.blade);
    addContents(frame, contents);
    showFigures(contents);
    addLifted(frame, m_moment, *m_patient);
    findViewpoint();
    frame.viewpoint = m_viewpoint;
    const bool ownChoice = m_output == ViewOutput::Screen && !m_viewpoint;
    const auto eyesOf = ownChoice ? m_throughEyesOf : std::nullopt;
    addPeople(frame, m_moment, eyesOf);
    if (eyesOf) {
        const PersonPose* head = headOf(m_moment.people, *eyesOf);
        frame.eyes = m_standardHeadset.eyes(ViewOutput::Mono,
                                            head ? std::optional{head->pose} : std::nullopt);
    } else if (m_headset && !m_viewpoint) {
        addHeadset(frame);
    }
    return frame;
}

TubeDrawing StationScene::bendTubeAtWork(SceneFrame& frame, const StationMoment& moment)
{
    if (!frame.bodies.contains(kTubeBody))
        return TubeDrawing::AsMeasured;
    const TissueAround tissue = tissueAround(frame.airway, frame.throat, frame.blade);
    const TubeInAirway lies =
        moment.tubePoses ? m_distantTube.at(moment, tissue) : m_tubeInAirway(moment, tissue);
    if (lies.p_E.empty())
        return lies.drawing;
    const auto bend = std::make_shared<const LineBend>(m_patient->tube().p_E_centre, lies.p_E);
    for (const char* body : {kTubeBody, kCuffBody}) {
        frame.bentInPlace.erase(body);
        frame.bentAlong[body] = bend;
    }
    if (lies.drawing == TubeDrawing::Apart)
        addMeasuredTube(frame, *m_patient);
    return lies.drawing;
}

void StationScene::addHeadset(SceneFrame& frame) const
{
    frame.isHeadSteered = looksByMouse(m_moment, m_output);
    const PlaceBeside place{.p_A_mouth = m_patient->landmarks().p_A_incisors,
                            .position = m_moment.position,
                            .turn = m_moment.turn};
    frame.eyes = frame.isHeadSteered ? m_headset->eyesAt(m_output, m_headByMouse.poseAt(place))
                                     : m_headset->eyes(m_output, m_moment.head);
}

void StationScene::steerHead()
{
    QObject::connect(&m_scene, &SceneView::headTurned, &m_scene,
                     [this](double right, double down) { m_headByMouse.turn(right, down); });
    QObject::connect(&m_scene, &SceneView::headNeared, &m_scene,
                     [this](double factor) { m_headByMouse.comeNearer(factor); });
    QObject::connect(&m_scene, &SceneView::headReturned, &m_scene,
                     [this] { m_headByMouse.standAgain(); });
}

/// Nobody's picture is moved whose own head moves it. While no poses arrive the last one is kept.
void StationScene::findViewpoint()
{
    const bool isShown = m_followsView && m_output == ViewOutput::Screen && !m_moment.head
                         && m_moment.lesson && m_moment.lesson->lesson.showsView;
    if (!isShown)
        m_viewpoint.reset();
    else if (m_moment.lessonView)
        m_viewpoint = m_moment.lessonView->X_FO;
}

void StationScene::showFigures(const std::vector<ThroatContent>& contents)
{
    std::vector<DrawnPerson> people = drawnPeople(m_moment, m_laryngoscope);
    std::vector<DrawnLift> lifts = drawnLifts(m_moment, *m_patient);
    std::vector<DrawnContent> drawn = drawnContents(contents);
    const bool isApart = m_moment.tubeDrawing == TubeDrawing::Apart;
    if (people == m_people && lifts == m_lifts && drawn == m_contents && isApart == m_isTubeApart)
        return;
    m_isTubeApart = isApart;
    m_people = std::move(people);
    m_lifts = std::move(lifts);
    m_contents = std::move(drawn);
    std::vector<SceneFigure> figures = peopleFigures(m_people, *m_patient);
    std::ranges::move(liftedFigures(m_lifts, *m_patient), std::back_inserter(figures));
    std::ranges::move(contentFigures(m_contents), std::back_inserter(figures));
    if (m_isTubeApart)
        figures.push_back(measuredTubeFigure(*m_patient));
    m_scene.setFigures(figures);
}

void StationScene::show(const PatientModel& patient, const StationView& view)
{
    m_patient = &patient;
    m_view = &view;
    m_laryngoscope.lieIn(patient);
    m_distantTube.lieIn(patient);
    m_scene.setParts(sceneParts(patient), patient.reach());
    m_people.clear(); // whose tubes are those of the patient before
    m_lifts.clear();
    m_contents.clear();
    m_isTubeApart = false;
    m_scene.setFigures({});
}

void StationScene::showTo(const HeadsetView& headset, ViewOutput output)
{
    m_headset = headset;
    m_output = output;
}

void StationScene::onFrameDrawn(Listener listener) { m_listeners.push_back(std::move(listener)); }

} // namespace carina
