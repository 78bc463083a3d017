#include "ui/scene/people_figures.h"

#include "models/station/people_words.h"
#include "ui/scene/scene_parts.h"
#include "widgets/scene/figures/figure_shapes.h"

#include <array>
#include <memory>
#include <utility>

namespace carina
{
namespace
{

/// Above the ids of the patient's parts.
constexpr std::uint16_t kFirstId = 0x8000;

/// Of the owner of a figure, by number. They repeat, and beside each is a name.
constexpr std::array kPeopleColors{QColor{150, 186, 214}, QColor{222, 188, 122},
                                   QColor{126, 156, 110}, QColor{206, 176, 208},
                                   QColor{176, 116, 100}, QColor{206, 214, 196}};
constexpr QColor kVisorColor{38, 44, 56};
constexpr QColor kBladeColor{196, 202, 208};
constexpr QColor kPointerColor{236, 92, 160};

const Vec3 kAboveHead{0.0, kHeadTop, 0.085};
const Vec3 kOnTube{0.0, 0.0, 0.01};

std::string bodyOfObject(ObjectId object) { return "person " + std::to_string(object.value); }

bool isDrawn(const PersonPose& person, const StationMoment& moment)
{
    switch (person.kind) {
    case ObjectKind::Head:
        return !person.isOwn;
    case ObjectKind::Hand:
    case ObjectKind::Stylus:
        return !person.isOwn || moment.ownHandsAreDrawn;
    case ObjectKind::Laryngoscope:
    case ObjectKind::Pointer:
        return true;
    case ObjectKind::Tube:
        // The own one at work is drawn with the patient.
        return !person.isOwn || !person.isAtWork;
    case ObjectKind::Jaw:
    case ObjectKind::Patient:
    case ObjectKind::OrganGroup:
    case ObjectKind::SpareTube:
    case ObjectKind::View:
        break;
    }
    return false;
}

/// Nobody sees their own objects turned: an eye is where its head is, whatever place was chosen.
const RigidTransform& poseInView(const PersonPose& person,
                                 const std::optional<ParticipantId>& throughEyesOf)
{
    const bool isViewers = throughEyesOf ? person.owner == *throughEyesOf : person.isOwn;
    return isViewers ? person.pose.X_FO : person.X_AO;
}

/// Makes the parts of figures, each with an id of its own.
class FigureMaker
{
public:
    explicit FigureMaker(const PatientModel& patient) : m_patient{patient} {}

    SceneFigure figureOf(const DrawnPerson& person)
    {
        m_figure = {.body = person.isAtWork ? kTubeBody : bodyOfObject(person.object),
                    .name = person.name};
        const FigureShapes& shapes = figureShapes();
        const QColor color = kPeopleColors[person.owner.value % kPeopleColors.size()];
        switch (person.kind) {
        case ObjectKind::Head:
            m_figure.p_F_name = kAboveHead;
            add("Head", shapes.head, color);
            add("Visor", shapes.visor, kVisorColor);
            add("Direction", shapes.gaze, color);
            break;
        case ObjectKind::Hand:
            add("Hand", shapes.hand, color);
            add("Direction", shapes.ray, color);
            break;
        case ObjectKind::Stylus:
            add("Stylus", shapes.stylus, color);
            add("Direction", shapes.ray, color);
            break;
        case ObjectKind::Pointer:
            add("Pointer", shapes.stylus, kPointerColor);
            break;
        case ObjectKind::Laryngoscope:
            add("Laryngoscope", std::make_shared<const TriangleMesh>(bladeMesh(person.blade)),
                kBladeColor);
            add("Handle", shapes.handle, color);
            break;
        case ObjectKind::Tube:
            m_figure.p_F_name = kOnTube;
            if (!person.isAtWork)
                addTube();
            break;
        case ObjectKind::Jaw:
        case ObjectKind::Patient:
        case ObjectKind::OrganGroup:
        case ObjectKind::SpareTube:
        case ObjectKind::View:
            break;
        }
        return std::move(m_figure);
    }

private:
    void add(const char* name, FigureShapes::Mesh mesh, const QColor& color)
    {
        m_figure.parts.push_back({.name = name,
                                  .id = m_nextId++,
                                  .group = MaterialGroup::Tool,
                                  .color = color,
                                  .body = m_figure.body,
                                  .framed = false,
                                  .levels = {std::move(mesh)}});
    }

    void addTube()
    {
        m_figure.parts = tubeParts(m_patient, m_figure.body, m_nextId);
        m_nextId += std::uint16_t(m_figure.parts.size());
    }

    const PatientModel& m_patient;
    SceneFigure m_figure;
    std::uint16_t m_nextId = kFirstId;
};

} // namespace

std::vector<DrawnPerson> drawnPeople(const StationMoment& moment, const StationLaryngoscope& blades)
{
    std::vector<DrawnPerson> people;
    for (const PersonPose& person : moment.people)
        if (isDrawn(person, moment))
            people.push_back({.object = person.object,
                              .owner = person.owner,
                              .kind = person.kind,
                              .name = nameBeside(person, moment.worker),
                              .isAtWork = person.isAtWork,
                              .isOwn = person.isOwn,
                              .blade = person.kind == ObjectKind::Laryngoscope
                                           ? blades.bladeOf(person).form
                                           : BladeForm{}});
    return people;
}

std::vector<SceneFigure> peopleFigures(const std::vector<DrawnPerson>& people,
                                       const PatientModel& patient)
{
    FigureMaker maker{patient};
    std::vector<SceneFigure> figures;
    for (const DrawnPerson& person : people)
        figures.push_back(maker.figureOf(person));
    return figures;
}

std::vector<ObjectInFrame> objectsIn(const SceneFrame& frame, const StationMoment& moment)
{
    std::vector<ObjectInFrame> objects;
    for (const PersonPose& person : moment.people) {
        const bool isDrawnWithPatient = person.isAtWork && person.kind == ObjectKind::Tube;
        const auto body =
            frame.bodies.find(isDrawnWithPatient ? kTubeBody : bodyOfObject(person.object));
        ObjectInFrame object{person.object, person.owner, person.kind, person.isOwn, person.X_AO};
        const bool isInFrame = body != frame.bodies.end();
        if (!isInFrame && (!person.isOwn || person.pose.validity == Validity::Lost))
            continue;
        if (isInFrame && !person.isOwn)
            object.X_AO = body->second.X_AF;
        objects.push_back(object);
    }
    return objects;
}

void bendTubes(SceneFrame& frame, const StationMoment& moment, const PatientModel& patient)
{
    bendTube(frame, patient);
    for (const PersonPose& person : moment.people)
        if (person.kind == ObjectKind::Tube && !person.isAtWork)
            bendTube(frame, patient, bodyOfObject(person.object));
}

void addPeople(SceneFrame& frame, const StationMoment& moment,
               const std::optional<ParticipantId>& throughEyesOf)
{
    for (const PersonPose& person : moment.people) {
        const bool isEye = person.kind == ObjectKind::Head && person.owner == throughEyesOf;
        if (isDrawn(person, moment) && !person.isAtWork && !isEye
            && person.pose.validity != Validity::Lost)
            frame.bodies[bodyOfObject(person.object)] = poseInView(person, throughEyesOf);
    }
}

} // namespace carina
