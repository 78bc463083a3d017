#include "models/tracker/tracker_trial.h"

#include "tests/evaluation/polaris/served_device.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QTcpServer>

namespace carina::tracker_trial_test
{
namespace
{

std::uint16_t freeTcpPort()
{
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

TrackerDescription wiredAt(std::uint16_t port, std::vector<DescribedTool> tools)
{
    TrackerDescription described;
    described.address = "127.0.0.1:" + std::to_string(port);
    described.tools = std::move(tools);
    return described;
}

std::optional<PolarisPose> still(const std::string& tool, LocalTime)
{
    if (tool == "wired 2")
        return std::nullopt;
    return PolarisPose{Quat::Identity(), {0.0, 0.0, -1500.0}, 0.1};
}

} // namespace

class TrackerTrialTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsWhatAnswersAndHowToolsAreSeen()
    {
        const std::uint16_t port = freeTcpPort();
        const ServedDevice device{PolarisLine::tcp(port).value(),
                                  {.wired = {{.port = 1}, {.port = 2}},
                                   .hasRate = false,
                                   .constants = {{"VER:4", "Polaris Control Firmware\n"
                                                           "NDI S/N: P4-12345\nRev\n"}}},
                                  still};
        TrackerTrial trial;
        QVERIFY(trial.begin(wiredAt(
            port,
            {{"Stylus", ToolRole::Stylus}, {"Chin", ToolRole::Jaw}, {"Tube", ToolRole::Tube}})));
        QCOMPARE(trial.state(), TrackerTrial::State::Looking);
        QTRY_COMPARE_WITH_TIMEOUT(trial.state(), TrackerTrial::State::Answers, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(trial.text().contains(QStringLiteral("✓ Stylus: visible")),
                                 kPatience_ms);
        const QString text = trial.text();
        QVERIFY2(text.contains(QStringLiteral("Polaris Control Firmware, NDI S/N: P4-12345")),
                 qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("plugged in: 2")));
        QVERIFY(text.contains(QStringLiteral("▲ Chin probe: out of view")));
        QVERIFY(text.contains(QStringLiteral("Tube: nothing is plugged in for it")));
        trial.end();
        QCOMPARE(trial.text(), QString{});
    }

    void saysThatNothingAnswersUntilSomethingDoes()
    {
        const std::uint16_t port = freeTcpPort();
        TrackerTrial trial;
        QVERIFY(trial.begin(wiredAt(port, {})));
        QTRY_COMPARE_WITH_TIMEOUT(trial.state(), TrackerTrial::State::Silent, kPatience_ms);
        QVERIFY2(
            trial.text().contains(QStringLiteral("No tracker answers at 127.0.0.1:%1").arg(port)),
            qPrintable(trial.text()));
        QVERIFY(trial.text().contains(QStringLiteral("switched on")));
        const ServedDevice device{PolarisLine::tcp(port).value(), {.hasRate = false}, still};
        QTRY_COMPARE_WITH_TIMEOUT(trial.state(), TrackerTrial::State::Answers, kPatience_ms);
        QVERIFY(trial.text().contains(QStringLiteral("plugged in: 0")));
    }

    void refusesAnAddressThatIsNone()
    {
        TrackerTrial trial;
        const auto begun = trial.begin({});
        QVERIFY(!begun);
        QCOMPARE(begun.error().code, Errc::WrongAddress);
        QCOMPARE(trial.state(), TrackerTrial::State::Idle);
    }
};

CARINA_TEST(TrackerTrialTest)

} // namespace carina::tracker_trial_test

#include "tst_tracker_trial.moc"
