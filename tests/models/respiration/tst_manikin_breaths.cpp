#include "engine/session/respiration/patient_run.h"
#include "models/respiration/manikin_breaths.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::manikin_breaths_test
{

using test::FakeSessionNode;

class TestManikinBreaths : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void locksThePatientToTheManikin();
    void hearsNothingOfAMarkerThatIsLost();
    void isNotForObservers();
};

namespace
{

constexpr double kRate_perMin = 22.0;
constexpr std::chrono::milliseconds kFrame{16};

/// A chest that rises towards -y by 12 mm, at each whole breath since the epoch.
struct Manikin {
    FakeSessionNode node;
    Validity validity = Validity::Tracked;
    ManikinBreaths breaths{node, [this] { return marker(); }};

    explicit Manikin(ParticipantId self = FakeSessionNode::kTrainee) : node{self}
    {
        node.decide(fact::PhaseChanged{SessionPhase::Running});
    }
    [[nodiscard]] double phase() const
    {
        const double breath = kRate_perMin / 60.0 * toSeconds(node.now()->time_since_epoch());
        return breath - std::floor(breath);
    }
    [[nodiscard]] std::optional<PoseSample> marker() const
    {
        const double third = 3.0 * phase();
        const double rise = third < 2.0 ? 0.006 * (1.0 - std::cos(std::numbers::pi * third)) : 0.0;
        PoseSample sample;
        sample.time = *node.now();
        sample.validity = validity;
        sample.X_FO = RigidTransform::translation({0.1, 0.3 - rise, 0.2});
        return sample;
    }
    void run(Duration time)
    {
        for (Duration gone{}; gone < time; gone += kFrame) {
            node.advance(kFrame);
            breaths.look();
        }
    }
    [[nodiscard]] RespirationTimeline timeline() const
    {
        return node.state()->stations().at(FakeSessionNode::kStation).respiration;
    }
};

} // namespace

void TestManikinBreaths::locksThePatientToTheManikin()
{
    Manikin manikin;
    manikin.run(std::chrono::seconds{60});
    QVERIFY(manikin.timeline().breaths().size() >= 20);
    const RespirationTimeline timeline = manikin.timeline();
    PatientRun run{timeline, SessionTime::min()};
    run.advanceTo(timeline, *manikin.node.now());
    const BreathClock::State clock = run.fold().state().clock;
    QVERIFY(std::abs(inPerMinute(clock.rate) - kRate_perMin) < 0.5);
    // Rises begin together: the detector is late by 0.158 of a third of a breath.
    const double virtualPhase = clock.breaths - std::floor(clock.breaths);
    const double apart = std::remainder(virtualPhase - manikin.phase() + 0.053, 1.0);
    QVERIFY2(std::abs(apart) < 0.04, qPrintable(QString::number(apart)));
}

void TestManikinBreaths::hearsNothingOfAMarkerThatIsLost()
{
    Manikin manikin;
    manikin.validity = Validity::Lost;
    manikin.run(std::chrono::seconds{10});
    QCOMPARE(manikin.node.proposed, 0);
}

void TestManikinBreaths::isNotForObservers()
{
    Manikin manikin{FakeSessionNode::kObserver};
    manikin.run(std::chrono::seconds{10});
    QVERIFY(manikin.node.proposed > 0);
    QVERIFY(manikin.timeline().breaths().empty());
}

CARINA_TEST(TestManikinBreaths)

} // namespace carina::manikin_breaths_test

#include "tst_manikin_breaths.moc"
