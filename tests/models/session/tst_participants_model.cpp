#include "models/session/participants_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include <cmath>
#include <numbers>

namespace carina::participants_model_test
{

using test::FakeSessionNode;

class TestParticipantsModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsEverybodyWithTheirRole();
    void saysWhoIsWhere();
    void saysWhoIsAtWork();
    void namesItsColumns();
    void marksWhoSeesTheSame();
    void saysWhoHasNothingToCompare();
    void takesTheTrackersErrorForNoDifference();
    void takesAHandForNoDifference_data();
    void takesAHandForNoDifference();
    void saysWhetherSomebodyIsThere_data();
    void saysWhetherSomebodyIsThere();
    void saysWhoMayNotTakePart();
    void saysHowMuchSomebodySends();
    void tellsOfAReplacedToken();
    void saysHowEachRegistrationStands_data();
    void saysHowEachRegistrationStands();
    void forgetsTheRegistrationWithTheTracker();
    void showsTheWorstOfSomebodysObjects();
    void forgetsTheObjectsOfWhoLeft();
    void takesWhoIsMutedForNoBrokenTracker();
    void speaksEachCell();
    void addsWhoComesInAndKeepsWhoLeft();
    void changesCellsWithoutLosingTheSelection();
};

namespace
{

using Column = ParticipantsModel::Column;
using std::chrono::microseconds;
using std::chrono::milliseconds;

struct Table {
    FakeSessionNode node;
    SessionModel session{node};
    ParticipantsModel model{session};
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};

    void deliver()
    {
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] QString cell(int row, int column, int role = Qt::DisplayRole) const
    {
        return model.data(model.index(row, column), role).toString();
    }
};

// Rows come in order of ids.
constexpr int kInstructorRow = 0;
constexpr int kTraineeRow = 1;
constexpr int kObserverRow = 2;

const QString kNoValue = QStringLiteral("–");

} // namespace

void TestParticipantsModel::listsEverybodyWithTheirRole()
{
    const Table table;
    QCOMPARE(table.model.rowCount(), 3);
    QCOMPARE(table.cell(kInstructorRow, Column::Name), QStringLiteral("Ina"));
    QCOMPARE(table.cell(kInstructorRow, Column::RoleColumn), QStringLiteral("Instructor"));
    QCOMPARE(table.cell(kTraineeRow, Column::RoleColumn), QStringLiteral("Trainee, at work"));
    QCOMPARE(table.cell(kObserverRow, Column::RoleColumn), QStringLiteral("Observer"));
}

void TestParticipantsModel::saysWhoIsWhere()
{
    Table table;
    QCOMPARE(table.cell(kInstructorRow, Column::Station), QStringLiteral("Station 1"));
    table.node.addStation("Room 5");
    table.node.decideAt(StationId{1}, fact::ParticipantMoved{FakeSessionNode::kTrainee});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Station), QStringLiteral("Room 5"));
    QCOMPARE(table.cell(kObserverRow, Column::Station), QStringLiteral("Station 1"));
    QCOMPARE(table.cell(kTraineeRow, Column::Station, Qt::AccessibleTextRole),
             QStringLiteral("Station: Room 5"));
    // Whichever station the console shows.
    QCOMPARE(table.cell(kInstructorRow, Column::Station), QStringLiteral("Station 1 (your place)"));
    QVERIFY(table.model.headerData(Column::Station, Qt::Horizontal, Qt::ToolTipRole)
                .toString()
                .contains(QStringLiteral("whichever station")));
}

void TestParticipantsModel::saysWhoIsAtWork()
{
    Table table;
    table.node.decide(fact::WorkTaken{FakeSessionNode::kInstructor, FakeSessionNode::kTrainee});
    table.deliver();
    QCOMPARE(table.cell(kInstructorRow, Column::RoleColumn), QStringLiteral("Instructor, at work"));
    QCOMPARE(table.cell(kTraineeRow, Column::RoleColumn), QStringLiteral("Trainee"));
}

void TestParticipantsModel::namesItsColumns()
{
    const Table table;
    const QStringList expected{
        QStringLiteral("Name"),  QStringLiteral("Role"),         QStringLiteral("Station"),
        QStringLiteral("State"), QStringLiteral("Registration"), QStringLiteral("Sends"),
        QStringLiteral("Age"),   QStringLiteral("Drift °"),      QStringLiteral("Drift mm"),
        QStringLiteral("Delay"), QStringLiteral("Objects")};
    QStringList headers;
    for (int column = 0; column < table.model.columnCount(); ++column)
        headers << table.model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    QCOMPARE(headers, expected);
}

