#include "models/station/tool_status.h"

#include "tests/support/test_class.h"

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
        return {{"Blade", ToolRole::Laryngoscope, &m_history}};
    }

    /// Fifty a second, the last one so long ago.
    void see(int samples, Duration lastAgo, Validity validity = Validity::Tracked)
    {
        for (int i = samples; i-- > 0;)
            m_history.push(
                {.time = kNow - lastAgo - i * 20ms, .validity = validity, .error = 0.25e-3});
    }
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
