#include "engine/tracking/simulated/simulated_options.h"

#include "tests/support/test_class.h"

namespace carina::simulated_options_test
{
namespace
{

using namespace std::chrono_literals;

/// A tracker of these options before which all tools lie still, after so many seconds; its history
/// holds 512 samples.
class Tracked
{
public:
    explicit Tracked(const std::string& options, Duration until = 8s)
    {
        auto settings = readSimulatedOptions(options).value();
        settings.latency = Duration::zero();
        m_tracker = std::make_unique<SimulatedTracker>(
            settings,
            [](ToolRole, SessionTime) {
                return RigidTransform::translation({0.0, 0.0, -1.5});
            },
            [] { return std::optional<SessionTime>{}; });
        for (SessionTime now{}; now < SessionTime{until};)
            now = m_tracker->advance(now);
    }

    [[nodiscard]] std::vector<PoseSample> samplesOf(ToolRole role) const
    {
        for (const TrackedTool& tool : m_tracker->tools())
            if (tool.role == role)
                return tool.history->samples();
        return {};
    }

    [[nodiscard]] Validity at(ToolRole role, Duration t) const
    {
        const auto samples = samplesOf(role);
        const auto found = std::ranges::lower_bound(samples, SessionTime{t}, {}, &PoseSample::time);
        return found == samples.end() ? Validity::Lost : found->validity;
    }

private:
    std::unique_ptr<SimulatedTracker> m_tracker;
};

} // namespace

class TestSimulatedOptions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void exposesAtTheChosenRate()
    {
        const Tracked tracked{"rate=30"};
        QCOMPARE(tracked.samplesOf(ToolRole::Tube).size(), 8U * 30U);
    }

    void hidesAToolAgainAndAgain()
    {
        const Tracked tracked{"rate=20,hidden=tube", 16s};
        QCOMPARE(tracked.at(ToolRole::Tube, 2900ms), Validity::Tracked);
        QCOMPARE(tracked.at(ToolRole::Tube, 4s), Validity::Lost);
        QCOMPARE(tracked.at(ToolRole::Tube, 5100ms), Validity::Tracked);
        QCOMPARE(tracked.at(ToolRole::Tube, 14s), Validity::Lost);
        QCOMPARE(tracked.at(ToolRole::Tube, 15100ms), Validity::Tracked);
        QCOMPARE(tracked.at(ToolRole::Jaw, 4s), Validity::Tracked);
    }

    void hidesHalfOfTheMarkers()
    {
        const Tracked tracked{"rate=20,partly=head"};
        QCOMPARE(tracked.at(ToolRole::Head, 4s), Validity::PartlyOccluded);
        QCOMPARE(tracked.at(ToolRole::Head, 6s), Validity::Tracked);
    }

    /// Of 480 exposures a fifth with a standard deviation of 1.8 %: four of these to either side.
    void dropsExposures()
    {
        const Tracked tracked{"dropouts=20"};
        const double share = double(tracked.samplesOf(ToolRole::Jaw).size()) / (8.0 * 60.0);
        QVERIFY2(std::abs(share - 0.8) < 0.073, QByteArray::number(share).constData());
        QCOMPARE(tracked.samplesOf(ToolRole::Jaw).size(),
                 tracked.samplesOf(ToolRole::Head).size()); // the exposure is lost, not a tool
    }

    void hasALaryngoscopeWhereAskedFor()
    {
        QVERIFY(readSimulatedOptions("with=laryngoscope").value().laryngoscope);
        QVERIFY(!readSimulatedOptions("rate=30").value().laryngoscope);
        QVERIFY(!Tracked{"with=laryngoscope"}.samplesOf(ToolRole::Laryngoscope).empty());
    }

    void saysInWordsWhatItRead_data()
    {
        QTest::addColumn<std::string>("words");
        for (const char* words :
             {"rate=30", "dropouts=2.5", "hidden=tube,hidden=jaw,partly=head",
              "rate=12.5,hidden=tube,partly=jaw,dropouts=5", "dropouts=5,with=laryngoscope"})
            QTest::newRow(words) << std::string{words};
    }

    void saysInWordsWhatItRead()
    {
        QFETCH(const std::string, words);
        const auto options = simulatedOptions(words);
        QVERIFY(options);
        QCOMPARE(simulatedWords(*options), words);
    }

    void saysNothingOfWhatIsAsUsual()
    {
        QCOMPARE(simulatedWords({}), std::string{});
        QCOMPARE(simulatedWords(simulatedOptions("rate=60,dropouts=0").value()), std::string{});
    }

    void refusesOthersAndSaysWhatThereIs_data()
    {
        QTest::addColumn<std::string>("words");
        for (const char* words :
             {"", "rate", "rate=0", "rate=2000", "rate=fast", "hidden=other", "hidden=tubes",
              "dropouts=95", "speed=3", "rate=30,", "rate=nan", "with=tube", "with="})
            QTest::addRow("\"%s\"", words) << std::string{words};
    }

    void refusesOthersAndSaysWhatThereIs()
    {
        QFETCH(std::string, words);
        const auto settings = readSimulatedOptions(words);
        QVERIFY(!settings);
        QCOMPARE(settings.error().code, Errc::WrongOption);
        for (const char* there :
             {"rate=HZ", "hidden=TOOL", "partly=TOOL", "dropouts=PERCENT", "laryngoscope"})
            QVERIFY2(settings.error().detail.find(there) != std::string::npos, there);
    }
};

CARINA_TEST(TestSimulatedOptions)

} // namespace carina::simulated_options_test

#include "tst_simulated_options.moc"