void TestParticipantsModel::saysWhetherSomebodyIsThere_data()
{
    QTest::addColumn<int>("link"); // -1: none
    QTest::addColumn<bool>("present");
    QTest::addColumn<QString>("word");
    QTest::newRow("connected") << int(LinkState::Connected) << true
                               << QStringLiteral("✓ connected");
    QTest::newRow("connecting") << int(LinkState::Connecting) << true
                                << QStringLiteral("◇ connecting");
    QTest::newRow("away") << int(LinkState::Away) << true << QStringLiteral("▲ away");
    QTest::newRow("no link") << -1 << true << QStringLiteral("▲ away");
    QTest::newRow("left") << int(LinkState::Connected) << false << QStringLiteral("○ left");
}

void TestParticipantsModel::saysWhetherSomebodyIsThere()
{
    QFETCH(const int, link);
    QFETCH(const bool, present);
    QFETCH(const QString, word);
    Table table;
    table.node.linkReports.push_back(
        {FakeSessionNode::kObserver, LinkState::Connected, {}, {}, {}});
    if (link >= 0)
        table.node.linkReports.push_back({FakeSessionNode::kTrainee, LinkState(link), {}, {}, {}});
    if (!present)
        table.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::State), word);
    QCOMPARE(table.cell(kInstructorRow, Column::State), QStringLiteral("✓ here"));
    QCOMPARE(table.cell(kObserverRow, Column::State), QStringLiteral("✓ connected"));
}

void TestParticipantsModel::saysWhoMayNotTakePart()
{
    Table table;
    table.node.decide(fact::ParticipantFellSilent{FakeSessionNode::kTrainee});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::State), QStringLiteral("▲ away"));
    table.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tom"});
    const auto tomIs = [&](FactBody body) {
        table.node.linkReports = {{FakeSessionNode::kTrainee, LinkState::Connected, {}, {}, {}}};
        table.node.decide(std::move(body), FakeSessionNode::kInstructor);
        table.deliver();
        return table.cell(kTraineeRow, Column::State);
    };
    constexpr ParticipantId tom = FakeSessionNode::kTrainee;
    QCOMPARE(tomIs(fact::ParticipantMuted{tom, true}), QStringLiteral("▲ muted"));
    QCOMPARE(tomIs(fact::ParticipantMuted{tom, false}), QStringLiteral("✓ connected"));
    QCOMPARE(tomIs(fact::ParticipantRemoved{tom, true, "too loud"}), QStringLiteral("✕ banned"));
    QCOMPARE(table.cell(kTraineeRow, Column::State, Qt::ToolTipRole),
             QStringLiteral("Removed by Ina: too loud"));
    QCOMPARE(table.cell(kTraineeRow, Column::State, Qt::AccessibleTextRole),
             QStringLiteral("State: banned"));
    QCOMPARE(tomIs(fact::BanLifted{tom}), QStringLiteral("○ may return"));
    table.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tom"});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::State), QStringLiteral("✓ connected"));
    QCOMPARE(table.cell(kTraineeRow, Column::State, Qt::ToolTipRole), QString{});
    QCOMPARE(table.model.data(table.model.index(kTraineeRow, 0), ParticipantsModel::kIdRole),
             QVariant{uint{tom.value}});
}

void TestParticipantsModel::saysHowMuchSomebodySends()
{
    Table table;
    QCOMPARE(table.cell(kTraineeRow, Column::Sends), kNoValue);
    PathReport path;
    path.peer = FakeSessionNode::kTrainee;
    path.traffic = TrafficReport{12'345.0, 60.0, 3, 2};
    table.node.pathReports = {path};
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Sends), QStringLiteral("12.3 kB/s"));
    QCOMPARE(table.cell(kObserverRow, Column::Sends), kNoValue);
}

void TestParticipantsModel::tellsOfAReplacedToken()
{
    Table table;
    table.node.linkReports = {{FakeSessionNode::kTrainee, LinkState::Connected, {}, {}, {}}};
    table.node.decide(fact::TokenReplaced{FakeSessionNode::kTrainee});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::State), QStringLiteral("▲ token replaced"));
}

