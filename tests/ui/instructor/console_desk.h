#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/scratch_folder.h"
#include "ui/instructor/instructor_window.h"

#include <utility>

namespace carina::test
{

/// A console over a session in virtual time, with the built-in child or another patient, and with a
/// tracker while `sight` says how that sees its tools.
struct ConsoleDesk {
    static SharedPatientModel child()
    {
        static const SharedPatientModel made =
            patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
        return made;
    }

    explicit ConsoleDesk(const ScratchFolder& kept, SharedPatientModel lying = child())
        : drawn{std::move(lying)}, keeper{kept.path()}
    {
    }

    SharedPatientModel drawn;
    FakeSessionNode node;
    SessionModel session{node};
    StationsModel stations{session};
    BreathingModel breathing{session, FakeSessionNode::kStation};
    RespirationModel respiration{session, FakeSessionNode::kStation};
    GasModel gas{session, FakeSessionNode::kStation};
    AirwayEventModel airway{session, FakeSessionNode::kStation};
    HeadPositionModel head{session, FakeSessionNode::kStation};
    BreathTrace trace{session, FakeSessionNode::kStation};
    ParticipantsModel participants{session};
    ConductModel conduct{session};
    PeopleModel people{session, FakeSessionNode::kStation};
    NetworkModel network{session};
    SharedObjectModel object{session, FakeSessionNode::kStation};
    LessonModel lesson{session, FakeSessionNode::kStation};
    ObjectActionModel actions{object};
    SessionPatient patient{node, FakeSessionNode::kStation, drawn, AnatomyCache::defaultFolder()};
    AttentionModel attention{session};
    IntubationTimeline intubation{session, FakeSessionNode::kStation};
    StationView view{node, FakeSessionNode::kStation, drawn->lungs()};
    KeptConsole keeper;
    std::optional<TrackerSight> sight;
    PoseRecording recording{[this] { return node.now(); }};
    OfferSwitch offer{[this] { return OfferGiver::Shown{view, *drawn}; }};
    InstructorWindow window{{session, breathing, respiration, gas, airway, head, trace,
                             participants, conduct, people, network, actions, stations, lesson,
                             patient, attention, intubation},
                            keeper,
                            view,
                            {.sight = [this] { return sight; },
                             .recording = &recording,
                             .canBeGiven = true,
                             .treatment = {{}, [](const PoseTreatment& /*chosen*/) {}},
                             .offer = &offer}};

    template <class Thing> [[nodiscard]] Thing& find(const char* name)
    {
        return *window.findChild<Thing*>(QLatin1String{name});
    }
};

} // namespace carina::test
