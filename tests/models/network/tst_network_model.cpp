#include "models/network/network_figures_model.h"
#include "models/network/network_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

namespace carina::network_model_test
{
namespace
{

using namespace std::chrono_literals;
using test::FakeSessionNode;
using Column = NetworkFiguresModel::Column;

constexpr auto kInstructor = FakeSessionNode::kInstructor;
constexpr auto kTrainee = FakeSessionNode::kTrainee;
constexpr auto kObserver = FakeSessionNode::kObserver;
const QString kUnknown = QStringLiteral("not known yet");

/// A path of which everything is known: delays of 8 and 12 ms.
PathReport knownPath(ParticipantId peer)
{
    PathReport path{peer};
    path.roundTrip = 24ms;
    path.delays = {8ms, 12ms};
    path.meanDelay = 10ms;
    path.sigma = 2ms;
    path.probesPerSecond = 3.0;
    path.clockOffset = 12'345'678'901us;
    path.clockError = 54us;
    path.clockErrorBound = 8ms;
    path.loss = 0.0123;
    return path;
}

ObjectReport movingTube()
{
    ObjectReport report{FakeSessionNode::kTube, 21ms, 0.14, 0.8};
    report.turnDegPerS = 100.0;
    report.moveMmPerS = 50.0;
    return report;
}

/// What the table says of a participant, line by line.
QStringList linesOf(const NetworkFigures& figures)
{
    NetworkFiguresModel table;
    const QAbstractItemModelTester tester{&table,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest};
    table.show(figures);
    QStringList lines;
    for (int row = 0; row < table.rowCount(); ++row)
        lines << table.index(row, Column::HowMuch).data(Qt::AccessibleTextRole).toString();
    return lines;
}

} // namespace

class TestNetworkModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsWhomThereIsAPathTo()
    {
        FakeSessionNode node;
        node.pathReports = {PathReport{kObserver}, PathReport{kTrainee},
                            PathReport{ParticipantId{77}}}; // nobody the session knows
        SessionModel session{node};
        const NetworkModel model{session};
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.index(0).data().toString(), QStringLiteral("Tom"));
        QCOMPARE(model.index(1).data().toString(), QStringLiteral("Olga"));
        QCOMPARE(model.index(1).data(NetworkModel::kIdRole).toInt(), int{kObserver.value});
        QCOMPARE(model.newest(), 1);
        QCOMPARE(model.index(2).data().toString(), QStringLiteral("Ina (you)"));
        QVERIFY(!model.figures(-1));
        QVERIFY(!model.figures(3));
    }

    void givesEveryFigureInItsUnit()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        const NetworkFigures figures = networkFigures(node).at(0);
        QCOMPARE(figures.roundTrip_ms, std::optional{24.0});
        QCOMPARE(figures.delays_ms, (std::vector<double>{8.0, 12.0}));
        QCOMPARE(figures.meanDelay_ms, std::optional{10.0});
        QCOMPARE(figures.sigma_ms, std::optional{2.0});
        QCOMPARE(figures.probes_per_s, std::optional{3.0});
        QCOMPARE(figures.clockOffset_s, std::optional{12'345.678901});
        QCOMPARE(figures.clockErrorBound_ms, std::optional{8.0});
        QVERIFY(std::abs(figures.loss_percent.value() - 1.23) < 1e-9);
        QVERIFY(figures.objects.empty());
    }

    void theLimitIsSpeedTimesDelay()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee), knownPath(kObserver)};
        node.pathReports[1].meanDelay = 15ms;
        node.reports = {movingTube()};
        const auto all = networkFigures(node);
        QVERIFY(all.at(1).objects.empty()); // the tube is Tom's
        const ObjectFigures tube = all.at(0).objects.at(0);
        QCOMPARE(tube.name, QStringLiteral("tube"));
        QCOMPARE(tube.drift_deg, std::optional{0.14});
        QVERIFY(std::abs(tube.limit_deg.value() - 1.0) < 1e-9); // 100 deg/s x 10 ms
        QVERIFY(std::abs(tube.limit_mm.value() - 0.5) < 1e-9);  // 50 mm/s x 10 ms
    }

    void tellsHowOftenEachParticipantActs()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee), knownPath(kObserver)};
        node.pathReports[1].meanDelay = 15ms;
        node.frequencies = {{kTrainee, 30.0}};
        const auto all = networkFigures(node);
        QCOMPARE(all.at(0).actions_per_s, std::optional{30.0});
        QVERIFY(!all.at(1).actions_per_s);
        // From Tom to Olga it is 25 ms, and back.
        for (const NetworkFigures& one : all)
            if (!one.isOwn)
                QVERIFY(std::abs(one.upshot_per_s.value() - 40.0) < 1e-9);
    }

    /// Who instructs often acts most, and has no path to themselves.
    void tellsHowOftenItsOwnParticipantActs()
    {
        FakeSessionNode node;
        QVERIFY(networkFigures(node).empty()); // nobody is there who would hear of it
        node.pathReports = {knownPath(kTrainee), knownPath(kObserver)};
        node.pathReports[1].meanDelay = 40ms;
        node.frequencies = {{kInstructor, 30.0}, {kTrainee, 2.0}};
        const auto all = networkFigures(node);
        QCOMPARE(all.size(), std::size_t{3});
        const NetworkFigures& own = all.back();
        QVERIFY(own.isOwn && own.id == kInstructor);
        QCOMPARE(own.actions_per_s, std::optional{30.0});
        QVERIFY(std::abs(own.upshot_per_s.value() - 25.0) < 1e-9); // 1 / 40 ms
        QCOMPARE(linesOf(own),
                 QStringList{QStringLiteral("Actions, vₖ (v₀): 30.0 (25) per s, above upshot")});
        for (PathReport& path : node.pathReports)
            path.meanDelay.reset();
        QVERIFY(!networkFigures(node).back().upshot_per_s);
    }

    void theLimitOfAnObjectThatIsActedOnIsThatOfTheAction()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        node.reports = {movingTube()};
        node.reports[0].limitDeg = 3.0;
        node.reports[0].limitMm = 0.25;
        const auto all = networkFigures(node);
        QCOMPARE(all.at(0).objects.at(0).limit_deg, std::optional{3.0});
        QCOMPARE(all.at(0).objects.at(0).limit_mm, std::optional{0.25});
    }

    void saysBesideThePlaceHowFarTheSizeIsOff()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        node.reports = {movingTube()};
        node.reports[0].limitDeg = 0.0;
        node.reports[0].limitMm = 0.0;
        node.reports[0].driftScale = 0.041;
        node.reports[0].limitScale = 0.0;
        QVERIFY(linesOf(networkFigures(node).at(0))
                    .contains(QStringLiteral(
                        "tube: drift (limit): 0.140 (0.000)°, 0.800 (0.000) mm, 4.100 (0.000) %")));
    }

    void withOneParticipantTheUpshotIsThatOfThePathHere()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        const auto all = networkFigures(node);
        QVERIFY(std::abs(all.at(0).upshot_per_s.value() - 100.0) < 1e-9);
    }

    void saysWhatIsNotKnownYet()
    {
        FakeSessionNode node;
        node.pathReports = {PathReport{kTrainee}};
        node.reports = {{FakeSessionNode::kTube, 21ms, 0.14, 0.8}};
        const QStringList expected{
            QStringLiteral("Round-trip time: ") + kUnknown,
            QStringLiteral("One-way delay ± σ: ") + kUnknown,
            QStringLiteral("tube: drift (limit): 0.140 (unknown)°, 0.800 (unknown) mm"),
            QStringLiteral("Clock's probe rate, γ₀: ") + kUnknown,
            QStringLiteral("Datagram loss: not known before 100 datagrams"),
            QStringLiteral("Actions, vₖ (v₀): ") + kUnknown,
            QStringLiteral("Clock drift since joining: ") + kUnknown,
            QStringLiteral("Clock error at most: ") + kUnknown};
        QCOMPARE(linesOf(networkFigures(node).at(0)), expected);
    }

    void saysEveryFigureWithItsUnit()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        node.reports = {movingTube()};
        node.frequencies = {{kTrainee, 30.0}};
        SessionModel session{node};
        const NetworkModel model{session};
        const QStringList expected{
            QStringLiteral("Round-trip time: 24.00 ms"),
            QStringLiteral("One-way delay ± σ: 10.00 ± 2.00 ms"),
            QStringLiteral("tube: drift (limit): 0.140 (1.000)°, 0.800 (0.500) mm"),
            QStringLiteral("Clock's probe rate, γ₀: 3 per s"),
            QStringLiteral("Datagram loss: 1.2 %"),
            QStringLiteral("Actions, vₖ (v₀): 30.0 (100) per s, below upshot"),
            QStringLiteral("Clock drift since joining: +0.000 ± 0.076 ms"), // 0.054 twice
            QStringLiteral("Clock error at most: ± 8.000 ms")};
        QCOMPARE(linesOf(*model.figures(0)), expected);
    }

    void saysWhoseProbesItShows()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        node.pathReports[0].isOfStrategy = true;
        QCOMPARE(linesOf(networkFigures(node).at(0)).at(2),
                 QStringLiteral("ASA's probe rate, γ₀: 3 per s"));
    }

    void saysWhetherDisciplinedClocksAreUsed()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        node.pathReports[0].external = ExternalVerdict{-15ms, 1ms, false};
        const auto line = [&] { return linesOf(networkFigures(node).at(0)).last(); };
        QCOMPARE(line(), QStringLiteral("Clocks set by NTP or PTP: used, -15.000 ± 1.000 ms"));
        node.pathReports[0].external = ExternalVerdict{14ms, 1ms, true};
        QCOMPARE(line(), QStringLiteral("Clocks set by NTP or PTP: refused, +14.000 ± 1.000 ms"));
        node.pathReports[0].external.reset();
        QVERIFY(!line().startsWith(QStringLiteral("Clocks set")));
    }

    void saysAtTheHostWhatAParticipantSends()
    {
        FakeSessionNode node;
        PathReport path = knownPath(kTrainee);
        path.traffic = TrafficReport{12'345.0, 59.7, 4, 17};
        node.pathReports = {path};
        const QStringList lines = linesOf(networkFigures(node).at(0));
        QCOMPARE(lines.at(4), QStringLiteral("Received: 12.3 kB/s, 60 samples per s"));
        QCOMPARE(lines.at(5), QStringLiteral("Changes made: 4"));
        QCOMPARE(lines.at(6), QStringLiteral("Refused: 17"));
    }

    void tellsTheCategoryByShapeAndWords()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        node.frequencies = {{kTrainee, 60.0}};
        NetworkFiguresModel table;
        const auto category = [&] {
            table.show(networkFigures(node).at(0));
            for (int row = 0; row < table.rowCount(); ++row)
                if (table.index(row, Column::What)
                        .data()
                        .toString()
                        .startsWith(QStringLiteral("Actions")))
                    return table.index(row, Column::HowMuch).data().toString();
            return QString{};
        };
        QCOMPARE(category(), QStringLiteral("60.0 (100) per s, ✓ below upshot"));
        node.frequencies[kTrainee] = 100.0;
        QCOMPARE(category(), QStringLiteral("100.0 (100) per s, ▲ above upshot"));
        node.frequencies.clear();
        QCOMPARE(category(), QStringLiteral("– (100) per s"));
    }

    void tellsHowFarClocksHaveRunApartSinceTheyCouldBeCompared()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        node.pathReports[0].clockOffset.reset();
        SessionModel session{node};
        const NetworkModel model{session};
        const auto after = [&](std::optional<Duration> offset, Duration error) {
            node.pathReports[0].clockOffset = offset;
            node.pathReports[0].clockError = error;
            node.announce();
            QCoreApplication::sendPostedEvents();
            return *model.figures(0);
        };
        QVERIFY(!model.figures(0)->clockChange_ms);
        QCOMPARE(after(5000s, 300us).clockChange_ms, std::optional{0.0});
        const NetworkFigures apart = after(5000s - 1500us, 400us);
        QVERIFY(std::abs(apart.clockChange_ms.value() + 1.5) < 1e-6);
        QVERIFY(std::abs(apart.clockChangeError_ms.value() - 0.5) < 1e-9); // of 0.3 and 0.4
        QCOMPARE(linesOf(apart).at(5),
                 QStringLiteral("Clock drift since joining: -1.500 ± 0.500 ms"));
        QVERIFY(!after({}, 0us).clockChange_ms); // comes in again
        QCOMPARE(after(7000s, 300us).clockChange_ms, std::optional{0.0});
    }

    void changesNumbersWithoutLosingTheSelection()
    {
        FakeSessionNode node;
        node.pathReports = {knownPath(kTrainee)};
        SessionModel session{node};
        NetworkModel model{session};
        NetworkFiguresModel table;
        table.show(model.figures(0));
        const QPersistentModelIndex selected = table.index(0, Column::HowMuch);
        QSignalSpy resets{&model, &QAbstractItemModel::modelReset};
        QSignalSpy measured{&model, &NetworkModel::measured};
        node.pathReports[0].roundTrip = 30ms;
        node.announce();
        QCoreApplication::sendPostedEvents();
        QCOMPARE(resets.count(), 0);
        QCOMPARE(measured.count(), 1);
        table.show(model.figures(0));
        QVERIFY(selected.isValid());
        QCOMPARE(selected.data().toString(), QStringLiteral("30.00 ms"));
        node.pathReports.push_back(PathReport{kInstructor});
        node.announce();
        QCoreApplication::sendPostedEvents();
        QCOMPARE(resets.count(), 1);
        QCOMPARE(model.figures(0)->id, kInstructor);
        table.show({});
        QCOMPARE(table.rowCount(), 0);
    }
};

CARINA_TEST(TestNetworkModel)

} // namespace carina::network_model_test

#include "tst_network_model.moc"