void TestParticipantsModel::saysHowEachRegistrationStands_data()
{
    QTest::addColumn<RegistrationStanding>("standing");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, const RegistrationStanding& standing, const char* text) {
        QTest::newRow(name) << standing << QString::fromUtf8(text);
    };
    using State = RegistrationState;
    using Why = StaleReason;
    row("good", {State::Good, Why::None, millimetres(1.4)}, "✓ registered, 1.4\u00a0mm");
    row("simulated", {State::Simulated, Why::None, {}}, "✓ simulated");
    row("missing", {State::Missing, Why::None, {}}, "▲ not registered");
    row("unverified", {State::Unverified, Why::Fit, millimetres(2.0)}, "▲ unverified, 2.0\u00a0mm");
    row("not good", {State::NotGood, Why::None, millimetres(4.2)},
        "▲ not good: 4.2\u00a0mm at check");
    row("stylus", {State::Stale, Why::Stylus, {}}, "▲ stale: stylus calibrated anew");
    row("landmarks", {State::Stale, Why::Landmarks, {}}, "▲ stale: landmarks changed");
    row("touches", {State::Stale, Why::Touches, {}}, "▲ stale: landmarks touched anew");
    row("tracker", {State::Stale, Why::Tracker, {}}, "▲ stale: tracker changed");
    row("patient", {State::Stale, Why::Patient, {}}, "▲ stale: another patient");
    row("manikin", {State::Stale, Why::Manikin, {}}, "▲ stale: manikin moved");
    row("registering", {State::Stale, Why::Registering, {}}, "▲ stale: being registered again");
    row("age", {State::Stale, Why::Age, {}}, "▲ stale: verified long ago");
    row("drift", {State::Stale, Why::Drift, millimetres(8.0)}, "▲ stale: moved by about 8\u00a0mm");
}

void TestParticipantsModel::saysHowEachRegistrationStands()
{
    QFETCH(const RegistrationStanding, standing);
    QFETCH(const QString, text);
    Table table;
    QCOMPARE(table.cell(kTraineeRow, Column::Registration), kNoValue);
    table.node.decide(fact::RegistrationStated{standing}, FakeSessionNode::kTrainee);
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Registration), text);
    QCOMPARE(table.cell(kTraineeRow, Column::Registration, Qt::AccessibleTextRole),
             QStringLiteral("Registration: ") + text.section(QLatin1Char(' '), 1));
    QVERIFY(!table.cell(kTraineeRow, Column::Registration, Qt::ToolTipRole).isEmpty());
    QCOMPARE(table.cell(kInstructorRow, Column::Registration), kNoValue);
    table.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Registration), kNoValue);
}

void TestParticipantsModel::forgetsTheRegistrationWithTheTracker()
{
    Table table;
    for (const auto state : {RegistrationState::Good, RegistrationState::NoTracker})
        table.node.decide(fact::RegistrationStated{{state, {}, {}}}, FakeSessionNode::kTrainee);
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Registration), kNoValue);
    QCOMPARE(table.cell(kTraineeRow, Column::Registration, Qt::AccessibleTextRole),
             QStringLiteral("Registration: none"));
    QVERIFY(table.cell(kTraineeRow, Column::Registration, Qt::ToolTipRole)
                .contains(QStringLiteral("no tracker")));
}

void TestParticipantsModel::showsTheWorstOfSomebodysObjects()
{
    Table table;
    table.node.decide(fact::ObjectShared{{}, FakeSessionNode::kTrainee, ObjectKind::Head, "head"});
    table.node.decide(
        fact::ObjectShared{{}, FakeSessionNode::kInstructor, ObjectKind::Head, "head"});
    table.node.reports = {{ObjectId{1}, milliseconds{12}, 0.03, 1.26},
                          {ObjectId{2}, milliseconds{41}, 0.014, 0.2},
                          {ObjectId{3}, milliseconds{700}, 9.0, 99.0},
                          {ObjectId{77}, milliseconds{900}, 90.0, 999.0}}; // of nobody
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Age), QStringLiteral("41 ms"));
    QCOMPARE(table.cell(kTraineeRow, Column::DriftAngle), QStringLiteral("0.03°"));
    QCOMPARE(table.cell(kTraineeRow, Column::DriftDistance), QStringLiteral("1.3 mm"));
    QCOMPARE(table.cell(kInstructorRow, Column::Age), QStringLiteral("700 ms"));
    for (const int column : {Column::Age, Column::DriftAngle, Column::DriftDistance})
        QCOMPARE(table.cell(kObserverRow, column), kNoValue);
    QCOMPARE(table.model.oldestSample_ms(), std::optional{700.0});
}

