#include "models/station/tool_status.h"

#include "tests/support/test_class.h"

#include <cmath>

namespace carina::tool_status_test
{
namespace
{

using namespace std::chrono_literals;

constexpr SessionTime kNow{100s};

/// One tool, with samples that a test writes.
class OneTool : public Tracker
{
public:
    [[nodiscard]] Result<void> start() override { return {}; }
    void stop() override {}
    [[nodiscard]] std::vector<TrackedTool> tools() const override
    {
        return {{"Blade", ToolRole::Laryngoscope, &m_history, probe, noise}};
    }

    /// Fifty a second, the last one so long ago.
    void see(int samples, Duration lastAgo, Validity validity = Validity::Tracked)
    {
        for (int i = samples; i-- > 0;)
            m_history.push({.time = kNow - lastAgo - i * 20ms,
                            .X_FO = RigidTransform::translation({0.0, 0.0, -1.0}),
                            .validity = validity,
                            .error = 0.25e-3});
    }
    [[nodiscard]] ToolSight sightOf(std::size_t) const override { return told; }
    ToolSight told = ToolSight::Unsaid;
    void push(const PoseSample& sample) { m_history.push(sample); }
    std::optional<Probe> probe{};
    MarkerNoise noise{};

    [[nodiscard]] ToolStatus status() const { return toolStatus(*this, kNow).at(0); }

private:
    mutable PoseHistory m_history;
};

} // namespace

class ToolStatusTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aToolThatWasNeverSeenHasNoAge()
    {
        const ToolStatus status = OneTool{}.status();
        QVERIFY(!status.isVisible);
        QCOMPARE(status.name, QStringLiteral("Laryngoscope"));
        QCOMPARE(status.state, QStringLiteral("never seen"));
        QVERIFY(!status.age_s && !status.error_mm);
        QCOMPARE(status.rate_Hz, 0.0);
    }

    void aToolThatIsSeenHasRateAgeAndFit()
    {
        OneTool tracker;
        tracker.see(100, 10ms);
        const ToolStatus status = tracker.status();
        QVERIFY(status.isVisible);
        QCOMPARE(status.state, QStringLiteral("visible"));
        QVERIFY(std::abs(status.rate_Hz - 50.0) < 1e-6);
        QVERIFY(std::abs(status.age_s.value() - 0.010) < 1e-9);
        QVERIFY(std::abs(status.error_mm.value() - 0.25) < 1e-9);
    }

    void theErrorToExpectIsThatOfItsMarkers()
    {
        OneTool tracker;
        tracker.see(10, 10ms, Validity::Tracked);
        QVERIFY(!tracker.status().expected_mm);
        // Four markers 50 mm from the origin in the corners of a square, seen from above: the
        // error of their mean is that of one over 2; each turn about an axis of the square is
        // s / (2 * 50 mm), about the normal by s / (2 sqrt(2) 50 mm) with s = e / sqrt(3).
        constexpr double kArm = 0.05;
        Probe square;
        for (const Vec3& p : {Vec3{kArm, 0.0, 0.0}, Vec3{0.0, kArm, 0.0}, Vec3{-kArm, 0.0, 0.0},
                              Vec3{0.0, -kArm, 0.0}})
            square.markers.push_back({p, Vec3::UnitZ()});
        tracker.probe = square;
        tracker.noise = {millimetres(0.3), 1.0};
        tracker.see(10, 0ms, Validity::Tracked);
        const ToolStatus status = tracker.status();
        QVERIFY(std::abs(status.expected_mm.value() - 0.15) < 1e-6);
        const double s = 0.3e-3 / std::sqrt(3.0);
        const double aboutAxis = s / std::sqrt(2.0 * kArm * kArm);
        const double aboutNormal = s / std::sqrt(4.0 * kArm * kArm);
        const double turn = std::sqrt(2.0 * aboutAxis * aboutAxis + aboutNormal * aboutNormal);
        QVERIFY(std::abs(status.expected_deg.value() - inDegrees(radians(turn))) < 1e-6);
    }

    /// It is partly hidden, and the tracker does not tell which of its markers it sees.
    void noErrorIsToldThatWouldBeTooSmall()
    {
        OneTool tracker;
        tracker.probe = Probe{.markers = {{{0.05, 0.0, 0.0}, Vec3::UnitZ()},
                                          {{0.0, 0.05, 0.0}, Vec3::UnitZ()},
                                          {{-0.05, 0.0, 0.0}, Vec3::UnitZ()}}};
        tracker.see(10, 10ms);
        QVERIFY(tracker.status().expected_mm && tracker.status().expected_deg);
        tracker.see(10, 0ms, Validity::PartlyOccluded);
        const ToolStatus status = tracker.status();
        QVERIFY(status.isVisible);
        QVERIFY(!status.expected_mm && !status.expected_deg);
    }

    /// As by a camera: 0.3 mm and 1 mrad about each axis, the shift and the turn of one point.
    void theErrorToExpectIsThatOfTheCovarianceThatItsTrackerTells()
    {
        OneTool tracker;
        PoseSample sample{.time = kNow - 10ms, .X_FO = RigidTransform::translation({0, 0, -1})};
        Vec6 variances;
        variances << Vec3::Constant(1e-6), Vec3::Constant(0.09e-6);
        sample.covariance_O = Mat6{variances.asDiagonal()};
        tracker.push(sample);
        const ToolStatus status = tracker.status();
        QVERIFY(std::abs(status.expected_mm.value() - std::sqrt(3.0) * 0.3) < 1e-9);
        QVERIFY(std::abs(status.expected_deg.value() - inDegrees(radians(std::sqrt(3.0) * 1e-3)))
                < 1e-9);
    }

