#include "models/station/chin_probe_model.h"

#include "engine/tracking/simulated/simulated_tracker.h"
#include "tests/support/test_class.h"

namespace carina::chin_probe_model_test
{
namespace
{

/// A station that is never started: what it has is known all the same.
StationTracking station(bool bodyProbe, bool chinProbe = true)
{
    SimulatedTrackerSettings settings;
    settings.bodyProbe = bodyProbe;
    StationRegistration registration;
    if (chinProbe)
        registration.X_JA = RigidTransform{};
    if (bodyProbe)
        registration.X_BA = RigidTransform{};
    const auto nowhere = [](ToolRole, SessionTime) { return std::optional<RigidTransform>{}; };
    return {std::make_unique<SimulatedTracker>(settings, nowhere,
                                               [] { return std::optional<SessionTime>{}; }),
            registration};
}

} // namespace

class TestChinProbeModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhatThePatientFollows()
    {
        StationTracking tracking = station(true);
        const ChinProbeModel model{&tracking};
        QVERIFY(!model.isThere()); // nothing to choose
        model.setMovesManikin(true);
        QVERIFY(!model.movesManikin());
        QVERIFY(model.notice().contains(QStringLiteral("body probe")));
        QCOMPARE(model.assumption(), model.notice());
    }

    void saysWhatIsAssumedOfAChinProbe()
    {
        StationTracking tracking = station(false);
        const ChinProbeModel model{&tracking};
        QVERIFY(model.isThere());
        QVERIFY(model.notice().isEmpty());
        QVERIFY(model.assumption().contains(QStringLiteral("moves the jaw")));
        model.setMovesManikin(true);
        QVERIFY(model.movesManikin());
        QVERIFY(model.notice().contains(QStringLiteral("follows the chin probe")));
        QCOMPARE(model.assumption(), model.notice());
        model.setMovesManikin(false);
        QVERIFY(model.notice().isEmpty());
    }

    void saysThatNothingMayBeMoved()
    {
        StationTracking tracking = station(false, false);
        const ChinProbeModel model{&tracking};
        QVERIFY(!model.isThere());
        QVERIFY(model.notice().isEmpty());
        QVERIFY(model.assumption().contains(QStringLiteral("Do not move")));
        QVERIFY(!model.assumption().contains(QStringLiteral("jaw")));
    }

    void saysNothingWithoutATracker()
    {
        const ChinProbeModel model{nullptr};
        QVERIFY(!model.isThere());
        QVERIFY(model.notice().isEmpty());
        QVERIFY(model.assumption().isEmpty());
    }
};

CARINA_TEST(TestChinProbeModel)

} // namespace carina::chin_probe_model_test

#include "tst_chin_probe_model.moc"