// A tube that turns at 100 deg/s and moves at 200 mm/s is shown elsewhere by 4 degrees and 8 mm
// after 40 ms: the delay explains that. Samples of a tracker at rest differ by 1 degree and 1 mm.
void TestParticipantsModel::marksWhoSeesTheSame()
{
    Table table;
    table.node.pathReports.push_back(
        {.peer = FakeSessionNode::kTrainee, .meanDelay = milliseconds{40}});
    table.node.reports = {{ObjectId{1}, milliseconds{41}, 0.03, 8.9, 100.0, 200.0}};
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Delay), QStringLiteral("40 ms"));
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("✓ same"));
    const QString figures = table.cell(kTraineeRow, Column::Same, Qt::ToolTipRole);
    for (const char* part : {"0.03°", "8.9 mm", "9.0 mm", "41 ms", "5.00°"})
        QVERIFY2(figures.contains(QString::fromUtf8(part)), qPrintable(figures));
    QCOMPARE(table.cell(kTraineeRow, Column::Same, Qt::AccessibleDescriptionRole), figures);
    table.node.reports = {{ObjectId{1}, milliseconds{41}, 0.03, 9.1, 100.0, 200.0}};
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("▲ differs"));
    QCOMPARE(table.cell(kTraineeRow, Column::Same, Qt::AccessibleTextRole),
             QStringLiteral("Objects: differs"));
    table.node.reports = {{ObjectId{1}, milliseconds{41}, 5.1, 0.4, 100.0, 200.0}};
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("▲ differs"));
}

void TestParticipantsModel::saysWhoHasNothingToCompare()
{
    Table table;
    const auto tip = [&table](int row) { return table.cell(row, Column::Same, Qt::ToolTipRole); };
    QCOMPARE(table.cell(kInstructorRow, Column::Same), kNoValue); // oneself
    QVERIFY(tip(kInstructorRow).isEmpty());
    QCOMPARE(table.cell(kObserverRow, Column::Same), QStringLiteral("○ none"));
    QVERIFY(tip(kObserverRow).contains(QStringLiteral("no tool")));
    QCOMPARE(table.cell(kObserverRow, Column::Same, Qt::AccessibleTextRole),
             QStringLiteral("Objects: none"));
    // Who owns a tube, also before the first sample of it came.
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("◇ unknown"));
    table.node.reports = {{ObjectId{1}, milliseconds{41}}};
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("◇ unknown"));
    QVERIFY(tip(kTraineeRow).contains(QStringLiteral("not compared yet")));
    table.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), kNoValue);
}

// What a tool at rest was off by in the demo, on one computer; the tracker measures no better.
void TestParticipantsModel::takesTheTrackersErrorForNoDifference()
{
    Table table;
    table.node.pathReports.push_back(
        {.peer = FakeSessionNode::kTrainee, .meanDelay = microseconds{200}});
    table.node.reports = {{ObjectId{1}, milliseconds{29}, 0.46, 0.2, 0.0, 0.0}};
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("✓ same"));
    // An action is stated exactly: a view of it has no such excuse.
    table.node.reports[0].limitDeg = 0.02;
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("▲ differs"));
    // Nobody sees a tenth of a degree, also where the action has arrived and nothing is left.
    table.node.reports[0].limitDeg = 0.0;
    table.node.reports[0].driftDeg = 0.09;
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("✓ same"));
    table.node.reports[0].driftDeg = 0.11;
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("▲ differs"));
    // Nor a hundredth of a size; one that grew by 4 % for its owner alone looks different.
    table.node.reports[0].driftDeg = 0.0;
    table.node.reports[0].driftScale = 0.009;
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("✓ same"));
    table.node.reports[0].driftScale = 0.04;
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("▲ differs"));
    const QString tip = table.cell(kTraineeRow, Column::Same, Qt::ToolTipRole);
    QVERIFY2(tip.contains(QStringLiteral("size off by 4.0 % (bound 1.0 %)")), qPrintable(tip));
}

void TestParticipantsModel::takesAHandForNoDifference_data()
{
    QTest::addColumn<milliseconds>("delay");
    QTest::newRow("one computer") << milliseconds{0};
    QTest::newRow("metro") << milliseconds{8};
    QTest::newRow("wan") << milliseconds{40};
}