    void predictionIsComparedWithWhatFollowed()
    {
        OneTool tracker;
        QVERIFY(!tracker.status().predicted_mm);
        for (int i = 100; i-- > 0;)
            tracker.push({.time = kNow - i * 20ms,
                          .X_FO = RigidTransform::translation({-0.2 * 0.02 * i, 0.0, -1.0}),
                          .motion = Motion{.v_FO = {0.2, 0.0, 0.0}}});
        const ToolStatus status = tracker.status();
        QVERIFY(std::abs(status.held_mm.value() - 8.0) < 1e-6); // 0.2 m/s for 40 ms
        QVERIFY(status.predicted_mm.value() < 1e-6);
    }

    /// Of a pose that came after the time of the look.
    void noToolIsYoungerThanNow()
    {
        OneTool tracker;
        tracker.see(10, -120ms);
        QCOMPARE(tracker.status().age_s.value(), 0.0);
        QVERIFY(tracker.status().isVisible);
    }

    void saysThatTheDeviceIsSilent()
    {
        OneTool tracker;
        tracker.told = ToolSight::Silent;
        QCOMPARE(tracker.status().state, QStringLiteral("never seen: device silent"));
        tracker.see(50, 10ms);
        QCOMPARE(tracker.status().state, QStringLiteral("device silent"));
        QVERIFY(!tracker.status().isVisible);
        OneTool longAgo;
        longAgo.told = ToolSight::Silent;
        longAgo.see(50, 5s);
        QCOMPARE(longAgo.status().state, QStringLiteral("device silent"));
        QCOMPARE(longAgo.status().text, QStringLiteral("device silent"));
    }

    void aHiddenToolKeepsItsRateWhileItsAgeGrows()
    {
        OneTool tracker;
        tracker.see(50, 400ms);
        tracker.see(20, 10ms, Validity::Lost);
        const ToolStatus status = tracker.status();
        QVERIFY(!status.isVisible);
        QCOMPARE(status.state, QStringLiteral("out of view"));
        QVERIFY(std::abs(status.rate_Hz - 50.0) < 1.0);
        QVERIFY(std::abs(status.age_s.value() - 0.4) < 1e-9);
        QVERIFY(!status.error_mm);
    }

    void aTrackerThatDeliversNothingHasNoRate()
    {
        OneTool tracker;
        tracker.see(50, 2s);
        const ToolStatus status = tracker.status();
        QVERIFY(!status.isVisible);
        QCOMPARE(status.rate_Hz, 0.0);
        QVERIFY(std::abs(status.age_s.value() - 2.0) < 1e-9);
    }

    void saysWhyAToolHasNoPose()
    {
        OneTool tracker;
        tracker.told = ToolSight::BadFit;
        QCOMPARE(tracker.status().state,
                 QStringLiteral("never seen: its markers do not fit its definition"));
        tracker.see(50, 400ms);
        tracker.see(20, 10ms, Validity::Lost);
        tracker.told = ToolSight::Interference;
        QCOMPARE(tracker.status().state, QStringLiteral("other infrared light disturbs"));
        QCOMPARE(tracker.status().text, QStringLiteral("other infrared light disturbs"));
    }

    void saysThatAPoseIsOutsideTheVolume()
    {
        OneTool tracker;
        tracker.see(50, 10ms, Validity::PartlyOccluded);
        tracker.told = ToolSight::OutOfVolume;
        const ToolStatus status = tracker.status();
        QVERIFY(status.isVisible);
        QCOMPARE(status.state, QStringLiteral("outside the working volume"));
        QVERIFY(status.text.startsWith(QStringLiteral("outside the working volume, 50")));
    }

    void forgetsTheReasonOfATrackerThatDeliversNothing()
    {
        OneTool tracker;
        tracker.see(50, 2s, Validity::Lost);
        tracker.see(1, 2s);
        tracker.told = ToolSight::Interference;
        QCOMPARE(tracker.status().state, QStringLiteral("out of view"));
    }

    /// Servers of OpenIGTLink and many recordings tell none.
    void statesNoFitThatNobodyTold()
    {
        OneTool tracker;
        for (int i = 50; i-- > 0;)
            tracker.push(
                {.time = kNow - i * 20ms, .X_FO = RigidTransform::translation({0.0, 0.0, -1.0})});
        const ToolStatus status = tracker.status();
        QVERIFY(status.isVisible);
        QVERIFY(!status.error_mm);
        QCOMPARE(status.text, QStringLiteral("visible, 50\u00a0Hz, 0\u00a0ms old"));
    }

    void aToolThatIsPartlyOutIsStillVisible()
    {
        OneTool tracker;
        tracker.see(50, 10ms, Validity::PartlyOccluded);
        QVERIFY(tracker.status().isVisible);
        QCOMPARE(tracker.status().state, QStringLiteral("partly out of view"));
    }
};

CARINA_TEST(ToolStatusTest)

} // namespace carina::tool_status_test

#include "tst_tool_status.moc"
