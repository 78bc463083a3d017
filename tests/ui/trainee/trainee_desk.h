#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "models/physiology/hands_model.h"
#include "models/vitals/sound_output.h"
#include "models/vitals/station_vitals.h"
#include "tests/models/fake_session_node.h"
#include "ui/trainee/trainee_window.h"

namespace carina::test
{

/// A trainee's window over a session in virtual time, with the built-in child and no tracker.
struct TraineeDesk {
    static SharedPatientModel child()
    {
        static const SharedPatientModel made =
            patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
        return made;
    }

    explicit TraineeDesk(ViewOutput kind = ViewOutput::Screen) : output{kind}
    {
        window.setMonitor(vitals.model(), sound);
        window.setHands(hands);
    }

    ViewOutput output;
    SharedPatientModel drawn = child();
    FakeSessionNode node{FakeSessionNode::kTrainee};
    SessionModel session{node};
    SharedObjectModel object{session, FakeSessionNode::kStation};
    ObjectActionModel actions{object};
    PeopleModel people{session, FakeSessionNode::kStation};
    TryWatch tries{session, FakeSessionNode::kStation};
    SessionPatient patient{node, FakeSessionNode::kStation, drawn, AnatomyCache::defaultFolder()};
    StationView view{node, FakeSessionNode::kStation, drawn->lungs()};
    StationVitals vitals{session, FakeSessionNode::kStation};
    SoundOutput sound{
        [this](std::span<float> samples) { vitals.model().sounds().render(samples); }};
    HandsModel hands{session, FakeSessionNode::kStation};
    OfferSwitch offer{[this] { return OfferGiver::Shown{view, *drawn}; }};
    TraineeWindow window{node,
                         patient,
                         view,
                         HeadsetView::standard(),
                         output,
                         ChinProbeModel{nullptr},
                         actions,
                         people,
                         tries,
                         {},
                         {.canBeGiven = true, .offer = &offer}};
};

} // namespace carina::test