// A hand to and fro at 1.5 Hz, with 1 m/s^2 root mean square: the farthest that it gets from where
// its motion of three frames and the delay before led, and twice that.
void TestParticipantsModel::takesAHandForNoDifference()
{
    QFETCH(milliseconds, delay);
    const double w = 2.0 * std::numbers::pi * 1.5;
    const double amplitude_mm = 1000.0 * std::numbers::sqrt2 / (w * w);
    const double age_s = 0.05 + 1e-3 * double(delay.count());
    double farthest_mm = 0.0;
    for (double t = 0.0; t < 1.0; t += 0.001) {
        const double led = amplitude_mm * (std::cos(w * t) - w * age_s * std::sin(w * t));
        farthest_mm =
            std::max(farthest_mm, std::abs(amplitude_mm * std::cos(w * (t + age_s)) - led));
    }
    Table table;
    table.node.pathReports.push_back({.peer = FakeSessionNode::kTrainee, .meanDelay = delay});
    table.node.reports = {{ObjectId{1}, milliseconds{29}, 0.0, farthest_mm, 0.0, 0.0}};
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("✓ same"));
    table.node.reports[0].driftMm = 2.0 * farthest_mm;
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Same), QStringLiteral("▲ differs"));
}

void TestParticipantsModel::forgetsTheObjectsOfWhoLeft()
{
    Table table;
    QVERIFY(!table.model.oldestSample_ms());
    table.node.reports = {{ObjectId{1}, milliseconds{12}, 0.03, 1.26}};
    table.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    table.deliver();
    for (const int column : {Column::Age, Column::DriftAngle, Column::DriftDistance})
        QCOMPARE(table.cell(kTraineeRow, column), kNoValue);
    QVERIFY(!table.model.oldestSample_ms());
}

void TestParticipantsModel::takesWhoIsMutedForNoBrokenTracker()
{
    Table table;
    table.node.reports = {{ObjectId{1}, milliseconds{9000}, 0.03, 1.26}};
    table.node.linkReports.push_back({FakeSessionNode::kTrainee, LinkState::Connected, {}, {}, {}});
    table.node.decide(fact::ParticipantMuted{FakeSessionNode::kTrainee, true});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::State), QStringLiteral("▲ muted"));
    for (const int column : {Column::Age, Column::DriftAngle, Column::DriftDistance})
        QCOMPARE(table.cell(kTraineeRow, column), kNoValue);
    QVERIFY(!table.model.oldestSample_ms());
    table.node.decide(fact::ParticipantMuted{FakeSessionNode::kTrainee, false});
    table.deliver();
    QCOMPARE(table.cell(kTraineeRow, Column::Age), QStringLiteral("9000 ms"));
}

void TestParticipantsModel::speaksEachCell()
{
    Table table;
    table.node.reports = {{ObjectId{1}, milliseconds{12}, 0.03, 1.26}};
    table.deliver();
    const auto spoken = [&](int row, int column) {
        return table.cell(row, column, Qt::AccessibleTextRole);
    };
    QCOMPARE(spoken(kTraineeRow, Column::Name), QStringLiteral("Name: Tom"));
    QCOMPARE(spoken(kInstructorRow, Column::State), QStringLiteral("State: here"));
    QCOMPARE(spoken(kTraineeRow, Column::Age), QStringLiteral("Age: 12 ms"));
    QCOMPARE(spoken(kObserverRow, Column::Age), QStringLiteral("Age: unknown"));
}

void TestParticipantsModel::addsWhoComesInAndKeepsWhoLeft()
{
    Table table;
    const QPersistentModelIndex chosen = table.model.index(kTraineeRow, 0);
    table.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
    table.node.decide(fact::ParticipantLeft{FakeSessionNode::kObserver});
    table.deliver();
    QVERIFY(chosen.isValid()); // whoever was chosen stays so
    QCOMPARE(table.model.rowCount(), 4);
    QCOMPARE(table.cell(3, Column::Name), QStringLiteral("Tess"));
    QCOMPARE(table.cell(kObserverRow, Column::Name), QStringLiteral("Olga"));
}

void TestParticipantsModel::changesCellsWithoutLosingTheSelection()
{
    Table table;
    const QPersistentModelIndex selected = table.model.index(kTraineeRow, Column::Name);
    QSignalSpy changes{&table.model, &QAbstractItemModel::dataChanged};
    table.deliver();
    QCOMPARE(changes.count(), 0); // nothing did
    table.node.reports = {{ObjectId{1}, milliseconds{12}, 0.03, 1.26}};
    table.deliver();
    QCOMPARE(changes.count(), 1);
    QVERIFY(selected.isValid());
    QCOMPARE(selected.row(), kTraineeRow);
}

CARINA_TEST(TestParticipantsModel)

} // namespace carina::participants_model_test

#include "tst_participants_model.moc"
