#pragma once

#include "models/scoring/try_watch.h"
#include "tests/models/fake_session_node.h"

namespace carina::test
{

/// A session that runs, with a watch over the tries at its station; the monitor's notes are written
/// by hand.
struct TriedSession {
    FakeSessionNode node;
    SessionModel session{node};
    TryWatch tries{session, FakeSessionNode::kStation};

    explicit TriedSession(ParticipantId self = FakeSessionNode::kInstructor) : node{self}
    {
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        run(std::chrono::seconds{2});
    }
    /// Time passes, and the watch looks.
    void run(std::chrono::milliseconds time)
    {
        constexpr std::chrono::milliseconds kLook{100};
        for (std::chrono::milliseconds passed{}; passed < time; passed += kLook) {
            node.advance(kLook);
            tries.watch();
        }
    }
    void note(IntubationStep step, TubeSeat seat = TubeSeat::None, Length depth = {})
    {
        node.decide(fact::IntubationNoted{{.step = step,
                                           .at = *node.now(),
                                           .seat = seat,
                                           .depthAtTeeth = depth,
                                           .tipAboveCarina = millimetres(25.0),
                                           .glotticOpening = 0.6},
                                          {}});
        run(std::chrono::seconds{1});
    }
    /// Blade in, a view, and the tube 200 mm deep in the trachea, in four seconds.
    void intubate()
    {
        note(IntubationStep::BladeIn);
        note(IntubationStep::GlottisSeen);
        note(IntubationStep::TubePastTeeth);
        note(IntubationStep::ThroughCords, TubeSeat::Trachea, millimetres(200.0));
    }
    /// A person ends the try, which takes effect a moment later.
    void endTry()
    {
        tries.finish();
        node.advance(std::chrono::milliseconds{300});
        tries.watch();
    }
    void squeezeBag() { node.decide(fact::BagSqueezed{{perMinute(20.0), millilitres(300.0)}}); }
};

} // namespace carina::test
